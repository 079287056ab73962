import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import storage
from storage import ErrorKind, Fault, JobError, JobState

ROOT = Path(__file__).parents[2]
PACKED = storage.pack_arrays({})

NewJobs = Callable[..., storage.NewJob]
Queues = Callable[..., storage.Queue]


@pytest.fixture
def claimed(jobs: storage.Jobs, queue: storage.Queue, new_job: NewJobs) -> storage.Job:
    jobs.create(new_job())
    job = queue.claim()
    assert job is not None
    return job


@pytest.fixture
def taken_over(jobs: storage.Jobs, open_queue: Queues, new_job: NewJobs) -> storage.Job:
    """Return the job as the engine "silent" knew it before "second" took it over."""
    jobs.create(new_job())
    job = open_queue("silent", lease_seconds=-1.0).claim()
    assert job is not None
    assert open_queue("second").claim() is not None
    return job


def test_a_claimed_job_runs(queue: storage.Queue, claimed: storage.Job) -> None:
    assert (claimed.state, claimed.attempt, claimed.owner) == (JobState.RUNNING, 1, "first")
    assert claimed.started is not None
    assert queue.claim() is None


def test_the_oldest_job_comes_first(
    jobs: storage.Jobs, queue: storage.Queue, new_job: NewJobs
) -> None:
    for _ in range(3):
        jobs.create(new_job())
    oldest_first = sorted(jobs.page(size=9), key=lambda job: job.cursor)
    claimed = [queue.claim() for _ in range(3)]
    assert [job.id for job in claimed if job] == [job.id for job in oldest_first]


def test_engines_that_claim_at_once_share_no_job(
    url: str, jobs: storage.Jobs, new_job: NewJobs
) -> None:
    for _ in range(40):
        jobs.create(new_job())
    code = f"""
import os, storage
queue = storage.Queue(storage.open_database({url!r}), str(os.getpid()), lease_seconds=60)
while job := queue.claim():
    print(job.id)
"""
    engines = [
        subprocess.Popen([sys.executable, "-c", code], cwd=ROOT, stdout=subprocess.PIPE)
        for _ in range(3)
    ]
    claimed = [line for engine in engines for line in engine.communicate(timeout=60)[0].split()]
    assert len(claimed) == len(set(claimed)) == 40


def test_a_job_whose_lease_ran_out_is_taken_over(
    jobs: storage.Jobs, taken_over: storage.Job
) -> None:
    now = jobs.get(taken_over.id)
    assert (now.owner, now.attempt) == ("second", 2)


def test_a_renewed_lease_is_kept(jobs: storage.Jobs, open_queue: Queues, new_job: NewJobs) -> None:
    jobs.create(new_job())
    job = open_queue("first", lease_seconds=-1.0).claim()
    assert job is not None
    assert open_queue("first").renew(job)
    assert open_queue("second").claim() is None


def test_an_engine_hears_of_its_own_cancellations(
    jobs: storage.Jobs, queue: storage.Queue, open_queue: Queues, claimed: storage.Job
) -> None:
    jobs.request_cancel(claimed.id)
    assert (queue.to_cancel(), open_queue("second").to_cancel()) == ({claimed.id}, set())


def test_a_lost_lease_is_not_renewed(open_queue: Queues, taken_over: storage.Job) -> None:
    assert not open_queue("silent").renew(taken_over)


WRITES: dict[str, Callable[[storage.Queue, storage.Job], object]] = {
    "store_tile": lambda queue, job: queue.store_tile(job, 0, PACKED),
    "succeed": lambda queue, job: queue.succeed(job, "{}"),
    "fail": lambda queue, job: queue.fail(job, JobError(ErrorKind.SYSTEM, "")),
    "cancel": lambda queue, job: queue.cancel(job),
    "release": lambda queue, job: queue.release(job),
}


@pytest.mark.parametrize("write", WRITES)
def test_who_lost_the_lease_writes_nothing(
    jobs: storage.Jobs, open_queue: Queues, taken_over: storage.Job, write: str
) -> None:
    before = jobs.get(taken_over.id)
    with pytest.raises(storage.LeaseLost):
        WRITES[write](open_queue("silent"), taken_over)
    assert jobs.get(taken_over.id) == before
    assert jobs.result(taken_over.id) is None
    assert list(jobs.tiles(taken_over.id)) == []


@pytest.mark.parametrize("write", WRITES)
def test_an_earlier_attempt_of_the_same_engine_writes_nothing(
    jobs: storage.Jobs, open_queue: Queues, new_job: NewJobs, write: str
) -> None:
    jobs.create(new_job())
    queue = open_queue("same", lease_seconds=-1.0)
    earlier = queue.claim()
    assert earlier is not None
    assert queue.claim() is not None
    with pytest.raises(storage.LeaseLost):
        WRITES[write](queue, earlier)


def test_a_tile_counts_as_progress(
    jobs: storage.Jobs, queue: storage.Queue, claimed: storage.Job
) -> None:
    assert queue.store_tile(claimed, 2, PACKED)
    after = jobs.get(claimed.id)
    assert (after.done, after.revision) == (2, claimed.revision + 1)
    assert queue.finished_tiles(claimed) == {2}


def test_a_tile_is_kept_and_counted_once(
    jobs: storage.Jobs, queue: storage.Queue, claimed: storage.Job
) -> None:
    queue.store_tile(claimed, 0, PACKED)
    before = jobs.get(claimed.id)
    assert not queue.store_tile(claimed, 0, PACKED)
    assert jobs.get(claimed.id) == before


def test_tiles_outlive_the_attempt(
    jobs: storage.Jobs, open_queue: Queues, new_job: NewJobs
) -> None:
    jobs.create(new_job())
    silent, second = open_queue("silent", lease_seconds=-1.0), open_queue("second")
    job = silent.claim()
    assert job is not None
    silent.store_tile(job, 1, PACKED)
    taken = second.claim()
    assert taken is not None
    assert (second.finished_tiles(taken), taken.done) == ({1}, 4)


def test_a_successful_job_has_its_result(
    jobs: storage.Jobs, queue: storage.Queue, claimed: storage.Job
) -> None:
    queue.succeed(claimed, '{"x": 1}')
    after = jobs.get(claimed.id)
    assert (after.state, after.owner, after.lease_until) == (JobState.SUCCESSFUL, None, None)
    assert after.finished is not None
    assert jobs.result(claimed.id) == '{"x": 1}'


def test_a_failed_job_says_why(
    jobs: storage.Jobs, queue: storage.Queue, claimed: storage.Job
) -> None:
    error = JobError(ErrorKind.USER, "too small", (Fault("/grid/0/step", "not positive"),))
    queue.fail(claimed, error)
    after = jobs.get(claimed.id)
    assert (after.state, after.error) == (JobState.FAILED, error)


def test_an_ended_job_stays_as_it_is(
    jobs: storage.Jobs, queue: storage.Queue, claimed: storage.Job
) -> None:
    queue.succeed(claimed, "{}")
    before = jobs.get(claimed.id)
    assert jobs.request_cancel(claimed.id) == before
    with pytest.raises(storage.LeaseLost):
        queue.cancel(claimed)


def test_a_released_job_is_taken_at_once_and_loses_no_attempt(
    queue: storage.Queue, open_queue: Queues, claimed: storage.Job
) -> None:
    queue.release(claimed)
    taken = open_queue("second").claim()
    assert taken is not None
    assert (taken.id, taken.attempt, taken.started) == (claimed.id, 1, claimed.started)


def test_a_released_job_that_was_to_stop_is_cancelled(
    jobs: storage.Jobs, queue: storage.Queue, claimed: storage.Job
) -> None:
    jobs.request_cancel(claimed.id)
    queue.release(claimed)
    assert jobs.get(claimed.id).state == JobState.CANCELLED


def test_a_job_that_loses_too_many_engines_fails(
    jobs: storage.Jobs, open_queue: Queues, new_job: NewJobs
) -> None:
    job, _ = jobs.create(new_job())
    for number in range(3):
        taken = open_queue(f"{number}", lease_seconds=-1.0, max_attempts=2).claim()
        assert (taken is None) == (number == 2)
    after = jobs.get(job.id)
    assert after.state == JobState.FAILED
    assert after.error is not None
    assert after.error.kind == ErrorKind.LOST


def test_a_lost_job_that_was_to_stop_is_cancelled(
    jobs: storage.Jobs, open_queue: Queues, new_job: NewJobs
) -> None:
    job, _ = jobs.create(new_job())
    held = open_queue("lost").claim()
    jobs.request_cancel(job.id)
    assert held is not None
    open_queue("lost", lease_seconds=-1.0).renew(held)
    assert open_queue("second").claim() is None
    assert jobs.get(job.id).state == JobState.CANCELLED


def test_a_claimed_job_carries_its_request(queue: storage.Queue, claimed: storage.Job) -> None:
    assert queue.request(claimed) == '{"analysis": "workspace"}'
