"""What storage refuses to do, each error carrying the values that explain it."""


class StorageRefusal(Exception):  # noqa: N818  (these names say what is the case)
    """Root of everything that storage raises on purpose."""


class DatabaseUnavailable(StorageRefusal):
    """The database could not be reached or stayed locked; trying again may help."""


class MechanismNotFound(StorageRefusal):
    """No mechanism is stored under this id."""

    def __init__(self, mechanism_id: str) -> None:
        super().__init__(f"no mechanism {mechanism_id!r}")
        self.mechanism_id = mechanism_id


class JobNotFound(StorageRefusal):
    """No job has this id."""

    def __init__(self, job_id: str) -> None:
        super().__init__(f"no job {job_id!r}")
        self.job_id = job_id


class JobStillRunning(StorageRefusal):
    """The job has not ended, so it cannot be removed."""

    def __init__(self, job_id: str, state: str) -> None:
        super().__init__(f"job {job_id!r} is {state}")
        self.job_id = job_id
        self.state = state


class IdempotencyConflict(StorageRefusal):
    """The idempotency key was used for another body."""

    def __init__(self, key: str) -> None:
        super().__init__(f"idempotency key {key!r} belongs to another request")
        self.key = key


class QueueFull(StorageRefusal):
    """As many jobs wait as are allowed to."""

    def __init__(self, waiting: int, limit: int) -> None:
        super().__init__(f"{waiting} jobs wait, {limit} may")
        self.waiting = waiting
        self.limit = limit


class LeaseLost(StorageRefusal):
    """The job is no longer this engine's: another took it, or it was ended from outside."""

    def __init__(self, job_id: str, owner: str, attempt: int) -> None:
        super().__init__(f"job {job_id!r} is not attempt {attempt} of {owner!r} any more")
        self.job_id = job_id
        self.owner = owner
        self.attempt = attempt


class DatabaseUnsupported(StorageRefusal):
    """Neither SQLite nor PostgreSQL, or its driver is not installed."""

    def __init__(self, backend: str, reason: str) -> None:
        super().__init__(f"a database of the kind {backend!r} cannot be used: {reason}")
        self.backend = backend
