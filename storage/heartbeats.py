"""Signs of life of the engines."""

from sqlalchemy import delete, func, select, update

from storage.clock import now
from storage.database import Database, insert_or_nothing
from storage.tables import heartbeats

# An engine silent for so long is forgotten. [s]
_FORGOTTEN_AFTER = 24 * 3600.0


class Heartbeats:
    """When each engine was last heard of."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def beat(self, owner: str) -> None:
        """Note that an engine lives."""
        with self._database.writing() as connection:
            if not insert_or_nothing(connection, heartbeats, {"owner": owner, "beat": now()}):
                mine = heartbeats.c.owner == owner
                connection.execute(update(heartbeats).where(mine).values(beat=now()))
            forgotten = heartbeats.c.beat < now() - _FORGOTTEN_AFTER
            connection.execute(delete(heartbeats).where(forgotten))

    def end(self, owner: str) -> None:
        """Note that an engine stopped in good order."""
        with self._database.writing() as connection:
            connection.execute(delete(heartbeats).where(heartbeats.c.owner == owner))

    def youngest_age(self) -> float | None:
        """Return the seconds since an engine was last heard of, None without any."""
        with self._database.reading() as connection:
            age = connection.execute(select(now() - func.max(heartbeats.c.beat))).scalar_one()
        return None if age is None else max(0.0, float(age))
