"""Many orientations taken together, against each of them taken alone."""

import math
from dataclasses import replace

import numpy as np
import pytest

from mechanics.arrays import Bytes, Floats
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import Condition
from mechanics.conditions.pressure_angle import PressureAngle
from mechanics.conditions.reach import Reach
from mechanics.grid import Axis, Grid
from mechanics.legs import CRANK, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import PLANAR
from mechanics.orientations import Orientations, Question, scan_orientations
from mechanics.workspace import Scan, ranks_of, scan
from tests.mechanics.test_sweeps import SPATIAL, conditions_of, limited, turned
from tests.oracles.draws import DRAWS

RANGES = [("rz", -math.pi, math.pi), ("rz", -0.4, 0.5), ("rx", 0.3, 0.3)]


def positions_of(least: Floats, most: Floats) -> Grid:
    """Return a grid wider than a box of positions, of more nodes than are weighed together."""
    middle, wide = 0.5 * (least + most), 0.8 * (most - least)
    axes = tuple(
        Axis(name, m - w, m + w, 2.0 * w / (count - 0.5))
        for name, m, w, count in zip("xyz", middle[:3], wide[:3], (7, 9, 11), strict=True)
    )
    return Grid(axes, (0, 1, 2), np.zeros(6))


def around(mechanism: Mechanism, turn: tuple[str, float, float]) -> Orientations:
    """Return orientations on either side of rest, about two axes, with all of a turn."""
    own = turned(mechanism, *turn)
    names = [name for name in mechanism.motion.turns if name != own.coordinate]
    axes = tuple(Axis(name, -0.2, 0.2, 0.1) for name in names)
    columns = tuple(mechanism.motion.coordinates.index(name) for name in names)
    return Orientations(Grid(axes, columns, np.zeros(6)), own, 0.4**2 * (own.high - own.low))


def dense(found: Scan) -> tuple[Bytes, Floats]:
    codes = np.repeat(found.codes, found.lengths)
    free = np.zeros(codes.size)
    free[codes == 0] = found.fields.get("free_orientation", 0.0)
    return codes, free


def one_by_one(
    mechanism: Mechanism,
    conditions: list[Condition],
    grid: Grid,
    orientations: Orientations,
    *,
    every: bool,
) -> tuple[Bytes, Floats]:
    """Return codes, and free orientations, put together as their definition says."""
    rows = []
    for fixed in orientations.grid.poses(0, orientations.grid.size).T:
        alone = replace(orientations, grid=Grid((), (), fixed))
        turned = replace(grid, fixed=fixed)
        question = Question(mechanism, conditions, turned, alone, every, measured=True)
        found = scan_orientations(question, 0, grid.size)
        rows.append(dense(found))
    codes, free = (np.array(column) for column in zip(*rows, strict=True))
    return put_together(codes, conditions, every=every)[0], free.mean(axis=0)


def put_together(codes: Bytes, conditions: list[Condition], *, every: bool) -> tuple[Bytes, Floats]:
    """Return the codes of nodes, and shares inside, from codes, shape (orientations, nodes)."""
    free = np.mean(codes == 0, axis=0)
    if every:
        worst = np.where(codes == 0, 255, codes).min(axis=0)
        return np.where(worst == 255, 0, worst).astype(np.uint8), free
    ranks = ranks_of(conditions)[codes]
    farthest = np.where(ranks == ranks.max(axis=0), codes, 255).min(axis=0)
    return farthest.astype(np.uint8), free


@pytest.mark.parametrize("every", [False, True])
@pytest.mark.parametrize("turn", RANGES)
@pytest.mark.parametrize("name", SPATIAL)
def test_orientations_together_say_what_each_alone_says(
    name: str, turn: tuple[str, float, float], every: bool
) -> None:
    random = np.random.default_rng(11)
    draw = DRAWS[name](random)
    poses = random.uniform(draw.least, draw.most, (200, draw.least.size)).T.copy()
    mechanism = limited(draw, poses)
    conditions = conditions_of(mechanism)
    grid, orientations = positions_of(draw.least, draw.most), around(mechanism, turn)
    expected, free = one_by_one(mechanism, conditions, grid, orientations, every=every)
    for measured in (False, True):
        question = Question(mechanism, conditions, grid, orientations, every, measured)
        found = scan_orientations(question, 0, grid.size)
        codes, sizes = dense(found)
        assert np.array_equal(codes, expected)
        if measured:
            inside = codes == 0
            np.testing.assert_allclose(sizes[inside], free[inside], rtol=1e-13)
    # A whole turn breaks the first stop nearly everywhere.
    assert every or np.unique(expected).size > 1


@pytest.mark.parametrize("few", [0, 100, 10_000])
@pytest.mark.parametrize("every", [False, True])
@pytest.mark.parametrize("name", ["gough_stewart", "hexa_rotary", "planar_3rrr"])
def test_orientations_in_order_say_what_poses_say(
    name: str, every: bool, few: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Along lines one after the other, few nodes several together, or first one, then the other."""
    monkeypatch.setattr("mechanics.orientations.FEW", few)
    random = np.random.default_rng(23)
    draw = DRAWS[name](random)
    poses = random.uniform(draw.least, draw.most, (200, draw.least.size)).T.copy()
    mechanism = limited(draw, poses)
    conditions: list[Condition] = [Reach(mechanism), ActuatorLimits(mechanism)]
    conditions.append(PressureAngle(mechanism, 0.7))
    motion, middle = mechanism.motion, 0.5 * (draw.least + draw.most)
    grid = positions_of(draw.least, draw.most)
    count = len(motion.translations)
    grid = Grid(grid.axes[:count], grid.columns[:count], middle)
    turns = tuple(Axis(name, -0.3, 0.3, 0.2) for name in motion.turns)
    turned = Grid(turns, tuple(motion.coordinates.index(name) for name in motion.turns), middle)
    for measured in (False, True):
        around = Orientations(turned, None, 1.0)
        question = Question(mechanism, conditions, grid, around, every, measured)
        codes, sizes = dense(scan_orientations(question, 0, grid.size))
        each = [
            dense(scan(mechanism, conditions, at, {}, 0, grid.size, by_lines=False))[0]
            for at in map(question.turned, range(turned.size))
        ]
        expected, free = put_together(np.array(each), conditions, every=every)
        assert np.array_equal(codes, expected)
        if measured:
            np.testing.assert_allclose(sizes[codes == 0], free[codes == 0], rtol=1e-13)
    assert np.unique(expected).size > 1


@pytest.mark.parametrize("every", [False, True])
def test_a_turn_of_more_radians_than_lengths_have_metres_is_no_length(every: bool) -> None:
    """Lines finer by far than all lengths are walked at all orientations, or at none."""
    ends = [([0.6, 0.0, 0.0], [0.2, 0.0, 0.0]), ([0.1, 0.1, 0.0], [0.0, 0.0, 0.0]),
            ([0.6, 0.0, 0.0], [-0.2, 0.0, 0.0])]  # fmt: skip
    axis, zero = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)
    legs = [Leg(CRANK, np.array(A), np.array(c), axis, zero, 0.25, 0.25) for A, c in ends]
    free = np.tile([-np.inf, np.inf], (3, 1))
    mechanism = Mechanism(PLANAR, gather(legs, free, np.ones(3)))
    grid = Grid((Axis("x", 0.0, 0.0002, 0.00002),), (0,), np.zeros(3))
    around = Orientations(Grid((Axis("phi", 0.0, 3.14, 3.14),), (2,), np.zeros(3)), None, 3.14)
    question = Question(mechanism, [Reach(mechanism)], grid, around, every, measured=False)
    found = scan_orientations(question, 0, grid.size)
    # The third leg fails at rest, the first one turned by half a turn.
    assert found.codes.tolist() == [1]
    assert found.lengths.tolist() == [11]
