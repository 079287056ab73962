"""Workspace: where the platform can be, and why not elsewhere."""

import math
from typing import Any

import numpy as np

from analyses.analysis import Analysis, Arrays, Stretches
from analyses.errors import AnalysisError
from analyses.plan import LEAST_SECONDS, Plan, cut
from analyses.units import coordinate_units, power_unit
from analyses.workspace_fields import FieldSummaries, histograms
from analyses.workspace_geometry import geometric_errors, geometric_extent, geometric_seconds
from analyses.workspace_home import component_code, home_errors, of_component
from analyses.workspace_orientations import tried
from analyses.workspace_price import seconds_inscribed, seconds_per_node, seconds_per_tile
from analyses.workspace_setup import (
    WorkspaceSetup,
    axes_of,
    check_request,
    field_units,
    question_of,
    set_up,
)
from mechanics import inscribed, regions
from mechanics.arrays import Floats
from mechanics.conditions.condition import NO_LEG
from mechanics.mechanism import Mechanism
from mechanics.orientations import scan_orientations
from mechanics.unions import union
from mechanics.workspace import Scan, reason_codes, scan
from schemas.quantities import Model
from schemas.workspace import WorkspaceRequest
from schemas.workspace_result import (
    Bounds,
    Component,
    Excluded,
    Inscribed,
    InscribedBall,
    InscribedBox,
    Measure,
    WorkspaceResult,
)

COMPONENTS_LISTED = 100
FIELD_PREFIX = "field_"


class Workspace(Analysis[WorkspaceRequest]):
    """Answers `workspace`."""

    name = "workspace"

    def check(self, request: WorkspaceRequest, node_limit: int) -> None:
        """Raise AnalysisError if the request makes no sense for its mechanism."""
        check_request(request, node_limit)
        setup = set_up(request)
        errors = geometric_errors(request, setup) + home_errors(request, setup.mechanism)
        if errors:
            raise AnalysisError(*errors)

    def items(self, request: WorkspaceRequest) -> int:
        """Return the number of grid nodes."""
        return math.prod(axis.count for axis in axes_of(request))

    def line(self, request: WorkspaceRequest) -> int:
        """Return the length of a grid line."""
        return axes_of(request)[-1].count

    def seconds_per_item(self, request: WorkspaceRequest) -> float:
        """Return the mean cost of a node. [s]"""
        return seconds_per_node(request, set_up(request))

    def plan(self, request: WorkspaceRequest, tile_seconds: float) -> Plan:
        """Return how the grid is cut, so that what each orientation costs once stays a share."""
        worth = 3.0 * seconds_per_tile(set_up(request))
        seconds, line = self.seconds_per_item(request), self.line(request)
        longest, least = max(tile_seconds, worth), max(LEAST_SECONDS, worth)
        return cut(self.items(request), seconds, longest, line, least)

    def seconds(self, request: WorkspaceRequest) -> float:
        """Return the cost of all nodes, and of what is added to them, however few they are. [s]"""
        setup = set_up(request)
        nodes = setup.grid.size * seconds_per_node(request, setup)
        once = seconds_per_tile(setup) + geometric_seconds(request, setup)
        return nodes + once + seconds_inscribed(request, setup)

    def result_bytes(self, request: WorkspaceRequest) -> int:
        """Return the size of the dense arrays. [B]"""
        setup = set_up(request)
        widths = [field_width(name, setup.mechanism.drive_count) for name in setup.fields]
        return setup.grid.size * (2 + 8 * sum(widths))

    def compute(self, request: WorkspaceRequest, start: int, stop: int) -> Arrays:
        """Return runs and fields of the nodes `start` to `stop`."""
        found = _scan(request, set_up(request), start, stop)
        fields = {FIELD_PREFIX + name: values for name, values in found.fields.items()}
        return {"codes": found.codes, "lengths": found.lengths, **fields}

    def assemble(self, request: WorkspaceRequest, stretches: Stretches) -> Model:
        """Return what the whole grid amounts to."""
        setup = set_up(request)
        stretches = of_component(request, setup, stretches)
        summaries = FieldSummaries(setup, field_units(request, setup.mechanism))
        codes, lengths = [], []
        for arrays in stretches():
            summaries.add(arrays)
            codes.append(arrays["codes"])
            lengths.append(arrays["lengths"])
        region = regions.Region(setup.grid, np.concatenate(codes), np.concatenate(lengths))
        return WorkspaceResult.model_construct(
            analysis=self.name,
            class_=request.class_,
            type=request.type,
            orientations=tried(setup.orientations),
            working_mode=_mode(request, setup),
            shape=list(setup.grid.shape),
            nodes=setup.grid.size,
            fields=summaries.answer(
                histograms(stretches, request.fields) if request.histograms else {}
            ),
            excluded=_excluded(request, setup, region),
            inscribed=_inscribed(setup, region) if request.inscribed else None,
            **{"boundary": None, "outer_bound": False}
            | _extent(setup, region)
            | geometric_extent(request, setup),
        )


def _scan(request: WorkspaceRequest, s: WorkspaceSetup, start: int, stop: int) -> Scan:
    scans = [_scan_mode(request, s, mechanism, start, stop) for mechanism in s.mechanisms]
    return union(scans, s.conditions, s.grid, start)


def _scan_mode(
    request: WorkspaceRequest, s: WorkspaceSetup, mechanism: Mechanism, start: int, stop: int
) -> Scan:
    question = question_of(request, s, mechanism)
    if question is None:
        return scan(mechanism, s.conditions, s.grid, s.fields, start, stop)
    return scan_orientations(question, start, stop)


def _mode(request: WorkspaceRequest, setup: WorkspaceSetup) -> list[int] | str:
    if request.working_mode == "any":
        return "any"
    return list(setup.mechanism.working_mode)


def field_width(name: str, drives: int) -> int:
    """Return how many numbers a field has per node."""
    return drives if name in ("effort", "actuators") else 1


def _extent(setup: WorkspaceSetup, region: regions.Region) -> dict[str, Any]:
    components = region.components
    whole = _whole(components)
    return {
        "inside": region.nodes,
        "measure": Measure.model_construct(
            value=region.measure,
            unit=power_unit(_axis_units(setup)),
            error_bound=region.measure_error,
            rigorous=False,
        ),
        "bounds": [] if whole is None else _bounds(setup, whole),
        "centroid": None if whole is None else _named(setup, whole.centroid),
        "components": [_component(setup, c) for c in components[:COMPONENTS_LISTED]],
        "component_count": len(components),
    }


def _inscribed(setup: WorkspaceSetup, region: regions.Region) -> Inscribed:
    ball = inscribed.largest_ball(region, setup.mechanism.motion)
    box = inscribed.largest_box(region)
    units = _axis_units(setup)
    return Inscribed.model_construct(
        ball=None
        if ball is None
        else InscribedBall.model_construct(
            centre=_named(setup, ball.centre), radius=ball.radius, unit=units[0]
        ),
        box=None
        if box is None
        else InscribedBox.model_construct(
            min=_named(setup, box.minimum),
            max=_named(setup, box.maximum),
            measure=box.measure,
            unit=power_unit(units),
        ),
    )


def _whole(components: list[regions.Component]) -> regions.Component | None:
    if not components:
        return None
    nodes = np.array([c.nodes for c in components])
    centroids = np.array([c.centroid for c in components])
    return regions.Component(
        int(nodes.sum()),
        np.min([c.minimum for c in components], axis=0),
        np.max([c.maximum for c in components], axis=0),
        nodes @ centroids / nodes.sum(),
    )


def _component(setup: WorkspaceSetup, part: regions.Component) -> Component:
    return Component.model_construct(
        nodes=part.nodes,
        measure=part.nodes * setup.grid.cell,
        bounds=_bounds(setup, part),
        centroid=_named(setup, part.centroid),
    )


def _bounds(setup: WorkspaceSetup, part: regions.Component) -> list[Bounds]:
    return [
        Bounds.model_construct(
            coordinate=axis.coordinate,
            min=float(least),
            max=float(greatest),
            clipped=bool(
                least < axis.minimum + 0.5 * axis.step
                or greatest > axis.nodes[-1] - 0.5 * axis.step
            ),
        )
        for axis, least, greatest in zip(setup.grid.axes, part.minimum, part.maximum, strict=True)
    ]


def _named(setup: WorkspaceSetup, numbers: Floats) -> dict[str, float]:
    return {
        axis.coordinate: float(number)
        for axis, number in zip(setup.grid.axes, numbers, strict=True)
    }


def _axis_units(setup: WorkspaceSetup) -> list[str]:
    motion = setup.mechanism.motion
    units = dict(zip(motion.coordinates, coordinate_units(motion), strict=True))
    return [units[axis.coordinate] for axis in setup.grid.axes]


def _excluded(
    request: WorkspaceRequest, setup: WorkspaceSetup, region: regions.Region
) -> list[Excluded]:
    counts = region.nodes_by_code()
    code = component_code(setup)
    apart = Excluded.model_construct(
        code=code, reason="component", leg=None, other_leg=None, nodes=int(counts[code])
    )
    conditions = [
        Excluded.model_construct(
            code=entry.code,
            reason=entry.reason,
            leg=None if entry.leg == NO_LEG else entry.leg,
            other_leg=entry.partner,
            nodes=int(counts[entry.code]),
        )
        for entry in reason_codes(setup.conditions)
    ]
    return conditions if request.component == "all" else [*conditions, apart]
