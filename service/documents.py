"""From what is stored to what travels."""

from datetime import UTC, datetime

import analyses
from schemas.jobs import FieldFault, Job, JobError, Links, Progress
from schemas.kinds import StoredMechanismDocument
from schemas.mechanisms import parse_spec
from storage import Job as JobRow
from storage import StoredMechanism


def job_document(job: JobRow) -> Job:
    """Return a job as the API shows it."""
    here = f"/v1/jobs/{job.id}"
    return Job(
        id=job.id,
        analysis=job.analysis,
        mechanism=job.mechanism_id,
        state=job.state.value,
        progress=Progress(done=job.done, total=job.items, fraction=job.done / job.items),
        attempt=job.attempt,
        created=_time(job.created),
        started=None if job.started is None else _time(job.started),
        finished=None if job.finished is None else _time(job.finished),
        error=_error(job),
        links=Links(
            self=here,
            events=f"{here}/events",
            cancel=f"{here}/cancel",
            result=f"{here}/result",
            grid=f"{here}/grid" if analyses.has_grid(job.analysis) else None,
            figure=f"{here}/figure" if analyses.has_figure(job.analysis) else None,
        ),
    )


def mechanism_document(stored: StoredMechanism) -> StoredMechanismDocument:
    """Return a stored mechanism as the API shows it."""
    return StoredMechanismDocument(
        id=stored.id, created=_time(stored.created), mechanism=parse_spec(stored.spec_json)
    )


def _error(job: JobRow) -> JobError | None:
    if job.error is None:
        return None
    faults = [FieldFault(pointer=f.pointer, detail=f.detail) for f in job.error.errors]
    return JobError(kind=job.error.kind.value, detail=job.error.detail, errors=faults)


def _time(seconds: float) -> datetime:
    return datetime.fromtimestamp(seconds, UTC)
