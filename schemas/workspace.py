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


class Measure(Model):
    """Length, area or volume of a workspace."""

    value: float
    unit: str
    error_bound: float = Field(description="How far off the value may be.")
    rigorous: bool = Field(
        description="False where nodes were counted: what is thinner than a step is not seen."
    )


class OrientationsTried(Model):
    """The orientations along one turning coordinate at which the conditions were tried. [rad]"""

    coordinate: str
    min: float
    max: float
    step: float = Field(
        description="Between those tried; of all angles, between those at which conditions "
        "without closed forms are looked at before the ends of their arcs are sought."
    )
    count: int | None = Field(description="Null for all angles.")
    all_angles: bool = Field(
        description="Whether all angles count, not those a step apart: arcs in closed form, or "
        "with ends to 1e-9 rad."
    )


class Bounds(Model):
    """Extent along one axis, over the nodes inside."""

    coordinate: str
    min: float
    max: float
    clipped: bool = Field(description="It touches the grid's end and may go on beyond.")


class Arc(Model):
    """A circular arc of a boundary; the inside is on its left. [m, rad]"""

    centre: list[float]
    radius: float
    start: float = Field(description="Angle of its first point.")
    end: float = Field(description="Of its last point; below start where it turns clockwise.")


class InscribedBall(Model):
    """The largest interval, disc or ball about a node, all of whose neighbours are inside too."""

    centre: dict[str, float]
    radius: float
    unit: str


class InscribedBox(Model):
    """The largest box, by measure, all of whose nodes are inside; its corners are nodes."""

    min: dict[str, float]
    max: dict[str, float]
    measure: float
    unit: str


class Inscribed(Model):
    """What fits into the workspace, between nodes that are inside."""

    ball: InscribedBall | None = Field(
        description="Null where none has room, or metres and radians are mixed."
    )
    box: InscribedBox | None = Field(description="Null where none has room.")


class Component(Model):
    """A connected part; nodes are neighbours when their cells share a face."""

    nodes: int
    measure: float
    bounds: list[Bounds]
    centroid: dict[str, float]


class Excluded(Model):
    """How many nodes one condition excluded on one leg, or on two of them together."""

    code: int = Field(description="What the grid's `reason` array says for these nodes.")
    reason: Reason
    leg: int | None = Field(description="Null where all legs together make the condition.")
    other_leg: int | None = Field(
        description="The other one of two whose rods come too near or make the angle; else null."
    )
    nodes: int


class Histogram(Model):
    """How many finite values lie between successive edges; the last bin has its upper edge too."""

    edges: list[float] = Field(description="From the least value to the greatest, equally spaced.")
    counts: list[int]
    undefined: int = Field(description="Values that are not there or not finite.")


class FieldSummary(Model):
    """A field over the nodes inside."""

    min: float | None
    max: float | None
    at_max: dict[str, float] | None = Field(description="The pose at which it is greatest.")
    unit: str
    histogram: Histogram | None = Field(
        description="Over the nodes inside, and the legs; null unless asked for."
    )


class WorkspaceResult(Model):
    """A workspace, without its arrays: those are the job's `grid`."""

    analysis: Literal["workspace"]
    class_: WorkspaceClass = Field(alias="class")
    type: WorkspaceType
    orientations: list[OrientationsTried] | None = Field(
        description="Null for constant_orientation and orientation."
    )
    working_mode: WorkingMode | Literal["any"]
    shape: list[int]
    nodes: int
    inside: int
    measure: Measure
    bounds: list[Bounds] = Field(description="Empty where nothing is inside.")
    centroid: dict[str, float] | None
    components: list[Component] = Field(description="The largest 100, the largest first.")
    component_count: int
    excluded: list[Excluded]
    inscribed: Inscribed | None = Field(description="Null unless asked for.")
    outer_bound: bool = Field(
        description="True where measure, bounds and boundary are of a region that holds the "
        "workspace and may be larger: maximal by the geometric method."
    )
    boundary: list[list[Arc]] | None = Field(
        description="Closed loops, outer ones counterclockwise, holes clockwise; null unless the "
        "geometric method was asked for in the plane."
    )
    fields: dict[str, FieldSummary]
