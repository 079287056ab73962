"""Turns errors into HTTP: the only place that does."""

from typing import Any

import structlog
from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import Response
from starlette.exceptions import HTTPException

import storage
from analyses import AnalysisError
from exports import ExportError
from schemas.problems import FieldProblem, Problem
from service.pointers import field_errors
from service.refusals import Refusal, invalid, not_found

log = structlog.get_logger()

PROBLEM_JSON = "application/problem+json"
RETRY_SECONDS = "5"
MOST_REPORTED = 20
LONGEST_DETAIL = 1200
MOST_TOLD = 3
"""Fields that a problem's `detail` names; `errors` has more."""

Responses = dict[int | str, dict[str, Any]]
"""How routes declare their answers to OpenAPI."""


def problem_response(refusal: Refusal) -> Response:
    """Return the problem details of a refusal."""
    reported = [
        FieldProblem(pointer=_printable(p), detail=_printable(d))
        for p, d in refusal.errors[:MOST_REPORTED]
    ]
    if more := len(refusal.errors) - len(reported):
        reported.append(FieldProblem(pointer="", detail=f"{more} more fields are invalid"))
    problem = Problem(
        type=f"/problems/{refusal.kind}",
        title=refusal.title,
        status=refusal.status,
        detail=_printable(refusal.detail, LONGEST_DETAIL),
        errors=reported,
    )
    return Response(
        problem.model_dump_json(),
        status_code=refusal.status,
        media_type=PROBLEM_JSON,
        headers=refusal.headers,
    )


def _printable(text: str, longest: int = 300) -> str:
    """Return text that can be sent, whatever a caller put into it, and not much longer."""
    cut = text if len(text) <= longest else text[:longest] + "..."
    return cut.encode("utf-8", "backslashreplace").decode()


def install(app: FastAPI) -> None:
    """Answer every error of this application as a problem."""
    for kind in (Refusal, AnalysisError, ExportError, storage.StorageRefusal):
        app.add_exception_handler(kind, _expected)
    app.add_exception_handler(RequestValidationError, _invalid_request)
    app.add_exception_handler(HTTPException, _http_exception)
    app.add_exception_handler(Exception, _unexpected)


def _expected(request: Request, error: Exception) -> Response:
    return problem_response(refusal_of(error))


def refusal_of(error: Exception) -> Refusal:
    """Return how an error of the packages below is answered."""
    match error:
        case Refusal():
            return error
        case AnalysisError():
            return nonsense(_in_short(error.errors), error.errors)
        case ExportError():
            return Refusal("not-exportable", 422, "This cannot be exported", str(error))
        case storage.MechanismNotFound():
            return not_found("mechanism", error.mechanism_id)
        case storage.JobNotFound():
            return not_found("job", error.job_id)
        case storage.JobStillRunning():
            return Refusal(
                "job-not-ended", 409, "The job has not ended", f"{error}; cancel it first"
            )
        case storage.IdempotencyConflict():
            return invalid("header:idempotency-key", str(error))
        case storage.QueueFull():
            return _busy("queue-full", "The queue is full", str(error))
        case _:
            return _busy("unavailable", "The database cannot be reached", str(error))


def nonsense(detail: str, errors: tuple[tuple[str, str], ...]) -> Refusal:
    """Return the refusal of a well-formed request that makes no sense."""
    return Refusal("invalid-request", 422, "The request makes no sense", detail, tuple(errors))


def _busy(kind: str, title: str, detail: str) -> Refusal:
    return Refusal(kind, 503, title, detail, headers={"Retry-After": RETRY_SECONDS})


def _invalid_request(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)
    if any(e["type"] == "json_invalid" for e in error.errors()):
        detail = "the body is not JSON: " + str(error.errors()[0].get("ctx", {}).get("error", ""))
        return problem_response(Refusal("not-json", 400, "The body is not JSON", detail))
    errors = tuple(field_errors(error.errors(), error.body))
    if isinstance(error.body, bytes):
        given = request.headers.get("content-type")
        detail = f"send the body as application/json; given {given!r}"
        return problem_response(
            Refusal("unsupported-media-type", 415, "The body is not declared as JSON", detail)
        )
    return problem_response(nonsense(_in_short(errors), errors))


def _in_short(errors: tuple[tuple[str, str], ...]) -> str:
    told = [f"{pointer or 'the body'}: {text}" for pointer, text in errors[:MOST_TOLD]]
    more = len(errors) - len(told)
    return "; ".join(told) + (f"; and {more} more" if more else "")


_TITLES = {
    400: ("bad-request", "The request cannot be read"),
    404: ("not-found", "Not found"),
    405: ("method-not-allowed", "Method not allowed"),
    413: ("body-too-large", "The body is larger than is allowed"),
    416: ("range-not-satisfiable", "The file has no such range"),
}


def _http_exception(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    refusal = refusal_of_status(error.status_code, f"{request.url.path}: {error.detail}")
    refusal.headers.update(error.headers or {})
    return problem_response(refusal)


def refusal_of_status(status: int, detail: str) -> Refusal:
    """Return the refusal that the web framework expressed as a bare status."""
    kind, title = _TITLES.get(status, ("error", "The request failed"))
    return Refusal(kind, status, title, detail)


def _unexpected(request: Request, error: Exception) -> Response:
    log.error("unexpected error", path=request.url.path, exc_info=error)
    return problem_response(
        Refusal("internal", 500, "Internal error", "an unexpected error occurred and was logged")
    )


def declared(*statuses: int) -> Responses:
    """Return how OpenAPI declares error answers of these statuses."""
    titles = {
        400: "The body is not JSON",
        404: "There is none of this id, or not yet",
        406: "None of the accepted types is offered",
        409: "The job has not ended",
        413: "The body is too large",
        415: "The body is not declared as JSON",
        422: "The request makes no sense; `errors` says which field, given and allowed",
        500: "The job failed in the system, or was lost",
        504: "A part of the job took too long",
        507: "The job needed more memory than there is",
        503: "The queue is full or the database cannot be reached; see Retry-After",
    }
    return {
        status: {
            "description": titles[status],
            "content": {PROBLEM_JSON: {"schema": {"$ref": "#/components/schemas/Problem"}}},
        }
        for status in statuses
    }
