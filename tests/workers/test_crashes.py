"""Engines that stop, die or fall silent, and the ones that go on."""

import json
import signal
import subprocess
import time

import storage
from storage import JobState
from tests.workers.works import Works, is_alive, wait_until


def test_a_killed_engine_loses_no_stored_tile(works: Works) -> None:
    first = works.start_engine()
    job = works.submit(items=12, seconds=0.2)
    works.wait_for_done(job, 4)
    first.kill()
    first.wait()
    wait_until(lambda: not any(map(is_alive, works.worker_pids(job))), seconds=2.0)
    stored, begun = works.jobs.get(job).done, len(works.begun(job))
    works.start_engine()
    ended = works.wait_for(job)
    assert (ended.state, ended.attempt) == (JobState.SUCCESSFUL, 2)
    assert len(works.begun(job)) == begun + 12 - stored
    assert json.loads(works.jobs.result(job) or "") == {"items": list(range(12))}


def test_a_stopped_engine_gives_its_jobs_back(works: Works) -> None:
    first = works.start_engine(lease_seconds=600)
    job = works.submit(items=12, seconds=0.2)
    works.wait_for_done(job, 4)
    first.send_signal(signal.SIGTERM)
    assert first.wait(5) == 0
    released, begun = works.jobs.get(job), len(works.begun(job))
    assert (released.state, released.attempt) == (JobState.ACCEPTED, 0)
    assert works.beating() == set()
    works.start_engine(lease_seconds=600)
    ended = works.wait_for(job)
    assert (ended.state, ended.attempt) == (JobState.SUCCESSFUL, 1)
    assert len(works.begun(job)) == begun + 12 - released.done


def test_a_stopped_engine_leaves_no_worker(works: Works) -> None:
    engine = works.start_engine()
    job = works.submit(do={"0": "hang", "1": "hang"})
    wait_until(lambda: len(works.begun(job)) == 2)
    engine.send_signal(signal.SIGTERM)
    assert engine.wait(5) == 0
    assert not any(map(is_alive, works.worker_pids(job)))


def test_two_engines_share_the_work(works: Works) -> None:
    for _ in range(2):
        works.start_engine(processes=1, concurrent_jobs=1)
    jobs = [works.submit(items=3, seconds=0.1) for _ in range(6)]
    for job in jobs:
        assert works.wait_for(job).state == JobState.SUCCESSFUL
        assert sorted(works.begun(job)) == [0, 1, 2]
    assert len(set[int]().union(*map(works.worker_pids, jobs))) == 2


def stop_between_writes(works: Works, engine: subprocess.Popen[bytes]) -> None:
    """Stop an engine while it does not hold SQLite's write lock, which would stop all others."""
    while True:
        engine.send_signal(signal.SIGSTOP)
        try:
            with works.database.writing():
                return
        except storage.DatabaseUnavailable:
            engine.send_signal(signal.SIGCONT)
            # Stopped again at once it would still be in the same write.
            time.sleep(0.1)


def test_an_engine_that_was_silent_leaves_its_job_to_another(works: Works) -> None:
    silent = works.start_engine()
    job = works.submit(items=6, seconds=0.3)
    works.wait_for_done(job, 2)
    stop_between_writes(works, silent)
    works.start_engine()
    wait_until(lambda: works.jobs.get(job).attempt == 2)
    silent.send_signal(signal.SIGCONT)
    ended = works.wait_for(job)
    assert (ended.state, ended.done) == (JobState.SUCCESSFUL, 6)
    assert json.loads(works.jobs.result(job) or "") == {"items": list(range(6))}


def test_an_engine_that_was_silent_goes_on_with_other_jobs(works: Works) -> None:
    engine = works.start_engine(lease_seconds=0.5)
    stop_between_writes(works, engine)
    job = works.submit()
    time.sleep(1.0)
    engine.send_signal(signal.SIGCONT)
    assert works.wait_for(job).state == JobState.SUCCESSFUL
