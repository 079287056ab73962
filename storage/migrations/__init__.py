"""The tables' history, for Alembic."""

from alembic.config import Config
from alembic.script import ScriptDirectory


def alembic_config() -> Config:
    """Return Alembic's configuration; it needs no file and no current folder."""
    config = Config()
    config.set_main_option("script_location", "storage:migrations")
    config.set_main_option("path_separator", "os")
    return config


def newest_revision() -> str:
    """Return the revision that this version of the program works with."""
    revision = ScriptDirectory.from_config(alembic_config()).get_current_head()
    if revision is None:
        raise RuntimeError("storage/migrations has no revision")
    return revision
