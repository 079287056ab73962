"""Everything that can be set from outside, read once from the environment."""

from pathlib import Path

from pydantic import Field
from pydantic_settings import BaseSettings, SettingsConfigDict


class Settings(BaseSettings):
    """Settings of one parmech process, each overridable as `PARMECH_<NAME>`."""

    model_config = SettingsConfigDict(env_prefix="PARMECH_", frozen=True)

    data: Path = Field(
        default=Path("data"), description="Folder of the database and the exported files."
    )
    database_url: str | None = Field(
        default=None, description="SQLAlchemy URL; by default an SQLite file in the data folder."
    )
    host: str = "127.0.0.1"
    port: int = Field(default=8000, ge=0, le=65535)

    synchronous_seconds: float = Field(
        default=0.5, ge=0, description="An analysis estimated above this becomes a job. [s]"
    )
    node_limit: int = Field(default=2_000_000_000, ge=1, description="Most nodes of one grid.")
    body_limit_bytes: int = Field(default=32 * 2**20, ge=1024, description="Largest request body.")
    queue_limit: int = Field(default=1000, ge=1, description="Most jobs waiting to be run.")

    processes: int = Field(default=2, ge=1, description="Worker processes of one engine.")
    concurrent_jobs: int = Field(default=8, ge=1, description="Jobs one engine interleaves.")
    tile_seconds: float = Field(default=1.0, gt=0, description="A tile, as foreseen, at most. [s]")
    tile_timeout_seconds: float = Field(
        default=120.0, gt=0, description="A tile is killed after this. [s]"
    )
    tile_retries: int = Field(
        default=2, ge=0, description="New tries of a tile whose process died."
    )
    max_attempts: int = Field(
        default=5, ge=1, description="Engines that may lose a job before it fails."
    )
    lease_seconds: float = Field(
        default=15.0, gt=0, description="A silent engine loses its jobs. [s]"
    )
    heartbeat_seconds: float = Field(default=2.0, gt=0, description="Between signs of life. [s]")
    poll_seconds: float = Field(default=0.05, gt=0, description="Between looks at the queue. [s]")
    worker_memory_bytes: int | None = Field(
        default=4 * 2**30, ge=2**29, description="Address space of one worker process."
    )

    @property
    def resolved_database_url(self) -> str:
        """The URL of the database, the default SQLite file if none is set."""
        return self.database_url or f"sqlite:///{(self.data / 'parmech.sqlite').resolve()}"
