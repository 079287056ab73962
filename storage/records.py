"""What storage hands out: frozen rows."""

import json
from dataclasses import asdict, dataclass
from enum import StrEnum
from typing import NamedTuple, Self


class JobState(StrEnum):
    """Where a job is in its life; it ends in one of the last three."""

    ACCEPTED = "accepted"
    RUNNING = "running"
    SUCCESSFUL = "successful"
    FAILED = "failed"
    CANCELLED = "cancelled"

    @property
    def ended(self) -> bool:
        """Whether nothing about the job changes any more."""
        return self not in (JobState.ACCEPTED, JobState.RUNNING)


class ErrorKind(StrEnum):
    """Whose fault a failure is, or which bound it broke."""

    USER = "user"
    SYSTEM = "system"
    TIMEOUT = "timeout"
    MEMORY = "memory"
    LOST = "lost"


class Fault(NamedTuple):
    """One thing wrong with one field of the request."""

    pointer: str
    detail: str


@dataclass(frozen=True)
class JobError:
    """Why a job failed."""

    kind: ErrorKind
    detail: str
    errors: tuple[Fault, ...] = ()

    def to_json(self) -> str:
        """Return the error as it is stored: `{kind, detail, errors: [{pointer, detail}]}`."""
        return json.dumps(asdict(self) | {"errors": [fault._asdict() for fault in self.errors]})

    @classmethod
    def from_json(cls, text: str) -> Self:
        """Return the error that `to_json` wrote."""
        stored = json.loads(text)
        faults = tuple(Fault(**fault) for fault in stored["errors"])
        return cls(ErrorKind(stored["kind"]), stored["detail"], faults)


class Cursor(NamedTuple):
    """Place in a list that is sorted newest first: the next page starts after it."""

    created: float
    id: str


@dataclass(frozen=True)
class StoredMechanism:
    """A mechanism's specification and the time it came. `created` in s since the epoch."""

    id: str
    spec_json: str
    created: float

    @property
    def cursor(self) -> Cursor:
        """The mechanism's place in the list."""
        return Cursor(self.created, self.id)


@dataclass(frozen=True)
class NewJob:
    """A job as it is asked for.

    Parameters
    ----------
    analysis : str
        Name of the analysis.
    request_json : str
        The whole canonical request, mechanism included.
    items, items_per_tile : int
        Items of work in all, and in every tile but the last. It never changes after.
    body_hash : str
        Hash of the body; tells a repeated request from a reused idempotency key.
    mechanism_id : str, optional
        Id of the mechanism that the request is about, if it is about one.
    idempotency_key : str, optional
        Under the same key the same job is returned for 24 h.
    """

    analysis: str
    request_json: str
    items: int
    items_per_tile: int
    body_hash: str
    mechanism_id: str | None = None
    idempotency_key: str | None = None


@dataclass(frozen=True)
class Job:
    """One row of the job table.

    Times are seconds since the epoch by the database's clock. `revision` grows with every change
    that a client can see. `done` and `items` count poses, grid nodes or meshes.
    """

    id: str
    analysis: str
    mechanism_id: str | None
    state: JobState
    items: int
    items_per_tile: int
    done: int
    attempt: int
    revision: int
    created: float
    started: float | None
    finished: float | None
    cancel_requested: bool
    owner: str | None
    lease_until: float | None
    error: JobError | None

    @property
    def cursor(self) -> Cursor:
        """The job's place in the list."""
        return Cursor(self.created, self.id)

    @property
    def tiles(self) -> int:
        """The number of tiles."""
        return -(-self.items // self.items_per_tile)

    def bounds(self, tile: int) -> tuple[int, int]:
        """Return the first item of a tile and the one after its last."""
        start = tile * self.items_per_tile
        return start, min(start + self.items_per_tile, self.items)
