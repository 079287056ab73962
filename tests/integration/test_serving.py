"""Starting and stopping `parmech serve`."""

import signal
import socket
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.integration.servers import Server, serving, wait_until
from tests.integration.studies import ENDLESS


class Stopped:
    """A server that got Ctrl-C while a job ran and somebody watched it."""

    def __init__(self, server: Server) -> None:
        self.server = server
        job = server.submit(ENDLESS)
        wait_until(lambda: server.look(job)["state"] == "running")
        with server.client.stream("GET", job["links"]["events"]) as stream:
            next(stream.iter_lines())
            begun = time.monotonic()
            server.supervisor.send_signal(signal.SIGINT)
            self.status = server.supervisor.wait(30)
            self.seconds = time.monotonic() - begun


@pytest.fixture(scope="module")
def stopped(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Stopped]:
    """Return a server that was stopped."""
    with serving(tmp_path_factory.mktemp("stopped")) as server:
        yield Stopped(server)


def test_what_says_that_it_is_ready_is(server: Server) -> None:
    answer = server.client.get("/readyz")
    assert answer.status_code == 200
    assert answer.json()["status"] == "ready"


def test_a_server_is_a_service_and_an_engine_with_two_workers(server: Server) -> None:
    assert (len(server.service()), len(server.engine())) == (1, 1)
    wait_until(lambda: len(server.workers()) == 2)


def test_the_docs_are_served(server: Server) -> None:
    assert server.client.get("/docs").status_code == 200
    assert server.client.get("/openapi.json").status_code == 200


def test_ctrl_c_is_a_success(stopped: Stopped) -> None:
    assert stopped.status == 0


def test_ctrl_c_takes_a_few_seconds(stopped: Stopped) -> None:
    assert stopped.seconds < 8.0


def test_ctrl_c_leaves_no_process(stopped: Stopped) -> None:
    wait_until(lambda: not stopped.server.processes(), seconds=2.0)


def test_ctrl_c_gives_the_job_back(stopped: Stopped) -> None:
    assert stopped.server.rows("SELECT state, attempt FROM jobs") == [("accepted", 0)]


def test_ctrl_c_says_nothing_alarming(stopped: Stopped) -> None:
    assert "Traceback" not in stopped.server.told
    assert "started again" not in stopped.server.told


def test_a_taken_port_is_told(tmp_path: Path) -> None:
    server = Server(tmp_path)
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        server.begin(port=taken.getsockname()[1])
        assert server.supervisor.wait(30) != 0
    assert "in use" in server.told
    assert "Traceback" not in server.told
    assert server.processes() == set()


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "data").write_text("a file stands where the folder should be")
    server = Server(tmp_path)
    server.begin()
    assert server.supervisor.wait(30) != 0
    assert "cannot start" in server.told
    assert "Traceback" not in server.told
