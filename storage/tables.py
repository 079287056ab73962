"""The tables as the code sees them; migrations/ makes them."""

from sqlalchemy import (
    BigInteger,
    Boolean,
    Column,
    Double,
    ForeignKey,
    Index,
    Integer,
    LargeBinary,
    MetaData,
    String,
    Table,
    Text,
)

metadata = MetaData(
    naming_convention={
        "ix": "ix_%(table_name)s_%(column_0_N_name)s",
        "fk": "fk_%(table_name)s_%(column_0_name)s",
        "pk": "pk_%(table_name)s",
    }
)

mechanisms = Table(
    "mechanisms",
    metadata,
    Column("id", String(64), primary_key=True),
    Column("spec", Text, nullable=False),
    Column("created", Double, nullable=False),
    Index(None, "created", "id"),
)

# Small rows: they are read by every poll and written by every tile. What is large stands in
# `requests`, `results` and `tiles`.
jobs = Table(
    "jobs",
    metadata,
    Column("id", String(32), primary_key=True),
    Column("analysis", String(64), nullable=False),
    # No foreign key: a job carries its whole request and outlives the mechanism.
    Column("mechanism_id", String(64)),
    Column("state", String(16), nullable=False),
    Column("items", BigInteger, nullable=False),
    Column("items_per_tile", BigInteger, nullable=False),
    Column("done", BigInteger, nullable=False),
    Column("attempt", Integer, nullable=False),
    Column("revision", Integer, nullable=False),
    Column("created", Double, nullable=False),
    Column("started", Double),
    Column("finished", Double),
    Column("cancel_requested", Boolean, nullable=False),
    Column("owner", String(128)),
    Column("lease_until", Double),
    Column("error", Text),
    Index(None, "created", "id"),
    Index(None, "state", "created"),
)


def _job_key() -> Column[str]:
    owned = ForeignKey("jobs.id", ondelete="CASCADE")
    return Column("job_id", String(32), owned, primary_key=True)


requests = Table("requests", metadata, _job_key(), Column("request", Text, nullable=False))

results = Table("results", metadata, _job_key(), Column("result", Text, nullable=False))

tiles = Table(
    "tiles",
    metadata,
    _job_key(),
    Column("index", Integer, primary_key=True, autoincrement=False),
    Column("attempt", Integer, nullable=False),
    Column("items", BigInteger, nullable=False),
    Column("stored", Double, nullable=False),
    Column("arrays", LargeBinary, nullable=False),
)

idempotency_keys = Table(
    "idempotency_keys",
    metadata,
    Column("key", Text, primary_key=True),
    Column("job_id", String(32), nullable=False, index=True),
    Column("body_hash", String(128), nullable=False),
    Column("created", Double, nullable=False, index=True),
)

heartbeats = Table(
    "heartbeats",
    metadata,
    Column("owner", String(128), primary_key=True),
    Column("beat", Double, nullable=False),
)
