"""A real `parmech serve` on a free port, its processes and its database."""

import os
import re
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, TypeVar

import httpx
import pytest

ROOT = Path(__file__).parents[2]
ENDED = ("successful", "failed", "cancelled")
MARK = "PARMECH_SERVED_FOR"
"""Variable by which the processes of a server are known, whoever their parent is."""

START_SECONDS = 120.0
"""The first start of all compiles the kernels."""

PROC = Path("/proc")
Found = TypeVar("Found")


def wait_until(look: Callable[[], Found | None], seconds: float = 60.0) -> Found:
    """Return what `look` returns as soon as it is true; fail the test after `seconds`."""
    deadline = time.monotonic() + seconds
    while True:
        found = look()
        if found:
            return found
        if time.monotonic() > deadline:
            pytest.fail(f"not within {seconds} s")
        time.sleep(0.02)


class Server:
    """A supervisor with a service and an engine over a folder.

    Parameters
    ----------
    folder : Path
        Where everything is kept; also what tells its processes from others.
    settings : str, float or int
        Settings by name.
    """

    def __init__(self, folder: Path, **settings: object) -> None:
        self.folder = folder
        self._environment = (
            {name: value for name, value in os.environ.items() if not name.startswith("PARMECH_")}
            | {f"PARMECH_{name.upper()}": str(value) for name, value in settings.items()}
            | {MARK: str(folder)}
        )
        self._supervisor: subprocess.Popen[bytes] | None = None
        self._client: httpx.Client | None = None
        self._starts = 0

    @property
    def supervisor(self) -> subprocess.Popen[bytes]:
        """The process of `parmech serve`."""
        assert self._supervisor is not None
        return self._supervisor

    @property
    def client(self) -> httpx.Client:
        """Speaks to the service."""
        assert self._client is not None
        return self._client

    @property
    def url(self) -> str:
        """Where the service listens."""
        return str(self.client.base_url)

    def begin(self, port: int = 0) -> None:
        """Start without waiting."""
        self._starts += 1
        command = [sys.executable, "-c", "import commands; commands.app()", "serve"]
        with self._out.open("wb") as out, self._log.open("wb") as log:
            self._supervisor = subprocess.Popen(
                [*command, "--port", str(port), "--data", str(self.folder / "data")],
                cwd=ROOT,
                env=self._environment,
                stdin=subprocess.DEVNULL,
                stdout=out,
                stderr=log,
                # Ctrl-C of whoever runs the tests is not for it.
                start_new_session=True,
            )

    def start(self, port: int = 0) -> None:
        """Start, and wait until all is ready."""
        self.begin(port)
        url = wait_until(self._announced, START_SECONDS)
        self._client = httpx.Client(base_url=url, timeout=60.0)

    @property
    def _out(self) -> Path:
        return self.folder / f"out-{self._starts}"

    @property
    def _log(self) -> Path:
        return self.folder / f"log-{self._starts}"

    @property
    def told(self) -> str:
        """All that was written to standard error since the last start."""
        return self._log.read_text()

    def _announced(self) -> str | None:
        assert self.supervisor.poll() is None, self.told
        found = re.search(r"ready at (http://\S+)", self._out.read_text())
        return found and found.group(1)

    def close(self) -> None:
        """End everything that still runs."""
        for pid in self.processes():
            kill(pid)
        if self._supervisor is not None:
            self._supervisor.wait()
        if self._client is not None:
            self._client.close()

    def processes(self) -> set[int]:
        """Return all running processes of this server, by their environment."""
        mark = f"{MARK}={self.folder}".encode()
        return {
            int(entry.name)
            for entry in PROC.iterdir()
            if entry.name.isdigit() and mark in _read(entry / "environ").split(b"\0")
        }

    def service(self) -> set[int]:
        """Return the process that speaks HTTP."""
        return {pid for pid in self.processes() if _command(pid).endswith("-m service")}

    def engine(self) -> set[int]:
        """Return the process of the engine."""
        return {pid for pid in self.processes() if _command(pid).endswith("-m workers")}

    def workers(self) -> set[int]:
        """Return the processes that compute: those forked from the fork server."""
        forked = {pid for pid in self.processes() if "multiprocessing.forkserver" in _command(pid)}
        return {pid for pid in forked if _parent(pid) in forked}

    def rows(self, statement: str, *values: object) -> list[tuple[Any, ...]]:
        """Return what a statement finds in the database, seen from outside."""
        with sqlite3.connect(self.folder / "data" / "parmech.sqlite", timeout=30) as connection:
            found = connection.execute(statement, values).fetchall()
        connection.close()
        return found

    def submit(self, request: dict[str, Any]) -> dict[str, Any]:
        """Return a new job."""
        answer = self.client.post("/v1/jobs", json=request)
        assert answer.status_code == 201, answer.text
        job: dict[str, Any] = answer.json()
        return job

    def look(self, job: dict[str, Any], **query: float) -> dict[str, Any]:
        """Return a job as it is now, or as it is after a wait."""
        answer = self.client.get(job["links"]["self"], params=query)
        assert answer.status_code == 200, answer.text
        now: dict[str, Any] = answer.json()
        return now

    def wait_for_progress(self, job: dict[str, Any], fraction: float = 0.0) -> dict[str, Any]:
        """Return a job once more than this fraction of it is done."""
        return wait_until(lambda: _past(self.look(job), fraction))

    def wait_for_end(self, job: dict[str, Any], seconds: float = 90.0) -> dict[str, Any]:
        """Return a job when it has ended."""
        deadline = time.monotonic() + seconds
        now = self.look(job)
        while now["state"] not in ENDED:
            if time.monotonic() > deadline:
                pytest.fail(f"{now} after {seconds} s; {self.told[-2000:]}")
            now = self.look(job, wait=2)
        return now

    def done(self, request: dict[str, Any]) -> dict[str, Any]:
        """Return a job of a request when it has succeeded."""
        job = self.wait_for_end(self.submit(request))
        assert job["state"] == "successful", job
        return job


@contextmanager
def serving(folder: Path, **settings: object) -> Iterator[Server]:
    """Yield a server that is ready, and end it and all of its processes."""
    server = Server(folder, **settings)
    try:
        server.start()
        yield server
    finally:
        server.close()


def kill(pid: int) -> None:
    """Kill a process, if it is still there."""
    with suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)


def _past(job: dict[str, Any], fraction: float) -> dict[str, Any] | None:
    assert job["state"] in ("accepted", "running"), f"it ended before it was looked at: {job}"
    return job if job["progress"]["fraction"] > fraction else None


def _read(path: Path) -> bytes:
    # A process may end while it is looked at; one that nobody has waited for yet has nothing.
    try:
        return path.read_bytes()
    except OSError:
        return b""


def _command(pid: int) -> str:
    return _read(PROC / str(pid) / "cmdline").rstrip(b"\0").replace(b"\0", b" ").decode()


def _parent(pid: int) -> int | None:
    fields = _read(PROC / str(pid) / "stat").rpartition(b")")[2].split()
    return int(fields[1]) if fields else None
