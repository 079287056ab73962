"""`/v1/kinds`: the mechanism families."""

from fastapi import APIRouter

import analyses
from schemas.kinds import Kind, KindPage
from service.problems import declared
from service.refusals import not_found

router = APIRouter(prefix="/v1/kinds", tags=["kinds"])


@router.get("", operation_id="list_kinds")
def list_kinds() -> KindPage:
    """List the mechanism families: coordinates, drives, analyses, schema, example, presets."""
    return KindPage(items=analyses.offered_kinds())


@router.get("/{kind}", operation_id="get_kind", responses=declared(404))
def get_kind(kind: str) -> Kind:
    """Return one mechanism family."""
    try:
        return analyses.offered_kind(kind)
    except KeyError as error:
        raise not_found("kind", kind) from error
