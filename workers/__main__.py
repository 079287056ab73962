"""`python -m workers`: one engine, until SIGTERM or Ctrl-C."""

import os
import signal
import socket
import sys
from uuid import uuid4

import structlog

import lifeline
import logs
import storage
from settings import Settings
from workers import tiles
from workers.engine import Engine
from workers.executors import Executor, ExecutorError, LocalExecutor
from workers.pulse import Pulse

_log = structlog.get_logger()


def main() -> int:
    """Run an engine with the settings of the environment; return the exit status."""
    lifeline.watch()
    logs.configure()
    settings = Settings()
    # Never used twice, so that an earlier run's leases are not taken for ours.
    owner = f"{socket.gethostname()[:64]}:{os.getpid()}:{uuid4().hex}"
    database = storage.open_database(settings.resolved_database_url)
    try:
        if not database.is_current():
            _log.error("the database is not migrated: run `parmech migrate`")
            return 1
        _run(settings, database, owner)
    except (storage.DatabaseUnavailable, ExecutorError) as error:
        _log.error("engine stopped", reason=str(error))
        return 1
    finally:
        database.close()
    return 0


def _run(settings: Settings, database: storage.Database, owner: str) -> None:
    heartbeats = storage.Heartbeats(database)
    engine = _assemble_engine(settings, database, heartbeats, owner)
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda *_: engine.stop())
    _log.info("engine starts", owner=owner, processes=settings.processes)
    engine.run()
    heartbeats.end(owner)
    _log.info("engine stopped", owner=owner)


def _assemble_engine(
    settings: Settings, database: storage.Database, heartbeats: storage.Heartbeats, owner: str
) -> Engine:
    lease = settings.lease_seconds
    queue = storage.Queue(database, owner, lease_seconds=lease, max_attempts=settings.max_attempts)
    pulse = Pulse(
        queue,
        heartbeats,
        owner,
        lease_seconds=lease,
        heartbeat_seconds=settings.heartbeat_seconds,
    )
    return Engine(
        database_url=settings.resolved_database_url,
        queue=queue,
        executor=_executor(settings),
        pulse=pulse,
        settings=settings,
    )


def _executor(settings: Settings) -> Executor:
    # The processes are the parallelism; threads below them would only take each other's cores.
    for library in ("OMP", "OPENBLAS", "MKL", "NUMBA"):
        os.environ.setdefault(f"{library}_NUM_THREADS", "1")
    return LocalExecutor(settings.processes, tiles.warm, settings.worker_memory_bytes)


if __name__ == "__main__":
    sys.exit(main())
