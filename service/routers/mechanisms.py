"""`/v1/mechanisms`: mechanisms kept under the hash of their canonical form."""

from typing import Annotated, Any

from fastapi import APIRouter, Header, Response

from analyses import check_mechanism
from schemas.kinds import MechanismPage, StoredMechanismDocument
from schemas.mechanisms import MechanismSpec, canonical_json, mechanism_id
from service.documents import mechanism_document
from service.etags import is_known
from service.paging import PageSize, PageToken, cursor_of, token_of
from service.problems import Responses, declared
from service.stores import UsedStores

router = APIRouter(prefix="/v1/mechanisms", tags=["mechanisms"])

_UNCHANGED: Responses = {304: {"description": "It has not changed."}}
_CREATED: Responses = {
    200: {"model": StoredMechanismDocument, "description": "It was stored before."},
}


@router.post(
    "",
    operation_id="create_mechanism",
    status_code=201,
    responses=_CREATED | declared(400, 413, 415, 422, 503),
)
def create_mechanism(
    mechanism: MechanismSpec, response: Response, stores: UsedStores
) -> StoredMechanismDocument:
    """Store a mechanism; the same spec again answers 200 with the same id."""
    check_mechanism(mechanism, at="")
    identifier = mechanism_id(mechanism)
    created = stores.mechanisms.add(identifier, canonical_json(mechanism))
    response.status_code = 201 if created else 200
    response.headers["Location"] = f"/v1/mechanisms/{identifier}"
    return mechanism_document(stores.mechanisms.get(identifier))


@router.get("", operation_id="list_mechanisms", responses=declared(422))
def list_mechanisms(
    stores: UsedStores, page_token: PageToken = None, page_size: PageSize = 50
) -> MechanismPage:
    """List the stored mechanisms, the newest first."""
    rows = stores.mechanisms.page(after=cursor_of(page_token), size=page_size + 1)
    more = len(rows) > page_size
    return MechanismPage(
        items=[mechanism_document(row) for row in rows[:page_size]],
        next_page_token=token_of(rows[page_size - 1].cursor) if more else None,
    )


@router.get(
    "/{mechanism_id}",
    operation_id="get_mechanism",
    response_model=StoredMechanismDocument,
    responses=_UNCHANGED | declared(404),
)
def get_mechanism(
    mechanism_id: str,
    response: Response,
    stores: UsedStores,
    if_none_match: Annotated[str | None, Header()] = None,
) -> Any:  # noqa: ANN401
    """Return one stored mechanism, with an ETag."""
    stored = stores.mechanisms.get(mechanism_id)
    etag = f'"{stored.id}"'
    if is_known(etag, if_none_match):
        return Response(status_code=304, headers={"ETag": etag})
    response.headers["ETag"] = etag
    return mechanism_document(stored)


@router.delete(
    "/{mechanism_id}",
    operation_id="delete_mechanism",
    status_code=204,
    responses=declared(404),
)
def delete_mechanism(mechanism_id: str, stores: UsedStores) -> None:
    """Remove a stored mechanism; jobs that named it carry their own copy."""
    stores.mechanisms.delete(mechanism_id)
