"""What is built and shipped: pins, no registry's address, the compose file's services."""

import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[1]
BUILD_FILES = [
    ".ci/run",
    ".dockerignore",
    "Dockerfile",
    "Makefile",
    "constraints.txt",
    "docker-compose.yml",
    "pyproject.toml",
    "sdk/config.yml",
    "sdk/generate.py",
    "sdk/python/pyproject.toml",
]
ADDRESS = re.compile(r"https?://(?!127\.0\.0\.1)|index-url|find-links|file://")
HEALTHY_WITHIN = 60.0  # s; the first start compiles the kernels


def _compose() -> dict[str, Any]:
    services: dict[str, Any] = yaml.safe_load((ROOT / "docker-compose.yml").read_text())["services"]
    return services


def _distribution(requirement: str) -> str:
    """Return the normalised name at the start of a requirement."""
    name = re.split(r"[^\w.-]", requirement, maxsplit=1)[0]
    return re.sub(r"[-_.]+", "-", name).lower()


@pytest.mark.parametrize("name", BUILD_FILES)
def test_build_files_name_no_registry(name: str) -> None:
    assert not ADDRESS.search((ROOT / name).read_text())


def test_constraints_are_names_and_versions_only() -> None:
    lines = (ROOT / "constraints.txt").read_text().splitlines()
    assert [line for line in lines if not re.fullmatch(r"[\w.-]+==[\w.]+", line)] == []


def test_every_direct_dependency_is_pinned() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    wanted = chain(project["dependencies"], *project["optional-dependencies"].values())
    pinned = {_distribution(line) for line in (ROOT / "constraints.txt").read_text().splitlines()}
    assert {_distribution(requirement) for requirement in wanted} <= pinned


def test_docker_accepts_the_compose_file() -> None:
    docker = shutil.which("docker")
    if docker is None:
        pytest.skip("no docker client here")
    if subprocess.run([docker, "compose", "version"], capture_output=True, check=False).returncode:
        pytest.skip("the docker client here has no compose")
    outcome = subprocess.run(
        [docker, "compose", "config", "--quiet"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert outcome.returncode == 0, outcome.stderr


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    """Return the services' environment, its folder, host and port moved to this machine's own."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    inherited = {key: value for key, value in os.environ.items() if not key.startswith("PARMECH_")}
    return {
        **inherited,
        **_compose()["api"]["environment"],
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        "PARMECH_DATA": str(tmp_path),
        "PARMECH_HOST": "127.0.0.1",
        "PARMECH_PORT": str(port),
    }


@contextmanager
def _running(command: list[str], environment: dict[str, str]) -> Iterator[subprocess.Popen[bytes]]:
    folder = environment["PARMECH_DATA"]
    with subprocess.Popen(
        command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, start_new_session=True
    ) as process:
        try:
            yield process
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)


def _healthy(service: dict[str, Any], environment: dict[str, str]) -> bool:
    how, *check = service["healthcheck"]["test"]
    assert how == "CMD"
    outcome = subprocess.run(
        check, cwd=environment["PARMECH_DATA"], env=environment, capture_output=True, check=False
    )
    return outcome.returncode == 0


@pytest.mark.parametrize("name", ["api", "engine"])
def test_compose_service_becomes_healthy_and_stops(name: str, environment: dict[str, str]) -> None:
    services = _compose()
    subprocess.run(
        services["migrate"]["command"],
        cwd=environment["PARMECH_DATA"],
        env=environment,
        stdin=subprocess.DEVNULL,
        check=True,
    )
    assert not _healthy(services[name], environment)
    with _running(services[name]["command"], environment) as process:
        deadline = time.monotonic() + HEALTHY_WITHIN
        while not _healthy(services[name], environment):
            assert process.poll() is None, "it ended by itself"
            assert time.monotonic() < deadline, "it did not become healthy in time"
            time.sleep(0.1)
        process.terminate()
        grace = float(services[name]["stop_grace_period"].removesuffix("s"))
        assert process.wait(grace) in (0, -signal.SIGTERM)


def test_everything_in_the_wheel_enters_the_image() -> None:
    tool = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]
    included = tool["hatch"]["build"]["targets"]["wheel"]["only-include"]
    allowed = {line.removeprefix("!") for line in (ROOT / ".dockerignore").read_text().split()}
    assert set(included) <= allowed
