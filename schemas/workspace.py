"""`workspace`: where the platform can be, and why not elsewhere."""

from typing import Annotated, Literal

from pydantic import Field, ValidationInfo, field_validator

from schemas.effort import LoadSize
from schemas.legged import WorkingMode
from schemas.mechanisms import Mechanism
from schemas.quantities import Angle, Finite, Limit, Model, Step

WorkspaceClass = Literal["theoretical", "constructive", "effective"]
FieldName = Literal["effort", "effort_max", "determinant", "actuators"]
Reason = Literal["reach", "actuator_limits", "crank_rod_angle", "rod_rod_angle", "effort"]


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


class Constructive(Model):
    """Bounds that the built mechanism sets; what is left out is not asked. [rad]"""

    min_crank_rod_angle: Angle | None = Field(
        default=None, description="Inside angle at the elbow, 0 folded, pi stretched."
    )
    max_crank_rod_angle: Angle | None = None
    min_rod_rod_angle: Angle | None = Field(
        default=None, description="Angle between two rods at a shared joint of the platform."
    )
    max_rod_rod_angle: Angle | None = None

    @field_validator("max_crank_rod_angle", "max_rod_rod_angle", mode="after")
    @classmethod
    def _right_way_round(cls, value: float | None, info: ValidationInfo) -> float | None:
        least = info.data.get(str(info.field_name).replace("max_", "min_"))
        if value is not None and least is not None and value < least:
            raise ValueError(f"must not be below its minimum, which is {least}")
        return value


class Effective(Model):
    """Bounds on the quality of motion; what is left out is not asked."""

    load: LoadSize | None = Field(
        default=None, description="The load of max_effort and of the effort fields."
    )
    max_effort: Limit | list[Limit] | None = Field(
        default=None,
        description="Greatest effort of any drive under load: one, or one per leg. [N m or N]",
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
    one body serves all three, and are not applied. `type` constant_orientation: the
    conditions hold at the one orientation given in `fixed`.
    """

    analysis: Literal["workspace"]
    mechanism: Mechanism
    class_: WorkspaceClass = Field(alias="class")
    type: Literal["constant_orientation"]
    grid: Annotated[list[GridAxis], Field(min_length=1, max_length=6)]
    fixed: dict[str, Finite] = Field(
        default_factory=dict, description="The value of every coordinate that is not on the grid."
    )
    constructive: Constructive | None = None
    effective: Effective | None = None
    fields: list[FieldName] = Field(
        default_factory=list, max_length=20, description="Numbers to keep for every node inside."
    )
    working_mode: WorkingMode | None = None

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


class Bounds(Model):
    """Extent along one axis, over the nodes inside."""

    coordinate: str
    min: float
    max: float
    clipped: bool = Field(description="It touches the grid's end and may go on beyond.")


class Component(Model):
    """A connected part; nodes are neighbours when their cells share a face."""

    nodes: int
    measure: float
    bounds: list[Bounds]
    centroid: dict[str, float]


class Excluded(Model):
    """How many nodes one condition excluded on one leg."""

    code: int = Field(description="What the grid's `reason` array says for these nodes.")
    reason: Reason
    leg: int
    nodes: int


class FieldSummary(Model):
    """A field over the nodes inside."""

    min: float | None
    max: float | None
    at_max: dict[str, float] | None = Field(description="The pose at which it is greatest.")
    unit: str


class WorkspaceResult(Model):
    """A workspace, without its arrays: those are the job's `grid`."""

    analysis: Literal["workspace"]
    class_: WorkspaceClass = Field(alias="class")
    type: Literal["constant_orientation"]
    working_mode: WorkingMode
    shape: list[int]
    nodes: int
    inside: int
    measure: Measure
    bounds: list[Bounds] = Field(description="Empty where nothing is inside.")
    centroid: dict[str, float] | None
    components: list[Component] = Field(description="The largest 100, the largest first.")
    component_count: int
    excluded: list[Excluded]
    fields: dict[str, FieldSummary]
