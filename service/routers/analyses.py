"""`/v1/analyses` and `/v1/estimates`: answers at once, or a job; and what they would cost."""

from typing import Annotated, Any

from fastapi import APIRouter, Body, Header, Response

import analyses
from schemas.analyses import AnalysisRequest, AnalysisResult
from schemas.estimates import Estimate
from schemas.examples import EXAMPLES
from schemas.jobs import Job
from service.documents import job_document
from service.problems import Responses, declared
from service.stores import UsedStores
from service.submission import enqueue, take_in

router = APIRouter(prefix="/v1", tags=["analyses"])

REQUEST_EXAMPLES: dict[str, Any] = {
    example.request.analysis: {
        "summary": example.title,
        "value": example.request.model_dump(mode="json", exclude_defaults=True),
    }
    for example in EXAMPLES
}
_ANSWER_EXAMPLES = {
    example.request.analysis: {"summary": example.title, "value": example.answer}
    for example in EXAMPLES
}

_ANSWERS: Responses = {
    200: {
        "description": "The result.",
        "content": {"application/json": {"examples": _ANSWER_EXAMPLES}},
    },
    202: {"model": Job, "description": "It became a job; see Location."},
}

AnalysisBody = Annotated[AnalysisRequest, Body(openapi_examples=REQUEST_EXAMPLES)]
IdempotencyKey = Annotated[
    str | None,
    Header(
        min_length=1,
        max_length=200,
        description="The same key answers with the same job for 24 hours.",
    ),
]


@router.post(
    "/analyses",
    operation_id="analyse",
    response_model=AnalysisResult,
    responses=_ANSWERS | declared(400, 413, 415, 422, 503),
)
def analyse(
    request: AnalysisBody,
    stores: UsedStores,
    prefer: Annotated[str | None, Header(description="`respond-async` asks for a job.")] = None,
    idempotency_key: IdempotencyKey = None,
) -> Response:
    """Answer an analysis at once, or make a job of it when it is heavy or when asked to."""
    taken = take_in(stores, request)
    wants_job = "respond-async" in [p.strip().lower() for p in (prefer or "").split(",")]
    estimate = analyses.estimate(taken, stores.settings.synchronous_seconds)
    if not wants_job and estimate.mode == "sync":
        result = analyses.answer(taken)
        return Response(result.model_dump_json(), media_type="application/json")
    job, _ = enqueue(stores, taken, idempotency_key)
    document = job_document(job)
    headers = {"Location": document.links.self}
    if wants_job:
        headers["Preference-Applied"] = "respond-async"
    return Response(document.model_dump_json(), 202, media_type="application/json", headers=headers)


@router.post("/estimates", operation_id="estimate", responses=declared(400, 413, 415, 422, 503))
def estimate(request: AnalysisBody, stores: UsedStores) -> Estimate:
    """Say what an analysis would cost and how it would be answered, before anyone pays."""
    return analyses.estimate(take_in(stores, request), stores.settings.synchronous_seconds)
