"""A service in this process, over a folder of its own, without any worker."""

import shutil
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
from starlette.exceptions import StarletteDeprecationWarning

import storage
from service.app import create_app
from settings import Settings
from storage import Job, Queue

with warnings.catch_warnings():
    # The test client is given httpx, whose successor it would rather have.
    warnings.simplefilter("ignore", StarletteDeprecationWarning)
    from fastapi.testclient import TestClient

DATABASE = "parmech.sqlite"
PROBLEM_FIELDS = {"type", "title", "status", "detail", "errors"}


class Service:
    """A running service.

    Parameters
    ----------
    settings : Settings
        Its settings.
    client : TestClient
        Speaks to it.
    database : Database
        What it keeps, seen from outside.
    """

    def __init__(self, settings: Settings, client: TestClient, database: storage.Database) -> None:
        self.settings = settings
        self.client = client
        self.database = database

    def get(self, path: str, **options: Any) -> httpx.Response:  # noqa: ANN401
        """Return the answer to a GET."""
        answer: httpx.Response = self.client.get(path, **options)
        return answer

    def post(self, path: str, body: Any, **headers: str) -> httpx.Response:  # noqa: ANN401
        """Return the answer to a POST of a JSON document; in header names _ stands for -."""
        named = {name.replace("_", "-"): value for name, value in headers.items()}
        answer: httpx.Response = self.client.post(path, json=body, headers=named)
        return answer

    def post_text(self, path: str, text: str | bytes) -> httpx.Response:
        """Return the answer to a POST of a text that is said to be JSON."""
        headers = {"Content-Type": "application/json"}
        answer: httpx.Response = self.client.post(path, content=text, headers=headers)
        return answer

    def rows(self) -> dict[str, int]:
        """Return how many rows every table has."""
        tables = "SELECT name FROM sqlite_master WHERE type = 'table'"
        with self.database.reading() as connection:
            names = list(connection.exec_driver_sql(tables).scalars())
            return {
                name: connection.exec_driver_sql(f'SELECT count(*) FROM "{name}"').scalar_one()
                for name in names
            }


@contextmanager
def service(folder: Path, migrated: Path | None, **settings: Any) -> Iterator[Service]:  # noqa: ANN401
    """Yield a service over a folder, with a copy of a migrated database if one is given."""
    folder.mkdir(exist_ok=True)
    if migrated is not None:
        shutil.copy(migrated, folder / DATABASE)
    chosen = Settings(data=folder, **settings)
    database = storage.open_database(chosen.resolved_database_url)
    with TestClient(create_app(chosen), raise_server_exceptions=False) as client:
        yield Service(chosen, client, database)
    database.close()


def assert_problem(answer: httpx.Response, status: int, *pointers: str) -> None:
    """Fail unless this is a problem of the status with faults at just these pointers."""
    assert answer.status_code == status, answer.text[:500]
    assert answer.headers["content-type"] == "application/problem+json"
    problem = answer.json()
    assert problem.keys() == PROBLEM_FIELDS
    assert problem["status"] == status
    assert problem["title"]
    assert problem["detail"]
    if pointers:
        assert [fault["pointer"] for fault in problem["errors"]] == list(pointers), problem
        assert all(fault["detail"] for fault in problem["errors"])


def claimed(api: Service, body: dict[str, Any]) -> tuple[Queue, Job]:
    """Return a job that an engine has taken up, and the engine's queue."""
    assert api.post("/v1/jobs", body).status_code == 201
    queue = Queue(api.database, "an engine", lease_seconds=60)
    job = queue.claim()
    assert job is not None
    return queue, job
