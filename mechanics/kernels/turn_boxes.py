"""Boxes of poses told at once, at all angles of a turn, by what bounds the lengths of legs.

At every angle each test keeps a length within bounds, and no length changes more from one pose to
another than the platform point does. So the arcs of the box's centre, cut by bounds that are wider
by as much as any pose of the box may be off, hold those of all its poses; cut by narrower ones,
they are within those of all.
"""

import math
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.kernels.arcs import beside, between
from mechanics.kernels.bands import (
    NOTHING,
    REACH,
    SPAN,
    Turning,
    at_angle,
    band_within,
    by_band,
    dot,
    moved,
    square,
    turning,
)
from mechanics.kernels.codes import INSIDE, UNSEEN
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import Numbers, Vector, arm, numbers
from mechanics.kernels.sides import above
from mechanics.kernels.sweeps import ARCS_PER_TEST, discriminant
from mechanics.kernels.waves import Wave
from mechanics.legs import CRANK, STRUT, Legs

SLACK = 1e-6
"""By this share of all lengths bounds are moved more than they need be.

What rounding, and the thresholds of single poses, take of a squared length is far below its square.
"""
TOGETHER = 512
"""Boxes judged together: few enough for the second cache."""
WIDE, NARROW = 0, 1
"""Of each box arcs that hold, and arcs that are within, those of all its poses."""


class _State(NamedTuple):
    """What is known of the boxes judged together.

    `first` is the test of a condition that was the first to take anything from all poses of a box;
    below 0: it may be another for some poses. `counts` of wide arcs and of narrow ones have shape
    (2, boxes), and the columns of arcs (see `arcs`) are the wide ones, then the narrow ones.
    """

    open: Booleans
    touched: Booleans
    first: Integers
    counts: Integers
    starts: Floats
    stops: Floats
    left: Floats


@kernel
def judge_boxes(
    asked: tuple[Integers, Integers, Integers],
    bounds: Floats,
    legs: Legs,
    places: tuple[Floats, Floats, Floats],
    reach: tuple[Floats, Floats],
    ends: tuple[float, float],
    every: bool,
    codes: Bytes,
) -> None:
    """Write the code that `sweeps.sweep` gives to all poses of each box; `UNSEEN` where not told.

    Parameters
    ----------
    asked, bounds, legs, places, ends, every : as there; `places` are the boxes' centres.
    reach : how far any pose of a box may be from its centre, and how much it may be turned
        against it, shape (boxes,) each. [m, rad]
    """
    tests, own_legs, groups = asked
    most, codes[:] = 1 + ARCS_PER_TEST * tests.size, UNSEEN
    state = _State(
        np.empty(TOGETHER, np.bool_),
        np.empty(TOGETHER, np.bool_),
        np.empty(TOGETHER, np.int64),
        np.empty((2, TOGETHER), np.int64),
        np.empty((most, 2 * TOGETHER)),
        np.empty((most, 2 * TOGETHER)),
        np.empty((2, most + 2 * ARCS_PER_TEST)),
    )
    for begin in range(0, codes.size, TOGETHER):
        own, group = codes[begin : begin + TOGETHER], -1
        state.open[:], state.touched[:], state.first[:], state.counts[:] = True, False, 0, 1
        state.starts[0], state.stops[0] = ends
        for k in range(tests.size):
            if tests[k] == NOTHING:
                continue
            if groups[k] != group:
                _begin_condition(own.size, state)
            group = groups[k]
            leg, drive = numbers(legs, own_legs[k]), legs.drive[own_legs[k]]
            limits = bounds[k, 0], bounds[k, 1]
            _one_test(k + 1, tests[k], drive, leg, limits, every, places, reach, begin, own, state)
        for i in range(own.size):
            if state.open[i] and state.counts[NARROW, i] > 0:
                own[i] = INSIDE


@inlined
def _begin_condition(count: int, state: _State) -> None:
    """Forget who took what of boxes of which all poses have some left; the others stay untold."""
    for i in range(count):
        state.open[i] &= state.counts[NARROW, i] > 0
        state.first[i] = 0


@kernel
def _one_test(
    code: int,
    test: int,
    drive: int,
    leg: Numbers,
    asked_band: tuple[float, float],
    every: bool,
    places: tuple[Floats, Floats, Floats],
    reach: tuple[Floats, Floats],
    begin: int,
    codes: Bytes,
    state: _State,
) -> None:
    """Cut the arcs of all boxes by a test, and write the codes of those that it tells."""
    positions, rotations, axes = places
    size = leg.crank_length + leg.rod_length + _sum(leg.base_point) + _length(leg.platform_point)
    d = turning(leg, arm(leg, rotations, 0), (axes[0, 0], axes[1, 0], axes[2, 0]))
    for i in range(codes.size):
        if not state.open[i]:
            continue
        at = begin + i
        if rotations.shape[1] > 1:
            d = turning(leg, arm(leg, rotations, at), (axes[0, at], axes[1, at], axes[2, at]))
        p = (positions[0, at], positions[1, at], positions[2, at])
        here = moved(d, p)
        off = reach[0][at] + _length(leg.platform_point) * reach[1][at]
        slack = (1.0 + SLACK) * off + SLACK * (size + _sum(p))
        if _bounded(test, drive, leg, here, reach[1][at]):
            taken = _cut_both(test, drive, leg, asked_band, here, slack, i, state)
        else:
            taken = -_side(drive, leg, here, slack) if test == REACH else 0
            for kind in range(2):
                if taken > 0 or (taken == 0 and kind == NARROW):
                    state.counts[kind, i] = 0
        if taken < 0:
            continue
        state.touched[i] = True
        if state.first[i] == 0:
            state.first[i] = code if taken > 0 else -1
        lost = every or state.counts[WIDE, i] == 0
        state.open[i] = not (lost or (state.counts[NARROW, i] == 0 and state.first[i] < 0))
        if lost and state.first[i] > 0:
            codes[i] = state.first[i]


@inlined
def _sum(v: Vector) -> float:
    """Return the sum of a vector's numbers, which its length is at most."""
    return abs(v[0]) + abs(v[1]) + abs(v[2])


@inlined
def _length(v: Vector) -> float:
    """Return the length of a vector."""
    return math.sqrt(dot(v, v))


@inlined
def _side(drive: int, leg: Numbers, d: Turning, slack: float) -> int:
    """Return 1 where a leg reaches all round from all poses of a box, -1 from none, 0: untold.

    What its rod must reach is neither nearer nor farther than the rod is long; where it is of
    neither of two lengths all round, it is on one side of both or between them all round.
    """
    L = leg.rod_length
    long = above(discriminant(drive, leg, L + slack, d))
    short = above(discriminant(drive, leg, L - slack, d)) if slack < L else 0
    if long > 0:
        return 1 if short > 0 else 0
    d0 = at_angle(d, 0.0)
    along = dot(d0, leg.axis)
    across = math.sqrt(max(0.0, dot(d0, d0) - along * along))
    r = leg.crank_length if drive == CRANK else 0.0
    if long < 0 and math.hypot(along if drive == CRANK else 0.0, across - r) > L + slack:
        return -1
    near = short < 0 and drive == CRANK and math.hypot(along, across + r) < L - slack
    return -1 if near else 0


@inlined
def _cut_both(
    test: int,
    drive: int,
    leg: Numbers,
    asked_band: tuple[float, float],
    d: Turning,
    slack: float,
    i: int,
    state: _State,
) -> int:
    """Leave of a box's arcs those on which lengths that may be off by a slack pass a test.

    Return 1 if the test takes anything from all poses of the box, -1 if it takes nothing from any,
    else 0; nobody asks once the first test is known.
    """
    X = square(d)
    narrow = band_within(test, drive, leg, asked_band, d, -slack)
    inner = beside(X, narrow[0], narrow[1])
    if inner > 0:
        return -1
    wide = band_within(test, drive, leg, asked_band, d, slack)
    outer = beside(X, wide[0], wide[1])
    middle = math.atan2(X.s, X.c) if inner == 0 or outer == 0 else 0.0
    sure, fresh = outer < 0, not state.touched[i]
    if outer == 0 and not fresh and state.first[i] == 0:
        sure = _left(X, middle, wide, outer, NARROW, i, state) >= 0
    spared = _leave(X, middle, narrow, inner, NARROW, i, state)
    taken = not _leave(X, middle, wide, outer, WIDE, i, state)
    # Before anything is taken both are the arc of every pose.
    if fresh and spared:
        return -1
    return 1 if sure or (fresh and taken) else 0


@inlined
def _leave(
    X: Wave,
    middle: float,
    limits: tuple[float, float],
    side: int,
    kind: int,
    i: int,
    state: _State,
) -> bool:
    """Leave of a box's arcs those within limits, on which side its wave is; say if all are."""
    kept, column = _left(X, middle, limits, side, kind, i, state), kind * TOGETHER + i
    for k in range(kept):
        state.starts[k, column], state.stops[k, column] = state.left[0, k], state.left[1, k]
    if kept >= 0:
        state.counts[kind, i] = kept
    return kept < 0


@inlined
def _left(
    X: Wave,
    middle: float,
    limits: tuple[float, float],
    side: int,
    kind: int,
    i: int,
    state: _State,
) -> int:
    """Write which of a box's arcs are within limits; return how many, or -1: all."""
    count, column = state.counts[kind, i], kind * TOGETHER + i
    if side > 0 or count == 0:
        return -1
    if side < 0:
        return 0
    low, high = limits
    return between(X, middle, low, high, column, count, state.starts, state.stops, state.left)


@inlined
def _bounded(test: int, drive: int, leg: Numbers, d: Turning, turned: float) -> bool:
    """Return whether bounds on |d|^2 decide a test at all poses of a box."""
    if turned == 0.0:
        return by_band(test, drive, leg, d)
    # What is steady at the centre need not be so where the platform is turned.
    return drive == STRUT or test == SPAN
