"""The span of a leg while the platform turns, and what bounds on its square alone can tell.

While the platform turns about one axis, the span of a leg is d(t) = c0 + c1 cos t + c2 sin t with
c1 and c2 perpendicular and of one length, so that |d|^2 and every product of d with a fixed vector
are waves, m + c cos t + s sin t.
"""

import math
from typing import NamedTuple

from mechanics.kernels.compiling import inlined
from mechanics.kernels.legs import Numbers, Vector, span
from mechanics.kernels.waves import Wave
from mechanics.legs import CRANK, RAIL, STRUT

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
def band_within(
    test: int,
    drive: int,
    leg: Numbers,
    asked_band: tuple[float, float],
    d: Turning,
    slack: float,
) -> tuple[float, float]:
    """Return the least and greatest |d|^2 of a test whose lengths may be off by a slack. [m^2]

    Where that is below 0, at which they must not be off.
    """
    if test == SPAN:
        low, high = asked_band
        least = math.sqrt(low) if low > 0.0 else 0.0
        greatest = math.sqrt(high) if high >= 0.0 else -math.inf
        return _squares(least - slack if least > 0.0 else 0.0, greatest + slack, 0.0)
    if test == LIMITS:
        least = leg.lower_limit
        return _squares(least - slack if least > 0.0 else 0.0, leg.upper_limit + slack, 0.0)
    if drive == STRUT:
        return _squares(math.sqrt(LEAST_STRUT * square(d).m) - slack, math.inf, 0.0)
    along, r, L = dot(d.still, leg.axis), leg.crank_length, leg.rod_length
    if drive == RAIL:
        return _squares(0.0, L + slack, along)
    # The nearest point of the crank's circle must be as near as a rod, the farthest as far.
    near, far = _across(L + slack, along), _across(L - slack, along)
    if near < 0.0 or (far < 0.0 and slack < 0.0):
        return math.inf, -math.inf
    return _squares(max(r - near, far - r), r + near, along)


@inlined
def _across(length: float, along: float) -> float:
    """Return how far a point is across an axis that is so far away and along it; < 0: nowhere."""
    return math.sqrt((length - along) * (length + along)) if length >= abs(along) else -1.0


@inlined
def _squares(least: float, greatest: float, along: float) -> tuple[float, float]:
    """Return bounds of |d|^2 from those of its length across an axis along which it is known."""
    low = least * least + along * along if least > 0.0 else -math.inf
    return low, greatest * greatest + along * along if greatest >= 0.0 else -math.inf
