"""`/v1/jobs`: submitting, watching, stopping and removing."""

import asyncio
from collections.abc import AsyncIterator
from typing import Annotated

from fastapi import APIRouter, Depends, Header, Query, Response
from fastapi.concurrency import run_in_threadpool
from fastapi.sse import EventSourceResponse, ServerSentEvent

from schemas.jobs import Job, JobPage, State
from service.documents import job_document
from service.paging import PageSize, PageToken, cursor_of, token_of
from service.problems import Responses, declared
from service.routers.analyses import AnalysisBody, IdempotencyKey
from service.stores import UsedStores
from service.submission import enqueue, take_in
from storage import Job as JobRow
from storage import JobNotFound, Jobs, JobState

router = APIRouter(prefix="/v1/jobs", tags=["jobs"])

LOOK_SECONDS = 0.05
"""Between two looks at a job that somebody waits for."""

LONGEST_WAIT = 60.0

_MADE_BEFORE: Responses = {200: {"model": Job, "description": "The key's job, made before."}}


@router.post(
    "",
    operation_id="create_job",
    status_code=201,
    responses=_MADE_BEFORE | declared(400, 413, 415, 422, 503),
)
def create_job(
    request: AnalysisBody,
    response: Response,
    stores: UsedStores,
    idempotency_key: IdempotencyKey = None,
) -> Job:
    """Queue an analysis; it is kept before this answers."""
    job, created = enqueue(stores, take_in(stores, request), idempotency_key)
    document = job_document(job)
    response.status_code = 201 if created else 200
    response.headers["Location"] = document.links.self
    return document


@router.get("", operation_id="list_jobs", responses=declared(422))
def list_jobs(
    stores: UsedStores,
    state: State | None = None,
    analysis: Annotated[str | None, Query(max_length=40)] = None,
    mechanism: Annotated[str | None, Query(max_length=40)] = None,
    page_token: PageToken = None,
    page_size: PageSize = 50,
) -> JobPage:
    """List jobs, the newest first."""
    rows = stores.jobs.page(
        state=None if state is None else JobState(state),
        analysis=analysis,
        mechanism_id=mechanism,
        after=cursor_of(page_token),
        size=page_size + 1,
    )
    more = len(rows) > page_size
    return JobPage(
        items=[job_document(row) for row in rows[:page_size]],
        next_page_token=token_of(rows[page_size - 1].cursor) if more else None,
    )


@router.get("/{job_id}", operation_id="get_job", responses=declared(404, 422))
async def get_job(
    job_id: str,
    stores: UsedStores,
    wait: Annotated[
        float, Query(ge=0, le=LONGEST_WAIT, description="Wait up to this long for the end. [s]")
    ] = 0.0,
) -> Job:
    """Return a job, at once or when it has ended."""
    loop = asyncio.get_running_loop()
    deadline = loop.time() + wait
    job = await run_in_threadpool(stores.jobs.get, job_id)
    while not job.state.ended and loop.time() < deadline:
        await asyncio.sleep(LOOK_SECONDS)
        job = await run_in_threadpool(stores.jobs.get, job_id)
    return job_document(job)


def _existing(job_id: str, stores: UsedStores) -> JobRow:
    return stores.jobs.get(job_id)


@router.get(
    "/{job_id}/events",
    operation_id="watch_job",
    response_class=EventSourceResponse,
    responses=declared(404),
)
async def watch_job(
    job: Annotated[JobRow, Depends(_existing)],
    stores: UsedStores,
    last_event_id: Annotated[str | None, Header()] = None,
) -> AsyncIterator[ServerSentEvent]:
    """Stream `state` and `progress` events until the job ends; Last-Event-ID resumes."""
    seen = last_event_id
    told: JobState | None = None
    while True:
        if str(job.revision) != seen:
            seen = str(job.revision)
            kind = "progress" if job.state is told else "state"
            told = job.state
            yield ServerSentEvent(event=kind, id=seen, data=job_document(job))
        if job.state.ended:
            return
        await asyncio.sleep(LOOK_SECONDS)
        again = await run_in_threadpool(_if_there, stores.jobs, job.id)
        if again is None:
            return
        job = again


def _if_there(jobs: Jobs, job_id: str) -> JobRow | None:
    try:
        return jobs.get(job_id)
    except JobNotFound:
        return None


@router.post("/{job_id}/cancel", operation_id="cancel_job", responses=declared(404))
def cancel_job(job_id: str, stores: UsedStores) -> Job:
    """Stop a job; one that has ended stays as it is."""
    return job_document(stores.jobs.request_cancel(job_id))


@router.delete(
    "/{job_id}", operation_id="delete_job", status_code=204, responses=declared(404, 409)
)
def delete_job(job_id: str, stores: UsedStores) -> None:
    """Remove an ended job with its result and arrays."""
    stores.jobs.delete(job_id)
    stores.artefacts.drop(job_id)
