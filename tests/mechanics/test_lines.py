"""Scans by whole lines find what scans node by node find, code for code."""

import json
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from analyses.mechanisms import build
from mechanics.arrays import Bytes, Integers
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import Condition
from mechanics.conditions.crank_rod_angle import CrankRodAngle, legs_with_elbows
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.fields import actuators
from mechanics.grid import Axis, Grid
from mechanics.kernels.lines import walk
from mechanics.legs import CRANK, RAIL, STRUT, Leg, gather
from mechanics.lines import provable
from mechanics.mechanism import Mechanism
from mechanics.motions import SPATIAL, TRANSLATION, Motion
from mechanics.workspace import Scan, scan
from schemas.mechanisms import parse_spec
from tests.oracles.draws import DRAWS, Draw, Fields, Random

TRANSLATING = [name for name in sorted(DRAWS) if "spherical" not in name]


def wired(wire: Fields) -> Mechanism:
    return build(parse_spec(json.dumps(wire, default=float)))


def limited(draw: Draw, random: Random) -> Mechanism:
    """Return the mechanism with stops that some poses of the draw's box meet and others do not."""
    poses = random.uniform(draw.least, draw.most, (200, draw.least.size)).T.copy()
    drives = Configuration(wired(draw.wire), poses).actuators
    drives = np.where(np.isnan(drives).all(axis=1, keepdims=True), 0.0, drives)
    ends = [np.nanquantile(row, [0.2, 0.9]) for row in drives]
    stops = [{"min": float(low), "max": float(high)} for low, high in ends]
    return wired(draw.wire | {"actuator_limits": stops})


def grid_about(
    draw: Draw,
    mechanism: Mechanism,
    random: Random,
    turning: bool,
    size: float = 4.0,
    lines: int = 5,
) -> Grid:
    """Return a grid of lines along some translation, so many times as wide as the draw's box."""
    motion = mechanism.motion
    names = list(random.permutation(motion.translations))
    if turning and motion.turns:
        names.insert(0, str(random.choice(motion.turns)))
    columns = [motion.coordinates.index(name) for name in names]
    wide = size * (draw.most - draw.least)
    middle = 0.5 * (draw.most + draw.least) + 0.05 * wide * random.uniform(-1, 1, wide.size)
    counts = [5, 5, lines, 61][-len(names) :]
    axes = tuple(
        Axis(name, middle[c] - 0.5 * wide[c], middle[c] + 0.5 * wide[c], wide[c] / (count - 0.5))
        for name, c, count in zip(names, columns, counts, strict=True)
    )
    return Grid(axes, tuple(columns), middle)


def same(one: Scan, other: Scan) -> bool:
    return one.codes.tobytes() == other.codes.tobytes() and (
        one.lengths.tobytes() == other.lengths.tobytes()
    )


@pytest.mark.parametrize("turning", [False, True])
@pytest.mark.parametrize("name", TRANSLATING)
def test_lines_and_nodes_agree(name: str, turning: bool) -> None:
    random = np.random.default_rng(17)
    for _ in range(5):
        draw = DRAWS[name](random)
        mechanism = limited(draw, random)
        grid = grid_about(draw, mechanism, random, turning)
        conditions: list[Condition] = [Reach(mechanism), ActuatorLimits(mechanism)]
        if legs_with_elbows(mechanism):
            conditions.append(CrankRodAngle(mechanism, 0.5, 2.8))
        assert provable(mechanism, conditions, grid) >= 2
        kept = {"actuators": actuators}
        by_lines = scan(mechanism, conditions, grid, kept, 0, grid.size)
        by_nodes = scan(mechanism, conditions, grid, kept, 0, grid.size, by_lines=False)
        assert same(by_lines, by_nodes)
        assert by_lines.fields["actuators"].tobytes() == by_nodes.fields["actuators"].tobytes()


@pytest.mark.parametrize("name", TRANSLATING)
def test_grids_far_wider_than_legs_are_what_their_nodes_are(name: str) -> None:
    """Whole rows, next to each other in a block of lines, are out of the first leg's reach."""
    random = np.random.default_rng(43)
    for size in (2.0, 8.0, 30.0):
        draw = DRAWS[name](random)
        mechanism = limited(draw, random)
        grid = grid_about(draw, mechanism, random, turning=False, size=size, lines=33)
        for conditions in ([Reach(mechanism), ActuatorLimits(mechanism)], [Reach(mechanism)]):
            by_lines = scan(mechanism, conditions, grid, {}, 0, grid.size)
            by_nodes = scan(mechanism, conditions, grid, {}, 0, grid.size, by_lines=False)
            assert same(by_lines, by_nodes)


@pytest.mark.parametrize("drive", [CRANK, RAIL])
def test_rows_of_lines_just_within_a_legs_reach_are_what_their_nodes_are(drive: int) -> None:
    random = np.random.default_rng(29)
    met = 0
    for _ in range(12):
        axis = random.normal(size=3) * random.choice([0.0, 1.0, 1.0], size=3)
        axis = axis if axis.any() else np.array([0.0, 0.0, 1.0])
        across = np.cross(axis, random.normal(size=3))
        crank, rod = random.uniform(0.2, 1.0, 2)
        base, point = random.uniform(-0.3, 0.3, (2, 3))
        legs = [Leg(drive, base, point, axis, across, crank, rod)]
        legs += [Leg(STRUT, np.full(3, 9.0 + k), np.zeros(3)) for k in range(2)]
        free = np.tile([-np.inf, np.inf], (3, 1))
        mechanism = Mechanism(TRANSLATION, gather(legs, free, np.ones(3)))
        u, v, j = random.permutation(3)
        begin, step = random.uniform(-1.0, 1.0), 10.0 ** random.uniform(-4.0, -1.5)
        rows = Axis("xyz"[u], begin, begin + 39.0 * step, step), Axis("xyz"[j], -4.0, 4.0, 0.02)

        def found(offset: float, *, by_lines: bool) -> Scan:
            fixed = np.zeros(3)
            fixed[v] = offset  # noqa: B023  (called in this turn of the loop only)
            grid = Grid(rows, (u, j), fixed)  # noqa: B023
            conditions = [Reach(mechanism)]  # noqa: B023
            return scan(mechanism, conditions, grid, {}, 0, grid.size, by_lines=by_lines)  # noqa: B023

        within = [
            offset
            for offset in np.linspace(-2.5, 2.5, 26)
            if (found(offset, by_lines=False).codes == 0).any()
        ]
        if not within:
            continue
        met += 1
        inside, outside = within[-1], 9.0
        for _ in range(40):
            middle = 0.5 * (inside + outside)
            if (found(middle, by_lines=False).codes == 0).any():
                inside = middle
            else:
                outside = middle
        for offset in (inside, outside, inside - 1e-7, outside + 1e-5, 5.0):
            assert same(found(offset, by_lines=True), found(offset, by_lines=False))
    assert met >= 6


@pytest.mark.parametrize("name", ["delta_linear", "gough_stewart", "planar_3rrr", "hexa_rotary"])
def test_a_stretch_may_begin_and_end_within_a_line(name: str) -> None:
    random = np.random.default_rng(5)
    draw = DRAWS[name](random)
    mechanism = limited(draw, random)
    grid = grid_about(draw, mechanism, random, turning=False)
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    whole = scan(mechanism, conditions, grid, {}, 0, grid.size, by_lines=False)
    dense = np.repeat(whole.codes, whole.lengths)
    for start, stop in pairwise([0, 1, 30, 61, 62, 200, grid.size - 1, grid.size]):
        part = scan(mechanism, conditions, grid, {}, start, stop)
        assert np.array_equal(np.repeat(part.codes, part.lengths), dense[start:stop])


def test_lines_that_touch_a_boundary_are_decided_by_their_nodes() -> None:
    # Lines and nodes fall on the circles' tops, on their centres and on their ends exactly.
    mechanism = wired(
        {
            "kind": "custom",
            "motion": "planar_translation",
            "legs": [
                {"drive": "crank", "base_point": [0, 0, 0], "axis": [0, 0, 1],
                 "zero_direction": [1, 0, 0], "crank_length": 0.5, "rod_length": 0.5,
                 "platform_point": [0, 0, 0]},
                {"drive": "rail", "base_point": [0, 0.25, 0], "direction": [1, 0, 0],
                 "rod_length": 0.75, "platform_point": [0, 0, 0]},
            ],
            "actuator_limits": [None, {"min": -0.5, "max": 0.5}],
        }
    )  # fmt: skip
    for names in ("xy", "yx"):
        axes = tuple(Axis(name, -1.25, 1.25, 0.125) for name in names)
        grid = Grid(axes, tuple("xy".index(name) for name in names), np.zeros(2))
        conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
        assert provable(mechanism, conditions, grid) == 2
        by_lines = scan(mechanism, conditions, grid, {}, 0, grid.size)
        by_nodes = scan(mechanism, conditions, grid, {}, 0, grid.size, by_lines=False)
        assert same(by_lines, by_nodes)
        assert 0 in by_lines.codes


def rail(lean: float, point: list[float], length: float) -> Fields:
    return {
        "drive": "rail",
        "base_point": point,
        "direction": [lean, 0.0, 1.0],
        "rod_length": length,
        "platform_point": [0.0, 0.0, 0.0],
    }


def strut(x: float, y: float) -> Fields:
    return {"drive": "strut", "base_point": [x, y, 0.0], "platform_point": [0.0, 0.0, 0.0]}


def spatial(*legs: Fields) -> Mechanism:
    return wired({"kind": "custom", "motion": "translation", "legs": list(legs)})


def agree(mechanism: Mechanism, *lines: Axis) -> None:
    grid = Grid(lines, (0, 1, 2), np.zeros(3))
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    assert provable(mechanism, conditions, grid) == 2
    by_lines = scan(mechanism, conditions, grid, {}, 0, grid.size)
    by_nodes = scan(mechanism, conditions, grid, {}, 0, grid.size, by_lines=False)
    assert same(by_lines, by_nodes)


@pytest.mark.parametrize("lean", [0.0, 1e-9, 1e-7, 1e-6, 1e-5, 1e-3])
def test_rails_that_lean_off_the_line(lean: float) -> None:
    mechanism = spatial(rail(lean, [0.0, 0.0, 0.0], 0.2), strut(0.5, 0.0), strut(0.0, 0.5))
    for x in (0.2, 0.2 - 1e-7, 0.2 + 1e-7):
        agree(mechanism, Axis("x", x, x, 1.0), Axis("y", 0.0, 0.0, 1.0), Axis("z", -1.0, 1.0, 0.05))


@pytest.mark.parametrize("crank", [0.1, 0.3, 0.5])
@pytest.mark.parametrize("axis", [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [1.0, 0.0, 9e-13]])
def test_cranks_along_and_across_the_line(crank: float, axis: list[float]) -> None:
    leg = {
        "drive": "crank",
        "base_point": [0.0, 0.0, 0.0],
        "axis": axis,
        "zero_direction": [0.0, 1.0, 0.0],
        "crank_length": crank,
        "rod_length": 0.5,
        "platform_point": [0.0, 0.0, 0.0],
    }
    mechanism = spatial(leg, strut(2.0, 0.0), strut(0.0, 2.0))
    agree(
        mechanism, Axis("x", -0.6, 0.6, 0.06), Axis("y", -1.0, 1.0, 0.1), Axis("z", -1.1, 1.1, 0.01)
    )
    edge = 0.5 - 5e-7
    agree(
        mechanism,
        Axis("x", -edge, -edge, 1.0),
        Axis("y", 0.1, 0.1, 1.0),
        Axis("z", -9.0, 9.0, 0.01),
    )


def beside_a_root(leg: Leg, x: float, y: float, root: float, least: float, step: float) -> None:
    """Hold lines along z against their nodes, one of which is a little beside a root."""
    legs = [leg, *(Leg(STRUT, base, np.zeros(3)) for base in np.diag([0.5, 0.5, 0.0])[:2])]
    mechanism = Mechanism(TRANSLATION, gather(legs, np.array([[-np.inf, np.inf]] * 3), np.ones(3)))
    nodes = int((root - least) / step)
    for off in np.geomspace(1e-7, 1e-5, 12) * max(abs(least), 1.0):
        for z in (root - off, root + off):
            line = Axis("z", z - nodes * step, z + 4.5 * step, step)
            agree(mechanism, Axis("x", x, x, 1.0), Axis("y", y, y, 1.0), line)


@pytest.mark.parametrize("length", [1.0 - 9e-16, 1.0, 1.0 + 9e-16])
def test_far_along_a_line_that_a_lean_rail_all_but_misses(length: float) -> None:
    # What is a unit vector but for rounding is taken as one.
    lean, half = 1.05e-3, 0.5
    direction = np.array([np.sin(lean), 0.0, np.cos(lean)]) * length
    leg = Leg(RAIL, np.zeros(3), np.zeros(3), axis=direction, rod_length=1.0)
    beside_a_root(leg, 0.0, np.sqrt(1.0 - (half * np.sin(lean)) ** 2), half, -800.0, 0.0085)


@pytest.mark.parametrize("off", [-0.9e-9, 0.9e-9])
def test_a_zero_direction_that_is_all_but_perpendicular(off: float) -> None:
    share = 3.5e-7
    axis, zero = (1.0, 0.0, 0.0), (off, 0.6, 0.8)
    leg = Leg(CRANK, np.zeros(3), np.zeros(3), axis, zero, crank_length=0.5, rod_length=1.0)
    beside_a_root(
        leg, 0.8, 1.1 * np.sqrt(1.0 - 2.0 * share), 1.1 * np.sqrt(2.0 * share), -0.5, 0.01
    )


@pytest.mark.parametrize("off", [-1e-12, -1e-15, 0.0, 1e-15, 1e-12])
def test_lines_a_hair_beside_a_sphere(off: float) -> None:
    wire = {
        "kind": "custom",
        "motion": "translation",
        "legs": [strut(0.0, 0.0), strut(5.0, 0.0), strut(0.0, 5.0)],
        "actuator_limits": [{"min": 0.25, "max": 1.0}, None, None],
    }
    for x in (1.0, 0.25):
        agree(wired(wire), Axis("x", x + off, x + off, 1.0), Axis("y", 0.0, 0.0, 1.0),
              Axis("z", -1.0, 1.0, 0.001))  # fmt: skip


def any_leg(random: Random) -> tuple[Leg, list[float]]:
    """Return a leg of round lengths, along, across, beside or askew to the lines, and its stops."""
    drive = int(random.integers(3))
    axis = np.roll([0.0, 0.0, float(random.choice([-1.0, 1.0]))], random.integers(3))
    axis += random.choice([0.0, 0.0, 10.0 ** random.uniform(-17, -1), 1.0]) * random.normal(size=3)
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    rod, crank = random.integers(1, 10, 2) * 0.125
    low, high = np.sort(random.integers(-6, 10, 2) * 0.125)
    low, high = (abs(low), abs(low) + high - low + 0.25) if drive == STRUT else (low, high + 0.25)
    point, base = random.integers(-2, 3, (2, 3)) * 0.125
    leg = Leg(drive, base, point, axis, across, crank, rod)
    turns = 4.0 * np.pi if drive == CRANK else 1.0
    free = random.random() < 0.2, random.random() < 0.2
    return leg, [-np.inf if free[0] else turns * low, np.inf if free[1] else turns * high]


def any_grid(random: Random, motion: Motion) -> Grid:
    """Return a small grid of round or odd steps, its lines along some translation."""
    names = [str(name) for name in random.permutation(list("xyz"))]
    if motion is SPATIAL and random.random() < 0.5:
        names.insert(0, "rx")
    names = names[-int(random.integers(1, len(names) + 1)) :]
    axes = []
    for name in names:
        last = name == names[-1]
        step = float(random.choice([0.125, 0.0125, random.uniform(0.02, 0.3)]))
        count = int(random.integers(1, 60 if last else 8))
        least = -0.125 * int(random.integers(0, 13))
        axes.append(Axis(name, least, least + (count - 1) * step, step))
    fixed = random.integers(-4, 5, len(motion.coordinates)).astype(np.float64) * 0.125
    return Grid(tuple(axes), tuple(motion.coordinates.index(name) for name in names), fixed)


@pytest.mark.parametrize("motion", [TRANSLATION, SPATIAL])
def test_round_lengths_on_round_grids(motion: Motion) -> None:
    # Nodes stand on ends, lines touch boundaries, rods fold onto cranks' axes, exactly.
    random = np.random.default_rng(3)
    for _ in range(400):
        drawn = [any_leg(random) for _ in motion.coordinates]
        modes = random.choice([-1.0, 1.0], len(drawn))
        legs = gather([leg for leg, _ in drawn], np.array([stops for _, stops in drawn]), modes)
        mechanism, grid = Mechanism(motion, legs), any_grid(random, motion)
        limits: Condition = ActuatorLimits(mechanism)
        for conditions in ([Reach(mechanism), limits], [limits]):
            assert provable(mechanism, conditions, grid) == len(conditions)
            start, stop = np.sort(random.integers(0, grid.size + 1, 2))
            if start < stop:
                by_lines = scan(mechanism, conditions, grid, {}, start, stop)
                by_nodes = scan(mechanism, conditions, grid, {}, start, stop, by_lines=False)
                assert same(by_lines, by_nodes)


def test_long_scans_from_within_a_line() -> None:
    mechanism = spatial(strut(0.0, 0.0), strut(0.5, 0.0), rail(0.0, [0.0, 0.5, 0.0], 0.6))
    lines = Axis("x", -1.0, 1.0, 0.02), Axis("y", -1.0, 1.0, 0.02), Axis("z", -1.0, 1.0, 0.1)
    grid = Grid(lines, (0, 1, 2), np.zeros(3))
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    found = [
        scan(mechanism, conditions, grid, {}, 7, grid.size - 5, by_lines=way)
        for way in (True, False)
    ]
    assert same(*found)


def test_lines_of_many_runs_are_walked_in_turns(monkeypatch: pytest.MonkeyPatch) -> None:
    """Spheres within each other leave a dozen runs a line, far more than there is room for."""
    centres = np.random.default_rng(7).normal(0.0, 0.02, (6, 3))
    stops = np.array([(0.0, 1.0 - 0.13 * k) for k in range(6)])
    legs = gather([Leg(STRUT, centre, np.zeros(3)) for centre in centres], stops, np.ones(6))
    mechanism = Mechanism(SPATIAL, legs)
    across, along = (Axis(c, -0.2, 0.2, 0.01) for c in "xy"), Axis("z", -1.2, 1.2, 0.06)
    grid = Grid((*across, along), (0, 1, 2), np.zeros(6))
    ends: list[int] = []

    def followed(*given: Any) -> tuple[Bytes, Integers, int]:  # noqa: ANN401
        found = walk(*given)
        ends.append(found[2])
        return found

    monkeypatch.setattr("mechanics.lines.walk", followed)
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    for start, stop in ((0, grid.size), (17, grid.size - 23)):
        by_nodes = scan(mechanism, conditions, grid, {}, start, stop, by_lines=False)
        ends.clear()
        by_lines = scan(mechanism, conditions, grid, {}, start, stop)
        assert same(by_lines, by_nodes)
        assert len(ends) > 2
        assert ends == sorted(set(ends))
        assert ends[-1] == stop


def test_the_finest_lines_are_left_to_nodes() -> None:
    random = np.random.default_rng(1)
    mechanism = limited(DRAWS["gough_stewart"](random), random)
    axis = Axis("z", 0.9, 0.900001, 1e-8)
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    assert provable(mechanism, conditions, Grid((axis,), (2,), np.zeros(6))) == 0


def test_no_nodes_make_no_runs() -> None:
    mechanism = wired(DRAWS["delta_linear"](np.random.default_rng(0)).wire)
    far = Grid(tuple(Axis(c, 90.0, 99.0, 1.0) for c in "xyz"), (0, 1, 2), np.zeros(3))
    assert scan(mechanism, [Reach(mechanism)], far, {}, 7, 7).lengths.size == 0
