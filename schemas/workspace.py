"""`workspace`: where the platform can be, and why not elsewhere."""

import math
from typing import Annotated, Literal

from pydantic import AfterValidator, Field, ValidationInfo, field_validator

from schemas.effort import LoadSize
from schemas.legged import Vector, WorkingMode
from schemas.mechanisms import Mechanism
from schemas.quantities import Angle, Finite, Length, Limit, Model, Ratio, Size, Step

WorkspaceClass = Literal["theoretical", "constructive", "effective"]
WorkspaceType = Literal[
    "constant_orientation",
    "orientation",
    "maximal",
    "inclusive_orientation",
    "orientation_range",
    "full",
]
FieldName = Literal[
    "effort",
    "effort_max",
    "determinant",
    "condition_number",
    "pressure_angle",
    "actuators",
    "free_orientation",
]
Reason = Literal[
    "reach",
    "actuator_limits",
    "crank_rod_angle",
    "rod_rod_angle",
    "base_joint_angle",
    "platform_joint_angle",
    "rod_distance",
    "effort",
    "pressure_angle",
    "determinant",
    "condition_number",
    "actuator_speed",
    "component",
]

_LEAST_DIRECTION = 1e-12


def _some_direction(vector: list[float]) -> list[float]:
    if math.hypot(*vector) < _LEAST_DIRECTION:
        raise ValueError("must not be zero: it is a direction")
    return vector


Direction = Annotated[Vector, AfterValidator(_some_direction)]


class GridAxis(Model):
    """Nodes at `min + i step` while they are not above `max`. [m or rad]"""

    coordinate: str = Field(max_length=40)
    min: Finite
    max: Finite
    step: Step

    @field_validator("max", mode="after")
    @classmethod
    def _right_way_round(cls, value: float, info: ValidationInfo) -> float:
        least = info.data.get("min")
        if least is not None and value < least:
            raise ValueError(f"max must not be below min, which is {least}")
        return value


class OrientationAxis(Model):
    """Orientations along one turning coordinate, from `min` to `max`, `step` apart. [rad]"""

    coordinate: str = Field(max_length=40)
    min: Finite | None = Field(
        default=None, description="With max: for inclusive_orientation and orientation_range."
    )
    max: Finite | None = None
    step: Step | None = Field(
        default=None,
        description="The largest there may be between orientations tried; by default 2 degrees "
        "for one turn, 15 for three.",
    )


class Constructive(Model):
    """Bounds that the built mechanism sets; what is left out is not asked."""

    min_crank_rod_angle: Angle | None = Field(
        default=None, description="Inside angle at the elbow, 0 folded, pi stretched. [rad]"
    )
    max_crank_rod_angle: Angle | None = None
    min_rod_rod_angle: Angle | None = Field(
        default=None, description="Angle between two rods at a shared joint of the platform. [rad]"
    )
    max_rod_rod_angle: Angle | None = None
    max_base_joint_angle: Angle | None = Field(
        default=None,
        description="Cone of the joint at each rod's moving end B (a strut's end on the base): "
        "greatest angle of the rod off base_joint_axes, which it needs. Not for arcs. [rad]",
    )
    base_joint_axes: list[Direction] | None = Field(
        default=None,
        description="One per leg: the rod's direction, from base to platform, with that joint at "
        "rest, in the base frame while all drives stand at 0; a crank turns it along. Of any "
        "length but 0. There is no default: no leg has a direction in which its joint must rest.",
    )
    max_platform_joint_angle: Angle | None = Field(
        default=None,
        description="Cone of the joint at each rod's end on the platform: greatest angle of the "
        "rod off platform_joint_axes, which it needs. Not for arcs. [rad]",
    )
    platform_joint_axes: list[Direction] | None = Field(
        default=None,
        description="One per leg: the rod's direction, from base to platform, with that joint at "
        "rest, in the platform's frame, or under a wrist in that of what the rods carry, which "
        "does not turn. Of any length but 0; no default.",
    )
    min_rod_distance: Length | None = Field(
        default=None,
        description="Least distance between the centre lines of two rods, so the sum of their "
        "radii; for all pairs that share no joint. Of a parallelogram its middle line is meant; "
        "not for arcs. [m]",
    )

    @field_validator("max_crank_rod_angle", "max_rod_rod_angle", mode="after")
    @classmethod
    def _right_way_round(cls, value: float | None, info: ValidationInfo) -> float | None:
        least = info.data.get(str(info.field_name).replace("max_", "min_"))
        if value is not None and least is not None and value < least:
            raise ValueError(f"must not be below its minimum, which is {least}")
        return value


class PlatformSpeed(Model):
    """A velocity of the platform whose size is known and whose direction is not."""

    linear: Size = Field(default=0.0, description="Of the reference point. [m/s]")
    angular: Size = Field(default=0.0, description="[rad/s]")


class Effective(Model):
    """Bounds on the quality of motion; what is left out is not asked."""

    load: LoadSize | None = Field(
        default=None, description="The load of max_effort and of the effort fields."
    )
    max_effort: Limit | list[Limit] | None = Field(
        default=None,
        description="Greatest effort of any drive under load: one, or one per drive. [N m or N]",
    )
    max_pressure_angle: Angle | None = Field(
        default=None,
        description="Between the velocity of each leg's joint on the platform, all other drives "
        "braked, and the line of its rod's force; never above pi/2. [rad]",
    )
    min_abs_determinant: Limit | None = Field(
        default=None, description="Of det Jx as it is. [m to the number of turns]"
    )
    max_condition_number: Ratio | None = Field(
        default=None, description="Of Jx with turns measured at the characteristic length."
    )
    max_actuator_speed: Limit | list[Limit] | None = Field(
        default=None,
        description="Greatest speed of any drive at platform_speed, which it needs: one, or one "
        "per drive. [rad/s or m/s]",
    )
    platform_speed: PlatformSpeed | None = Field(
        default=None,
        description="How fast the platform moves and turns, each in its own worst direction; "
        "what the motion lacks has no share.",
    )

    @field_validator("max_effort", mode="after")
    @classmethod
    def _needs_load(
        cls, value: float | list[float] | None, info: ValidationInfo
    ) -> float | list[float] | None:
        if value is not None and "load" in info.data and info.data["load"] is None:
            raise ValueError("max_effort needs a load, and load is missing")
        return value


class WorkspaceRequest(Model):
    """Ask which nodes of a grid belong to a workspace of a class and a type.

    `class` says which conditions a pose must meet: `theoretical` the inverse problem alone;
    `constructive` also the actuator limits and what `constructive` bounds; `effective` also
    what `effective` bounds. Blocks of a higher class than the one asked are allowed, so that
    one body serves all three, and are not applied.

    `type` says at which orientations the conditions must hold together: constant_orientation at
    the one in `fixed`; orientation: these are on the grid, and the position is fixed, or on the
    grid too, as in any slice through the space of poses; maximal at some, full at every one;
    inclusive_orientation at some, orientation_range at every one of `orientation_range`. Of one
    turn all angles count; of three, all angles of the last, if only reach, actuator limits and
    angles between crank and rod are asked, with a grid of the others, else a grid of all three,
    which the result tells. The position of a spherical mechanism is where its platform's z axis
    points, and its one turn is the `spin` about that.
    """

    analysis: Literal["workspace"]
    mechanism: Mechanism
    class_: WorkspaceClass = Field(alias="class")
    type: WorkspaceType
    grid: Annotated[list[GridAxis], Field(min_length=1, max_length=6)]
    orientation_range: list[OrientationAxis] = Field(
        default_factory=list,
        max_length=3,
        description="The turns, for the types that need many orientations; for maximal and full "
        "only their steps, since they mean the whole turn.",
    )
    fixed: dict[str, Finite] = Field(
        default_factory=dict, description="The value of every coordinate that is not on the grid."
    )
    constructive: Constructive | None = None
    effective: Effective | None = None
    fields: list[FieldName] = Field(
        default_factory=list, max_length=20, description="Numbers to keep for every node inside."
    )
    method: Literal["grid", "geometric"] = Field(
        default="grid",
        description="geometric: the measure is that of the intersection of the legs' regions, of "
        "the whole of it, wherever the grid ends; in the plane so are bounds and centroid, and "
        "its boundary is told in arcs. For reach and actuator limits, over all translations.",
    )
    component: Literal["all", "home"] = Field(
        default="all",
        description="home: only what the platform can reach from the pose `home` without det Jx "
        "changing its sign; neighbouring nodes share a cell's face.",
    )
    home: list[Finite] | None = Field(
        default=None,
        max_length=6,
        description="A pose of the mechanism; the nearest node stands for it.",
    )
    inscribed: bool = Field(
        default=False,
        description="Whether to look for the largest ball and the largest box along the axes that "
        "lie inside, on up to three axes.",
    )
    histograms: bool = Field(
        default=False, description="Whether to count how often each field has which values."
    )
    working_mode: WorkingMode | Literal["any"] | None = Field(
        default=None,
        description="any: the union over all working modes; fields are those of the first mode, "
        "of +1 before -1 leg by leg, that a node belongs in.",
    )

    @field_validator("fields", mode="after")
    @classmethod
    def _each_once(cls, names: list[FieldName]) -> list[FieldName]:
        return sorted(set(names))
