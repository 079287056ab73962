"""One engine at work, told what to do by requests alone."""

import json
import time

import pytest

from storage import ErrorKind, Fault, JobState
from tests.workers.works import Works, is_alive, wait_until


def test_a_job_is_computed_and_assembled(running: Works) -> None:
    job = running.submit(items=5, items_per_tile=2)
    ended = running.wait_for(job)
    assert (ended.state, ended.done, ended.attempt) == (JobState.SUCCESSFUL, 5, 1)
    assert json.loads(running.jobs.result(job) or "") == {"items": [0, 1, 2, 3, 4]}
    assert sorted(running.begun(job)) == [0, 2, 4]


def test_a_job_without_items_is_assembled(running: Works) -> None:
    assert running.wait_for(running.submit(items=0)).state == JobState.SUCCESSFUL


def test_a_job_starts_soon(running: Works) -> None:
    job = running.wait_for(running.submit())
    assert job.started is not None
    assert job.started - job.created < 0.5


def test_jobs_take_turns(running: Works) -> None:
    long = running.submit(items=100, seconds=0.1)
    wait_until(lambda: running.begun(long))
    short = running.submit(items=2, seconds=0.1)
    assert running.wait_for(short).state == JobState.SUCCESSFUL
    assert running.jobs.get(long).done < 50
    running.jobs.request_cancel(long)


@pytest.mark.parametrize(
    ("what", "kind"),
    [
        ("refuse", ErrorKind.USER),
        ("raise", ErrorKind.SYSTEM),
        ("allocate", ErrorKind.MEMORY),
        ("hang", ErrorKind.TIMEOUT),
        ("die", ErrorKind.SYSTEM),
    ],
)
def test_a_tile_that_fails_fails_its_job_alone(running: Works, what: str, kind: ErrorKind) -> None:
    bad = running.submit(do={"2": what})
    good = running.submit()
    ended = running.wait_for(bad)
    assert ended.error is not None
    assert (ended.state, ended.error.kind) == (JobState.FAILED, kind)
    assert running.wait_for(good).state == JobState.SUCCESSFUL


def test_a_refusal_says_what_is_wrong_where(running: Works) -> None:
    error = running.wait_for(running.submit(do={"0": "refuse"})).error
    assert error is not None
    assert error.errors == (Fault("/grid", "too fine"),)


def test_a_tile_whose_process_died_is_computed_again(running: Works) -> None:
    job = running.submit(do={"1": "die once"})
    assert running.wait_for(job).state == JobState.SUCCESSFUL
    assert sorted(running.begun(job)) == [0, 1, 1, 2, 3]


def test_a_cancelled_job_stops_at_once(works: Works) -> None:
    works.start_engine()
    job = works.submit(do={"0": "hang", "1": "hang"})
    wait_until(lambda: len(works.begun(job)) == 2)
    works.jobs.request_cancel(job)
    works.wait_for(job, JobState.CANCELLED, seconds=1.0)
    wait_until(lambda: not any(map(is_alive, works.worker_pids(job))), seconds=2.0)
    assert works.wait_for(works.submit()).state == JobState.SUCCESSFUL


def test_assembling_can_be_cancelled(running: Works) -> None:
    job = running.submit(items=1, assembling_seconds=60)
    running.wait_for_done(job, 1)
    running.jobs.request_cancel(job)
    assert running.wait_for(job, seconds=1.0).state == JobState.CANCELLED


def test_an_engine_takes_no_more_jobs_than_it_may(works: Works) -> None:
    works.start_engine(concurrent_jobs=1)
    first = works.submit(seconds=0.3)
    second = works.submit()
    works.wait_for_done(first, 1)
    assert works.jobs.get(second).state == JobState.ACCEPTED
    assert works.wait_for(second).state == JobState.SUCCESSFUL


def test_a_locked_database_costs_nothing(running: Works) -> None:
    job = running.submit(items=6, seconds=0.1)
    running.wait_for_done(job, 1)
    with running.database.writing():
        # Longer than all tiles take, shorter than the lease.
        time.sleep(1.0)
    assert running.wait_for(job).state == JobState.SUCCESSFUL
    assert sorted(running.begun(job)) == list(range(6))


def test_an_engine_asks_for_migrated_tables(works: Works) -> None:
    url = f"sqlite:///{works.folder / 'empty.sqlite'}"
    assert works.start("-m", "workers", database_url=url).wait(60) == 1
