"""All angles of one turn: on which arcs of it a leg passes a test, in closed form.

A test that bounds |d|^2, a wave (see `bands`), holds on arcs whose ends are arc cosines; one that
bounds a product of waves, on arcs between the roots of a wave of two harmonics; a drive meets its
stops where one more wave vanishes.
"""

import math

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.kernels.arcs import beside, between, changed, cut, keep
from mechanics.kernels.bands import (
    NOTHING,
    REACH,
    SPAN,
    Turning,
    at_angle,
    band,
    by_band,
    dot,
    moved,
    product,
    square,
    turning,
)
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import (
    Numbers,
    Vector,
    arm,
    crank_angle,
    crank_equation,
    crank_turn,
    numbers,
    rail_coordinate,
)
from mechanics.kernels.waves import (
    MOST_CELLS,
    TURN,
    Ripple,
    Wave,
    added,
    height,
    ripple_roots,
    squared,
    wave_roots,
)
from mechanics.legs import CRANK, RAIL, Legs

ARCS_PER_TEST = 4
"""How many arcs a test may add at most."""


@kernel
def sweep(
    asked: tuple[Integers, Integers, Integers],
    bounds: Floats,
    legs: Legs,
    places: tuple[Floats, Floats, Floats],
    ends: tuple[float, float],
    every: bool,
    codes: Bytes,
    counts: Integers,
    starts: Floats,
    stops: Floats,
) -> None:
    """Write the codes of poses and the arcs of a turn on which all tests hold together.

    A code is 0 while an arc is left (with `every`: while nothing of the range is missing), else
    that of the first test, from 1 on, that takes anything of what its condition met.

    Parameters
    ----------
    asked : tests, their legs, and the number of each one's condition, shape (tests,) each.
    bounds : of a `SPAN` test the least and the greatest |d|^2, shape (tests, 2). [m^2]
    places : positions, shape (3, poses), rotations, shape (9, poses), and axes of the turn,
        shape (3, poses), while its angle is 0; one rotation and axis may stand for all. [m, -, -]
    ends : least and greatest angle, at most a whole turn apart. [rad]
    counts, starts, stops : the arcs left, shapes (poses,), (arcs, poses) and (arcs, poses).
    """
    tests, own_legs, groups = asked
    first = np.zeros(codes.size, np.int64)
    # Whatever part of a whole turn is missing, a pose is done with if all of it is asked.
    done = every and ends[1] - ends[0] >= TURN
    codes[:] = 0
    counts[:] = 1
    starts[0], stops[0] = ends
    for k in range(tests.size):
        if tests[k] == NOTHING or codes.size == 0:
            continue
        leg, drive = numbers(legs, own_legs[k]), legs.drive[own_legs[k]]
        asked_band = (bounds[k, 0], bounds[k, 1])
        for i in range(codes.size):
            # What an earlier condition took counts no more where this one finds something left.
            if codes[i] == 0 and first[i] > 0 and groups[first[i] - 1] < groups[k]:
                first[i] = 0
        _one_test(
            k + 1, tests[k], drive, leg, asked_band, done, places, first, counts, starts, stops
        )
        for i in range(codes.size):
            if codes[i] == 0 and (counts[i] == 0 or (every and first[i] > 0)):
                codes[i], counts[i] = first[i], 0


@kernel
def _one_test(
    code: int,
    test: int,
    drive: int,
    leg: Numbers,
    asked_band: tuple[float, float],
    done: bool,
    places: tuple[Floats, Floats, Floats],
    first: Integers,
    counts: Integers,
    starts: Floats,
    stops: Floats,
) -> None:
    """Leave of every pose's arcs those on which a test holds; `first` keeps who took anything.

    Of poses that are `done` with as soon as any is missing, no arcs are left then.
    """
    positions, rotations, axes = places
    events = np.empty(2 * ARCS_PER_TEST)
    left = np.empty((2, starts.shape[0] + events.size))
    cells = np.empty((2, MOST_CELLS))
    d = turning(leg, arm(leg, rotations, 0), (axes[0, 0], axes[1, 0], axes[2, 0]))
    banded = by_band(test, drive, leg, d)
    for i in range(counts.size):
        if counts[i] == 0:
            continue
        if rotations.shape[1] > 1:
            d = turning(leg, arm(leg, rotations, i), (axes[0, i], axes[1, i], axes[2, i]))
            banded = by_band(test, drive, leg, d)
        here = moved(d, (positions[0, i], positions[1, i], positions[2, i]))
        if banded:
            low, high = band(test, drive, leg, here) if test != SPAN else asked_band
            X = square(here)
            # Most poses are told without a trigonometric call, and without an array's.
            side = beside(X, low, high)
            if side > 0:
                continue
            count = 0
            if side == 0 and not done:
                middle = math.atan2(X.s, X.c)
                count = between(X, middle, low, high, i, counts[i], starts, stops, left)
        else:
            count = _by_events(
                test, drive, leg, here, i, counts[i], starts, stops, left, events, cells
            )
        if count < 0:
            continue
        first[i] = first[i] or code
        counts[i] = count
        for k in range(count):
            starts[k, i], stops[k, i] = left[0, k], left[1, k]


@kernel
def _by_events(
    test: int,
    drive: int,
    leg: Numbers,
    d: Turning,
    i: int,
    count: int,
    starts: Floats,
    stops: Floats,
    left: Floats,
    events: Floats,
    cells: Floats,
) -> int:
    """Write what a test leaves of pose i's arcs; return how many arcs, or -1: all is left.

    Between two events the verdict is the same, and the middle decides.
    """
    low, high = starts[0, i], stops[count - 1, i]
    f = discriminant(drive, leg, leg.rod_length, d)
    if test == REACH:
        met = ripple_roots(f, low, high, cells, events)
    else:
        met = _stops_met(drive, leg, d, low, high, events)
    pieces, kept = cut(events, met, i, count, starts, stops, left), 0
    for k in range(pieces):
        middle = 0.5 * (left[0, k] + left[1, k])
        if test == REACH:
            holds = height(f, middle) >= 0.0
        else:
            holds = within_stops(drive, leg, at_angle(d, middle))
        kept = keep(left, k, kept, holds)
    return kept if changed(left, kept, i, count, starts, stops) else -1


@inlined
def discriminant(drive: int, leg: Numbers, L: float, d: Turning) -> Ripple:
    """Return what must not be below 0 if a rod of length L is to reach from a crank or a rail."""
    r = leg.crank_length
    X, along = square(d), product(d, leg.axis)
    whole = Ripple(X.m, X.c, X.s, 0.0, 0.0)
    if drive == RAIL:
        return added(squared(along), added(whole, Ripple(L * L, 0.0, 0.0, 0.0, 0.0), -1.0), -1.0)
    # P^2 + Q^2 - S^2, and P^2 + Q^2 is 4 r^2 times the square of what lies across the axis.
    S = Wave(X.m + r * r - L * L, X.c, X.s)
    across = added(whole, squared(along), -1.0)
    S2 = squared(S)
    return added(Ripple(-S2.m, -S2.c, -S2.s, -S2.cc, -S2.ss), across, 4.0 * r * r)


@kernel
def _stops_met(
    drive: int, leg: Numbers, d: Turning, low: float, high: float, events: Floats
) -> int:
    """Write at which angles the drive may stand at a stop: there B is a rod's length from c."""
    met = 0
    X, r, L = square(d), leg.crank_length, leg.rod_length
    for bound in (leg.lower_limit, leg.upper_limit):
        if not abs(bound) < math.inf:
            continue
        if drive == CRANK:
            e, f = leg.zero_direction, leg.quarter_direction
            c, s = r * math.cos(bound), r * math.sin(bound)
            B = (e[0] * c + f[0] * s, e[1] * c + f[1] * s, e[2] * c + f[2] * s)
        else:
            B = (bound * leg.axis[0], bound * leg.axis[1], bound * leg.axis[2])
        along = product(d, B)
        rest = dot(B, B) - L * L
        reached = Wave(X.m - 2.0 * along.m + rest, X.c - 2.0 * along.c, X.s - 2.0 * along.s)
        met = wave_roots(reached, low, high, events, met)
    return met


@kernel
def within_stops(drive: int, leg: Numbers, d: Vector) -> bool:
    """Return whether a crank, in some turn, or a rail stands within its stops."""
    if drive == RAIL:
        q = rail_coordinate(leg, d[0], d[1], d[2])
        return bool(q >= leg.lower_limit and q <= leg.upper_limit)
    P, Q, S, root = crank_equation(leg, d[0], d[1], d[2])
    cosine, sine = crank_turn(P, Q, S, root, leg.working_mode)
    angle = crank_angle(cosine, sine)
    middle = 0.5 * (leg.lower_limit + leg.upper_limit)
    angle += TURN * round((middle - angle) / TURN)
    return bool(angle >= leg.lower_limit and angle <= leg.upper_limit)
