"""Health and readiness on the wire."""

from typing import Literal

from pydantic import Field

from schemas.quantities import Model


class Health(Model):
    """The process answers."""

    status: Literal["alive"]


class Readiness(Model):
    """Everything that a job needs is there."""

    status: Literal["ready"]
    database: Literal["current"]
    worker_heartbeat_age: float = Field(description="Since a worker's last sign of life. [s]")
