"""Boxes of nodes told at all angles of a turn at once, against nodes told one by one."""

import math

import numpy as np
import pytest

from mechanics import judging
from mechanics.arrays import Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.conditions.pressure_angle import PressureAngle
from mechanics.conditions.reach import Reach as Reaching
from mechanics.grid import Axis, Grid
from mechanics.kernels.codes import UNSEEN
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Margins, Neighbourhood
from mechanics.octree import Reach, decide
from mechanics.orientations import Orientations, Question, scan_orientations
from mechanics.sweeps import Sweep, arcs_left
from mechanics.workspace import Scan
from tests.mechanics.test_sweeps import CASES, ENDS, SPIN, conditions_of, limited, turned
from tests.oracles.draws import DRAWS, Draw

TOLD = [("planar_3rrr", "phi", 200), *(("gough_stewart", turn, 40) for turn in ("rx", "rz"))]


def grid_of(draw: Draw, mechanism: Mechanism, coordinate: str, count: int) -> Grid:
    """Return a grid somewhat wider than a box of poses, over all but a turn that is swept.

    Of three turns and three translations it has the translations.
    """
    motion = mechanism.motion
    free = motion.translations or motion.turns[: 2 if coordinate == SPIN else 3]
    names = [name for name in free if name != coordinate]
    columns = tuple(motion.coordinates.index(name) for name in names)
    middle, wide = 0.5 * (draw.least + draw.most), 0.9 * (draw.most - draw.least)
    axes = tuple(
        Axis(name, middle[c] - wide[c], middle[c] + wide[c], 2.0 * wide[c] / (count + 2 * k))
        for k, (name, c) in enumerate(zip(names, columns, strict=True))
    )
    return Grid(axes, columns, np.random.default_rng(2).uniform(-0.2, 0.2, draw.least.size))


def count_of(mechanism: Mechanism) -> int:
    return 40 if len(mechanism.motion.translations) == 2 else 12


def drawn(name: str, seed: int) -> tuple[Draw, Mechanism]:
    random = np.random.default_rng(seed)
    draw = DRAWS[name](random)
    poses = random.uniform(draw.least, draw.most, (200, draw.least.size)).T.copy()
    return draw, limited(draw, poses)


def chosen(mechanism: Mechanism) -> list[list[Condition]]:
    """Return reach alone, which boxes tell most of, and all that has closed forms."""
    return [[Reaching(mechanism)], conditions_of(mechanism)]


def told(scan: Scan) -> Floats:
    """Return the codes and the fields of a scan, in one array."""
    parts = [np.repeat(scan.codes, scan.lengths), *scan.fields.values()]
    return np.concatenate([np.asarray(part, dtype=float) for part in parts])


Asked = tuple[Mechanism, list[Condition], Grid, Orientations]


def boxes_agree_with_nodes(asked: Asked, stretch: tuple[int, int], every: bool) -> None:
    """Hold codes, and what is measured of orientations, by boxes against those by nodes."""
    for measured in (False, True):
        by_boxes, by_nodes = (
            scan_orientations(Question(*asked, every, measured), *stretch, by_boxes=way)
            for way in (True, False)
        )
        assert np.array_equal(told(by_boxes), told(by_nodes))


@pytest.mark.parametrize("every", [False, True])
@pytest.mark.parametrize(("name", "coordinate"), CASES)
def test_boxes_say_what_nodes_say(name: str, coordinate: str, every: bool) -> None:
    for seed, (low, high) in enumerate(ENDS):
        draw, mechanism = drawn(name, seed)
        grid = grid_of(draw, mechanism, coordinate, count_of(mechanism))
        turn = turned(mechanism, coordinate, low, high)
        around = Orientations(Grid((), (), grid.fixed), turn, high - low)
        stretch = (grid.size // 7, grid.size - grid.size // 9)
        for conditions in chosen(mechanism):
            boxes_agree_with_nodes((mechanism, conditions, grid, around), stretch, every)


@pytest.mark.parametrize("every", [False, True])
@pytest.mark.parametrize(("name", "coordinate", "count"), TOLD)
def test_boxes_tell_most_of_what_legs_reach(
    name: str, coordinate: str, count: int, every: bool
) -> None:
    for seed, (low, high) in enumerate(ENDS):
        draw, mechanism = drawn(name, seed)
        grid = grid_of(draw, mechanism, coordinate, count)
        turn = turned(mechanism, coordinate, low, high)
        sweep = Sweep(mechanism, [Reaching(mechanism)], grid, turn, every, measured=False)
        asked: list[Integers] = []

        def ask(nodes: Integers, sweep: Sweep = sweep, asked: list[Integers] = asked) -> Bytes:
            asked.append(nodes)
            return sweep.verdicts(nodes)[0]

        decide(mechanism.motion, grid, 0, grid.size, sweep.judge, ask)
        assert sum(nodes.size for nodes in asked) < 0.2 * grid.size


def test_conditions_without_closed_forms_are_searched_where_boxes_are_not_told() -> None:
    draw, mechanism = drawn("planar_3rrr", 3)
    conditions = [*conditions_of(mechanism), PressureAngle(mechanism, 1.2)]
    grid = grid_of(draw, mechanism, "phi", 5)
    turn = turned(mechanism, "phi", -math.pi, math.pi)
    around = Orientations(Grid((), (), grid.fixed), turn, 2.0 * math.pi)
    for every in (False, True):
        boxes_agree_with_nodes((mechanism, conditions, grid, around), (3, grid.size), every)


@pytest.mark.parametrize("every", [False, True])
@pytest.mark.parametrize(("name", "coordinate"), CASES)
def test_what_is_told_of_a_box_holds_at_poses_between_its_nodes(
    name: str, coordinate: str, every: bool
) -> None:
    random = np.random.default_rng(7)
    for seed, (low, high) in enumerate(ENDS):
        draw, mechanism = drawn(name, 10 + seed)
        grid = grid_of(draw, mechanism, coordinate, count_of(mechanism))
        turn = turned(mechanism, coordinate, low, high)
        for conditions in chosen(mechanism):
            sweep = Sweep(mechanism, conditions, grid, turn, every, measured=False)
            middle = 0.5 * (draw.least + draw.most)
            centres = middle + random.uniform(-1.0, 1.0, (300, middle.size)) * (draw.most - middle)
            sizes = 10.0 ** random.uniform(-4.0, -0.5, 300)
            moving = [
                name in mechanism.motion.translations
                for name in (axis.coordinate for axis in grid.axes)
            ]
            reach = Reach(sizes * math.sqrt(sum(moving)), sizes * (len(moving) - sum(moving)))
            poses = np.ascontiguousarray(centres.T)
            codes = sweep.judge(poses, reach)
            own = np.flatnonzero(codes != UNSEEN)
            for _ in range(20):
                moved = poses.copy()
                for column in grid.columns:
                    moved[column] += sizes * random.choice([-1.0, -0.3, 0.5, 1.0], 300)
                single, _ = arcs_left(mechanism, conditions, turn, moved, every=every)
                assert np.array_equal(single[own], codes[own])


def test_no_box_of_one_orientation_is_judged_where_nodes_are_asked_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    draw, mechanism = drawn("gough_stewart", 5)
    grid = grid_of(draw, mechanism, "rz", 12)
    for name, value in {"WORTH_BOXES": 1, "SPARSE": 10**9, "MOST_ASKED": 2.0}.items():
        monkeypatch.setattr(judging, name, value)
    asked: list[Condition] = []

    judged = PressureAngle.margins_near

    def margins_near(self: PressureAngle, near: Neighbourhood) -> Margins:
        asked.append(self)
        return judged(self, near)

    monkeypatch.setattr(PressureAngle, "margins_near", margins_near)
    conditions: list[Condition] = [Reaching(mechanism), PressureAngle(mechanism, 1.5)]
    around = Orientations(Grid((), (), grid.fixed), None, 0.0)
    question = Question(mechanism, conditions, grid, around, every=True, measured=False)
    scan_orientations(question, 0, grid.size, by_boxes=False)
    assert not asked
