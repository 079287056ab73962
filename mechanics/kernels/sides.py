"""On which side of a test a leg is all round a turn, told by the extremes of its waves alone.

1: the test holds at all angles, -1: at none, 0: arcs must be cut (`sweeps`), which says the same
wherever a side is told: bounds on |d|^2 are compared with the very numbers that arcs are cut by,
and of all else only what is farther from 0 than rounding reaches is told.
"""

import math
from typing import NamedTuple

from mechanics.arrays import Floats, Integers
from mechanics.kernels.arcs import beside
from mechanics.kernels.bands import (
    LIMITS,
    REACH,
    SPAN,
    Turning,
    band,
    by_band,
    dot,
    moved,
    product,
    square,
)
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import Numbers, Vector
from mechanics.kernels.sweeps import discriminant
from mechanics.kernels.waves import ROUNDING, Ripple, Wave
from mechanics.legs import CRANK, RAIL, STRUT

FAR = 16.0 * ROUNDING
"""A sum farther from 0 than this share of its terms has the sign that it seems to have."""
CLOSE = 1e-6
"""By this share of its lengths a drive near the ends of its reach may be misplaced."""


class Stops(NamedTuple):
    """A ball that holds the driven link's end wherever its drive is within stops. [m]"""

    centre: Vector
    radius: float


@kernel
def write_sides(
    test: int,
    drive: int,
    leg: Numbers,
    asked_band: tuple[float, float],
    d: Turning,
    positions: Floats,
    count: int,
    sides: Integers,
) -> None:
    """Write the sides of platforms at the first `count` positions, shape (3, nodes).

    `d` is the leg's span with the platform at 0. Each kind of test has a loop of its own, so that
    all are free of branches.
    """
    if test == SPAN:
        _by_band(SPAN, STRUT, leg, asked_band, d, positions, count, sides)
    elif by_band(test, drive, leg, d):
        if drive == RAIL:
            _by_band(REACH, RAIL, leg, asked_band, d, positions, count, sides)
        elif drive == CRANK:
            _by_band(REACH, CRANK, leg, asked_band, d, positions, count, sides)
        elif test == LIMITS:
            _by_band(LIMITS, STRUT, leg, asked_band, d, positions, count, sides)
        else:
            _by_band(REACH, STRUT, leg, asked_band, d, positions, count, sides)
    elif test == LIMITS:
        _by_stops(drive, leg, d, positions, count, sides)
    elif drive == RAIL:
        _by_ripple(RAIL, leg, d, positions, count, sides)
    else:
        _by_ripple(CRANK, leg, d, positions, count, sides)


@inlined
def _by_band(
    test: int,
    drive: int,
    leg: Numbers,
    asked_band: tuple[float, float],
    d: Turning,
    positions: Floats,
    count: int,
    sides: Integers,
) -> None:
    for i in range(count):
        here = moved(d, (positions[0, i], positions[1, i], positions[2, i]))
        low, high = band(test, drive, leg, here) if test != SPAN else asked_band
        sides[i] = beside(square(here), low, high)


@inlined
def _by_ripple(
    drive: int, leg: Numbers, d: Turning, positions: Floats, count: int, sides: Integers
) -> None:
    for i in range(count):
        here = moved(d, (positions[0, i], positions[1, i], positions[2, i]))
        sides[i] = above(discriminant(drive, leg, leg.rod_length, here))


@inlined
def above(f: Ripple) -> int:
    """Return 1 where f is above 0 all round, -1 where below, 0 where it is too near to tell."""
    size = math.sqrt(f.c * f.c + f.s * f.s) + math.sqrt(f.cc * f.cc + f.ss * f.ss)
    blur = FAR * (abs(f.m) + size)
    return 1 if f.m - size > blur else (-1 if f.m + size < -blur else 0)


@inlined
def _by_stops(
    drive: int, leg: Numbers, d: Turning, positions: Floats, count: int, sides: Integers
) -> None:
    """Tell where the rod cannot end within a ball that holds all places of the driven link."""
    ball = _stops(drive, leg)
    L, r = leg.rod_length, ball.radius
    own = dot(ball.centre, ball.centre)
    slack = CLOSE * (L + r + math.sqrt(own))
    low, high = max(0.0, L - r - slack), L + r + slack
    for i in range(count):
        here = moved(d, (positions[0, i], positions[1, i], positions[2, i]))
        X, along = square(here), product(here, ball.centre)
        apart = Wave(X.m - 2.0 * along.m + own, X.c - 2.0 * along.c, X.s - 2.0 * along.s)
        sides[i] = -1 if beside(apart, low * low, high * high) < 0 else 0


@inlined
def _stops(drive: int, leg: Numbers) -> Stops:
    middle = 0.5 * (leg.lower_limit + leg.upper_limit)
    half = 0.5 * (leg.upper_limit - leg.lower_limit)
    if not abs(middle) < math.inf:
        return Stops((0.0, 0.0, 0.0), math.inf)
    if drive == RAIL:
        s = leg.axis
        return Stops((middle * s[0], middle * s[1], middle * s[2]), half)
    e, f, r = leg.zero_direction, leg.quarter_direction, leg.crank_length
    c, s1 = r * math.cos(middle), r * math.sin(middle)
    centre = (e[0] * c + f[0] * s1, e[1] * c + f[1] * s1, e[2] * c + f[2] * s1)
    return Stops(centre, 2.0 * r * math.sin(min(0.5 * half, 0.5 * math.pi)))
