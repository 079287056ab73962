"""A folder with a database, and the engines and supervisors that tests start on it."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

import storage
from storage import Job, JobState

ROOT = Path(__file__).parents[2]
FAKE = Path(__file__).parent / "fake"
ENDED = (JobState.SUCCESSFUL, JobState.FAILED, JobState.CANCELLED)

# Short enough for tests that wait for them.
QUICK = {
    "PARMECH_LEASE_SECONDS": "2",
    "PARMECH_HEARTBEAT_SECONDS": "0.2",
    "PARMECH_PROCESSES": "2",
    "PARMECH_WORKER_MEMORY_BYTES": str(2**31),
}


def wait_until(condition: Callable[[], object], seconds: float = 60.0) -> None:
    """Wait for a condition; fail the test after `seconds`."""
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            pytest.fail(f"not within {seconds} s")
        time.sleep(0.01)


def is_alive(pid: int) -> bool:
    """Return whether a process runs; one that nobody has waited for yet does not."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except (FileNotFoundError, ProcessLookupError):
        return False
    return state != "Z"


class Works:
    """The folder; requests are those of fake/analyses.py."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        url = f"sqlite:///{folder / 'parmech.sqlite'}"
        storage.migrate(url)
        self.database = storage.open_database(url)
        self.jobs = storage.Jobs(self.database)
        self._processes: list[subprocess.Popen[bytes]] = []
        self._logs: dict[str, Path] = {}

    def start(self, *arguments: str, **settings: object) -> subprocess.Popen[bytes]:
        """Start a Python that finds the fakes before the packages they stand in for."""
        given = {f"PARMECH_{name.upper()}": str(value) for name, value in settings.items()}
        paths = {"PYTHONPATH": f"{FAKE}:{ROOT}", "PARMECH_DATA": str(self.folder)}
        process = subprocess.Popen(
            [sys.executable, *arguments],
            cwd=self.folder,
            env=os.environ | QUICK | paths | given,
            stdout=subprocess.PIPE,
        )
        self._processes.append(process)
        return process

    def start_engine(self, **settings: object) -> subprocess.Popen[bytes]:
        """Start an engine and wait until it beats."""
        before = self.beating()
        engine = self.start("-m", "workers", **settings)
        wait_until(lambda: self.beating() - before)
        return engine

    def close(self) -> None:
        """Kill what still runs."""
        for process in self._processes:
            process.kill()
            process.communicate()
        self.database.close()

    def beating(self) -> set[str]:
        """Return the engines that were heard of and did not stop in good order."""
        with self.database.reading() as connection:
            return set(connection.exec_driver_sql("SELECT owner FROM heartbeats").scalars())

    def submit(self, items: int = 4, items_per_tile: int = 1, **request: object) -> str:
        """Put a job into the queue and return its id."""
        log = self.folder / f"computed-{len(self._logs)}"
        request_json = json.dumps({"log": str(log)} | request)
        new = storage.NewJob("fake", request_json, items, items_per_tile, body_hash="")
        job, _ = self.jobs.create(new)
        self._logs[job.id] = log
        return job.id

    def wait_for(self, job_id: str, *states: JobState, seconds: float = 60.0) -> Job:
        """Wait until a job is in one of the states, the ended ones if none are named."""
        wait_until(lambda: self.jobs.get(job_id).state in (states or ENDED), seconds)
        return self.jobs.get(job_id)

    def wait_for_done(self, job_id: str, items: int) -> None:
        """Wait until so many items of a job are stored."""
        wait_until(lambda: self.jobs.get(job_id).done >= items)

    def begun(self, job_id: str) -> list[int]:
        """Return the first items of the tiles that were begun, in their order."""
        return [start for start, _ in self._begun(job_id)]

    def worker_pids(self, job_id: str) -> set[int]:
        """Return the processes that began a tile of a job."""
        return {pid for _, pid in self._begun(job_id)}

    def _begun(self, job_id: str) -> list[tuple[int, int]]:
        log = self._logs[job_id]
        lines = log.read_text().split() if log.exists() else []
        return [(int(start), int(pid)) for start, pid in (line.split(":") for line in lines)]
