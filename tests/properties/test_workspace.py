"""Workspaces: nodes, codes, classes, tiles, against an oracle that goes node by node."""

import json
import math
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import analyses
from mechanics import fields
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import Condition
from mechanics.conditions.crank_rod_angle import CrankRodAngle
from mechanics.conditions.effort import Effort
from mechanics.conditions.reach import Reach
from mechanics.conditions.rod_rod_angle import RodRodAngle
from mechanics.fields import Field
from mechanics.grid import Axis, Grid
from mechanics.loads import Load
from mechanics.regions import Region
from mechanics.workspace import Scan, reason_codes, scan
from schemas.workspace import WorkspaceRequest
from tests.oracles import planar
from tests.properties.samples import Sample, numbers, samples

FEWER = settings(max_examples=20, deadline=None)
UNDECIDED = 1e-9


@dataclass(frozen=True)
class Task:
    """A workspace to be scanned: mechanism with limits, bounds, load, grid."""

    sample: Sample
    elbow: tuple[float, float]
    shared: tuple[float, float]
    force: float
    moment: float
    efforts: tuple[float, ...]
    start: tuple[float, float]
    steps: tuple[float, float]
    shape: tuple[int, int]

    @property
    def load(self) -> Load:
        return Load(force=self.force, moment=self.moment)

    @property
    def axes(self) -> tuple[Axis, Axis]:
        first, second = (
            Axis(name, low, low + step * (count - 1), step)
            for name, low, step, count in zip("xy", self.start, self.steps, self.shape, strict=True)
        )
        return first, second

    @property
    def grid(self) -> Grid:
        return Grid(self.axes, (0, 1), np.array([0.0, 0.0, *self.sample.pose[2:]]))

    @property
    def poses(self) -> planar.Floats:
        """The nodes, counted here anew, shape (nodes, coordinates)."""
        x, y = (
            low + step * np.arange(count)
            for low, step, count in zip(self.start, self.steps, self.shape, strict=True)
        )
        nodes = np.stack([grid.ravel() for grid in np.meshgrid(x, y, indexing="ij")], axis=1)
        turns = np.tile(self.sample.pose[2:], (len(nodes), 1))
        return np.concatenate([nodes, turns], axis=1)

    @property
    def conditions(self) -> list[Condition]:
        mechanism = self.sample.mechanism
        shared = [] if self.sample.radius else [RodRodAngle(mechanism, *self.shared)]
        return [
            Reach(mechanism),
            ActuatorLimits(mechanism),
            CrankRodAngle(mechanism, *self.elbow),
            *shared,
            Effort(mechanism, self.load, np.array(self.efforts)),
        ]

    def scan(self, **kept: Field) -> Scan:
        grid = self.grid
        return scan(self.sample.mechanism, self.conditions, grid, kept, 0, grid.size)

    @property
    def body(self) -> dict[str, Any]:
        """The same as a request."""
        lower, upper = self.elbow
        shared = {"min_rod_rod_angle": self.shared[0], "max_rod_rod_angle": self.shared[1]}
        limits = [
            {} if low == -math.inf else {"min": low, "max": high}
            for low, high in self.sample.limits
        ]
        return {
            "analysis": "workspace",
            "mechanism": {**self.sample.wire, "actuator_limits": limits},
            "class": "effective",
            "type": "constant_orientation",
            "grid": [
                {"coordinate": a.coordinate, "min": a.minimum, "max": a.maximum, "step": a.step}
                for a in self.axes
            ],
            "fixed": {"phi": self.sample.pose[2]} if self.sample.radius else {},
            "constructive": {
                "min_crank_rod_angle": lower,
                "max_crank_rod_angle": upper,
                **({} if self.sample.radius else shared),
            },
            "effective": {
                "load": {"force": self.force, "moment": self.moment},
                "max_effort": list(self.efforts),
            },
            "fields": ["effort", "effort_max", "determinant", "actuators"],
        }


@st.composite
def tasks(draw: st.DrawFn) -> Task:
    sample = draw(samples())
    limits = []
    for _ in range(sample.legs):
        low = draw(numbers(-9.0, 9.0))
        free = draw(st.booleans())
        limits.append((-math.inf, math.inf) if free else (low, low + draw(numbers(1.0, 7.0))))
    extent = 2 * (sample.crank + sample.rod)
    shape = draw(st.tuples(st.integers(1, 24), st.integers(1, 24)))
    steps = tuple(round(extent * draw(numbers(0.02, 0.1)), 6) for _ in range(2))
    corner = [
        round(value - step * count / 2, 6)
        for value, step, count in zip(sample.pose, steps, shape, strict=False)
    ]
    force = draw(numbers(0.1, 20.0))
    scale = force * sample.crank
    return Task(
        replace(sample, limits=tuple(limits)),
        (draw(numbers(0.0, 0.8)), math.pi - draw(numbers(0.0, 0.8))),
        (draw(numbers(0.0, 0.5)), math.pi - draw(numbers(0.0, 0.5))),
        force,
        draw(numbers(0.0, 2.0)) * sample.crank,
        tuple(scale * draw(numbers(0.5, 8.0)) for _ in range(sample.legs)),
        (corner[0], corner[1]),
        (steps[0], steps[1]),
        shape,
    )


def margins(task: Task) -> list[tuple[str, int, planar.Floats]]:
    """Return (reason, leg, margin at every node) in the order of the conditions."""
    oracle, poses = task.sample.oracle, task.poses
    legs = range(task.sample.legs)
    reach = planar.reach_margins(oracle, poses)
    angles = planar.crank_angles(oracle, poses)
    turned = angles[..., None] + 2 * np.pi * np.arange(-4, 5)
    low, high = np.array(task.sample.limits).T[..., None]
    stops = np.minimum(turned - low, high - turned).max(axis=-1)
    elbows = planar.elbow_angles(oracle, poses)
    bends = np.minimum(elbows - task.elbow[0], task.elbow[1] - elbows)
    parts = [("reach", leg, reach[:, leg]) for leg in legs]
    parts += [("actuator_limits", leg, stops[:, leg]) for leg in legs]
    parts += [("crank_rod_angle", leg, bends[:, leg]) for leg in legs]
    if task.sample.radius is None:
        rods = planar.rod_angle(oracle, poses)
        between = np.minimum(rods - task.shared[0], task.shared[1] - rods)
        parts.append(("rod_rod_angle", 0, between))
    reached = np.all(reach > 0, axis=1)
    spare = np.full((len(poses), task.sample.legs), np.nan)
    if reached.any():
        clear = np.flatnonzero(reached)[planar.spread(oracle, poses[reached]) < 1e12]
        worst = planar.worst(oracle, poses[clear], task.force, task.moment)
        spare[clear] = (np.array(task.efforts) - worst) / worst.max(axis=1, keepdims=True)
    return parts + [("effort", leg, spare[:, leg]) for leg in legs]


def expected_codes(task: Task) -> tuple[npt.NDArray[np.uint8], planar.Booleans]:
    """Return the number of the first part that fails at each node, and where that is sure."""
    values = np.array([margin for _, _, margin in margins(task)])
    codes = np.zeros(values.shape[1], dtype=np.uint8)
    sure = np.ones(values.shape[1], dtype=bool)
    for node, column in enumerate(values.T):
        for code, margin in enumerate(column, start=1):
            sure[node] &= abs(margin) > UNDECIDED or math.isnan(margin)
            if not margin >= 0:
                codes[node] = code
                break
    return codes, sure


def dense(found: Scan) -> npt.NDArray[np.uint8]:
    codes: npt.NDArray[np.uint8] = np.repeat(found.codes, found.lengths)
    return codes


@FEWER
@given(tasks())
def test_codes_are_the_first_failure_of_the_lowest_leg(task: Task) -> None:
    codes, sure = expected_codes(task)
    np.testing.assert_array_equal(dense(task.scan())[sure], codes[sure])


@FEWER
@given(tasks())
def test_codes_mean_the_conditions_in_their_order(task: Task) -> None:
    meanings = [(entry.reason, entry.leg) for entry in reason_codes(task.conditions)]
    assert meanings == [(reason, leg) for reason, leg, _ in margins(task)]


@FEWER
@given(tasks())
def test_codes_count_from_one(task: Task) -> None:
    numbers_ = [entry.code for entry in reason_codes(task.conditions)]
    assert numbers_ == list(range(1, len(numbers_) + 1))


@FEWER
@given(tasks())
def test_runs_are_maximal_within_grid_lines(task: Task) -> None:
    found = task.scan()
    assert np.all(found.lengths > 0)
    assert found.lengths.sum() == task.grid.size
    starts = np.cumsum(found.lengths)[:-1]
    same = found.codes[1:] == found.codes[:-1]
    assert np.all(starts[same] % task.shape[1] == 0)


@FEWER
@given(tasks(), st.data())
def test_any_two_stretches_make_the_whole(task: Task, data: st.DataObject) -> None:
    grid, mechanism = task.grid, task.sample.mechanism
    assume(grid.size > 1)
    cut = data.draw(st.integers(1, grid.size - 1))
    kept = {"effort": fields.effort(task.load), "determinant": fields.determinant}
    whole = scan(mechanism, task.conditions, grid, kept, 0, grid.size)
    parts = [
        scan(mechanism, task.conditions, grid, kept, start, stop)
        for start, stop in ((0, cut), (cut, grid.size))
    ]
    np.testing.assert_array_equal(np.concatenate([dense(part) for part in parts]), dense(whole))
    for name, values in whole.fields.items():
        joined = np.concatenate([part.fields[name] for part in parts])
        assert joined.tobytes() == values.tobytes()


@FEWER
@given(tasks())
def test_fields_are_kept_for_the_nodes_inside(task: Task) -> None:
    found = task.scan(effort_max=fields.effort_max(task.load), actuators=fields.actuators)
    inside = dense(found) == 0
    assert len(found.fields["effort_max"]) == inside.sum()
    assert found.fields["actuators"].shape == (inside.sum(), task.sample.legs)
    angles = planar.crank_angles(task.sample.oracle, task.poses[inside])
    gap = np.angle(np.exp(1j * (found.fields["actuators"] - angles)))
    assert np.abs(gap).max(initial=0.0) < 1e-6


@FEWER
@given(tasks())
def test_no_effort_inside_is_above_its_limit(task: Task) -> None:
    found = task.scan(effort=fields.effort(task.load))
    assert np.all(found.fields["effort"] <= np.array(task.efforts))


@FEWER
@given(tasks(), st.lists(st.integers(-3, 3), min_size=3, max_size=3))
def test_whole_turns_added_to_limits_change_nothing(task: Task, turns: list[int]) -> None:
    moved = tuple(
        (low + 2 * math.pi * turn, high + 2 * math.pi * turn)
        for (low, high), turn in zip(task.sample.limits, turns, strict=False)
    )
    _, sure = expected_codes(task)
    there = replace(task, sample=replace(task.sample, limits=moved)).scan()
    np.testing.assert_array_equal(dense(there)[sure], dense(task.scan())[sure])


@FEWER
@given(tasks())
def test_limits_a_turn_wide_exclude_nothing(task: Task) -> None:
    wide = tuple((low, low + 2 * math.pi + 1e-9) for low, _ in task.sample.limits)
    wide = tuple((-1.0, 5.3) if low == -math.inf else (low, high) for low, high in wide)
    mechanism = replace(task.sample, limits=wide).mechanism
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    codes = dense(scan(mechanism, conditions, task.grid, {}, 0, task.grid.size))
    assert codes.max() <= task.sample.legs


@FEWER
@given(tasks(), st.integers(-5, 5))
def test_scaling_by_a_power_of_two_scales_the_area_exactly(task: Task, power: int) -> None:
    scale = 2.0**power
    areas = []
    for factor in (1.0, scale):
        mechanism = task.sample.scaled(factor).mechanism
        axes = tuple(
            Axis(a.coordinate, a.minimum * factor, a.maximum * factor, a.step * factor)
            for a in task.axes
        )
        grid = Grid(axes, (0, 1), task.grid.fixed)
        found = scan(mechanism, [Reach(mechanism)], grid, {}, 0, grid.size)
        areas.append(Region(grid, found.codes, found.lengths).measure)
    assert areas[1] == areas[0] * scale**2


@FEWER
@given(tasks(), st.floats(0.01, 100.0))
def test_scaling_scales_the_area(task: Task, scale: float) -> None:
    margin = planar.reach_margins(task.sample.oracle, task.poses)
    assume(np.abs(margin).min() > 1e-9)
    areas = []
    for factor in (1.0, scale):
        mechanism = task.sample.scaled(factor).mechanism
        axes = tuple(
            Axis(a.coordinate, a.minimum * factor, a.maximum * factor, a.step * factor)
            for a in task.axes
        )
        grid = Grid(axes, (0, 1), task.grid.fixed)
        found = scan(mechanism, [Reach(mechanism)], grid, {}, 0, grid.size)
        areas.append(Region(grid, found.codes, found.lengths).measure)
    np.testing.assert_allclose(areas[1], areas[0] * scale**2, rtol=1e-12)


@FEWER
@given(tasks(), st.sampled_from(["x", "y"]))
def test_a_single_line_is_a_line_of_the_plane(task: Task, along: str) -> None:
    first, second = task.axes
    axis, column = (first, 0) if along == "x" else (second, 1)
    fixed = task.grid.fixed.copy()
    fixed[1 - column] = task.start[1 - column]
    line = Grid((axis,), (column,), fixed)
    found = scan(task.sample.mechanism, task.conditions, line, {}, 0, line.size)
    plane = dense(task.scan()).reshape(task.shape)
    np.testing.assert_array_equal(dense(found), plane[:, 0] if along == "x" else plane[0])


@FEWER
@given(tasks())
def test_swapping_the_axes_transposes_the_codes(task: Task) -> None:
    grid = Grid(task.axes[::-1], (1, 0), task.grid.fixed)
    found = scan(task.sample.mechanism, task.conditions, grid, {}, 0, grid.size)
    swapped = dense(found).reshape(task.shape[::-1]).T
    np.testing.assert_array_equal(swapped, dense(task.scan()).reshape(task.shape))


def asked(task: Task, **changes: object) -> WorkspaceRequest:
    request = analyses.parse(json.dumps({**task.body, **changes}))
    analyses.check(request, 10**6)
    assert isinstance(request, WorkspaceRequest)
    return request


def arrays(
    request: WorkspaceRequest, stretches: list[analyses.Arrays]
) -> dict[str, npt.NDArray[Any]]:
    grid = analyses.dense_grid(request, lambda: iter(stretches))
    return {
        column.name: np.concatenate(list(column.chunks())).reshape(column.shape)
        for column in grid.columns
    }


def whole(request: WorkspaceRequest) -> dict[str, npt.NDArray[Any]]:
    items = analyses.plan(request, 1.0).items
    return arrays(request, [analyses.compute(request, 0, items)])


@FEWER
@given(tasks())
def test_request_and_scan_give_the_same_reasons(task: Task) -> None:
    # A request leaves out conditions that nothing can break, so the codes may differ.
    request = asked(task)
    asked_for = {
        entry["code"]: (entry["reason"], entry["leg"])
        for entry in analyses.answer(request).model_dump()["excluded"]
    }
    scanned = {entry.code: (entry.reason, entry.leg) for entry in reason_codes(task.conditions)}
    reasons = [asked_for.get(code, "inside") for code in whole(request)["reason"].ravel()]
    assert reasons == [scanned.get(code, "inside") for code in dense(task.scan())]


@FEWER
@given(tasks())
def test_classes_are_nested_node_by_node(task: Task) -> None:
    effective, constructive, theoretical = (
        whole(asked(task, **{"class": name}))["inside"]
        for name in ("effective", "constructive", "theoretical")
    )
    assert np.all(constructive[effective])
    assert np.all(theoretical[constructive])


@FEWER
@given(tasks())
def test_the_theoretical_class_knows_no_limits(task: Task) -> None:
    reach = planar.reach_margins(task.sample.oracle, task.poses).min(axis=1)
    sure = np.abs(reach) > UNDECIDED
    inside = whole(asked(task, **{"class": "theoretical"}))["inside"].ravel()
    np.testing.assert_array_equal(inside[sure], reach[sure] > 0)


@FEWER
@given(tasks(), st.data())
def test_tiles_make_the_same_result_as_one_piece(task: Task, data: st.DataObject) -> None:
    request = asked(task)
    items = analyses.plan(request, 1.0).items
    cuts = sorted(data.draw(st.sets(st.integers(1, max(items - 1, 1)), max_size=6)) - {items})
    bounds = [0, *cuts, items]
    tiles = [analyses.compute(request, start, stop) for start, stop in pairwise(bounds)]
    one = [analyses.compute(request, 0, items)]
    assert analyses.assemble(request, lambda: tiles) == analyses.assemble(request, lambda: one)
    separate, together = arrays(request, tiles), arrays(request, one)
    for name, values in together.items():
        assert separate[name].tobytes() == values.tobytes(), name


@FEWER
@given(tasks(), st.floats(1e-9, 1e-3))
def test_a_plan_covers_every_node_once(task: Task, seconds: float) -> None:
    plan = analyses.plan(asked(task), seconds)
    size = plan.items_per_tile
    bounds = [(a, min(a + size, plan.items)) for a in range(0, plan.items, size)]
    assert bounds[0][0] == 0
    assert bounds[-1][1] == plan.items == task.grid.size
    assert all(a[1] == b[0] and b[0] < b[1] for a, b in pairwise(bounds))


@FEWER
@given(tasks())
def test_the_answer_is_that_of_its_arrays(task: Task) -> None:
    request = asked(task)
    answer = json.loads(analyses.answer(request).model_dump_json(), parse_constant=refuse)
    made = whole(request)
    inside = made["inside"]
    assert answer["nodes"] == inside.size
    assert answer["inside"] == inside.sum()
    counts = np.bincount(made["reason"].ravel(), minlength=256)
    given_ = {entry["code"]: entry["nodes"] for entry in answer["excluded"]}
    assert all(given_.get(code, 0) == counts[code] for code in range(1, 256))
    for name, summary in answer["fields"].items():
        values = made[name][inside]
        assert summary["max"] == (values.max() if values.size else None)
        assert summary["min"] == (values.min() if values.size else None)


@FEWER
@given(tasks())
def test_fields_are_nan_exactly_outside(task: Task) -> None:
    made = whole(asked(task))
    for name in ("effort", "effort_max", "determinant", "actuators"):
        missing = np.isnan(made[name]).reshape(*task.shape, -1)
        np.testing.assert_array_equal(missing.any(axis=-1), ~made["inside"])
        np.testing.assert_array_equal(missing.all(axis=-1), ~made["inside"])


@FEWER
@given(tasks())
def test_the_effort_field_is_that_of_an_effort_request(task: Task) -> None:
    made = whole(asked(task))
    inside = made["inside"].ravel()
    assume(inside.any())
    grid = task.grid
    body = {
        "analysis": "effort",
        "mechanism": task.sample.wire,
        "poses": grid.poses(0, grid.size)[: len(task.sample.pose)].T[inside].tolist(),
        "load": {"force": task.force, "moment": task.moment},
    }
    answer = analyses.answer(analyses.parse(json.dumps(body))).model_dump()
    field = made["effort"].reshape(grid.size, -1)[inside]
    np.testing.assert_array_equal(np.array(answer["effort"]), field)


def refuse(constant: str) -> None:
    raise AssertionError(f"{constant} on the wire")
