"""What the engine asks of whoever computes."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass


class ExecutorError(Exception):
    """The executor cannot compute anything, and trying again here will not help."""


@dataclass(frozen=True)
class Call:
    """A function of a module, so that it travels by name, and its arguments.

    Parameters
    ----------
    function : callable
        What to call in a worker process.
    arguments : tuple
        Its arguments; they are pickled.
    timeout_seconds : float
        The call is killed after this. [s]
    """

    function: Callable[..., object]
    arguments: tuple[object, ...]
    timeout_seconds: float


@dataclass(frozen=True)
class Returned:
    """The call returned a value."""

    value: object


@dataclass(frozen=True)
class Raised:
    """The call raised; `memory` tells whether it asked for more memory than it may have."""

    detail: str
    traceback: str
    memory: bool


@dataclass(frozen=True)
class TimedOut:
    """The call was killed because it took too long. [s]"""

    seconds: float


@dataclass(frozen=True)
class Died:
    """The process that computed the call ended; negative codes are signals."""

    exit_code: int | None


Outcome = Returned | Raised | TimedOut | Died


class Executor(ABC):
    """Computes calls somewhere else, as many at a time as it has room for.

    It is used from one thread. A call is known by the number that `start` returned.
    """

    @abstractmethod
    def room(self) -> int:
        """Return how many calls could start at once."""

    @abstractmethod
    def start(self, call: Call) -> int:
        """Start a call and return its number; needs room."""

    @abstractmethod
    def wait(self, timeout_seconds: float) -> list[tuple[int, Outcome]]:
        """Return the calls that ended, waiting for the first one up to the timeout.

        Raises
        ------
        ExecutorError : No worker process comes up.
        """

    @abstractmethod
    def kill(self, number: int) -> None:
        """Stop a call at once; it has no outcome. Does nothing for a call that ended."""

    @abstractmethod
    def close(self) -> None:
        """Stop everything at once."""
