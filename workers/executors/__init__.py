"""Where tiles are computed: local processes now, a cluster by the same interface."""

from workers.executors.interface import (
    Call,
    Died,
    Executor,
    ExecutorError,
    Outcome,
    Raised,
    Returned,
    TimedOut,
)
from workers.executors.local import LocalExecutor

__all__ = [
    "Call",
    "Died",
    "Executor",
    "ExecutorError",
    "LocalExecutor",
    "Outcome",
    "Raised",
    "Returned",
    "TimedOut",
]
