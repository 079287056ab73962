"""Rows of the job table: read, and changed the same way from both sides."""

from typing import Any

from sqlalchemy import Connection, Row, select

from storage.clock import now
from storage.errors import JobNotFound
from storage.records import Job, JobError, JobState
from storage.tables import jobs


def to_job(row: Row[Any]) -> Job:
    """Return the job in a row of the job table."""
    values = row._asdict()
    values["state"] = JobState(row.state)
    values["error"] = None if row.error is None else JobError.from_json(row.error)
    return Job(**values)


def find_job(connection: Connection, job_id: str) -> Job:
    """Return one job as this transaction sees it.

    Raises
    ------
    JobNotFound : There is none of this id.
    """
    row = connection.execute(select(jobs).where(jobs.c.id == job_id)).one_or_none()
    if row is None:
        raise JobNotFound(job_id)
    return to_job(row)


def ended(state: JobState, error: JobError | None = None) -> dict[str, Any]:
    """Return what changes in a job's row when it ends."""
    return {
        "state": state,
        "finished": now(),
        "owner": None,
        "lease_until": None,
        "error": None if error is None else error.to_json(),
        "revision": jobs.c.revision + 1,
    }


def cancelled() -> dict[str, Any]:
    """Return what changes in a job's row when it is cancelled."""
    return ended(JobState.CANCELLED) | {"cancel_requested": True}
