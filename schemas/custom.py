"""The user's own mechanism: a motion and legs, drives freely mixed."""

from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationInfo, field_validator

from schemas.legged import LeggedMechanism, Vector
from schemas.quantities import Length, Model

MotionName = Literal[
    "planar_translation", "planar", "translation", "schoenflies", "spherical", "spatial"
]


class CrankLeg(Model):
    """A crank that turns about `axis` through `base_point`, and a rod."""

    drive: Literal["crank"]
    base_point: Vector = Field(description="On the crank's axis. [m]")
    axis: Vector = Field(description="Of any length but 0.")
    zero_direction: Vector = Field(description="Of a crank of angle 0; perpendicular to the axis.")
    crank_length: Length = Field(description="[m]")
    rod_length: Length = Field(description="[m]")
    platform_point: Vector = Field(description="In the platform's frame. [m]")


class RailLeg(Model):
    """A carriage on a rail along `direction`, and a rod."""

    drive: Literal["rail"]
    base_point: Vector = Field(description="The carriage's joint at drive coordinate 0. [m]")
    direction: Vector = Field(description="Of any length but 0.")
    rod_length: Length = Field(description="[m]")
    platform_point: Vector = Field(description="In the platform's frame. [m]")


class StrutLeg(Model):
    """A telescopic strut; its drive coordinate is its length."""

    drive: Literal["strut"]
    base_point: Vector = Field(description="[m]")
    platform_point: Vector = Field(description="In the platform's frame. [m]")


CustomLeg = Annotated[CrankLeg | RailLeg | StrutLeg, Field(discriminator="drive")]


class _LegList(Model):
    """Stands before the shared fields, since those are checked against the number of legs."""

    motion: MotionName = Field(description="Which coordinates the platform has.")
    axis: Vector | None = Field(
        default=None, validate_default=True, description="Of the turn of a schoenflies motion."
    )
    legs: Annotated[list[CustomLeg], Field(min_length=2, max_length=6)] = Field(
        description="As many as the motion has coordinates. Points are three numbers always."
    )

    @field_validator("axis", mode="after")
    @classmethod
    def _axis_of_schoenflies_only(
        cls, axis: list[float] | None, info: ValidationInfo
    ) -> list[float] | None:
        motion = info.data.get("motion")
        if motion == "schoenflies" and axis is None:
            raise ValueError("the motion schoenflies needs the axis of its turn")
        if motion not in ("schoenflies", None) and axis is not None:
            raise ValueError(f"the motion {motion} takes no axis")
        return axis


class Custom(LeggedMechanism, _LegList):
    """The user's own legs under a platform of one of the six motions."""

    kind: Literal["custom"]

    @classmethod
    def count_drives(cls, data: Mapping[str, Any]) -> int:
        """Return how many legs are listed; 0 where the list itself is invalid."""
        return len(data.get("legs", ()))
