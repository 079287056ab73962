from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import storage


@pytest.fixture
def url(tmp_path: Path) -> str:
    return f"sqlite:///{tmp_path / 'parmech.sqlite'}"


@pytest.fixture
def database(url: str) -> Iterator[storage.Database]:
    storage.migrate(url)
    database = storage.open_database(url)
    yield database
    database.close()


@pytest.fixture
def jobs(database: storage.Database) -> storage.Jobs:
    return storage.Jobs(database, queue_limit=100)


@pytest.fixture
def open_queue(database: storage.Database) -> Callable[..., storage.Queue]:
    def open_one(owner: str, lease_seconds: float = 60.0, max_attempts: int = 5) -> storage.Queue:
        return storage.Queue(
            database, owner, lease_seconds=lease_seconds, max_attempts=max_attempts
        )

    return open_one


@pytest.fixture
def queue(open_queue: Callable[..., storage.Queue]) -> storage.Queue:
    return open_queue("first")


@pytest.fixture
def new_job() -> Callable[..., storage.NewJob]:
    def make(**given: object) -> storage.NewJob:
        values: dict[str, object] = {
            "analysis": "workspace",
            "request_json": '{"analysis": "workspace"}',
            "items": 10,
            "items_per_tile": 4,
            "body_hash": "hash",
        }
        return storage.NewJob(**(values | given))  # type: ignore[arg-type]

    return make
