"""The engine: takes jobs, has their tiles computed in turn, keeps what comes back."""

import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import structlog

import storage
from settings import Settings
from workers.executors import Died, Executor, Outcome, Raised, Returned
from workers.failures import to_job_error
from workers.pulse import Pulse
from workers.running import RunningJob, take_up
from workers.tiles import Refused

# Calls of a job that ended get so long to end by themselves: a killed worker must start anew. [s]
_GRACE_SECONDS = 1.0

# After the database could not be reached. [s]
_PAUSE_SECONDS = 0.5

# Results that wait for the database; with more of them nothing new is computed.
_MOST_WRITES = 32

_log = structlog.get_logger()


@dataclass(frozen=True)
class _Flight:
    """A piece of a job that is being computed."""

    running: RunningJob
    piece: int


@dataclass(frozen=True)
class _Write:
    """A change that waits for the database; `last` ends the job here."""

    running: RunningJob
    apply: Callable[[], object]
    last: bool


class Engine:
    """Runs jobs until it is told to stop.

    Parameters
    ----------
    database_url : str
        Where the jobs are; worker processes read the tiles there when they assemble a result.
    queue : Queue
        The jobs, in this engine's name.
    executor : Executor
        Who computes.
    pulse : Pulse
        Renews the leases; not started yet.
    settings : Settings
        Bounds and periods.
    """

    def __init__(
        self,
        *,
        database_url: str,
        queue: storage.Queue,
        executor: Executor,
        pulse: Pulse,
        settings: Settings,
    ) -> None:
        self._database_url = database_url
        self._queue = queue
        self._executor = executor
        self._pulse = pulse
        self._settings = settings
        # In the order of their turns.
        self._running: deque[RunningJob] = deque()
        self._flights: dict[int, _Flight] = {}
        self._writes: deque[_Write] = deque()
        # Calls of jobs that ended, and when they are killed.
        self._overdue: dict[int, float] = {}
        # Not an Event: setting one in a signal handler may deadlock with the code it interrupts.
        self._stopping = False

    def stop(self) -> None:
        """Let `run` give its jobs back and return; may be called from a signal handler."""
        self._stopping = True

    def run(self) -> None:
        """Run jobs until `stop`.

        Raises
        ------
        ExecutorError : No worker process comes up.
        """
        try:
            self._await_workers()
            with self._pulse:
                while not self._stopping:
                    self._turn()
        finally:
            self._executor.close()
        # Only in good order: the jobs of an engine that breaks count an attempt.
        self._give_back()

    def _await_workers(self) -> None:
        while not (self._stopping or self._executor.room()):
            self._executor.wait(self._settings.poll_seconds)

    def _turn(self) -> None:
        for number, outcome in self._executor.wait(self._settings.poll_seconds):
            self._overdue.pop(number, None)
            flight = self._flights.pop(number, None)
            if flight is not None:
                self._settle(flight, outcome)
        # Before the database is asked anything: idle workers are what costs.
        self._dispatch()
        self._kill_overdue()
        try:
            self._write()
            self._look_for_ends()
            self._claim()
        except storage.DatabaseUnavailable as error:
            _log.warning("database unavailable", reason=str(error))
            time.sleep(_PAUSE_SECONDS)
        self._dispatch()

    def _settle(self, flight: _Flight, outcome: Outcome) -> None:
        """Put what follows from an outcome into the line of writes."""
        running, piece = flight.running, flight.piece
        match outcome:
            case Returned(Refused() as refused):
                self._fail(running, to_job_error(refused))
            case Returned(bytes() as packed):
                self._append(running, lambda: self._store(running, piece, packed))
            case Returned(str() as result):
                succeed = partial(self._queue.succeed, running.job, result)
                self._append(running, lambda: self._keep(running, succeed), last=True)
            case Returned(value):
                raise TypeError(f"a worker returned {type(value).__name__}")
            case Died() if running.deaths[piece] < self._settings.tile_retries:
                running.deaths[piece] += 1
                running.waiting.appendleft(piece)
            case _:
                if isinstance(outcome, Raised):
                    _log.error("call failed", job=running.job.id, traceback=outcome.traceback)
                self._fail(running, to_job_error(outcome))

    def _store(self, running: RunningJob, piece: int, packed: bytes) -> None:
        self._keep(running, partial(self._queue.store_tile, running.job, piece, packed))
        running.tile_stored()

    def _keep(self, running: RunningJob, write: Callable[[], object]) -> None:
        """Write; what the database will never take fails its job and not the engine."""
        try:
            write()
        except storage.StorageRefusal:
            raise
        except Exception:
            _log.exception("result refused by the database", job=running.job.id)
            error = storage.JobError(storage.ErrorKind.SYSTEM, "the result cannot be stored")
            self._queue.fail(running.job, error)
            self._drop(running)

    def _fail(self, running: RunningJob, error: storage.JobError) -> None:
        self._append(running, lambda: self._queue.fail(running.job, error), last=True)

    def _append(
        self, running: RunningJob, apply: Callable[[], object], *, last: bool = False
    ) -> None:
        self._writes.append(_Write(running, apply, last))
        if last:
            running.waiting.clear()

    def _write(self) -> None:
        """Apply the writes in their order; one that cannot be applied now stays first."""
        while self._writes:
            write = self._writes[0]
            if write.running in self._running:
                self._apply(write)
            self._writes.popleft()

    def _apply(self, write: _Write) -> None:
        try:
            write.apply()
        except storage.LeaseLost as error:
            _log.warning("job lost", reason=str(error))
            self._drop(write.running)
        if write.last:
            self._drop(write.running)

    def _look_for_ends(self) -> None:
        """Stop the jobs that are to be cancelled, or that are not ours any more."""
        lost = self._pulse.turn()
        to_cancel = self._queue.to_cancel() if self._running else set()
        for running in tuple(self._running):
            if running.job.id in lost:
                _log.warning("job lost", job=running.job.id)
                self._drop(running)
            elif running.job.id in to_cancel:
                self._cancel(running)

    def _cancel(self, running: RunningJob) -> None:
        try:
            self._queue.cancel(running.job)
        except storage.LeaseLost as error:
            _log.warning("job lost", reason=str(error))
        self._drop(running)

    def _drop(self, running: RunningJob) -> None:
        """Forget a job; its calls get a little time to end before they are killed."""
        self._pulse.let_go(running.job)
        if running in self._running:
            self._running.remove(running)
        running.waiting.clear()
        deadline = time.monotonic() + _GRACE_SECONDS
        for number, flight in tuple(self._flights.items()):
            if flight.running is running:
                del self._flights[number]
                self._overdue[number] = deadline

    def _kill_overdue(self) -> None:
        for number, deadline in tuple(self._overdue.items()):
            if time.monotonic() >= deadline:
                del self._overdue[number]
                self._executor.kill(number)

    def _claim(self) -> None:
        while len(self._running) < self._settings.concurrent_jobs:
            job = self._queue.claim()
            if job is None:
                return
            # Should this fail, the lease runs out and the job is taken again.
            running = take_up(self._queue, job)
            self._pulse.hold(job)
            self._running.append(running)

    def _dispatch(self) -> None:
        """Give every idle worker a piece, the jobs taking turns."""
        passed_over = 0
        if len(self._writes) > _MOST_WRITES:
            return
        while self._executor.room() and passed_over < len(self._running):
            running = self._running[0]
            self._running.rotate(-1)
            if not running.waiting:
                passed_over += 1
                continue
            passed_over = 0
            piece = running.waiting.popleft()
            call = running.call(piece, self._database_url, self._settings.tile_timeout_seconds)
            self._flights[self._executor.start(call)] = _Flight(running, piece)

    def _give_back(self) -> None:
        """Release the jobs, so that another engine goes on at once."""
        try:
            self._write()
            for running in self._running:
                self._release(running.job)
        except storage.DatabaseUnavailable as error:
            # The leases will run out.
            _log.warning("jobs not released", reason=str(error))

    def _release(self, job: storage.Job) -> None:
        try:
            self._queue.release(job)
        except storage.LeaseLost as error:
            _log.warning("job lost", reason=str(error))
