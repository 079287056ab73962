"""`/v1/jobs/{id}/result|grid|figure`: what a successful job has made."""

import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Header, Query, Response
from fastapi.responses import FileResponse

import analyses
from exports import draw_figure, write_csv, write_npz, write_whole
from schemas.analyses import AnalysisResult, Request
from schemas.workspace import WorkspaceRequest
from service.etags import is_known
from service.problems import Responses, declared
from service.refusals import Refusal
from service.stores import Stores, UsedStores
from storage import ErrorKind, Job, JobState

router = APIRouter(prefix="/v1/jobs/{job_id}", tags=["results"])

GridFormat = Literal["npz", "csv"]
FigureFormat = Literal["png", "svg"]
MEDIA_TYPES = {
    "npz": "application/x-npz",
    "csv": "text/csv",
    "png": "image/png",
    "svg": "image/svg+xml",
}
IfNoneMatch = Annotated[str | None, Header()]
Accept = Annotated[str | None, Header()]
_STATUS = {
    ErrorKind.USER: 422,
    ErrorKind.TIMEOUT: 504,
    ErrorKind.MEMORY: 507,
    ErrorKind.SYSTEM: 500,
    ErrorKind.LOST: 500,
}


def _binary(*formats: str) -> Responses:
    content = {MEDIA_TYPES[f]: {"schema": {"type": "string", "format": "binary"}} for f in formats}
    return {
        200: {"description": "The file.", "content": content},
        206: {"description": "A range of the file."},
        304: {"description": "It has not changed."},
    }


@router.get(
    "/result",
    operation_id="get_result",
    response_model=AnalysisResult,
    responses=declared(404, 422, 500, 504, 507),
)
def get_result(job_id: str, stores: UsedStores) -> Response:
    """Return the result; a failed job answers with its stored problem."""
    _successful(stores, job_id)
    return Response(stores.jobs.result(job_id), media_type="application/json")


@router.get(
    "/grid",
    operation_id="get_grid",
    response_class=FileResponse,
    responses=_binary("npz", "csv") | declared(404, 406, 422, 500, 504, 507),
)
def get_grid(
    job_id: str,
    stores: UsedStores,
    format: Annotated[GridFormat | None, Query()] = None,
    accept: Accept = None,
    if_none_match: IfNoneMatch = None,
) -> Response:
    """Return the arrays of a workspace over its whole grid: `inside`, `reason`, fields, axes."""
    _successful(stores, job_id)
    request = _gridded(stores, job_id)
    chosen = format or _accepted(accept, ("npz", "csv"))
    write = {"npz": write_npz, "csv": write_csv}[chosen]

    def make(path: Path) -> None:
        write(path, analyses.dense_grid(request, partial(stores.jobs.tiles, job_id)))

    return _file(stores, job_id, f"grid.{chosen}", if_none_match, make)


@router.get(
    "/figure",
    operation_id="get_figure",
    response_class=FileResponse,
    responses=_binary("png", "svg") | declared(404, 406, 422, 500, 504, 507),
)
def get_figure(
    job_id: str,
    stores: UsedStores,
    format: Annotated[FigureFormat | None, Query()] = None,
    field: Annotated[
        str | None,
        Query(
            max_length=60,
            description="Of a workspace a kept field, or `<field>_<leg>`, shown as colours; of "
            "friction `loss` or `input_torque`.",
        ),
    ] = None,
    accept: Accept = None,
    if_none_match: IfNoneMatch = None,
) -> Response:
    """Return a picture: of a workspace, or of a gear train's friction over the mesh cycle.

    A workspace is shown by its region, a field as colours and the mechanism in a pose.
    """
    _successful(stores, job_id)
    request = _pictured(stores, job_id)
    chosen: FigureFormat = format or _accepted(accept, ("png", "svg"))
    # Before the field's name becomes part of a file's.
    analyses.check_picture(request, field)

    def make(path: Path) -> None:
        picture = analyses.picture(request, partial(stores.jobs.tiles, job_id), field)
        write_whole(path, draw_figure(picture, chosen))

    return _file(stores, job_id, f"figure-{field or 'default'}.{chosen}", if_none_match, make)


def _successful(stores: Stores, job_id: str) -> Job:
    job = stores.jobs.get(job_id)
    if job.state is JobState.FAILED and job.error is not None:
        error = job.error
        faults = tuple((f.pointer, f.detail) for f in error.errors)
        status = _STATUS[error.kind]
        raise Refusal(f"job-{error.kind.value}", status, "The job failed", error.detail, faults)
    if job.state is JobState.CANCELLED:
        raise Refusal("job-cancelled", 404, "The job was cancelled", "it has no result")
    if job.state is not JobState.SUCCESSFUL:
        detail = f"the job is {job.state.value}; {job.done} of {job.items} done"
        raise Refusal("result-not-ready", 404, "The result is not ready", detail)
    return job


def _gridded(stores: Stores, job_id: str) -> WorkspaceRequest:
    request = analyses.parse(stores.jobs.request(job_id))
    if isinstance(request, WorkspaceRequest):
        return request
    raise _lacking(request, "grid")


def _pictured(stores: Stores, job_id: str) -> Request:
    request = analyses.parse(stores.jobs.request(job_id))
    if analyses.has_figure(request.analysis):
        return request
    raise _lacking(request, "figure")


def _lacking(request: Request, what: str) -> Refusal:
    detail = f"the analysis {request.analysis} has no {what}; fetch the result"
    return Refusal(f"no-{what}", 404, f"There is no {what}", detail)


def _accepted(accept: str | None, formats: tuple[str, ...]) -> Any:  # noqa: ANN401
    """Return the offered format that the Accept header ranks highest; by default the first."""
    for wanted in _by_rank(accept or "*/*"):
        for name in formats:
            if _matches(wanted, MEDIA_TYPES[name]):
                return name
    offered = ", ".join(MEDIA_TYPES[name] for name in formats)
    raise Refusal("not-acceptable", 406, "Not acceptable", f"given {accept!r}; offered: {offered}")


def _by_rank(accept: str) -> list[str]:
    """Return the media types of an Accept header, the most wanted first, without those refused."""
    ranked = []
    for part in accept.lower().split(","):
        media_type, *parameters = (word.strip() for word in part.split(";"))
        ranks = [p.removeprefix("q=") for p in parameters if p.startswith("q=")]
        rank = float(ranks[0]) if ranks and re.fullmatch(r"[01](\.\d*)?", ranks[0]) else 1.0
        if rank > 0.0:
            ranked.append((-rank, media_type))
    return [media_type for _, media_type in sorted(ranked, key=lambda entry: entry[0])]


def _matches(wanted: str, offered: str) -> bool:
    general = wanted == "*/*" or wanted == offered.split("/")[0] + "/*"
    # Every file is a stream of octets.
    return general or wanted in (offered, "application/octet-stream")


def _file(
    stores: Stores,
    job_id: str,
    name: str,
    if_none_match: str | None,
    make: Callable[[Path], None],
) -> Response:
    # A job's result never changes and files are written deterministically: the name is enough.
    etag = f'"{job_id}-{name}"'
    if is_known(etag, if_none_match):
        return Response(status_code=304, headers={"ETag": etag})
    path = stores.artefacts.fetch(job_id, name, make)
    return FileResponse(
        path,
        media_type=MEDIA_TYPES[path.suffix[1:]],
        filename=f"{job_id}-{name}",
        headers={"ETag": etag, "Vary": "Accept"},
        content_disposition_type="inline",
    )
