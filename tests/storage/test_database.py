import subprocess
import sys
from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.runtime.migration import MigrationContext
from sqlalchemy import Connection, func, insert, select

import storage
from storage.clock import now
from storage.tables import heartbeats, metadata

ROOT = Path(__file__).parents[2]


def _count(connection: Connection) -> int:
    return connection.execute(select(func.count()).select_from(heartbeats)).scalar_one()


def _run_together(code: str, processes: int) -> list[int]:
    running = [subprocess.Popen([sys.executable, "-c", code], cwd=ROOT) for _ in range(processes)]
    return [process.wait(60) for process in running]


def test_a_new_file_is_not_current(url: str) -> None:
    database = storage.open_database(url)
    assert not database.is_current()
    database.close()


def test_a_migrated_database_is_current(database: storage.Database) -> None:
    assert database.is_current()


def test_migrating_again_keeps_what_is_there(url: str, database: storage.Database) -> None:
    storage.Mechanisms(database).add("id", "{}")
    storage.migrate(url)
    assert storage.Mechanisms(database).get("id").spec_json == "{}"


def test_migrating_makes_the_folder(tmp_path: Path) -> None:
    storage.migrate(f"sqlite:///{tmp_path / 'a' / 'b' / 'c.sqlite'}")
    assert (tmp_path / "a" / "b" / "c.sqlite").exists()


def test_processes_may_migrate_at_once(url: str) -> None:
    assert _run_together(f"import storage; storage.migrate({url!r})", 4) == [0] * 4


def test_the_migrations_make_the_tables_that_the_code_sees(database: storage.Database) -> None:
    with database.reading() as connection:
        context = MigrationContext.configure(connection)
        assert compare_metadata(context, metadata) == []


def test_sqlite_writes_ahead_and_syncs(database: storage.Database) -> None:
    with database.reading() as connection:
        pragmas = ("journal_mode", "synchronous", "foreign_keys")
        values = [connection.exec_driver_sql(f"PRAGMA {pragma}").scalar() for pragma in pragmas]
    assert values == ["wal", 2, 1]


def test_the_clock_is_the_time_since_the_epoch(database: storage.Database) -> None:
    with database.reading() as connection:
        by_clock, by_sqlite = connection.execute(select(now(), func.strftime("%s", "now"))).one()
    assert by_clock == pytest.approx(float(by_sqlite), abs=1.5)


def test_a_write_that_raises_leaves_nothing(database: storage.Database) -> None:
    def write_half() -> None:
        with database.writing() as connection:
            connection.execute(insert(heartbeats).values(owner="half", beat=0.0))
            raise RuntimeError

    with pytest.raises(RuntimeError):
        write_half()
    with database.reading() as connection:
        assert _count(connection) == 0


def test_a_reader_sees_one_state_while_another_writes(database: storage.Database) -> None:
    with database.reading() as reader:
        before = _count(reader)
        with database.writing() as writer:
            writer.execute(insert(heartbeats).values(owner="new", beat=0.0))
        assert _count(reader) == before


def test_processes_that_read_and_then_write_lose_nothing(
    url: str, database: storage.Database
) -> None:
    with database.writing() as connection:
        connection.execute(insert(heartbeats).values(owner="counter", beat=0.0))
    code = f"""
import storage
from sqlalchemy import select, update
from storage.tables import heartbeats
database = storage.open_database({url!r})
for _ in range(50):
    with database.writing() as connection:
        beat = connection.execute(select(heartbeats.c.beat)).scalar_one()
        connection.execute(update(heartbeats).values(beat=beat + 1))
"""
    assert _run_together(code, 2) == [0, 0]
    with database.reading() as connection:
        assert connection.execute(select(heartbeats.c.beat)).scalar_one() == 100.0


def test_a_database_that_cannot_be_opened_is_unavailable(tmp_path: Path) -> None:
    database = storage.open_database(f"sqlite:///{tmp_path / 'no' / 'folder.sqlite'}")
    with pytest.raises(storage.DatabaseUnavailable):
        database.is_current()


def test_another_kind_of_database_is_refused() -> None:
    with pytest.raises(storage.DatabaseUnsupported, match="mysql"):
        storage.open_database("mysql://somewhere/parmech")
