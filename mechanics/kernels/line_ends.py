"""Where along a line of a grid the verdict on a leg changes, in closed form, line by line.

Along a line one translation changes, t, and what a leg passes there is one stretch less one hole:
strut and crank between two distances, and a rail's carriage, whose place is concave or convex in
t, not beyond one stop and beyond the other. All ends here are roots of quadratics; `line_torus`
has cranks whose axis is aslant of the line, `line_stops` the stops of cranks.
"""

import math
from typing import NamedTuple

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import Numbers
from mechanics.legs import CRANK, RAIL

REACH = 0
LIMITS = 1
NOTHING = 2
"""A test that every leg passes."""

BLUR = 1e-7
"""A root of less than this share of its terms may be there or not."""
LEAN = 1e-6
"""The square of the sine to a line below which a rail that is not parallel is left to nodes."""
SAME = 1e-10
"""Both solutions of a rail closer than this share of its lengths may be one."""
SHORT = 1e3
"""Legs of cranks with fewer times the distance within which nodes decide are left to these."""
STRAIGHT = 1e-16
"""The cosine of an axis that is perpendicular to a line, or its sine if it is parallel."""

FIRST, STOP, HOLE, HOLE_STOP = 0, 1, 2, 3
"""Rows of where a test begins to hold, ends, and between them does not."""
SECOND = 4
"""How many rows later there is one more stretch and hole, for what must hold as well."""

ABREAST = 128
"""Lines looked at together: few enough for the first cache."""


class Line(NamedTuple):
    """The nodes of a line: the coordinate j that changes, t = minimum + node step. [m]

    Nearer than `near` steps to an end a node decides for itself.
    """

    j: int
    nodes: int
    minimum: float
    step: float
    near: float


class Part(NamedTuple):
    """One leg, the `own` one of all, held to one test, and the code of who fails."""

    test: int
    drive: int
    leg: Numbers
    code: int
    own: int


@inlined
def write_ends(part: Part, line: Line, spans: Floats, ends: Floats) -> int:
    """Write where stretch and hole of each line end, in steps; return 1 + 2: both are there."""
    test, drive, leg = part.test, part.drive, part.leg
    j, share = line.j, 1.0 / line.step
    if test == REACH:
        if drive == CRANK:
            return _crank_ends(leg, j, share, spans, ends)
        if drive == RAIL:
            return _rail_ends(leg, j, share, spans, ends)
        return _strut_ends(j, spans, ends)
    sides = 0
    if drive == RAIL:
        begin, end = leg.lower_limit, leg.upper_limit
        if leg.working_mode < 0.0:
            begin, end = end, begin
        if abs(begin) < math.inf:
            sides += 1
            _stop_ends(leg, j, share, begin, spans, ends, FIRST)
        if abs(end) < math.inf:
            sides += 2
            _stop_ends(leg, j, share, end, spans, ends, HOLE)
        return sides
    if leg.upper_limit < math.inf:
        sides += 1
        _sphere_ends(leg.upper_limit, j, share, spans, ends, FIRST)
    if leg.lower_limit > 0.0:
        sides += 2
        _sphere_ends(leg.lower_limit, j, share, spans, ends, HOLE)
    return sides


@kernel
def roots(b: float, square: float, scale: float) -> tuple[float, float]:
    """Return the roots of (t + b)^2 = square; inf, -inf: none; NaN: rounding decides if any."""
    half = math.sqrt(square if square > 0.0 else 0.0)
    low = -b - half if square > 0.0 else math.inf
    high = -b + half if square > 0.0 else -math.inf
    doubtful = not abs(square) > BLUR * scale
    return math.nan if doubtful else low, math.nan if doubtful else high


@inlined
def _strut_ends(j: int, spans: Floats, ends: Floats) -> int:
    """Mark the lines through A itself, where a strut has no length."""
    through = 0
    u, v = (j + 1) % 3, (j + 2) % 3
    for i in range(ABREAST):
        across = spans[u, i] * spans[u, i] + spans[v, i] * spans[v, i]
        through += 1 if across == 0.0 else 0
        ends[HOLE, i] = math.nan if across == 0.0 else math.inf
        ends[HOLE_STOP, i] = math.nan if across == 0.0 else -math.inf
    return 2 if through > 0 else 0


@inlined
def _sphere_ends(
    radius: float, j: int, share: float, spans: Floats, ends: Floats, row: int
) -> None:
    """Write the roots of |d| = radius; of a negative radius, none."""
    square = radius * abs(radius)
    u, v = (j + 1) % 3, (j + 2) % 3
    for i in range(ABREAST):
        across = spans[u, i] * spans[u, i] + spans[v, i] * spans[v, i]
        low, high = roots(spans[j, i], square - across, abs(square) + across)
        ends[row, i], ends[row + 1, i] = low * share, high * share


@inlined
def _stop_ends(
    leg: Numbers,
    j: int,
    share: float,
    stop: float,
    spans: Floats,
    ends: Floats,
    row: int,
) -> None:
    """Write between where a rail's carriage, among nodes that it reaches, is beyond a stop.

    Beyond is to the side that the working mode takes. At a root of |d - stop s| = L it is either
    the carriage that stands at the stop, or the other solution, which ends nothing.
    """
    s, L, mode = leg.axis, leg.rod_length, leg.working_mode
    u, v = (j + 1) % 3, (j + 2) % 3
    a, b, c = s[j], s[u], s[v]
    flat, same = b * b + c * c, SAME * (L + abs(stop))
    steep = 1.0 / flat
    for i in range(ABREAST):
        e, f, g = spans[j, i] - stop * a, spans[u, i] - stop * b, spans[v, i] - stop * c
        across = f * f + g * g
        square = L * L - across
        low, high = roots(e, square, L * L + across)
        # How far the middle of both solutions is beyond the stop: at the line's origin, at the
        # roots and, where there are none, at the node that the leg reaches first of all.
        along = e * a + f * b + g * c
        top = mode * (along - a * (e - along * a) * steep)
        if square > 0.0:
            low = -math.inf if mode * (along + a * low) > same else low
            high = math.inf if mode * (along + a * high) > same else high
        elif flat > 0.0 and top > 0.0:
            low, high = -low, -high
        if 0.0 < flat <= LEAN:
            low = high = math.nan
        ends[row, i], ends[row + 1, i] = low * share, high * share


@inlined
def _rail_ends(leg: Numbers, j: int, share: float, spans: Floats, ends: Floats) -> int:
    """Write where c is a rod's length from the rail."""
    s, L = leg.axis, leg.rod_length
    u, v = (j + 1) % 3, (j + 2) % 3
    a, b, c = s[j], s[u], s[v]
    flat = b * b + c * c
    steep = 1.0 / flat
    if flat <= LEAN:
        _parallel_rail_ends(leg, j, flat, spans, ends)
        return 1
    for i in range(ABREAST):
        # Of what lies across the line alone: far along it nothing cancels, however lean the rail.
        e = spans[j, i] - a * (spans[u, i] * b + spans[v, i] * c) * steep
        apart = (spans[u, i] * c - spans[v, i] * b) ** 2 * steep
        low, high = roots(e, (L * L - apart) * steep, (L * L + apart) * steep)
        ends[FIRST, i], ends[STOP, i] = low * share, high * share
    return 1


@inlined
def _parallel_rail_ends(leg: Numbers, j: int, flat: float, spans: Floats, ends: Floats) -> None:
    """Write whether c is within a rod's length from a rail along which the distance stays."""
    L = leg.rod_length
    u, v = (j + 1) % 3, (j + 2) % 3
    for i in range(ABREAST):
        left = L * L - (spans[u, i] * spans[u, i] + spans[v, i] * spans[v, i])
        begin = -math.inf if left > 0.0 else math.inf
        begin = math.nan if flat > 0.0 or abs(left) <= BLUR * L * L else begin
        ends[FIRST, i], ends[STOP, i] = begin, -begin


@inlined
def _crank_ends(leg: Numbers, j: int, share: float, spans: Floats, ends: Floats) -> int:
    """Write where c enters or leaves the torus about the crank's axis."""
    s, r, L = leg.axis, leg.crank_length, leg.rod_length
    u, v = (j + 1) % 3, (j + 2) % 3
    a, b, c = s[j], s[u], s[v]
    for i in range(ABREAST):
        if abs(a) <= STRAIGHT:
            height, across = (
                spans[u, i] * b + spans[v, i] * c,
                (spans[u, i] * c - spans[v, i] * b) ** 2,
            )
            left = L * L - height * height
            g = math.sqrt(left if left > 0.0 else 0.0)
            far, near = (r + g) ** 2, (r - g) ** 2
            low, high = roots(spans[j, i], far - across, far + across + L * L)
            begin, end = roots(spans[j, i], near - across, near + across + L * L)
            if left <= 0.0:
                low, high = math.inf, -math.inf
            if abs(left) <= BLUR * L * L:
                low = high = math.nan
        else:
            radius = math.sqrt(spans[u, i] * spans[u, i] + spans[v, i] * spans[v, i])
            near, far = (radius - r) ** 2, (radius + r) ** 2
            low, high = roots(spans[j, i], L * L - near, L * L + near + r * r)
            begin, end = roots(spans[j, i], L * L - far, L * L + far + r * r)
        ends[FIRST, i], ends[STOP, i] = low * share, high * share
        ends[HOLE, i], ends[HOLE_STOP, i] = begin * share, end * share
    return 3


@inlined
def aslant(leg: Numbers, j: int) -> bool:
    """Return whether a crank's axis is neither across a line nor along it."""
    b, c = leg.axis[(j + 1) % 3], leg.axis[(j + 2) % 3]
    return abs(leg.axis[j]) > STRAIGHT and b * b + c * c > STRAIGHT * STRAIGHT
