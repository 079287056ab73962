"""The stored mechanisms."""

from sqlalchemy import Row, delete, select, tuple_

from storage.clock import now
from storage.database import Database, insert_or_nothing
from storage.errors import MechanismNotFound
from storage.records import Cursor, StoredMechanism
from storage.tables import mechanisms


class Mechanisms:
    """The mechanisms kept under the hash of their specification."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def add(self, mechanism_id: str, spec_json: str) -> bool:
        """Keep a mechanism.

        Returns
        -------
        bool
            Whether it was new.
        """
        values = {"id": mechanism_id, "spec": spec_json, "created": now()}
        with self._database.writing() as connection:
            return insert_or_nothing(connection, mechanisms, values)

    def get(self, mechanism_id: str) -> StoredMechanism:
        """Return one mechanism.

        Raises
        ------
        MechanismNotFound : There is none of this id.
        """
        with self._database.reading() as connection:
            row = connection.execute(
                select(mechanisms).where(mechanisms.c.id == mechanism_id)
            ).one_or_none()
        if row is None:
            raise MechanismNotFound(mechanism_id)
        return _mechanism(row)

    def page(self, *, after: Cursor | None = None, size: int) -> list[StoredMechanism]:
        """Return up to `size` mechanisms, newest first, those after `after`."""
        query = select(mechanisms).order_by(mechanisms.c.created.desc(), mechanisms.c.id.desc())
        if after is not None:
            query = query.where(tuple_(mechanisms.c.created, mechanisms.c.id) < tuple_(*after))
        with self._database.reading() as connection:
            return [_mechanism(row) for row in connection.execute(query.limit(size))]

    def delete(self, mechanism_id: str) -> None:
        """Remove a mechanism; jobs that named it carry their own copy.

        Raises
        ------
        MechanismNotFound : There is none of this id.
        """
        with self._database.writing() as connection:
            removed = connection.execute(delete(mechanisms).where(mechanisms.c.id == mechanism_id))
        if removed.rowcount == 0:
            raise MechanismNotFound(mechanism_id)


def _mechanism(row: Row[str, str, float]) -> StoredMechanism:
    return StoredMechanism(row.id, row.spec, row.created)
