"""What is answered about a workspace; what is asked is in `schemas.workspace`."""

from typing import Literal

from pydantic import Field

from schemas.legged import WorkingMode
from schemas.quantities import Model
from schemas.workspace import Reason, WorkspaceClass, WorkspaceType


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
