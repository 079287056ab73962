from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

import analyses
import logs
import storage
from tests.service.services import DATABASE, Service, claimed, service


@pytest.fixture(scope="session")
def migrated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return an empty database of this version, to be copied."""
    path = tmp_path_factory.mktemp("migrated") / DATABASE
    storage.migrate(f"sqlite:///{path}")
    return path


@pytest.fixture(autouse=True, scope="package")
def _short_logs() -> None:
    logs.configure()


@pytest.fixture
def start(tmp_path: Path, migrated: Path) -> Iterator[Callable[..., Service]]:
    """Return what starts a service with some settings."""
    with ExitStack() as stack:
        yield lambda **settings: stack.enter_context(
            service(tmp_path / "data", migrated, **settings)
        )


@pytest.fixture
def api(start: Callable[..., Service]) -> Service:
    """Return a service with nothing in it."""
    return start()


@pytest.fixture(scope="package")
def refusing(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Iterator[Service]:
    """Return a service that tests share because they store nothing in it."""
    with service(tmp_path_factory.mktemp("refusing"), migrated) as shared:
        yield shared


@pytest.fixture
def run(api: Service) -> Callable[[dict[str, Any]], dict[str, Any]]:
    """Return what submits a request and answers it as an engine would."""

    def run(body: dict[str, Any]) -> dict[str, Any]:
        queue, job = claimed(api, body)
        request = analyses.parse(queue.request(job))
        pieces = [analyses.compute(request, *job.bounds(tile)) for tile in range(job.tiles)]
        for tile, piece in enumerate(pieces):
            queue.store_tile(job, tile, storage.pack_arrays(piece))
        queue.succeed(job, analyses.assemble(request, lambda: pieces).model_dump_json())
        answer: dict[str, Any] = api.get(f"/v1/jobs/{job.id}").json()
        return answer

    return run
