"""What forecasts say of scans, against what scans of the same nodes do."""

from dataclasses import replace

import numpy as np
import pytest

from mechanics.arrays import Floats
from mechanics.conditions.condition import Condition
from mechanics.conditions.pressure_angle import PressureAngle
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.forecasts import (
    NODES,
    Search,
    met_along_lines,
    met_in_order,
    searches,
    seen_around,
    ways_told,
)
from mechanics.grid import Axis, Grid
from mechanics.mechanism import Mechanism
from mechanics.orientations import Orientations, Question, scan_orientations
from mechanics.workspace import scan
from tests.mechanics.test_sweeps import conditions_of, turned
from tests.mechanics.test_turn_boxes import drawn, grid_of

STEEPEST = 1.0
STEP = 0.1
ENDS_SOUGHT = 400
"""More angles than are ever looked at to find the ends of a node's arcs."""


class Counted(PressureAngle):
    """Counts the poses that it is asked of."""

    asked = 0

    def check(self, block: Configuration) -> Floats:
        self.asked += block.count
        return super().check(block)


@pytest.mark.parametrize("name", ["five_bar", "planar_3rrr", "delta_rotary", "gough_stewart"])
def test_a_sample_meets_what_all_nodes_meet(name: str) -> None:
    draw, mechanism = drawn(name, 1)
    grid = grid_of(draw, mechanism, "", 24)
    conditions = [*conditions_of(mechanism), PressureAngle(mechanism, STEEPEST)]
    foreseen = met_along_lines(mechanism, conditions, grid, {}).shares
    found = scan(mechanism, conditions, grid, {}, 0, grid.size)
    codes = np.repeat(found.codes, found.lengths)
    ends = np.cumsum([0, *(len(condition.legs) for condition in conditions)])
    met = np.array([np.mean((codes == 0) | (codes > end)) for end in ends])
    # Five times what chance moves a share by, and a node.
    blur = 5.0 * np.sqrt(met * (1.0 - met) / NODES) + 1.0 / NODES
    assert np.all(np.abs(foreseen - met) <= blur)


def few_orientations(every: bool, measured: bool) -> tuple[Question, Counted]:
    """Return a question about 27 nodes of a hexapod at eight orientations, and what is counted."""
    draw, mechanism = drawn("gough_stewart", 1)
    condition = Counted(mechanism, 0.7)
    middle, motion = 0.5 * (draw.least + draw.most), mechanism.motion
    axes = tuple(Axis(c, m - 0.1, m + 0.1, 0.1) for c, m in zip("xyz", middle, strict=False))
    turns = tuple(Axis(c, -0.2, 0.2, 0.4) for c in motion.turns)
    grid = Grid(axes, (0, 1, 2), middle)
    orientations = Orientations(Grid(turns, (3, 4, 5), middle), None, 1.0)
    conditions: list[Condition] = [Reach(mechanism), condition]
    return Question(mechanism, conditions, grid, orientations, every, measured), condition


@pytest.mark.parametrize("measured", [False, True])
@pytest.mark.parametrize("every", [False, True])
def test_of_few_nodes_in_order_it_is_foreseen_how_many_are_asked(
    every: bool, measured: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Along lines, that is: nodes at several orientations together are asked somewhat more.
    monkeypatch.setattr("mechanics.orientations.FEW", 0)
    question, condition = few_orientations(every, measured)
    shares = met_in_order(question)
    condition.asked = 0
    scan_orientations(question, 0, question.grid.size)
    pairs = question.grid.size * question.orientations.grid.size
    assert condition.asked == pytest.approx(pairs * shares[1], rel=1e-12)
    # What lines do not tell may still change a code to that of an earlier part.
    assert measured or every or condition.asked < pairs


def about(mechanism: Mechanism, grid: Grid, condition: Condition, every: bool) -> Question:
    """Return a question about a planar mechanism over two radians of its turn."""
    turn = replace(turned(mechanism, "phi", -1.0, 1.0), step=STEP)
    orientations = Orientations(Grid((), (), grid.fixed), turn, 2.0)
    conditions: list[Condition] = [Reach(mechanism), condition]
    return Question(mechanism, conditions, grid, orientations, every, measured=False)


def searched(question: Question) -> Search:
    turn = question.orientations.turn
    assert turn is not None
    return searches(question, turn, seen_around(question, turn))


@pytest.mark.parametrize("wide", [0.05, 0.3])
@pytest.mark.parametrize("every", [False, True])
def test_of_few_nodes_it_is_foreseen_how_many_angles_are_searched(every: bool, wide: float) -> None:
    _, mechanism = drawn("planar_3rrr", 1)
    axes = tuple(Axis(c, -wide, wide, wide / 3.0) for c in "xy")
    grid, condition = Grid(axes, (0, 1), np.zeros(3)), Counted(mechanism, STEEPEST)
    question = about(mechanism, grid, condition, every)
    search = searched(question)
    condition.asked = 0
    scan_orientations(question, 0, grid.size, by_boxes=False)
    looked, owners = grid.size * float(search.first[0] + search.sought[0]), search.owners[0]
    assert looked <= condition.asked + 1e-9 <= looked + grid.size * owners * ENDS_SOUGHT + 1e-6


def test_no_node_is_searched_of_which_something_is_missing_anyway() -> None:
    _, mechanism = drawn("planar_3rrr", 1)
    far = Grid(tuple(Axis(c, 0.3, 0.5, 0.02) for c in "xy"), (0, 1), np.zeros(3))
    question = about(mechanism, far, PressureAngle(mechanism, STEEPEST), every=True)
    assert not np.any(searched(question).owners)


@pytest.mark.parametrize(
    ("name", "coordinate", "by_roots"),
    [
        ("planar_3rrr", "phi", [False, False, False]),
        # A crank and a strut about the turn's axis, and a rail across it between them.
        ("custom_planar", "phi", [False, True, False]),
        ("gough_stewart", "rz", [False] * 6),
        ("hexa_rotary", "rz", [True] * 6),
    ],
)
def test_legs_aslant_of_a_turn_are_told_by_their_axes(
    name: str, coordinate: str, by_roots: list[bool]
) -> None:
    draw, mechanism = drawn(name, 1)
    grid, turn = grid_of(draw, mechanism, coordinate, 5), turned(mechanism, coordinate, -1.0, 1.0)
    around = Orientations(Grid((), (), grid.fixed), turn, 2.0)
    question = Question(mechanism, [Reach(mechanism)], grid, around, every=True, measured=False)
    ways = ways_told(question, turn)
    assert ways.by_roots.tolist() == by_roots
    assert np.array_equal(ways.by_bounds, ~ways.by_roots)
