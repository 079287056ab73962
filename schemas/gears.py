"""Meshes of gear wheels on the wire, by points in their plane or by design data.

The input wheel is the one nearer to the motor, the output wheel the one nearer to the output.
"""

import math
from typing import Annotated, Literal

from pydantic import Field

from schemas.quantities import Finite, Length, Model, Size

PlanePoint = Annotated[list[Finite], Field(min_length=2, max_length=2)]
PressureAngle = Annotated[float, Field(ge=0.05, le=1.2, strict=True, allow_inf_nan=False)]
ShaftAngle = Annotated[float, Field(gt=0.0, lt=math.pi, strict=True, allow_inf_nan=False)]
Shift = Annotated[float, Field(ge=-10.0, le=10.0, strict=True, allow_inf_nan=False)]
Addendum = Annotated[float, Field(gt=0.0, le=10.0, strict=True, allow_inf_nan=False)]

FrictionCoefficient = Annotated[
    Size,
    Field(
        description="Coefficient of friction between the teeth, the same at every sliding speed "
        "(Coulomb)."
    ),
]


class ExplicitMesh(Model):
    """Two wheels by points in their plane: centres, pitch point and contact.

    The line of action passes through pitch point and contact. A pitch point that is not between
    the centres makes the wheel whose centre is farther from it a ring with teeth inside.
    """

    kind: Literal["explicit"]
    input_centre: PlanePoint = Field(description="Of the wheel nearer to the motor. [m]")
    output_centre: PlanePoint = Field(description="Of the wheel nearer to the output. [m]")
    pitch_point: PlanePoint = Field(description="On the line of centres. [m]")
    contact: PlanePoint = Field(
        description="Where a pair of teeth touches, one end of the line of action. [m]"
    )
    opposite_contact: PlanePoint | None = Field(
        default=None,
        description="The other end of the line of action, beyond the pitch point; by default the "
        "mirror image of contact, or where the involute ends if that is nearer. [m]",
    )
    base_pitch: Length | None = Field(
        default=None,
        description="From one pair of teeth to the next along the line of action; needed for means "
        "and curves. [m]",
    )
    friction_coefficient: FrictionCoefficient


class Wheel(Model):
    """One wheel by its design data."""

    teeth: Annotated[int, Field(ge=3, le=100_000, strict=True)] = Field(
        description="Number of teeth."
    )
    profile_shift: Shift = Field(default=0.0, description="Over the module.")


class DesignMesh(Model):
    """Two wheels with external involute teeth by their design data, as one rack cuts them.

    Bevel wheels are taken by the equivalent spur pair at the mean diameter.
    """

    kind: Literal["design"]
    face: Literal["spur", "bevel"] = "spur"
    module: Length = Field(description="Of bevel wheels, the one at the mean diameter. [m]")
    pressure_angle: PressureAngle = Field(
        default=math.radians(20.0), description="Of the rack; 20 degrees by default. [rad]"
    )
    addendum_coefficient: Addendum = Field(
        default=1.0, description="Height of the rack's teeth over the module."
    )
    input: Wheel = Field(description="The wheel nearer to the motor.")
    output: Wheel = Field(description="The wheel nearer to the output.")
    centre_distance: Length | None = Field(
        default=None, description="Of spur wheels; by default the one without backlash. [m]"
    )
    shaft_angle: ShaftAngle | None = Field(
        default=None,
        description="Between the axes of bevel wheels; by default a right angle. [rad]",
    )
    contact_position: Finite | None = Field(
        default=None,
        description="A place on the line of action for explicit contact: from the pitch point, "
        "above 0 where the contact goes while the motor drives. [m]",
    )
    friction_coefficient: FrictionCoefficient


Mesh = Annotated[ExplicitMesh | DesignMesh, Field(discriminator="kind")]
Train = Annotated[
    list[Mesh],
    Field(min_length=1, max_length=100, description="Meshes from the output to the motor."),
]
