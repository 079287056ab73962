"""Brings the tables of a database up to this version of the program."""

import time
from pathlib import Path

from alembic import command
from sqlalchemy import Engine, text
from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import OperationalError

from storage.database import BUSY_SECONDS, create_database_engine
from storage.errors import DatabaseUnavailable
from storage.migrations import alembic_config

# Any number that nothing else in the database uses.
_ADVISORY_LOCK = 0x70_61_72_6D


def migrate(url: str) -> None:
    """Make or upgrade the tables; safe to run again, and by several processes at once.

    Parameters
    ----------
    url : str
        SQLAlchemy URL. The folder of an SQLite file is made if it is not there.

    Raises
    ------
    DatabaseUnavailable : The database cannot be reached or stays locked.
    """
    parsed = make_url(url)
    if parsed.get_backend_name() == "sqlite":
        _make_folder(parsed)
    engine = create_database_engine(url)
    try:
        if engine.dialect.name == "sqlite":
            _switch_to_wal(engine)
        _upgrade(engine)
    except OperationalError as error:
        raise DatabaseUnavailable(str(error.orig)) from error
    finally:
        engine.dispose()


def _make_folder(url: URL) -> None:
    if url.database and url.database != ":memory:":
        Path(url.database).parent.mkdir(parents=True, exist_ok=True)


def _upgrade(engine: Engine) -> None:
    # One transaction under a lock: the second process waits, then finds nothing to do.
    with engine.execution_options(writes=True).begin() as connection:
        if connection.dialect.name == "postgresql":
            connection.execute(text("SELECT pg_advisory_xact_lock(:key)"), {"key": _ADVISORY_LOCK})
        config = alembic_config()
        config.attributes["connection"] = connection
        command.upgrade(config, "head")


def _switch_to_wal(engine: Engine) -> None:
    """Let readers and a writer work side by side; the file remembers it."""
    deadline = time.monotonic() + BUSY_SECONDS
    while True:
        try:
            _set_wal(engine)
        except OperationalError:
            # SQLite's busy timeout does not cover this switch.
            if time.monotonic() > deadline:
                raise
            time.sleep(0.05)
        else:
            return


def _set_wal(engine: Engine) -> None:
    connection = engine.raw_connection()
    try:
        cursor = connection.cursor()
        cursor.execute("PRAGMA journal_mode = WAL")
        cursor.close()
    finally:
        connection.close()
