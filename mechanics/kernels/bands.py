"""The span of a leg while the platform turns, and what bounds on its square alone can tell.

While the platform turns about one axis, the span of a leg is d(t) = c0 + c1 cos t + c2 sin t with
c1 and c2 perpendicular and of one length, so that |d|^2 and every product of d with a fixed vector
are waves, m + c cos t + s sin t.
"""

import math
from typing import NamedTuple

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.kernels.arcs import beside
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import Numbers, Vector, arm, numbers, span
from mechanics.kernels.waves import Wave
from mechanics.legs import CRANK, RAIL, STRUT, Legs

REACH, LIMITS, SPAN, NOTHING = 0, 1, 2, 3
"""Tests: the leg's equation is solvable; its drive is within its stops; |d|^2 within given bounds;
none at all."""

LEAST_STRUT = 1e-14
"""A strut has no direction where its square is below this share of its mean over the turn."""
LEAST_SQUARE = 2.0**-1022
"""A strut whose square is below this has no length. [m^2]"""
STEADY = 1e-14
"""A wave this small beside the product of its vectors does not change."""


class Turning(NamedTuple):
    """The span of a leg while the platform turns: d = still + swing cos t + cross sin t. [m]"""

    still: Vector
    swing: Vector
    cross: Vector


@inlined
def dot(a: Vector, b: Vector) -> float:
    """Return the product of two vectors."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@inlined
def turning(leg: Numbers, rho: Vector, n: Vector) -> Turning:
    """Return the span of a leg, whose arm at t = 0 is rho, of a platform at 0 turning about n."""
    along = dot(rho, n)
    axial = (along * n[0], along * n[1], along * n[2])
    u = (rho[0] - axial[0], rho[1] - axial[1], rho[2] - axial[2])
    v = (n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0])
    return Turning(span(leg, (0.0, 0.0, 0.0), axial), u, v)


@inlined
def moved(d: Turning, p: Vector) -> Turning:
    """Return the span of a leg of a platform at p."""
    still = (d.still[0] + p[0], d.still[1] + p[1], d.still[2] + p[2])
    return Turning(still, d.swing, d.cross)


@inlined
def at_angle(d: Turning, t: float) -> Vector:
    """Return the span at an angle. [m]"""
    c, s = math.cos(t), math.sin(t)
    return (
        d.still[0] + d.swing[0] * c + d.cross[0] * s,
        d.still[1] + d.swing[1] * c + d.cross[1] * s,
        d.still[2] + d.swing[2] * c + d.cross[2] * s,
    )


@inlined
def product(d: Turning, v: Vector) -> Wave:
    """Return the wave d.v of a fixed vector."""
    c, s = dot(d.swing, v), dot(d.cross, v)
    if abs(c) + abs(s) <= STEADY * math.sqrt(dot(d.swing, d.swing) * dot(v, v)):
        return Wave(dot(d.still, v), 0.0, 0.0)
    return Wave(dot(d.still, v), c, s)


@inlined
def square(d: Turning) -> Wave:
    """Return the wave |d|^2. [m^2]"""
    mean = dot(d.still, d.still) + dot(d.swing, d.swing)
    return Wave(mean, 2.0 * dot(d.still, d.swing), 2.0 * dot(d.still, d.cross))


@inlined
def by_band(test: int, drive: int, leg: Numbers, d: Turning) -> bool:
    """Return whether bounds on |d|^2 decide a test: not where a leg's axis is aslant of a turn."""
    if drive == STRUT or test == SPAN:
        return True
    return test == REACH and steady(leg, d)


@inlined
def steady(leg: Numbers, d: Turning) -> bool:
    """Return whether the span's share along the leg's axis stays the same."""
    along = product(d, leg.axis)
    return along.c == 0.0 and along.s == 0.0


@inlined
def band(test: int, drive: int, leg: Numbers, d: Turning) -> tuple[float, float]:
    """Return the least and the greatest |d|^2 at which a test holds. [m^2]"""
    r, L = leg.crank_length, leg.rod_length
    if test == LIMITS:
        low, high = max(leg.lower_limit, 0.0), leg.upper_limit
        return low * low, high * abs(high)
    along = dot(d.still, leg.axis)
    if drive == RAIL:
        return 0.0, L * L + along * along
    if drive == CRANK:
        # Across the axis a circle of radius r about it must meet one of radius g about c.
        g = math.sqrt((L - along) * (L + along)) if abs(along) <= L else math.nan
        return along * along + (r - g) ** 2, along * along + (r + g) ** 2
    return max(LEAST_STRUT * square(d).m, LEAST_SQUARE), math.inf


@inlined
def _wave_and_band(
    test: int, drive: int, leg: Numbers, asked_band: tuple[float, float], d: Turning, p: Vector
) -> tuple[Wave, float, float]:
    """Return |d|^2 of a platform at p, and between what it must lie. [m^2]"""
    here = moved(d, p)
    low, high = band(test, drive, leg, here)
    low = asked_band[0] if test == SPAN else low
    high = asked_band[1] if test == SPAN else high
    return square(here), low, high


@kernel
def find_lost(
    asked: tuple[Integers, Integers, Integers],
    bounds: Floats,
    legs: Legs,
    places: tuple[Floats, Floats, Floats],
    lost: Booleans,
) -> None:
    """Say of poses that they are lost where one of the first condition's tests fails all round.

    Nothing is said where a rotation stands for one pose alone.
    """
    positions, rotations, axes = places
    tests, own_legs, groups = asked
    for k in range(tests.size):
        if rotations.shape[1] > 1 or groups[k] > groups[0]:
            break
        leg, drive = numbers(legs, own_legs[k]), legs.drive[own_legs[k]]
        d = turning(leg, arm(leg, rotations, 0), (axes[0, 0], axes[1, 0], axes[2, 0]))
        if tests[k] == NOTHING or not by_band(tests[k], drive, leg, d):
            continue
        limits = bounds[k, 0], bounds[k, 1]
        for i in range(lost.size):
            p = positions[0, i], positions[1, i], positions[2, i]
            X, low, high = _wave_and_band(tests[k], drive, leg, limits, d, p)
            lost[i] |= beside(X, low, high) < 0


@kernel
def hold_at(
    asked: tuple[Integers, Integers, Integers],
    bounds: Floats,
    legs: Legs,
    places: tuple[Floats, Floats, Floats],
    cosines: Floats,
    sines: Floats,
    holds: Booleans,
) -> None:
    """Write whether all tests hold at an angle of each pose's, by bounds on |d|^2.

    Where tests of another kind are asked, they are said not to hold.
    """
    positions, rotations, axes = places
    tests, own_legs, _ = asked
    holds[:] = True
    for k in range(tests.size):
        if tests[k] == NOTHING or holds.size == 0:
            continue
        leg, drive = numbers(legs, own_legs[k]), legs.drive[own_legs[k]]
        limits = bounds[k, 0], bounds[k, 1]
        d = turning(leg, arm(leg, rotations, 0), (axes[0, 0], axes[1, 0], axes[2, 0]))
        banded = by_band(tests[k], drive, leg, d)
        if rotations.shape[1] > 1:
            for i in range(holds.size):
                d = turning(leg, arm(leg, rotations, i), (axes[0, i], axes[1, i], axes[2, i]))
                p = positions[0, i], positions[1, i], positions[2, i]
                X, low, high = _wave_and_band(tests[k], drive, leg, limits, d, p)
                reached = X.m + X.c * cosines[i] + X.s * sines[i]
                holds[i] &= by_band(tests[k], drive, leg, d) & (reached >= low) & (reached <= high)
        else:
            for i in range(holds.size):
                p = positions[0, i], positions[1, i], positions[2, i]
                X, low, high = _wave_and_band(tests[k], drive, leg, limits, d, p)
                reached = X.m + X.c * cosines[i] + X.s * sines[i]
                holds[i] &= banded & (reached >= low) & (reached <= high)
