import _thread
import math
import os
import posix
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from workers.executors import (
    Call,
    Died,
    ExecutorError,
    LocalExecutor,
    Outcome,
    Raised,
    Returned,
    TimedOut,
)

# Functions of the standard library do for calls: worker processes find them without these tests.
ROOT = Path(__file__).parents[2]


@contextmanager
def executor_of(processes: int, memory_bytes: int | None = None) -> Iterator[LocalExecutor]:
    executor = LocalExecutor(processes, time.tzset, memory_bytes)
    try:
        wait_for_room(executor, processes)
        yield executor
    finally:
        executor.close()


def wait_for_room(executor: LocalExecutor, processes: int) -> None:
    deadline = time.monotonic() + 30
    while executor.room() < processes:
        assert executor.wait(0.1) == []
        assert time.monotonic() < deadline


@pytest.fixture
def executor() -> Iterator[LocalExecutor]:
    with executor_of(1) as executor:
        yield executor


def outcome_of(
    executor: LocalExecutor, function: Callable[..., object], *arguments: object, limit: float = 30
) -> Outcome:
    number = executor.start(Call(function, arguments, limit))
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline:
        ended = dict(executor.wait(0.1))
        if number in ended:
            return ended[number]
    raise TimeoutError


def test_a_call_returns_its_value(executor: LocalExecutor) -> None:
    assert outcome_of(executor, math.hypot, 3.0, 4.0) == Returned(5.0)


def test_what_a_call_raises_is_told(executor: LocalExecutor) -> None:
    outcome = outcome_of(executor, math.sqrt, -1.0)
    assert isinstance(outcome, Raised)
    assert outcome.detail.startswith("ValueError: ")
    assert not outcome.memory


def test_a_value_that_cannot_travel_fails_the_call(executor: LocalExecutor) -> None:
    outcome = outcome_of(executor, _thread.allocate_lock)
    assert isinstance(outcome, Raised)
    assert "pickle" in outcome.detail


def test_a_call_may_not_take_all_memory() -> None:
    with executor_of(1, memory_bytes=2**31) as executor:
        outcome = outcome_of(executor, bytes, 2**33)
    assert isinstance(outcome, Raised)
    assert outcome.memory


def test_a_call_that_takes_too_long_is_killed(executor: LocalExecutor) -> None:
    assert outcome_of(executor, time.sleep, 60, limit=0.2) == TimedOut(0.2)


def test_a_process_that_ends_is_told_and_replaced(executor: LocalExecutor) -> None:
    assert outcome_of(executor, posix._exit, 3) == Died(3)
    wait_for_room(executor, 1)
    assert outcome_of(executor, math.hypot, 3.0, 4.0) == Returned(5.0)


def test_an_idle_process_that_is_killed_is_replaced(executor: LocalExecutor) -> None:
    pid = outcome_of(executor, os.getpid)
    assert isinstance(pid, Returned)
    os.kill(int(str(pid.value)), signal.SIGKILL)
    time.sleep(0.2)
    assert executor.wait(0.0) == []
    wait_for_room(executor, 1)
    assert outcome_of(executor, os.getpid) != pid


def test_a_process_killed_while_it_answers_disturbs_nobody() -> None:
    with executor_of(2) as executor:
        first = outcome_of(executor, os.getpid)
        assert isinstance(first, Returned)
        # The same, first idle worker; its answer is larger than a pipe holds.
        answering = executor.start(Call(bytes, (50_000_000,), 30))
        time.sleep(0.5)
        os.kill(int(str(first.value)), signal.SIGKILL)
        time.sleep(0.2)
        assert executor.wait(1.0) == [(answering, Died(-signal.SIGKILL))]
        assert isinstance(outcome_of(executor, os.getpid), Returned)


def test_a_killed_call_has_no_outcome_and_frees_its_place(executor: LocalExecutor) -> None:
    executor.kill(executor.start(Call(time.sleep, (60,), 60)))
    wait_for_room(executor, 1)


def test_killing_a_call_that_ended_hurts_nobody(executor: LocalExecutor) -> None:
    first = outcome_of(executor, os.getpid)
    executor.kill(1)
    assert outcome_of(executor, os.getpid) == first


def test_processes_that_never_get_ready_are_given_up() -> None:
    executor = LocalExecutor(1, os.abort)
    try:
        with pytest.raises(ExecutorError, match="before they are ready"):
            wait_for_room(executor, 1)
    finally:
        executor.close()


def test_workers_end_with_a_killed_engine() -> None:
    code = """
import os, time
from workers.executors import Call, LocalExecutor
executor = LocalExecutor(2, time.tzset)
while executor.room() < 2:
    executor.wait(0.1)
numbers = [executor.start(Call(os.getpid, (), 9)), executor.start(Call(os.getpid, (), 9))]
while numbers:
    for number, outcome in executor.wait(0.1):
        numbers.remove(number)
        print(outcome.value, flush=True)
executor.start(Call(time.sleep, (60,), 60))
print("busy", flush=True)
time.sleep(60)
"""
    engine = subprocess.Popen([sys.executable, "-c", code], cwd=ROOT, stdout=subprocess.PIPE)
    assert engine.stdout is not None
    pids = [int(engine.stdout.readline()) for _ in range(2)]
    engine.stdout.readline()
    engine.kill()
    engine.communicate()
    deadline = time.monotonic() + 2
    while any(Path(f"/proc/{pid}").exists() for pid in pids):
        assert time.monotonic() < deadline
        time.sleep(0.02)
