"""What the routes work with, handed to them as dependencies."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import Depends, Request

from service.artefacts import Artefacts
from settings import Settings
from storage import Database, Heartbeats, Jobs, Mechanisms


@dataclass(frozen=True)
class Stores:
    """The settings and all that is kept."""

    settings: Settings
    database: Database
    mechanisms: Mechanisms
    jobs: Jobs
    heartbeats: Heartbeats
    artefacts: Artefacts

    @classmethod
    def over(cls, settings: Settings, database: Database) -> "Stores":
        """Return the stores over an open database."""
        return cls(
            settings,
            database,
            Mechanisms(database),
            Jobs(database, queue_limit=settings.queue_limit),
            Heartbeats(database),
            Artefacts(settings.data / "exports"),
        )


def _stores(request: Request) -> Stores:
    stores: Stores = request.app.state.stores
    return stores


UsedStores = Annotated[Stores, Depends(_stores)]
