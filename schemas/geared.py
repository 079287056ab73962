"""The geared decoupled mechanism on the wire. Lengths in m, angles in rad."""

from typing import Annotated, Literal

from pydantic import Field, field_validator

from schemas.families import UprightRails
from schemas.gears import Train
from schemas.quantities import Finite, Model

Gain = Annotated[float, Field(ge=1e-6, le=1e6, strict=True, allow_inf_nan=False)]
_ONE_LIMIT = (
    "rails move in m and motors turn in rad, so one limit cannot be that of all; give a list of "
    "six: rails, then motors D1, D2, D3 (null: unbounded)"
)


class WristGears(Model):
    """How far the motors turn for the platform, with k = k1 k2 kp.

    D1 = k (rx - ry) + k_gamma rz, D2 = k (rx + ry) + k_gamma rz, D3 = rz.
    """

    k1: Gain = Field(description="From the platform's bevel wheel to the intermediate ones.")
    k2: Gain = Field(description="From the intermediate to the first bevel wheels.")
    kp: Gain = Field(description="Of the gears between the wrist and the rods.")
    k_gamma: Finite = Field(description="With which D1 and D2 follow a turn about z.")


class GearedDecoupled(UprightRails):
    """The geared decoupled mechanism: three rails move a wrist, three motors turn the platform.

    Upright rails at 90, 210 and 330 degrees; drives are the carriages' heights, then the motors
    D1, D2, D3. The pose is that of the tool's point, which is tool_offset along the platform's x
    from the wrist's centre. Working mode 1 takes the upper of a rail's two roots; a motor has 1.
    """

    drive_count = 6

    kind: Literal["geared_decoupled"]
    tool_offset: Finite = Field(
        description="Of the tool's point from the wrist's centre, along the platform's x. [m]"
    )
    wrist: WristGears
    train: Train | None = Field(
        default=None,
        description="Meshes between the platform and D1, and likewise D2, from the platform to the "
        "motor, for friction_torque: they give what friction adds, and wrist the ratio.",
    )

    @field_validator("actuator_limits", mode="before")
    @classmethod
    def _no_limit_for_rails_and_motors(cls, limits: object) -> object:
        if limits is not None and not isinstance(limits, list):
            raise ValueError(_ONE_LIMIT)
        return limits
