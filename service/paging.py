"""Opaque page tokens."""

import base64
import binascii
import json
from typing import Annotated

from fastapi import Query

from service.refusals import invalid
from storage import Cursor

PageSize = Annotated[int, Query(ge=1, le=500, description="Most items of a page.")]
PageToken = Annotated[
    str | None, Query(max_length=400, description="`next_page_token` of the page before.")
]


def token_of(cursor: Cursor) -> str:
    """Return the token of the page after `cursor`."""
    return base64.urlsafe_b64encode(json.dumps(list(cursor)).encode()).decode()


def cursor_of(token: str | None) -> Cursor | None:
    """Return where a page starts.

    Raises
    ------
    Refusal : the token is none of ours.
    """
    if token is None:
        return None
    try:
        created, identifier = json.loads(base64.urlsafe_b64decode(token))
        return Cursor(float(created), str(identifier))
    except (binascii.Error, ValueError, TypeError) as error:
        raise invalid("?page_token", "not a token that a page gave") from error
