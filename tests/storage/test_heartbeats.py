import pytest

import storage


@pytest.fixture
def heartbeats(database: storage.Database) -> storage.Heartbeats:
    return storage.Heartbeats(database)


def test_without_engines_there_is_no_age(heartbeats: storage.Heartbeats) -> None:
    assert heartbeats.youngest_age() is None


def test_the_youngest_beat_counts(heartbeats: storage.Heartbeats) -> None:
    for owner in ("a", "b", "a"):
        heartbeats.beat(owner)
    age = heartbeats.youngest_age()
    assert age is not None
    assert 0 <= age < 5


def test_an_engine_that_stopped_does_not_count(heartbeats: storage.Heartbeats) -> None:
    heartbeats.beat("a")
    heartbeats.end("a")
    assert heartbeats.youngest_age() is None
