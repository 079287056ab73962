"""Where along a line of a grid a crank passes its stops.

At a stop, c is a rod's length from where the elbow is then: a quadratic in t. At roots that belong
to the leg's other working mode nothing happens; at each of the others the crank passes the stop,
since it turns steadily wherever the leg reaches. So one verdict, in the midst of the longest piece
between two of them, tells those of all pieces.
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import Numbers
from mechanics.kernels.line_ends import (
    ABREAST,
    FIRST,
    HOLE,
    HOLE_STOP,
    SECOND,
    SHORT,
    STOP,
    Line,
    roots,
)
from mechanics.kernels.stops import elbow, within_stops
from mechanics.kernels.waves import TURN
from mechanics.legs import CRANK

CLEAR = 1e-3
"""The sine between crank and rod, below which it is left to nodes what the working mode is."""
WOUND = 1e3
"""Stops beyond this angle are not known well enough within their turn. [rad]"""
FULL = TURN * (1.0 + 1e-12)
"""Stops this far apart stop nothing, whatever the rounding. [rad]"""
BROAD = 8.0
"""How many times longer a piece must be than what nodes decide for themselves."""
LEFT_TO_NODES = -1
"""What stands for a number of marks that are not known."""

Four = tuple[float, float, float, float]


@kernel
def stop_ends(
    leg: Numbers,
    line: Line,
    spans: Floats,
    reached: Floats,
    bounds: Floats,
    events: Floats,
    ends: Floats,
) -> int:
    """Write where stretch and holes of each line end, if it is still inside; return which exist.

    Parameters
    ----------
    reached : where the leg reaches, as the first four rows of `ends`. [steps]
    bounds : between which nodes a line is still inside, shape (2, lines).
    events : scratch, shape (4, lines).
    ends : a stretch and its hole, and from row `SECOND` on one more of which only the hole is
        used, shape (8, lines). [steps]
    """
    width = leg.upper_limit - leg.lower_limit
    wound = max(abs(leg.lower_limit), abs(leg.upper_limit))
    short = min(leg.crank_length, leg.rod_length) < SHORT * line.near * line.step
    if short or wound > WOUND or width < 0.0:
        ends[FIRST], ends[STOP] = math.nan, math.nan
        return 1
    if width >= FULL:
        return 0
    _write_events(leg, line, spans, events)
    marks = np.empty(6)
    sides = 0
    for i in range(ABREAST):
        passes, count = True, 0
        if bounds[0, i] < bounds[1, i]:
            e = _ordered(events[0, i], events[1, i], events[2, i], events[3, i])
            passes, count = _mark(leg, line, spans, reached, bounds, e, marks, i)
        sides |= _write_rows(passes, count, marks, ends, i)
    return sides


@inlined
def _write_events(leg: Numbers, line: Line, spans: Floats, events: Floats) -> None:
    """Write where the crank is at a stop, in its working mode; inf: nowhere, NaN: it may be."""
    j, share, r, L = line.j, 1.0 / line.step, leg.crank_length, leg.rod_length
    u, v = (j + 1) % 3, (j + 2) % 3
    for row in range(0, 4, 2):
        bound = leg.lower_limit if row == 0 else leg.upper_limit
        cosine, sine = math.cos(bound), math.sin(bound)
        B, ahead = elbow(leg, cosine, sine), elbow(leg, -sine, cosine)
        # Of the root of P^2 + Q^2 - S^2 with its sign, -(c - B) B' is half.
        share_of_mode = -leg.working_mode / (r * L)
        a, b, c = share_of_mode * ahead[j], share_of_mode * ahead[u], share_of_mode * ahead[v]
        for i in range(ABREAST):
            x, y, z = spans[j, i] - B[j], spans[u, i] - B[u], spans[v, i] - B[v]
            across = y * y + z * z
            square = L * L - across
            low, high = roots(x, square, L * L + across + r * r)
            aside, half = y * b + z * c, math.sqrt(square if square > 0.0 else 0.0)
            own, other = aside - half * a, aside + half * a
            none = low == math.inf
            low = low if own > CLEAR else math.inf if own < -CLEAR else math.nan
            high = high if other > CLEAR else math.inf if other < -CLEAR else math.nan
            events[row, i] = math.inf if none else low * share
            events[row + 1, i] = math.inf if none else high * share


@kernel
def _ordered(a: float, b: float, c: float, d: float) -> Four:
    """Return four numbers ascending; all NaN where one is that."""
    if math.isnan(a + b + c + d):
        return math.nan, math.nan, math.nan, math.nan
    a, b = min(a, b), max(a, b)
    c, d = min(c, d), max(c, d)
    a, c = min(a, c), max(a, c)
    b, d = min(b, d), max(b, d)
    return a, min(b, c), max(b, c), d


@inlined
def _mark(
    leg: Numbers,
    line: Line,
    spans: Floats,
    reached: Floats,
    bounds: Floats,
    e: Four,
    marks: Floats,
    i: int,
) -> tuple[bool, int]:
    """Write where the verdict changes; return the first verdict and how often it does."""
    d = spans[0, i], spans[1, i], spans[2, i]
    begin, end = reached[FIRST, i], reached[STOP, i]
    gap, gap_ends = reached[HOLE, i], reached[HOLE_STOP, i]
    first, now, count = True, True, 0
    if math.isnan(e[0] + begin + gap):
        return first, LEFT_TO_NODES
    known = False
    for side in range(2):
        one = begin if side == 0 else gap_ends if gap < gap_ends else math.inf
        other = end if side == 1 else min(gap, end)
        # Of what no node is left in nothing is asked.
        if one >= other or other < bounds[0, i] - 1.0 or one > bounds[1, i]:
            continue
        before = _before(leg, line, d, e, one, other)
        if before < 0:
            return first, LEFT_TO_NODES
        if known and now != (before == 1):
            marks[count] = 0.5 * (gap + gap_ends)
            count += 1
        now = before == 1
        first, known = now if not known else first, True
        for event in e:
            if one < event < other:
                marks[count] = event
                count += 1
                now = not now
    return first, count


@kernel
def _before(
    leg: Numbers, line: Line, d: tuple[float, float, float], e: Four, one: float, other: float
) -> int:
    """Return 1 if the crank is within its stops before the first event after `one`, else 0.

    -1: No piece is long enough to be sure.
    """
    begin, longest, middle, odd, turned = one, 0.0, one, False, False
    for event in e:
        if one < event < other:
            if event - begin > longest:
                longest, middle, turned = event - begin, 0.5 * (begin + event), odd
            begin, odd = event, not odd
    if other - begin > longest:
        longest, middle, turned = other - begin, 0.5 * (begin + other), odd
    if not longest > BROAD * line.near:
        return -1
    j, t = line.j, middle * line.step
    at = (
        d[0] + t if j == 0 else d[0],
        d[1] + t if j == 1 else d[1],
        d[2] + t if j == 2 else d[2],
    )
    return 1 if within_stops(CRANK, leg, at) != turned else 0


@inlined
def _write_rows(passes: bool, count: int, marks: Floats, ends: Floats, i: int) -> int:
    """Write stretch and holes between marks; return which rows of the lines are needed for them."""
    for row in range(0, 8, 2):
        whole = row in (FIRST, SECOND)
        ends[row, i] = -math.inf if whole else math.inf
        ends[row + 1, i] = math.inf if whole else -math.inf
    if count == LEFT_TO_NODES:
        ends[FIRST, i] = ends[STOP, i] = math.nan
        return 1
    sides, at = 0, 0
    if not passes:
        ends[FIRST, i] = marks[0] if count > 0 else math.inf
        sides, at = 1, 1
    if (count - at) % 2 == 1:
        count -= 1
        ends[STOP, i] = marks[count]
        sides = 1
    if at < count:
        ends[HOLE, i], ends[HOLE_STOP, i] = marks[at], marks[at + 1]
        sides |= 2
    if at + 2 < count:
        ends[SECOND + HOLE, i], ends[SECOND + HOLE_STOP, i] = marks[at + 2], marks[at + 3]
        sides |= 8
    return sides
