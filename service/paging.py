"""Opaque page tokens."""

import base64
import binascii
import json
from typing import Annotated

from fastapi import Query
from pydantic import Field, TypeAdapter

from service.refusals import invalid
from storage import Cursor

_Created = Annotated[float, Field(ge=0, le=1e12, strict=True, allow_inf_nan=False)]
_Id = Annotated[str, Field(pattern="^[0-9a-z_]+$")]
_CURSORS: TypeAdapter[tuple[float, str]] = TypeAdapter(tuple[_Created, _Id])

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
        return Cursor(*_CURSORS.validate_json(base64.urlsafe_b64decode(token)))
    except (binascii.Error, ValueError) as error:
        raise invalid("?page_token", "not a token that a page gave") from error
