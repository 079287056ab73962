"""Mechanisms on the wire, their canonical form and their id."""

import hashlib
import json
from collections.abc import Mapping
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, TypeAdapter, ValidationInfo, field_validator

from schemas.quantities import Finite, Length, Model

Sign = Literal[1, -1]
WorkingMode = list[Sign]


class ActuatorLimit(Model):
    """Least and greatest coordinate of a drive, null where unbounded. [m or rad]

    A crank's limit holds if its angle plus some whole number of turns lies within.
    """

    min: Finite | None = None
    max: Finite | None = None

    @field_validator("max", mode="after")
    @classmethod
    def _right_way_round(cls, value: float | None, info: ValidationInfo) -> float | None:
        least = info.data.get("min")
        if value is not None and least is not None and value < least:
            raise ValueError(f"max must not be below min, which is {least}")
        return value


class LeggedMechanism(Model):
    """What every inline mechanism may say. Lengths in m, angles in rad."""

    leg_count: ClassVar[int]
    default_working_mode: ClassVar[tuple[Sign, ...]]

    name: str | None = Field(default=None, max_length=200, description="A name for people.")
    actuator_limits: list[ActuatorLimit | None] | ActuatorLimit | None = Field(
        default=None,
        validate_default=True,
        description="One for all drives, or a list with one (or null) per leg.",
    )
    working_mode: WorkingMode | None = Field(
        default=None,
        validate_default=True,
        description="The default branch of the inverse solution: 1 or -1 per leg.",
    )

    # Both write out what was left to default, so that equal mechanisms have equal forms.

    @field_validator("actuator_limits", mode="after")
    @classmethod
    def _one_limit_per_leg(
        cls, limits: list[ActuatorLimit | None] | ActuatorLimit | None
    ) -> list[ActuatorLimit | None]:
        if not isinstance(limits, list):
            limits = [limits] * cls.leg_count
        if len(limits) != cls.leg_count:
            raise ValueError(f"a list must have {cls.leg_count} entries, one per leg")
        return [None if limit == ActuatorLimit() else limit for limit in limits]

    @field_validator("working_mode", mode="after")
    @classmethod
    def _one_sign_per_leg(cls, mode: WorkingMode | None) -> WorkingMode:
        signs = list(cls.default_working_mode) if mode is None else mode
        if len(signs) != cls.leg_count:
            raise ValueError(f"must have {cls.leg_count} signs, one per leg")
        return signs

    @property
    def limits(self) -> list[ActuatorLimit | None]:
        """The limits of the drives, one per leg."""
        return self.actuator_limits if isinstance(self.actuator_limits, list) else []

    @property
    def signs(self) -> tuple[int, ...]:
        """The default working mode."""
        return tuple(self.working_mode or ())


class FiveBar(LeggedMechanism):
    """Two cranks in the plane whose rods meet in the platform's point.

    Base joints at (-base_distance/2, 0) and (base_distance/2, 0); cranks turn about +z from +x.
    """

    leg_count = 2
    default_working_mode = (1, -1)

    kind: Literal["five_bar"]
    base_distance: Length = Field(description="Between the base joints. [m]")
    crank_length: Length = Field(description="[m]")
    rod_length: Length = Field(description="[m]")


class Planar3RRR(LeggedMechanism):
    """A triangular platform in the plane on three cranks and rods.

    The origin is the base triangle's centroid; vertices at 90, 210 and 330 degrees, the
    platform's likewise at phi = 0; cranks turn about +z from +x.
    """

    leg_count = 3
    default_working_mode = (1, 1, 1)

    kind: Literal["planar_3rrr"]
    base_side: Length = Field(description="Side of the base triangle. [m]")
    platform_radius: Length = Field(description="Circumradius of the platform triangle. [m]")
    crank_length: Length = Field(description="[m]")
    rod_length: Length = Field(description="[m]")


class StoredMechanism(Model):
    """A mechanism that was stored before."""

    kind: Literal["stored"]
    id: str = Field(pattern=r"^m_[0-9a-f]{32}$", description="The id that storing it answered.")


MechanismSpec = Annotated[FiveBar | Planar3RRR, Field(discriminator="kind")]
Mechanism = Annotated[FiveBar | Planar3RRR | StoredMechanism, Field(discriminator="kind")]
InlineMechanism = FiveBar | Planar3RRR

KINDS: Mapping[str, type[InlineMechanism]] = MappingProxyType(
    {"five_bar": FiveBar, "planar_3rrr": Planar3RRR}
)
_SPECS: TypeAdapter[InlineMechanism] = TypeAdapter(MechanismSpec)


def parse_spec(text: str) -> InlineMechanism:
    """Return the mechanism of a canonical JSON text."""
    return _SPECS.validate_json(text)


def canonical_json(model: Model) -> str:
    """Return the one JSON text of a model: every field written out, keys sorted, no spaces."""
    document: dict[str, Any] = model.model_dump(mode="json")
    return json.dumps(document, sort_keys=True, separators=(",", ":"), allow_nan=False)


def mechanism_id(spec: InlineMechanism) -> str:
    """Return the id of a mechanism, a hash of its canonical form."""
    return "m_" + hashlib.sha256(canonical_json(spec).encode()).hexdigest()[:32]
