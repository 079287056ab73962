"""Jobs: requests that are queued, run by workers and fetched."""

from datetime import datetime
from typing import Literal

from pydantic import Field

from schemas.quantities import Model

State = Literal["accepted", "running", "successful", "failed", "cancelled"]
ErrorKind = Literal["user", "system", "timeout", "memory", "lost"]


class Progress(Model):
    """How far a job has come, in poses, grid nodes or meshes."""

    done: int
    total: int
    fraction: float = Field(ge=0, le=1)


class FieldFault(Model):
    """What is wrong with one field of a failed job's request."""

    pointer: str
    detail: str


class JobError(Model):
    """Why a job failed."""

    kind: ErrorKind
    detail: str
    errors: list[FieldFault]


class Links(Model):
    """Where to go on from a job."""

    self: str
    events: str
    cancel: str
    result: str
    grid: str | None = Field(description="Null for analyses without a grid.")
    figure: str | None


class Job(Model):
    """A queued request and what became of it."""

    id: str
    analysis: str
    mechanism: str | None = Field(
        description="Id of the mechanism's canonical form; null where the request is about none."
    )
    state: State
    progress: Progress
    attempt: int = Field(description="How often an engine has taken it up.")
    created: datetime
    started: datetime | None
    finished: datetime | None
    error: JobError | None
    links: Links


class JobPage(Model):
    """Jobs, the newest first."""

    items: list[Job]
    next_page_token: str | None = Field(description="Null on the last page.")
