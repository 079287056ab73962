"""All angles of a turn at once, against every angle by itself."""

import json
import math

import numpy as np
import pytest

from analyses.mechanisms import build
from mechanics.arcs import Arcs, examined, narrowed
from mechanics.arrays import Booleans, Floats, Integers
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import Condition
from mechanics.conditions.crank_rod_angle import CrankRodAngle, legs_with_elbows
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.kernels.waves import MOST_CELLS, Ripple, height, ripple_roots
from mechanics.mechanism import Mechanism
from mechanics.sweeps import arcs_left
from mechanics.turns import Turn
from schemas.mechanisms import parse_spec
from tests.oracles.draws import DRAWS, Draw, Fields

SPIN = "spin"
PLANE = ("planar_3rrr", "custom_planar")
ONE_TURN = ("delta_linear_4dof", "custom_schoenflies")
SPHERICAL = ("spherical_3rrr", "custom_spherical")
SPATIAL = ("gough_stewart", "hexa_rotary", "hexa_linear", "custom_spatial")
CASES = [
    *((name, "phi") for name in PLANE),
    *((name, "theta") for name in ONE_TURN),
    *((name, turn) for name in SPHERICAL for turn in ("rx", "rz", SPIN)),
    *((name, turn) for name in SPATIAL for turn in ("rx", "ry", "rz")),
]
ENDS = [(-math.pi, math.pi), (-0.2, 0.4), (1.0, 5.0)]


def wired(wire: Fields) -> Mechanism:
    return build(parse_spec(json.dumps(wire, default=float)))


def turned(mechanism: Mechanism, name: str, low: float, high: float) -> Turn:
    motion = mechanism.motion
    column = None if name == SPIN else motion.coordinates.index(name)
    return Turn(motion, name, column, low, high, 0.05)


def limited(draw: Draw, poses: Floats) -> Mechanism:
    """Return the mechanism with stops that some of the poses meet and others do not."""
    drives = Configuration(wired(draw.wire), poses).actuators
    drives = np.where(np.isnan(drives).all(axis=1, keepdims=True), 0.0, drives)
    ends = np.array([np.nanquantile(row, [0.15, 0.85]) for row in drives])
    stops = [{"min": float(low), "max": float(high)} for low, high in ends]
    return wired(draw.wire | {"actuator_limits": stops})


def conditions_of(mechanism: Mechanism) -> list[Condition]:
    conditions: list[Condition] = [Reach(mechanism), ActuatorLimits(mechanism)]
    if legs_with_elbows(mechanism):
        conditions.append(CrankRodAngle(mechanism, 0.4, 2.7))
    return conditions


def codes_at(
    mechanism: Mechanism, conditions: list[Condition], turn: Turn, poses: Floats, angle: float
) -> Integers:
    owners = np.arange(poses.shape[1])
    block = Configuration(mechanism, turn.poses(poses, owners, np.full(owners.size, angle)))
    holds = np.concatenate([condition.check(block) >= 0.0 for condition in conditions])
    codes: Integers = np.where(holds.all(axis=0), 0, 1 + np.argmin(holds, axis=0))
    return codes


def beside(arcs: Arcs, owners: int, angle: float) -> tuple[Booleans, Booleans]:
    """Return which owners have an arc at an angle, and which have the end of one close to it."""
    on = (arcs.starts <= angle) & (angle <= arcs.stops)
    near = np.minimum(np.abs(arcs.starts - angle), np.abs(arcs.stops - angle)) < 1e-7
    return (
        np.bincount(arcs.owners[on], minlength=owners) > 0,
        np.bincount(arcs.owners[near], minlength=owners) > 0,
    )


@pytest.mark.parametrize(("name", "coordinate"), CASES)
def test_arcs_agree_with_every_angle(name: str, coordinate: str) -> None:
    random = np.random.default_rng(5)
    count = 200
    seen = np.zeros(2, np.int64)
    for low, high in ENDS:
        draw = DRAWS[name](random)
        poses = random.uniform(draw.least, draw.most, (count, draw.least.size)).T.copy()
        mechanism = limited(draw, poses)
        conditions = conditions_of(mechanism)
        turn = turned(mechanism, coordinate, low, high)
        codes, arcs = arcs_left(mechanism, conditions, turn, poses)
        broken, _ = arcs_left(mechanism, conditions, turn, poses, every=True)
        for angle in np.linspace(low, high, 101):
            single = codes_at(mechanism, conditions, turn, poses, angle)
            on, near = beside(arcs, count, angle)
            holds = single == 0
            assert np.array_equal(holds[~near], on[~near])
            assert np.all(codes[holds] == 0)
            # What one angle breaks is broken, by that part or an earlier one.
            assert np.all((broken[~holds] > 0) & (broken[~holds] <= single[~holds]))
            seen += [np.sum(on), np.sum(~on)]
    assert np.all(seen > 100)


def test_a_whole_turn_of_a_free_platform_is_one_arc() -> None:
    mechanism = wired(DRAWS["planar_3rrr"](np.random.default_rng(0)).wire)
    turn = turned(mechanism, "phi", -math.pi, math.pi)
    codes, arcs = arcs_left(mechanism, [], turn, np.zeros((3, 4)), every=True)
    assert codes.tolist() == [0] * 4
    assert arcs.measures(4) == pytest.approx([2.0 * math.pi] * 4, abs=1e-15)


def roots(f: Ripple, low: float, high: float) -> list[float]:
    found = np.empty(4)
    count = ripple_roots(f, low, high, np.empty((2, MOST_CELLS)), found)
    return sorted(found[:count].tolist())


def test_ripples_vanish_where_their_polynomials_do() -> None:
    random = np.random.default_rng(1)
    for _ in range(2000):
        f = Ripple(*(random.normal(size=5) * random.choice([1e-3, 1.0], 5)))
        # In z = exp(i t), of which the roots on the unit circle are real angles.
        one, two = 0.5 * complex(f.c, -f.s), 0.5 * complex(f.cc, -f.ss)
        z = np.roots([two, one, f.m, one.conjugate(), two.conjugate()])
        # Where two are nearly one, neither way knows whether they are there.
        if np.any((np.abs(np.abs(z) - 1.0) < 1e-4) & (np.abs(np.abs(z) - 1.0) > 1e-9)):
            continue
        angles = np.sort(np.angle(z[np.abs(np.abs(z) - 1.0) < 1e-9]))
        np.testing.assert_allclose(roots(f, -math.pi, math.pi), angles, atol=1e-8)
        part = angles[(angles > -1.0) & (angles < 2.0)]
        np.testing.assert_allclose(roots(f, -1.0, 2.0), part, atol=1e-8)


def test_roots_on_the_edges_of_cells_are_found() -> None:
    for place in np.arange(-12, 12) * math.pi / 12:
        for other in np.arange(-12, 12) * math.pi / 6:
            # sin(t - place) sin(t - other) = (cos(place - other) - cos(2t - place - other)) / 2
            total = place + other
            f = Ripple(
                0.5 * math.cos(place - other),
                0.0,
                0.0,
                -0.5 * math.cos(total),
                -0.5 * math.sin(total),
            )
            found = np.array(roots(f, -math.pi, math.pi))
            for root in (place, other):
                turned = (root - found + 0.5 * math.pi) % math.pi - 0.5 * math.pi
                assert np.min(np.abs(turned)) < 1e-6, (place, other)
            if abs(math.sin(place - other)) > 1e-9 and math.sin(place) * math.sin(other) != 0.0:
                assert found.size >= 4 - 2 * (abs(math.sin(place) * math.sin(other)) < 1e-9)


def test_a_root_opposite_a_triple_one_is_found() -> None:
    for shift in np.linspace(0.05, 1.0, 101):
        # (1 - cos u) sin u, u = t - shift
        c, s, cc, ss = math.cos(shift), math.sin(shift), math.cos(2 * shift), math.sin(2 * shift)
        f = Ripple(0.0, -s, c, 0.5 * ss, -0.5 * cc)
        found = roots(f, -math.pi, math.pi)
        assert min(abs(root - shift + math.pi) for root in found) < 1e-7
        assert min(abs(root - shift) for root in found) < 1e-4


def test_a_strut_without_length_all_round_does_not_reach() -> None:
    ends = [((0, 0, 0), (0.5, 0, 0)), ((0, 0.25, 0), (0, 0, 0)), ((0, 0, 0), (0, 0, 0))]
    legs = [{"drive": "strut", "base_point": a, "platform_point": b} for a, b in ends]
    mechanism = wired({"kind": "custom", "motion": "planar", "legs": legs})
    turn = turned(mechanism, "phi", -math.pi, math.pi)
    assert arcs_left(mechanism, [Reach(mechanism)], turn, np.zeros((3, 1)))[0].tolist() == [3]


def test_a_ripple_that_touches_zero_has_a_root_there() -> None:
    # (1 - cos(t - 0.3)) (2 + cos t) touches 0 at 0.3 and is above elsewhere.
    c, s = math.cos(0.3), math.sin(0.3)
    f = Ripple(2.0 - 0.5 * c, 1.0 - 2.0 * c, -2.0 * s, -0.5 * c, -0.5 * s)
    assert abs(height(f, 0.3)) < 1e-15
    assert roots(f, -math.pi, math.pi) == pytest.approx([0.3], abs=1e-7)


def whole(count: int) -> Arcs:
    return Arcs(np.arange(count), np.full(count, -math.pi), np.full(count, math.pi))


def test_ends_are_found_to_a_billionth() -> None:
    shifts = np.linspace(0.0, 1.0, 7)

    def look(owners: Integers, angles: Floats) -> Floats:
        return np.cos(3.0 * (angles - shifts[owners]))[None] - 0.5

    arcs = narrowed(examined(whole(7), 0.1, look, None), look)
    exact = [
        shift + (2.0 * math.pi * k + side * math.acos(0.5)) / 3.0
        for shift in shifts
        for k in range(-3, 4)
        for side in (-1, 1)
    ]
    ends = np.concatenate([arcs.starts, arcs.stops])
    inner = ends[np.abs(ends) < math.pi - 1e-8]
    assert inner.size == 7 * 6
    assert np.max(np.min(np.abs(inner[:, None] - exact), axis=1)) < 2e-9


@pytest.mark.parametrize("depth", [1e-6, 1e-3])
def test_dips_between_angles_are_found(depth: float) -> None:
    places = np.linspace(0.013, 0.087, 9)

    def look(owners: Integers, angles: Floats) -> Floats:
        return np.array([1.0 - depth - np.cos(angles - places[owners])])

    def raised(owners: Integers, angles: Floats) -> Floats:
        return -look(owners, angles)

    arcs = narrowed(examined(whole(9), 0.1, look, None), look)
    width = 2.0 * math.acos(1.0 - depth)
    np.testing.assert_allclose(2.0 * math.pi - arcs.measures(9), width, atol=1e-8)
    arcs = narrowed(examined(whole(9), 0.1, raised, None), raised)
    np.testing.assert_allclose(arcs.measures(9), width, atol=1e-8)


def test_dips_beside_the_ends_of_arcs_are_found() -> None:
    def look(owners: Integers, angles: Floats) -> Floats:
        return ((angles - 0.05) ** 2 - 1e-4)[None]

    for stop in (0.1, 0.15, 0.4):
        arc = Arcs(np.array([0]), np.array([0.0]), np.array([stop]))
        left = narrowed(examined(arc, 0.1, look, None), look)
        assert left.measures(1) == pytest.approx([stop - 0.02], abs=1e-8)


def test_singularities_break_what_stays_far_from_its_limit_beside_them() -> None:
    places = np.linspace(-0.03, 0.04, 5)

    def look(owners: Integers, angles: Floats) -> Floats:
        with np.errstate(divide="ignore"):
            return np.array([1.0 - 1e-6 / np.abs(angles - places[owners])])

    def determinants(owners: Integers, angles: Floats) -> Floats:
        return angles - places[owners]

    assert narrowed(examined(whole(5), 0.1, look, None), look).owners.size == 5
    arcs = narrowed(examined(whole(5), 0.1, look, determinants), look)
    assert arcs.owners.tolist() == [k for k in range(5) for _ in range(2)]
    np.testing.assert_allclose(2.0 * math.pi - arcs.measures(5), 2e-6, atol=1e-8)
