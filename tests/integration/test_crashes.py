"""Processes that are killed while a job runs."""

import sqlite3
import time
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from tests.integration.servers import Server, kill, serving, wait_until
from tests.integration.studies import arrays, workspace

QUICK = {"tile_seconds": 0.002, "lease_seconds": 2.0, "heartbeat_seconds": 0.2}
LONG = workspace(0.001, fields=["effort_max"])
TILES = 'SELECT "index", attempt, items, stored FROM tiles WHERE job_id = ? ORDER BY "index"'

# Who computes a tile again is not seen in `tiles`, which keeps the first: this keeps each try.
NOTE_EVERY_TRY = """
CREATE TABLE tries (job_id TEXT, tile INTEGER);
CREATE TRIGGER note BEFORE INSERT ON tiles
BEGIN INSERT INTO tries VALUES (NEW.job_id, NEW."index"); END;
"""


def grid(server: Server, job: dict[str, Any]) -> dict[str, Any]:
    answer = server.client.get(job["links"]["grid"])
    assert answer.status_code == 200
    return arrays(answer, server.folder)


def same(one: dict[str, Any], other: dict[str, Any]) -> bool:
    return one.keys() == other.keys() and all(
        (one[name].dtype, one[name].shape, one[name].tobytes())
        == (other[name].dtype, other[name].shape, other[name].tobytes())
        for name in one
    )


def assert_whole(server: Server, job: dict[str, Any]) -> None:
    """Fail unless a job has ended with each of its tiles stored once."""
    ((items, per_tile),) = server.rows(
        "SELECT items, items_per_tile FROM jobs WHERE id = ?", job["id"]
    )
    tiles = server.rows(TILES, job["id"])
    assert [index for index, *_ in tiles] == list(range(-(-items // per_tile)))
    assert sum(count for _, _, count, _ in tiles) == items
    assert job["progress"] == {"done": items, "total": items, "fraction": 1.0}


class Interrupted:
    """A job whose supervisor was killed in the middle, and what came after."""

    def __init__(self, server: Server) -> None:
        self.server = server
        with sqlite3.connect(server.folder / "data" / "parmech.sqlite") as connection:
            connection.executescript(NOTE_EVERY_TRY)
        connection.close()
        self.job = server.submit(LONG)
        server.wait_for_progress(self.job, 0.2)
        self.workers = server.workers()
        kill(server.supervisor.pid)
        server.supervisor.wait()
        begun = time.monotonic()
        wait_until(lambda: not server.processes(), seconds=30)
        self.seconds_to_die = time.monotonic() - begun
        self.stored = server.rows(TILES, self.job["id"])
        server.client.close()
        server.start()
        self.end = server.wait_for_end(self.job)


@pytest.fixture(scope="module")
def interrupted(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Interrupted]:
    """Return a job that went on after a kill -9 of the supervisor."""
    with serving(tmp_path_factory.mktemp("killed"), **QUICK) as server:
        yield Interrupted(server)


@pytest.fixture
def server(interrupted: Interrupted) -> Server:
    """Return a server of which things may be killed that come back."""
    return interrupted.server


def test_a_killed_supervisor_leaves_no_process(interrupted: Interrupted) -> None:
    assert len(interrupted.workers) == 2
    assert interrupted.seconds_to_die < 5.0


def test_it_was_killed_in_the_middle(interrupted: Interrupted) -> None:
    ((planned,),) = interrupted.server.rows(
        "SELECT items / items_per_tile FROM jobs WHERE id = ?", interrupted.job["id"]
    )
    assert 0 < len(interrupted.stored) < planned


def test_after_a_restart_the_job_succeeds(interrupted: Interrupted) -> None:
    assert interrupted.end["state"] == "successful"


def test_after_a_restart_every_tile_is_stored_once(interrupted: Interrupted) -> None:
    assert_whole(interrupted.server, interrupted.end)


def test_tiles_stored_before_the_kill_stay_as_they_were(interrupted: Interrupted) -> None:
    now = interrupted.server.rows(TILES, interrupted.job["id"])
    assert set(interrupted.stored) <= set(now)


def test_no_stored_tile_was_computed_again(interrupted: Interrupted) -> None:
    query = "SELECT tile FROM tries WHERE job_id = ?"
    tries = interrupted.server.rows(query, interrupted.job["id"])
    assert len(tries) == len(set(tries)) > len(interrupted.stored)


@pytest.fixture(scope="module")
def undisturbed(interrupted: Interrupted) -> dict[str, Any]:
    """Return a job of the same request that nothing happened to."""
    job = interrupted.server.done(LONG)
    assert job["attempt"] == 1
    return job


def test_its_arrays_are_those_of_an_undisturbed_run(
    interrupted: Interrupted, undisturbed: dict[str, Any]
) -> None:
    server = interrupted.server
    assert same(grid(server, interrupted.end), grid(server, undisturbed))


def test_its_result_is_that_of_an_undisturbed_run(
    interrupted: Interrupted, undisturbed: dict[str, Any]
) -> None:
    jobs = (interrupted.end, undisturbed)
    results = [interrupted.server.client.get(job["links"]["result"]) for job in jobs]
    assert results[0].content == results[1].content


def test_a_job_survives_a_killed_worker(server: Server) -> None:
    job = server.submit(LONG)
    server.wait_for_progress(job)
    killed = min(server.workers())
    kill(killed)
    end = server.wait_for_end(job)
    assert (end["state"], end["attempt"]) == ("successful", 1)
    assert_whole(server, end)
    assert len(server.workers() - {killed}) == 2


def test_a_job_survives_a_killed_engine(server: Server) -> None:
    job = server.submit(LONG)
    server.wait_for_progress(job)
    (service,), (engine,) = server.service(), server.engine()
    workers = server.workers()
    kill(engine)
    assert server.client.get("/healthz").status_code == 200
    assert server.look(job)["state"] == "running"
    wait_until(lambda: not workers & server.processes(), seconds=5.0)
    end = server.wait_for_end(job)
    assert (end["state"], end["attempt"]) == ("successful", 2)
    assert_whole(server, end)
    assert server.service() == {service}


def test_a_job_survives_a_killed_service(server: Server) -> None:
    job = server.submit(LONG)
    server.wait_for_progress(job)
    (service,), engine = server.service(), server.engine()
    kill(service)
    wait_until(lambda: server.service() - {service}, seconds=20)
    wait_until(lambda: _answers(server), seconds=20)
    end = server.wait_for_end(job)
    assert (end["state"], end["attempt"]) == ("successful", 1)
    assert server.engine() == engine


def _answers(server: Server) -> bool:
    try:
        return bool(server.client.get("/healthz").status_code == 200)
    except httpx.TransportError:
        return False


def test_a_cancel_holds_though_the_engine_was_killed(server: Server) -> None:
    job = server.submit(LONG)
    server.wait_for_progress(job)
    (engine,) = server.engine()
    kill(engine)
    server.client.post(job["links"]["cancel"])
    assert server.wait_for_end(job)["state"] == "cancelled"


def test_a_job_survives_the_end_of_everything(server: Server) -> None:
    job = server.submit(LONG)
    server.wait_for_progress(job)
    for pid in server.processes():
        kill(pid)
    server.supervisor.wait()
    wait_until(lambda: not server.processes(), seconds=5)
    stored = server.rows(TILES, job["id"])
    server.client.close()
    server.start()
    end = server.wait_for_end(job)
    assert end["state"] == "successful"
    assert_whole(server, end)
    # A tile that was computed again would stand there with another attempt or time.
    assert set(stored) <= set(server.rows(TILES, job["id"]))
