"""Worker processes on this machine, each with a pipe of its own.

Nothing is shared between them, no queue and no lock: a worker may be killed at any moment, in the
middle of a message too, and the others never notice.
"""

import multiprocessing
import pickle
import time
from collections.abc import Callable, Container, Iterable
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.context import ForkServerContext, ForkServerProcess

import structlog

from workers.executors.interface import (
    Call,
    Died,
    Executor,
    ExecutorError,
    Outcome,
    TimedOut,
)
from workers.executors.process import serve

# A worker that dies before it is ready so many times in a row will not come up at all.
_MOST_FAILED_STARTS = 5

_log = structlog.get_logger()


@dataclass(eq=False)
class _Worker:
    process: ForkServerProcess
    pipe: Connection
    ready: bool = False
    number: int | None = None
    timeout_seconds: float = 0.0
    deadline: float = float("inf")


class LocalExecutor(Executor):
    """A fixed number of worker processes; one that ends is replaced.

    Parameters
    ----------
    processes : int
        How many.
    warm : callable
        Called once in every process before its first call.
    memory_bytes : int, optional
        Address space of one process; more is a `MemoryError` in the call.
    """

    def __init__(
        self, processes: int, warm: Callable[[], None], memory_bytes: int | None = None
    ) -> None:
        self._context = _context(warm.__module__)
        self._setup = (warm, memory_bytes)
        self._failed_starts = 0
        self._started = 0
        self._workers = [self._new_worker() for _ in range(processes)]

    def room(self) -> int:
        """Return how many workers are ready and idle."""
        return sum(worker.ready and worker.number is None for worker in self._workers)

    def start(self, call: Call) -> int:
        """Send a call to an idle worker and return its number."""
        worker = next(worker for worker in self._workers if worker.ready and worker.number is None)
        self._started += 1
        worker.number = self._started
        worker.timeout_seconds = call.timeout_seconds
        worker.deadline = time.monotonic() + call.timeout_seconds
        try:
            worker.pipe.send((call.function, call.arguments))
        except OSError:
            # It has just died; `wait` will find it so.
            _log.warning("worker closed its pipe", pid=worker.process.pid)
        return worker.number

    def wait(self, timeout_seconds: float) -> list[tuple[int, Outcome]]:
        """Return the calls that ended, waiting for the first one up to the timeout."""
        deadline = min(worker.deadline for worker in self._workers)
        timeout = max(0.0, min(timeout_seconds, deadline - time.monotonic()))
        signs = wait(list(self._signs()), timeout)
        ended = [self._look(worker, signs) for worker in tuple(self._workers)]
        return [outcome for outcome in ended if outcome is not None]

    def kill(self, number: int) -> None:
        """Kill the worker that computes a call."""
        for worker in tuple(self._workers):
            if worker.number == number:
                self._replace(worker)

    def close(self) -> None:
        """Kill all workers."""
        for worker in self._workers:
            worker.process.kill()
        for worker in self._workers:
            _bury(worker)
        self._workers = []

    def _signs(self) -> Iterable[Connection | int]:
        for worker in self._workers:
            yield worker.pipe
            yield worker.process.sentinel

    def _look(self, worker: _Worker, signs: Container[object]) -> tuple[int, Outcome] | None:
        """Return what became of the worker's call if that is known now."""
        number = worker.number
        outcome: Outcome | None = None
        if worker.pipe in signs:
            outcome = self._receive(worker)
        elif worker.process.sentinel in signs:
            outcome = self._note_death(worker)
        elif time.monotonic() >= worker.deadline:
            outcome = TimedOut(worker.timeout_seconds)
            self._replace(worker)
        return None if outcome is None or number is None else (number, outcome)

    def _receive(self, worker: _Worker) -> Outcome | None:
        try:
            message = worker.pipe.recv()
        except (EOFError, OSError, pickle.UnpicklingError):
            return self._note_death(worker)
        if not worker.ready:
            worker.ready = True
            self._failed_starts = 0
            return None
        worker.number = None
        worker.deadline = float("inf")
        outcome: Outcome = message
        return outcome

    def _note_death(self, worker: _Worker) -> Outcome:
        self._replace(worker)
        code = worker.process.exitcode
        _log.warning("worker died", pid=worker.process.pid, exit_code=code, ready=worker.ready)
        if not worker.ready:
            self._failed_starts += 1
            if self._failed_starts >= _MOST_FAILED_STARTS:
                raise ExecutorError(f"worker processes end with {code} before they are ready")
        return Died(code)

    def _replace(self, worker: _Worker) -> None:
        worker.process.kill()
        _bury(worker)
        self._workers[self._workers.index(worker)] = self._new_worker()

    def _new_worker(self) -> _Worker:
        ours, theirs = self._context.Pipe()
        process = self._context.Process(
            target=serve, args=(theirs, *self._setup), name="parmech-worker", daemon=True
        )
        process.start()
        # Only the worker may hold its end, or its death would not close the pipe.
        theirs.close()
        return _Worker(process, ours)


def _context(preloaded: str) -> ForkServerContext:
    # Forked from a small server that has imported the kernels: a new worker is there at once,
    # and inherits neither the engine's threads nor its database connections.
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload([preloaded])
    return context


def _bury(worker: _Worker) -> None:
    worker.process.join()
    worker.pipe.close()
