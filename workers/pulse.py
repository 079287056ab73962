"""Signs of life: leases and the heartbeat, from a thread of their own."""

import threading
import time
from typing import Self

import structlog

import storage

_log = structlog.get_logger()


class Pulse:
    """Renews the leases of the jobs in hand and beats, while the engine's loop turns.

    A thread, because storing a large tile must not cost a lease. It falls silent with a loop that
    hangs, so that another engine can take over.

    Parameters
    ----------
    queue, heartbeats : Queue, Heartbeats
        Where to write.
    owner : str
        Name of the engine.
    lease_seconds, heartbeat_seconds : float
        How long a lease lasts and how often to beat. [s]
    """

    def __init__(
        self,
        queue: storage.Queue,
        heartbeats: storage.Heartbeats,
        owner: str,
        *,
        lease_seconds: float,
        heartbeat_seconds: float,
    ) -> None:
        self._queue = queue
        self._heartbeats = heartbeats
        self._owner = owner
        self._lease_seconds = lease_seconds
        self._period = min(heartbeat_seconds, lease_seconds / 4)
        self._lock = threading.Lock()
        self._held: dict[str, storage.Job] = {}
        self._lost: set[str] = set()
        self._turned = time.monotonic()
        self._stopping = threading.Event()
        self._thread = threading.Thread(target=self._run, name="pulse", daemon=True)

    def __enter__(self) -> Self:
        """Start to beat."""
        # Workers may have compiled for minutes since this was made.
        self._turned = time.monotonic()
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        """Fall silent."""
        self._stopping.set()
        self._thread.join()

    def hold(self, job: storage.Job) -> None:
        """Renew the lease of this job from now on."""
        with self._lock:
            self._held[job.id] = job

    def let_go(self, job: storage.Job) -> None:
        """Leave the lease of this job alone from now on."""
        with self._lock:
            self._held.pop(job.id, None)
            self._lost.discard(job.id)

    def turn(self) -> set[str]:
        """Note that the loop turns; return the ids of the jobs that are not ours any more."""
        self._turned = time.monotonic()
        with self._lock:
            return set(self._lost)

    def _run(self) -> None:
        while True:
            self._sign()
            if self._stopping.wait(self._period):
                return

    def _sign(self) -> None:
        if time.monotonic() - self._turned > self._lease_seconds:
            _log.error("the engine's loop hangs", owner=self._owner)
            return
        try:
            self._beat()
        except storage.DatabaseUnavailable as error:
            _log.warning("no sign of life", owner=self._owner, reason=str(error))

    def _beat(self) -> None:
        self._heartbeats.beat(self._owner)
        with self._lock:
            held = tuple(self._held.values())
        for job in held:
            if not self._queue.renew(job):
                with self._lock:
                    # Unless it ended meanwhile by our own hand.
                    if self._held.get(job.id) is job:
                        self._lost.add(job.id)
