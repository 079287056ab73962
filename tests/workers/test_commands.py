import signal
import socket
import subprocess
from pathlib import Path
from urllib.request import urlopen

import pytest

from storage import JobState
from tests.workers.works import Works, is_alive, wait_until


@pytest.fixture
def port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def serve(works: Works, port: int) -> subprocess.Popen[bytes]:
    """Start `parmech serve` and wait until it says that it is ready."""
    code = "import commands; commands.app()"
    supervisor = works.start("-c", code, "serve", "--port", str(port))
    assert supervisor.stdout is not None
    expected = f"parmech is ready at http://127.0.0.1:{port}\n"
    assert supervisor.stdout.readline().decode() == expected
    wait_until(works.beating)
    return supervisor


def children_of(pid: int) -> set[int]:
    """Return the processes below one."""
    direct = {
        int(child)
        for tasks in Path(f"/proc/{pid}/task").glob("*/children")
        for child in tasks.read_text().split()
    }
    return direct.union(*map(children_of, direct))


def service_pid(port: int) -> int | None:
    try:
        with urlopen(f"http://127.0.0.1:{port}/", timeout=1) as answer:
            return int(answer.read())
    except OSError:
        return None


def engine_pid(works: Works) -> int:
    (owner,) = works.beating()
    return int(owner.split(":")[1])


def test_migrating_makes_the_database(works: Works) -> None:
    folder = works.folder / "new"
    code = "import commands; commands.app()"
    assert works.start("-c", code, "migrate", "--data", str(folder)).wait(30) == 0
    assert (folder / "parmech.sqlite").exists()


def test_what_is_served_runs_jobs(works: Works, port: int) -> None:
    serve(works, port)
    assert works.wait_for(works.submit(), JobState.SUCCESSFUL).done == 4


def test_a_taken_port_is_told(works: Works) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        code = "import commands; commands.app()"
        assert works.start("-c", code, "serve", "--port", port).wait(30) == 1


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_supervisor_that_is_stopped_stops_everything(
    works: Works, port: int, number: signal.Signals
) -> None:
    supervisor = serve(works, port)
    below = children_of(supervisor.pid)
    supervisor.send_signal(number)
    assert supervisor.wait(10) == 0
    wait_until(lambda: not any(map(is_alive, below)), seconds=2.0)
    assert works.beating() == set()


def test_a_killed_supervisor_leaves_nothing_behind(works: Works, port: int) -> None:
    supervisor = serve(works, port)
    job = works.submit(do={"0": "hang", "1": "hang"})
    wait_until(lambda: len(works.begun(job)) == 2)
    below = children_of(supervisor.pid)
    assert works.worker_pids(job) <= below
    supervisor.kill()
    wait_until(lambda: not any(map(is_alive, below)), seconds=2.5)


def test_a_killed_engine_is_started_again_beside_the_same_service(works: Works, port: int) -> None:
    supervisor = serve(works, port)
    service = service_pid(port)
    job = works.submit(items=8, seconds=0.2)
    works.wait_for_done(job, 2)
    subprocess.run(["kill", "-9", str(engine_pid(works))], check=True)
    assert works.wait_for(job, JobState.SUCCESSFUL).attempt == 2
    assert service_pid(port) == service
    assert supervisor.poll() is None


def test_a_killed_service_is_started_again_beside_the_same_engine(works: Works, port: int) -> None:
    serve(works, port)
    engine, service = engine_pid(works), service_pid(port)
    subprocess.run(["kill", "-9", str(service)], check=True)
    wait_until(lambda: service_pid(port) not in (None, service))
    assert engine_pid(works) == engine
