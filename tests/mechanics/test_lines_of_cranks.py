"""Lines along which cranks reach and meet their stops are cut as their nodes say."""

import math

import numpy as np
import pytest

from mechanics.arrays import Floats
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import Condition
from mechanics.conditions.reach import Reach
from mechanics.families.delta import delta_rotary
from mechanics.families.five_bar import five_bar
from mechanics.grid import Axis, Grid
from mechanics.kernels.legs import numbers
from mechanics.kernels.line_ends import ABREAST, FIRST, HOLE, HOLE_STOP, STOP, Line
from mechanics.kernels.line_stops import stop_ends
from mechanics.kernels.line_torus import torus_ends
from mechanics.legs import CRANK, STRUT, Leg, gather
from mechanics.lines import provable
from mechanics.mechanism import Mechanism
from mechanics.motions import PLANAR_TRANSLATION, TRANSLATION, Motion
from mechanics.workspace import Scan, scan
from tests.oracles.draws import Random

QUARTER = 0.5 * math.pi
FREE = [-math.inf, math.inf]


def mechanism_of(motion: Motion, crank: Leg, stops: list[float], mode: float = 1.0) -> Mechanism:
    """Return a mechanism of which only one leg, a crank, ever stops anything."""
    far = [Leg(STRUT, base, np.zeros(3)) for base in np.diag([7.0, 8.0, 0.0])]
    legs = [crank, *far[: len(motion.coordinates) - 1]]
    limits = np.array([stops, *[FREE] * (len(legs) - 1)])
    return Mechanism(motion, gather(legs, limits, np.full(len(legs), mode)))


def agree(mechanism: Mechanism, grid: Grid) -> Scan:
    conditions: list[Condition] = [Reach(mechanism), ActuatorLimits(mechanism)]
    assert provable(mechanism, conditions, grid) == 2
    by_lines = scan(mechanism, conditions, grid, {}, 0, grid.size)
    by_nodes = scan(mechanism, conditions, grid, {}, 0, grid.size, by_lines=False)
    assert by_lines.codes.tobytes() == by_nodes.codes.tobytes()
    assert by_lines.lengths.tobytes() == by_nodes.lengths.tobytes()
    return by_lines


def any_stops(random: Random) -> list[float]:
    """Return stops anywhere, at round angles, at one angle, a turn apart or in a late turn."""
    kind = int(random.integers(5))
    if kind == 0:
        return list(np.sort(random.uniform(-4.0, 4.0, 2)))
    if kind == 1:
        return list(np.sort(random.integers(-12, 13, 2)) * math.pi / 12.0)
    if kind == 2:
        return [QUARTER * int(random.integers(-4, 5))] * 2
    if kind == 3:
        low = QUARTER * int(random.integers(-3, 4))
        return [low, low + 4.0 * QUARTER * (1.0 + float(random.choice([0.0, 1e-15, -1e-6, 1e-6])))]
    low = float(random.uniform(-9.0, 9.0)) * 10.0 ** int(random.integers(0, 5))
    return [low, low + float(random.uniform(0.0, 6.0))]


def any_crank(random: Random, flat: bool) -> Leg:
    """Return a crank of round lengths, in the plane z = 0 or with its axis in any direction."""
    axis = np.array([0.0, 0.0, random.choice([-1.0, 1.0])])
    if not flat:
        round_axis = random.integers(-1, 2, 3) + np.array([0.0, 0.0, 3.0])
        axis = [random.normal(size=3), round_axis, np.roll(axis, 1)][int(random.integers(3))]
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    crank, rod = random.integers(1, 10, 2) * 0.125
    if random.random() < 0.3:
        crank = rod
    point, base = random.integers(-2, 3, (2, 3)) * 0.125
    if flat:
        point[2] = base[2] = 0.0
    return Leg(CRANK, base, point, axis, across, crank, rod)


def any_grid(random: Random, motion: Motion) -> Grid:
    names = [str(name) for name in random.permutation(list(motion.coordinates))]
    axes = []
    for name in names:
        step = float(random.choice([0.125, 0.0625, 10.0 ** random.uniform(-3.0, 0.5)]))
        count = 60 if name == names[-1] else 6
        axes.append(Axis(name, -step * (count // 2), step * (count - count // 2 - 1), step))
    columns = tuple(motion.coordinates.index(name) for name in names)
    return Grid(tuple(axes), columns, np.zeros(len(names)))


@pytest.mark.parametrize("motion", [PLANAR_TRANSLATION, TRANSLATION])
def test_cranks_with_stops(motion: Motion) -> None:
    random = np.random.default_rng(31)
    within = beyond = 0
    for _ in range(250):
        crank = any_crank(random, motion is PLANAR_TRANSLATION)
        mode = float(random.choice([-1.0, 1.0]))
        mechanism = mechanism_of(motion, crank, any_stops(random), mode)
        found = agree(mechanism, any_grid(random, motion))
        within += int(np.count_nonzero(found.codes == 0))
        beyond += int(np.count_nonzero(found.codes > mechanism.leg_count))
    # Both verdicts were met, again and again.
    assert min(within, beyond) > 500


@pytest.mark.parametrize("mode", [-1.0, 1.0])
@pytest.mark.parametrize("stops", [[0.0, QUARTER], [-QUARTER, 0.0], [0.0, 0.0], [QUARTER, 4.0]])
def test_stops_at_the_angle_of_the_stretched_leg(stops: list[float], mode: float) -> None:
    # Lines along x in the plane of the axis meet the ends of reach at angle 0, and a stop there.
    crank = Leg(CRANK, np.zeros(3), np.zeros(3), [0, 1, 0], [1, 0, 0], 0.25, 0.75)
    mechanism = mechanism_of(TRANSLATION, crank, stops, mode)
    lines = (
        Axis("y", -0.75, 0.75, 0.125),
        Axis("z", -0.5, 0.5, 0.125),
        Axis("x", -1.0, 1.0, 0.03125),
    )
    agree(mechanism, Grid(lines, (1, 2, 0), np.zeros(3)))


def test_a_line_that_is_left_in_three_stretches() -> None:
    # Past an axis within the rod's reach the crank swings to and fro between its stops.
    random = np.random.default_rng(2)
    most = 0
    for _ in range(200):
        crank = any_crank(random, flat=False)
        mechanism = mechanism_of(TRANSLATION, crank, list(np.sort(random.uniform(-3.0, 3.0, 2))))
        line = Axis("x", -2.0, 2.0, 0.004)
        fixed = np.array([0.0, *random.uniform(-0.5, 0.5, 2)])
        found = agree(mechanism, Grid((line,), (0,), fixed))
        most = max(most, int(np.count_nonzero(found.codes == 0)))
    assert most >= 3


def test_a_strut_of_no_length_is_within_limits_from_0() -> None:
    legs = [Leg(STRUT, base, np.zeros(3)) for base in np.diag([0.0, 1.0, 0.0])]
    limits = np.array([[0.0, 1.0], FREE, FREE])
    mechanism = Mechanism(TRANSLATION, gather(legs, limits, np.ones(3)))
    grid = Grid((Axis("x", -1.0, 1.0, 0.5),), (0,), np.zeros(3))
    found = scan(mechanism, [ActuatorLimits(mechanism)], grid, {}, 0, grid.size)
    assert found.codes.tolist() == [0]


def beside(random: Random, legs: int) -> Floats:
    """Return spans of lines that most cranks of reach 1 meet."""
    return random.uniform(-0.8, 0.8, (legs, 4, ABREAST))


def test_aslant_cranks_reach_between_the_roots_of_their_quartic() -> None:
    random = np.random.default_rng(4)
    line, unknown = Line(0, 100, 0.0, 0.01, 1e-5), 0
    for spans in beside(random, 12):
        axis, r = random.normal(size=3), float(random.uniform(0.01, 0.99))
        crank = Leg(CRANK, np.zeros(3), np.zeros(3), axis, np.cross(axis, [1, 2, 3]), r, 1.0 - r)
        leg = numbers(mechanism_of(TRANSLATION, crank, FREE).legs, 0)
        ends = np.empty((8, ABREAST))
        torus_ends(leg, line, spans, ends)
        for i in range(ABREAST):
            first, last, hole, hole_ends = (ends[row, i] for row in (FIRST, STOP, HOLE, HOLE_STOP))
            if np.isnan(first):
                unknown += 1
                continue
            found = [first, hole, hole_ends, last] if hole < hole_ends else [first, last]
            expected = reach_ends(np.array(leg.axis), r, spans[:3, i])
            assert np.allclose(found if first < last else [], expected / line.step, atol=1e-6)
    assert unknown < 0.005 * 12 * ABREAST


def reach_ends(axis: Floats, r: float, d: Floats) -> Floats:
    """Return the real roots of P^2 + Q^2 - S^2 along x, from coefficients of polynomials."""
    t = np.polynomial.Polynomial([d[0], 1.0])
    square = t * t + d[1] ** 2 + d[2] ** 2
    height = axis[0] * t + axis[1] * d[1] + axis[2] * d[2]
    rest = square + r * r - (1.0 - r) ** 2
    roots = (4.0 * r * r * (square - height * height) - rest * rest).roots()
    return np.sort(roots[np.abs(roots.imag) < 1e-9].real)


@pytest.mark.parametrize("along", ["x", "z"])
def test_few_lines_are_left_to_nodes(along: str) -> None:
    random = np.random.default_rng(8)
    j = "xyz".index(along)
    line, unknown = Line(j, 100, 0.0, 0.02, 1e-5), 0
    for spans in beside(random, 60):
        r = float(random.uniform(0.2, 0.8))
        axis = random.normal(size=3)
        crank = Leg(CRANK, np.zeros(3), np.zeros(3), axis, np.cross(axis, [1, 2, 3]), r, 1.0 - r)
        stops = list(np.sort(random.uniform(-3.0, 3.0, 2)))
        leg = numbers(mechanism_of(TRANSLATION, crank, stops).legs, 0)
        reached, ends = np.empty((8, ABREAST)), np.empty((8, ABREAST))
        bounds = np.tile([[0.0], [100.0]], ABREAST)
        torus_ends(leg, line, spans, reached)
        stop_ends(leg, line, spans, reached[:4], bounds, np.empty((4, ABREAST)), ends)
        unknown += int(np.count_nonzero(np.isnan(ends[FIRST])))
    assert unknown < 0.005 * 60 * ABREAST


def test_families_with_limited_cranks_are_told_by_lines() -> None:
    limits = np.deg2rad([-60.0, 85.0])
    delta = delta_rotary(
        base_radius=0.2,
        platform_radius=0.05,
        crank_length=0.24,
        rod_length=0.5,
        limits=np.tile(limits, (3, 1)),
        working_mode=np.ones(3),
    )
    flat = five_bar(
        base_distance=0.12,
        crank_length=0.16,
        rod_length=0.22,
        limits=np.deg2rad([[20.0, 200.0], [-20.0, 160.0]]),
        working_mode=np.array([1.0, -1.0]),
    )
    for mechanism, names in ((delta, "zyx"), (delta, "xyz"), (flat, "yx"), (flat, "xy")):
        axes = tuple(Axis(name, -0.6, 0.6, 0.03) for name in names)
        columns = tuple("xyz".index(name) for name in names)
        found = agree(mechanism, Grid(axes, columns, np.zeros(len(names))))
        assert 0 in found.codes
