"""`/healthz` and `/readyz`."""

from collections.abc import Callable
from pathlib import Path

from storage import Heartbeats
from tests.service.services import Service, assert_problem, service


def test_a_service_is_alive(refusing: Service) -> None:
    answer = refusing.get("/healthz")
    assert (answer.status_code, answer.json()) == (200, {"status": "alive"})


def test_it_is_not_ready_before_a_worker_was_heard_of(api: Service) -> None:
    answer = api.get("/readyz")
    assert_problem(answer, 503)
    assert "worker" in answer.json()["detail"]
    assert "Retry-After" in answer.headers


def test_it_is_ready_with_a_worker(api: Service) -> None:
    Heartbeats(api.database).beat("an engine")
    answer = api.get("/readyz")
    assert answer.status_code == 200
    assert answer.json()["status"] == "ready"
    assert 0 <= answer.json()["worker_heartbeat_age"] < 15


def test_it_is_not_ready_once_the_worker_fell_silent(start: Callable[..., Service]) -> None:
    api = start(lease_seconds=1e-6)
    Heartbeats(api.database).beat("an engine")
    assert_problem(api.get("/readyz"), 503)


def test_it_is_not_ready_once_the_worker_stopped(api: Service) -> None:
    heartbeats = Heartbeats(api.database)
    heartbeats.beat("an engine")
    heartbeats.end("an engine")
    assert_problem(api.get("/readyz"), 503)


def test_it_is_not_ready_before_migration(tmp_path: Path) -> None:
    with service(tmp_path / "data", migrated=None) as unmigrated:
        answer = unmigrated.get("/readyz")
        assert_problem(answer, 503)
        assert "migrate" in answer.json()["detail"]


def test_it_is_alive_before_migration(tmp_path: Path) -> None:
    with service(tmp_path / "data", migrated=None) as unmigrated:
        assert unmigrated.get("/healthz").status_code == 200


def test_what_needs_the_database_is_unavailable_before_migration(tmp_path: Path) -> None:
    with service(tmp_path / "data", migrated=None) as unmigrated:
        answer = unmigrated.get("/v1/jobs")
        assert_problem(answer, 503)
        assert "Retry-After" in answer.headers
