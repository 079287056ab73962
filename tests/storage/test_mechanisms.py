import pytest

import storage


@pytest.fixture
def mechanisms(database: storage.Database) -> storage.Mechanisms:
    return storage.Mechanisms(database)


def test_the_same_mechanism_is_kept_once(mechanisms: storage.Mechanisms) -> None:
    assert [mechanisms.add("a", "{}"), mechanisms.add("a", "{}")] == [True, False]


def test_a_mechanism_that_is_not_there_is_named(mechanisms: storage.Mechanisms) -> None:
    with pytest.raises(storage.MechanismNotFound, match="'b'"):
        mechanisms.get("b")


def test_pages_go_through_all_newest_first(mechanisms: storage.Mechanisms) -> None:
    for name in "abcde":
        mechanisms.add(name, "{}")
    everything = mechanisms.page(size=10)
    first = mechanisms.page(size=2)
    rest = mechanisms.page(size=10, after=first[-1].cursor)
    assert first + rest == everything
    assert everything == sorted(everything, key=lambda each: each.cursor, reverse=True)
    assert len(everything) == 5


def test_a_removed_mechanism_is_gone(mechanisms: storage.Mechanisms) -> None:
    mechanisms.add("a", "{}")
    mechanisms.delete("a")
    with pytest.raises(storage.MechanismNotFound):
        mechanisms.delete("a")
