"""Kinds: the mechanism families that are offered, and named presets."""

from datetime import datetime
from typing import Any

from pydantic import Field

from schemas.mechanisms import MechanismSpec
from schemas.quantities import Model


class Preset(Model):
    """A machine that exists or was published, ready to be asked about."""

    name: str
    title: str
    source: str = Field(description="Where its dimensions are published.")
    mechanism: MechanismSpec


class Kind(Model):
    """A mechanism family."""

    kind: str
    title: str
    motion: str
    coordinates: list[str] = Field(description="In the order of a pose's numbers.")
    coordinate_units: list[str]
    drives: list[str] = Field(description="Those of the legs, then a wrist's motors.")
    analyses: list[str]
    json_schema: dict[str, Any] = Field(description="JSON Schema of the inline mechanism.")
    example: MechanismSpec
    presets: list[Preset]


class KindPage(Model):
    """All kinds."""

    items: list[Kind]


class StoredMechanismDocument(Model):
    """A mechanism that is kept under its id."""

    id: str
    created: datetime
    mechanism: MechanismSpec


class MechanismPage(Model):
    """Stored mechanisms, the newest first."""

    items: list[StoredMechanismDocument]
    next_page_token: str | None
