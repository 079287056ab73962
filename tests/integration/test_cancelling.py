"""Stopping a job that runs, under the default settings."""

import time
from collections.abc import Iterator
from typing import Any

import pytest

from tests.integration.servers import Server, serving, wait_until
from tests.integration.studies import ENDLESS, SMALL


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """Return a server with tiles as long as they are by default."""
    with serving(tmp_path_factory.mktemp("default")) as shared:
        yield shared


@pytest.fixture
def running(server: Server) -> dict[str, Any]:
    """Return a job that would run for minutes."""
    job = server.submit(ENDLESS)
    wait_until(lambda: server.look(job)["state"] == "running")
    return job


def cancel(server: Server, job: dict[str, Any]) -> dict[str, Any]:
    """Ask a job to stop, and return it when it has."""
    answer = server.client.post(job["links"]["cancel"])
    assert answer.status_code == 200
    return server.wait_for_end(job, seconds=30)


def test_a_running_job_stops_within_two_seconds(server: Server, running: dict[str, Any]) -> None:
    begun = time.monotonic()
    stopped = cancel(server, running)
    assert stopped["state"] == "cancelled"
    assert time.monotonic() - begun < 2.0


def test_the_workers_are_free_after_a_cancel(server: Server, running: dict[str, Any]) -> None:
    cancel(server, running)
    begun = time.monotonic()
    server.done(SMALL)
    assert time.monotonic() - begun < 5.0


def test_cancelling_again_changes_nothing(server: Server, running: dict[str, Any]) -> None:
    stopped = cancel(server, running)
    again = server.client.post(running["links"]["cancel"])
    assert (again.status_code, again.json()) == (200, stopped)


def test_a_cancelled_job_stores_no_more_tiles(server: Server, running: dict[str, Any]) -> None:
    cancel(server, running)
    count = "SELECT count(*) FROM tiles WHERE job_id = ?"
    before = server.rows(count, running["id"])
    time.sleep(1.5)
    assert server.rows(count, running["id"]) == before


def test_a_cancelled_job_has_no_result(server: Server, running: dict[str, Any]) -> None:
    cancel(server, running)
    for what in ("result", "grid", "figure"):
        answer = server.client.get(running["links"][what])
        assert answer.status_code == 404
        assert answer.headers["content-type"] == "application/problem+json"
        assert answer.json()["type"].endswith("job-cancelled")


def test_who_watches_hears_of_the_cancel(server: Server, running: dict[str, Any]) -> None:
    with server.client.stream("GET", running["links"]["events"]) as stream:
        server.client.post(running["links"]["cancel"])
        text = "".join(stream.iter_text())
    assert '"cancelled"' in text


def test_a_running_job_cannot_be_removed(server: Server, running: dict[str, Any]) -> None:
    answer = server.client.delete(running["links"]["self"])
    assert answer.status_code == 409
    assert cancel(server, running)["state"] == "cancelled"
    assert server.client.delete(running["links"]["self"]).status_code == 204


def test_what_is_not_ready_says_how_far_it_is(server: Server, running: dict[str, Any]) -> None:
    answer = server.client.get(running["links"]["result"])
    assert answer.status_code == 404
    assert answer.json()["type"].endswith("result-not-ready")
    cancel(server, running)


def test_a_busy_engine_slows_no_request_down(server: Server, running: dict[str, Any]) -> None:
    seconds = []
    for _ in range(20):
        begun = time.monotonic()
        assert server.client.get("/healthz").status_code == 200
        seconds.append(time.monotonic() - begun)
    cancel(server, running)
    assert sorted(seconds)[10] < 0.5
