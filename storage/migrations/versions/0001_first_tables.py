"""The first tables."""

import sqlalchemy as sa
from alembic import op

revision = "0001"
down_revision = None
branch_labels = None
depends_on = None


def upgrade() -> None:
    _create_mechanisms()
    _create_jobs()
    _create_what_belongs_to_a_job()
    _create_idempotency_keys()
    op.create_table(
        "heartbeats",
        sa.Column("owner", sa.String(128), nullable=False),
        sa.Column("beat", sa.Double, nullable=False),
        sa.PrimaryKeyConstraint("owner", name="pk_heartbeats"),
    )


def downgrade() -> None:
    for table in (
        "heartbeats",
        "idempotency_keys",
        "tiles",
        "results",
        "requests",
        "jobs",
        "mechanisms",
    ):
        op.drop_table(table)


def _create_mechanisms() -> None:
    op.create_table(
        "mechanisms",
        sa.Column("id", sa.String(64), nullable=False),
        sa.Column("spec", sa.Text, nullable=False),
        sa.Column("created", sa.Double, nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_mechanisms"),
    )
    op.create_index("ix_mechanisms_created_id", "mechanisms", ["created", "id"])


def _create_jobs() -> None:
    op.create_table(
        "jobs",
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("analysis", sa.String(64), nullable=False),
        sa.Column("mechanism_id", sa.String(64)),
        sa.Column("state", sa.String(16), nullable=False),
        sa.Column("items", sa.BigInteger, nullable=False),
        sa.Column("items_per_tile", sa.BigInteger, nullable=False),
        sa.Column("done", sa.BigInteger, nullable=False),
        sa.Column("attempt", sa.Integer, nullable=False),
        sa.Column("revision", sa.Integer, nullable=False),
        sa.Column("created", sa.Double, nullable=False),
        sa.Column("started", sa.Double),
        sa.Column("finished", sa.Double),
        sa.Column("cancel_requested", sa.Boolean, nullable=False),
        sa.Column("owner", sa.String(128)),
        sa.Column("lease_until", sa.Double),
        sa.Column("error", sa.Text),
        sa.PrimaryKeyConstraint("id", name="pk_jobs"),
    )
    op.create_index("ix_jobs_created_id", "jobs", ["created", "id"])
    op.create_index("ix_jobs_state_created", "jobs", ["state", "created"])


def _create_what_belongs_to_a_job() -> None:
    for table, column in (("requests", "request"), ("results", "result")):
        op.create_table(
            table,
            sa.Column("job_id", sa.String(32), nullable=False),
            sa.Column(column, sa.Text, nullable=False),
            sa.PrimaryKeyConstraint("job_id", name=f"pk_{table}"),
            _owned_by_job(table),
        )
    op.create_table(
        "tiles",
        sa.Column("job_id", sa.String(32), nullable=False),
        sa.Column("index", sa.Integer, nullable=False),
        sa.Column("attempt", sa.Integer, nullable=False),
        sa.Column("items", sa.BigInteger, nullable=False),
        sa.Column("stored", sa.Double, nullable=False),
        sa.Column("arrays", sa.LargeBinary, nullable=False),
        sa.PrimaryKeyConstraint("job_id", "index", name="pk_tiles"),
        _owned_by_job("tiles"),
    )


def _owned_by_job(table: str) -> sa.ForeignKeyConstraint:
    return sa.ForeignKeyConstraint(
        ["job_id"], ["jobs.id"], name=f"fk_{table}_job_id", ondelete="CASCADE"
    )


def _create_idempotency_keys() -> None:
    op.create_table(
        "idempotency_keys",
        sa.Column("key", sa.Text, nullable=False),
        sa.Column("job_id", sa.String(32), nullable=False),
        sa.Column("body_hash", sa.String(128), nullable=False),
        sa.Column("created", sa.Double, nullable=False),
        sa.PrimaryKeyConstraint("key", name="pk_idempotency_keys"),
    )
    for column in ("created", "job_id"):
        op.create_index(f"ix_idempotency_keys_{column}", "idempotency_keys", [column])
