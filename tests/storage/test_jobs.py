from collections.abc import Callable

import numpy as np
import pytest
from sqlalchemy import func, select, update

import storage
from storage import JobState
from storage.tables import idempotency_keys, metadata

NewJobs = Callable[..., storage.NewJob]


def test_a_new_job_waits(jobs: storage.Jobs, new_job: NewJobs) -> None:
    job, created = jobs.create(new_job())
    assert created
    assert (job.state, job.done, job.attempt, job.tiles) == (JobState.ACCEPTED, 0, 0, 3)


def test_the_tiles_cover_the_items(jobs: storage.Jobs, new_job: NewJobs) -> None:
    job, _ = jobs.create(new_job(items=10, items_per_tile=4))
    assert [job.bounds(tile) for tile in range(job.tiles)] == [(0, 4), (4, 8), (8, 10)]


def test_a_job_carries_its_request(jobs: storage.Jobs, new_job: NewJobs) -> None:
    job, _ = jobs.create(new_job(request_json='{"x": 1}'))
    assert jobs.request(job.id) == '{"x": 1}'


def test_a_repeated_key_returns_the_first_job(jobs: storage.Jobs, new_job: NewJobs) -> None:
    first, _ = jobs.create(new_job(idempotency_key="key"))
    again, created = jobs.create(new_job(idempotency_key="key"))
    assert (again, created) == (first, False)


def test_a_key_is_for_one_body(jobs: storage.Jobs, new_job: NewJobs) -> None:
    jobs.create(new_job(idempotency_key="key"))
    with pytest.raises(storage.IdempotencyConflict, match="'key'"):
        jobs.create(new_job(idempotency_key="key", body_hash="other"))


def test_a_key_expires(database: storage.Database, jobs: storage.Jobs, new_job: NewJobs) -> None:
    jobs.create(new_job(idempotency_key="key"))
    with database.writing() as connection:
        a_day_ago = idempotency_keys.c.created - 24 * 3600
        connection.execute(update(idempotency_keys).values(created=a_day_ago))
    _, created = jobs.create(new_job(idempotency_key="key", body_hash="other"))
    assert created


def test_a_full_queue_takes_no_more(database: storage.Database, new_job: NewJobs) -> None:
    jobs = storage.Jobs(database, queue_limit=1)
    jobs.create(new_job())
    with pytest.raises(storage.QueueFull):
        jobs.create(new_job(idempotency_key="key"))


def test_a_refused_job_leaves_its_key_free(database: storage.Database, new_job: NewJobs) -> None:
    storage.Jobs(database, queue_limit=1).create(new_job())
    with pytest.raises(storage.QueueFull):
        storage.Jobs(database, queue_limit=1).create(new_job(idempotency_key="key"))
    _, created = storage.Jobs(database, queue_limit=2).create(new_job(idempotency_key="key"))
    assert created


def test_a_full_queue_still_knows_its_keys(database: storage.Database, new_job: NewJobs) -> None:
    jobs = storage.Jobs(database, queue_limit=1)
    first, _ = jobs.create(new_job(idempotency_key="key"))
    again, _ = jobs.create(new_job(idempotency_key="key"))
    assert again == first


def test_pages_go_through_all_newest_first(jobs: storage.Jobs, new_job: NewJobs) -> None:
    for _ in range(5):
        jobs.create(new_job())
    everything = jobs.page(size=10)
    first = jobs.page(size=2)
    assert first + jobs.page(size=10, after=first[-1].cursor) == everything
    assert everything == sorted(everything, key=lambda job: job.cursor, reverse=True)
    assert len(everything) == 5


@pytest.mark.parametrize(
    "wanted", [{"state": JobState.RUNNING}, {"analysis": "effort"}, {"mechanism_id": "m"}]
)
def test_pages_hold_what_is_asked_for(
    jobs: storage.Jobs, queue: storage.Queue, new_job: NewJobs, wanted: dict[str, object]
) -> None:
    special, _ = jobs.create(new_job(analysis="effort", mechanism_id="m"))
    queue.claim()
    jobs.create(new_job())
    assert [job.id for job in jobs.page(size=10, **wanted)] == [special.id]  # type: ignore[arg-type]


def test_a_waiting_job_is_cancelled_at_once(jobs: storage.Jobs, new_job: NewJobs) -> None:
    job, _ = jobs.create(new_job())
    assert jobs.request_cancel(job.id).state == JobState.CANCELLED


def test_a_running_job_is_told_to_stop(
    jobs: storage.Jobs, queue: storage.Queue, new_job: NewJobs
) -> None:
    job, _ = jobs.create(new_job())
    queue.claim()
    asked = jobs.request_cancel(job.id)
    assert (asked.state, asked.cancel_requested) == (JobState.RUNNING, True)


def test_a_job_whose_engine_is_lost_is_cancelled_at_once(
    jobs: storage.Jobs, open_queue: Callable[..., storage.Queue], new_job: NewJobs
) -> None:
    job, _ = jobs.create(new_job())
    open_queue("lost", lease_seconds=-1.0).claim()
    assert jobs.request_cancel(job.id).state == JobState.CANCELLED


@pytest.mark.parametrize("claimed", [False, True])
def test_cancelling_again_changes_nothing(
    jobs: storage.Jobs, queue: storage.Queue, new_job: NewJobs, claimed: bool
) -> None:
    job, _ = jobs.create(new_job())
    if claimed:
        queue.claim()
    assert jobs.request_cancel(job.id) == jobs.request_cancel(job.id)


def test_a_job_that_has_not_ended_is_not_removed(jobs: storage.Jobs, new_job: NewJobs) -> None:
    job, _ = jobs.create(new_job())
    with pytest.raises(storage.JobStillRunning, match="accepted"):
        jobs.delete(job.id)


def test_a_removed_job_leaves_nothing(
    database: storage.Database, jobs: storage.Jobs, queue: storage.Queue, new_job: NewJobs
) -> None:
    jobs.create(new_job(idempotency_key="key"))
    job = queue.claim()
    assert job is not None
    queue.store_tile(job, 0, storage.pack_arrays({"a": np.zeros(1)}))
    queue.succeed(job, "{}")
    jobs.delete(job.id)
    with database.reading() as connection:
        rows = [
            connection.execute(select(func.count()).select_from(table)).scalar_one()
            for table in metadata.sorted_tables
        ]
    assert sum(rows) == 0


@pytest.mark.parametrize("call", ["get", "request", "result", "request_cancel", "delete"])
def test_a_job_that_is_not_there_is_named(jobs: storage.Jobs, call: str) -> None:
    with pytest.raises(storage.JobNotFound, match="'nobody'"):
        getattr(jobs, call)("nobody")


def test_tiles_come_in_their_order(
    jobs: storage.Jobs, queue: storage.Queue, new_job: NewJobs
) -> None:
    jobs.create(new_job())
    job = queue.claim()
    assert job is not None
    for index in (2, 0, 1):
        queue.store_tile(job, index, storage.pack_arrays({"a": np.array([index])}))
    assert [int(arrays["a"][0]) for arrays in jobs.tiles(job.id)] == [0, 1, 2]


def test_tiles_removed_while_they_are_read_are_missed(
    jobs: storage.Jobs, queue: storage.Queue, new_job: NewJobs
) -> None:
    jobs.create(new_job())
    job = queue.claim()
    assert job is not None
    for index in range(3):
        queue.store_tile(job, index, storage.pack_arrays({}))
    queue.succeed(job, "{}")
    tiles = jobs.tiles(job.id)
    next(tiles)
    jobs.delete(job.id)
    with pytest.raises(storage.JobNotFound):
        next(tiles)
