"""The `parmech` command."""

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from http import HTTPStatus
from http.client import HTTPConnection, HTTPException
from pathlib import Path
from typing import Annotated

import typer

import lifeline
import storage
from settings import Settings

# A child that dies is started anew after this, twice as long each time, up to the second. [s]
_FIRST_PAUSE, _LONGEST_PAUSE = 0.2, 10.0

# A child that lived so long died of something new. [s]
_HEALTHY_SECONDS = 30.0

# Children that were asked to stop are killed after this. [s]
_STOP_SECONDS = 8.0

_TICK_SECONDS = 0.1

app = typer.Typer(no_args_is_help=True, add_completion=False)

Data = Annotated[Path | None, typer.Option(help="Folder of the database and the files.")]


@app.command()
def migrate(data: Data = None) -> None:
    """Bring the database up to this version."""
    with _told_errors():
        storage.migrate(_settings(data=data).resolved_database_url)


@app.command()
def serve(
    host: Annotated[str | None, typer.Option(help="Address to listen on.")] = None,
    port: Annotated[
        int | None, typer.Option(min=0, max=65535, help="Port; 0 takes a free one.")
    ] = None,
    data: Data = None,
) -> None:
    """Serve HTTP and run jobs until Ctrl-C."""
    with _told_errors():
        settings = _settings(host=host, port=port, data=data)
        free_port = _free_port(settings.host, settings.port)
        storage.migrate(settings.resolved_database_url)
    environment = {
        "PARMECH_HOST": settings.host,
        "PARMECH_PORT": str(free_port),
        "PARMECH_DATA": str(settings.data.resolve()),
    }
    children = [Child(module, environment) for module in ("service", "workers")]
    Supervisor(children, settings.host, free_port).run()


class Child:
    """A process that is started anew whenever it dies.

    Its standard input is a pipe whose other end only this process holds, so it hears of our end
    however we end.

    Parameters
    ----------
    module : str
        What `python -m` runs.
    environment : dict
        Variables beside our own.
    """

    def __init__(self, module: str, environment: dict[str, str]) -> None:
        self.module = module
        self._environment = os.environ | environment | {lifeline.SUPERVISED: "1"}
        self._process: subprocess.Popen[bytes] | None = None
        self._started = 0.0
        self._pause = _FIRST_PAUSE
        self._start_at = 0.0

    def tend(self) -> None:
        """Start the process if it does not run and its pause is over."""
        if self._process is not None and self._process.poll() is not None:
            self._mourn(self._process)
        if self._process is None and time.monotonic() >= self._start_at:
            self._started = time.monotonic()
            # A session of its own: Ctrl-C at the terminal is for us, we tell the children.
            self._process = subprocess.Popen(
                [sys.executable, "-m", self.module],
                stdin=subprocess.PIPE,
                env=self._environment,
                start_new_session=True,
            )

    def ask_to_stop(self) -> None:
        """Send SIGTERM."""
        if self._process is not None:
            self._process.terminate()

    def end(self, deadline: float) -> None:
        """Wait for the end, and kill the process at the deadline."""
        if self._process is None:
            return
        try:
            self._process.wait(max(0.0, deadline - time.monotonic()))
        except subprocess.TimeoutExpired:
            _tell(f"{self.module} does not stop and is killed")
            self._process.kill()
            self._process.wait()
        _close(self._process)

    def _mourn(self, process: subprocess.Popen[bytes]) -> None:
        lived = time.monotonic() - self._started
        _tell(f"{self.module} ended with status {process.returncode} and is started again")
        _close(process)
        self._process = None
        self._pause = _FIRST_PAUSE if lived > _HEALTHY_SECONDS else self._pause
        self._start_at = time.monotonic() + self._pause
        self._pause = min(2 * self._pause, _LONGEST_PAUSE)


@dataclass
class Supervisor:
    """Keeps children running until SIGINT or SIGTERM.

    Parameters
    ----------
    children : list of Child
        What to keep running.
    host, port : str, int
        Where the service listens.
    """

    children: list[Child]
    host: str
    port: int
    stopping: bool = False
    announced: bool = False

    def run(self) -> None:
        """Start the children, tend them, and stop them in the end."""
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self._stop)
        try:
            while not self.stopping:
                for child in self.children:
                    child.tend()
                self._announce()
                time.sleep(_TICK_SECONDS)
        finally:
            self._end()

    def _stop(self, *_: object) -> None:
        self.stopping = True

    def _announce(self) -> None:
        """Say where we are, once everything is ready."""
        host = _reachable(self.host)
        if self.announced or not _is_ready(host, self.port):
            return
        self.announced = True
        typer.echo(f"parmech is ready at http://{f'[{host}]' if ':' in host else host}:{self.port}")

    def _end(self) -> None:
        for child in self.children:
            child.ask_to_stop()
        deadline = time.monotonic() + _STOP_SECONDS
        for child in self.children:
            child.end(deadline)


def _settings(**given: object) -> Settings:
    """Return the settings of the environment, under those given on the command line."""
    return Settings().model_copy(
        update={name: value for name, value in given.items() if value is not None}
    )


@contextmanager
def _told_errors() -> Iterator[None]:
    """Say what keeps us from starting, instead of a traceback."""
    try:
        yield
    except (OSError, ValueError, storage.StorageRefusal) as error:
        _tell(f"cannot start: {error}")
        raise typer.Exit(1) from error


def _free_port(host: str, port: int) -> int:
    """Return the port, or a free one for 0; raise OSError if it is taken."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    with socket.socket(family, socket.SOCK_STREAM) as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        probe.bind((host, port))
        return int(probe.getsockname()[1])


def _reachable(host: str) -> str:
    """Return where this machine finds a service that listens on `host`."""
    return {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host)


def _is_ready(host: str, port: int) -> bool:
    connection = HTTPConnection(host, port, timeout=1.0)
    try:
        connection.request("GET", "/readyz")
        return connection.getresponse().status == HTTPStatus.OK
    except (OSError, HTTPException):
        return False
    finally:
        connection.close()


def _close(process: subprocess.Popen[bytes]) -> None:
    if process.stdin is not None:
        process.stdin.close()


def _tell(message: str) -> None:
    typer.echo(f"parmech: {message}", err=True)
