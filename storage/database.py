"""The connection to the database: one kind of transaction to read, one to write."""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import Any

from alembic.runtime.migration import MigrationContext
from sqlalchemy import Connection, Engine, Table, create_engine, event, literal
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.engine import make_url
from sqlalchemy.engine.interfaces import DBAPIConnection
from sqlalchemy.exc import InterfaceError, OperationalError
from sqlalchemy.exc import TimeoutError as PoolTimeout
from sqlalchemy.pool import ConnectionPoolEntry

from storage.errors import DatabaseUnavailable, DatabaseUnsupported
from storage.migrations import newest_revision

# How long a writer waits for the writer before it. [s]
BUSY_SECONDS = 10.0


class Database:
    """An open database.

    Parameters
    ----------
    engine : Engine
        Engine whose SQLite connections leave BEGIN to `open_database`.
    """

    def __init__(self, engine: Engine) -> None:
        self._reader = engine
        self._writer = engine.execution_options(writes=True)

    @contextmanager
    def reading(self) -> Iterator[Connection]:
        """Yield a connection that sees one state of the database and writes nothing.

        Raises
        ------
        DatabaseUnavailable : The database cannot be reached.
        """
        with _translating_errors(), self._reader.connect() as connection:
            yield connection

    @contextmanager
    def writing(self) -> Iterator[Connection]:
        """Yield a connection whose writes are kept together, or not at all on an exception.

        Raises
        ------
        DatabaseUnavailable : The database cannot be reached or stays locked.
        """
        with _translating_errors(), self._writer.begin() as connection:
            yield connection

    def is_current(self) -> bool:
        """Return whether the tables are those of this version of the program."""
        with self.reading() as connection:
            heads = MigrationContext.configure(connection).get_current_heads()
        return heads == (self._newest_revision,)

    def close(self) -> None:
        """Close the connections that are not in use."""
        self._reader.dispose()

    @cached_property
    def _newest_revision(self) -> str:
        return newest_revision()


def open_database(url: str) -> Database:
    """Return the database at a URL; connections open when they are first needed.

    Parameters
    ----------
    url : str
        SQLAlchemy URL. SQLite and PostgreSQL are supported.
    """
    return Database(create_database_engine(url))


def create_database_engine(url: str) -> Engine:
    """Return an engine on which `writes=True` connections take SQLite's write lock at once."""
    backend = make_url(url).get_backend_name()
    if backend not in ("sqlite", "postgresql"):
        raise DatabaseUnsupported(backend, "only sqlite and postgresql are")
    if backend == "postgresql":
        try:
            return create_engine(url, pool_size=10, max_overflow=40, pool_pre_ping=True)
        except ModuleNotFoundError as error:
            raise DatabaseUnsupported(backend, f"its driver is missing ({error})") from error
    engine = create_engine(
        url, pool_size=10, max_overflow=40, connect_args={"timeout": BUSY_SECONDS}
    )
    event.listen(engine, "connect", _prepare_sqlite)
    event.listen(engine, "begin", _begin_sqlite)
    return engine


def insert_or_nothing(connection: Connection, table: Table, values: dict[str, Any]) -> bool:
    """Insert a row unless its key is taken.

    Returns
    -------
    bool
        Whether the row was inserted.
    """
    dialect = sqlite if connection.dialect.name == "sqlite" else postgresql
    row = dialect.insert(table).values(values).on_conflict_do_nothing()
    # Not rowcount, which drivers do not set for every INSERT.
    return connection.execute(row.returning(literal(1))).first() is not None


def _prepare_sqlite(connection: DBAPIConnection, _entry: ConnectionPoolEntry) -> None:
    # The driver would begin transactions late and deferred; `_begin_sqlite` does it instead.
    connection.isolation_level = None
    cursor = connection.cursor()
    cursor.execute("PRAGMA foreign_keys = ON")
    # An answered request survives a power cut; NORMAL would only survive a crash.
    cursor.execute("PRAGMA synchronous = FULL")
    cursor.close()


def _begin_sqlite(connection: Connection) -> None:
    # A deferred transaction that turns writer late fails at once, whatever the busy timeout.
    writes = connection.get_execution_options().get("writes", False)
    connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")


@contextmanager
def _translating_errors() -> Iterator[None]:
    try:
        yield
    except PoolTimeout as error:
        raise DatabaseUnavailable(str(error)) from error
    except (OperationalError, InterfaceError) as error:
        raise DatabaseUnavailable(str(error.orig)) from error
