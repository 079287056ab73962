"""Where a line of a grid enters or leaves the torus of a crank whose axis is aslant of it.

Of t from the point of the line nearest to A, S^2 - P^2 - Q^2 of the leg equation is a quartic
without a cubic term, t^4 + p t^2 + q t + s = (t^2 + h t + low) (t^2 - h t + high), after Descartes.
Its factors propose the roots, two Newton steps polish them; where that moves them far, where they
could be made or unmade by rounding, or moved too far by it, nodes decide.
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import Numbers
from mechanics.kernels.line_ends import ABREAST, FIRST, HOLE, HOLE_STOP, SHORT, STOP, Line

NEWTON = 16
"""Steps to the square of h; more are needed only where that is nearly a double root."""
SMALL = 1e-3
"""The square of h below which high - low is not found by dividing by h."""
BLUR = 1e-5
"""The square of half the distance of two roots below which there may be none, if left exact."""
LEFT = 1e-10
"""What may be left between the quartic and the product of its factors."""
FLAT = 2e-5
"""A slope at which rounding could move a root too far."""
MOVED, SETTLED = 1e-3, 1e-8
"""How far all steps may move a root, and the last one."""


@kernel
def torus_ends(leg: Numbers, line: Line, spans: Floats, ends: Floats) -> int:
    """Write where stretch and hole of each line end, inf, -inf: nowhere, NaN: ask the nodes."""
    unit, j = leg.crank_length + leg.rod_length, line.j
    # Of known size, made here: the compiler sees that nothing overlaps, and vectorises.
    f, pairs = np.empty((3, ABREAST)), np.empty((2, ABREAST))
    z, sides = np.empty(ABREAST), np.empty(ABREAST)
    _write_quartics(leg, j, 1.0 / unit, spans, f)
    _solve_resolvents(f, z, sides)
    _write_factors(f, z, pairs)
    for row in range(4):
        _polish(f, z, pairs[row // 2], row, ends[row])
    share = unit / line.step
    for i in range(ABREAST):
        lower, upper, origin = pairs[0, i] > 0.0, pairs[1, i] > 0.0, spans[j, i] / line.step
        first, second, third, fourth = ends[0, i], ends[1, i], ends[2, i], ends[3, i]
        # Where anything that is there is not known, nothing is.
        doubt = (first - first) + (second - second) if lower else 0.0
        doubt += (third - third) + (fourth - fourth) if upper else 0.0
        doubt += pairs[0, i] - pairs[0, i]
        begin = first if lower else third if upper else math.inf
        end = fourth if upper else second if lower else -math.inf
        hole = second if upper else math.inf
        hole_ends = third if upper else -math.inf
        ends[FIRST, i], ends[STOP, i] = begin * share - origin + doubt, end * share - origin + doubt
        ends[HOLE, i] = (hole if lower else math.inf) * share - origin + doubt
        ends[HOLE_STOP, i] = (hole_ends if lower else -math.inf) * share - origin + doubt
    if unit < SHORT * line.near * line.step:
        ends[FIRST], ends[STOP] = math.nan, math.nan
    return 3


@inlined
def _write_quartics(leg: Numbers, j: int, shrunk: float, spans: Floats, f: Floats) -> None:
    """Write p, q, s of each line, in units of the greatest reach: no root is beyond +-1."""
    a, r, L = leg.axis, leg.crank_length * shrunk, leg.rod_length * shrunk
    u, v = (j + 1) % 3, (j + 2) % 3
    flat = a[u] * a[u] + a[v] * a[v]
    for i in range(ABREAST):
        y, z = spans[u, i] * shrunk, spans[v, i] * shrunk
        across, height = y * y + z * z, y * a[u] + z * a[v]
        rest = across + (r - L) * (r + L)
        f[0, i] = 2.0 * rest - 4.0 * r * r * flat
        f[1, i] = 8.0 * r * r * a[j] * height
        f[2, i] = rest * rest - 4.0 * r * r * (across - height * height)


@inlined
def _solve_resolvents(f: Floats, z: Floats, sides: Floats) -> None:
    """Write the greatest root of z^3 + 2 p z^2 + (p^2 - 4 s) z - q^2, the square of h.

    With the greatest one the roots of one factor all lie below those of the other.
    """
    for i in range(ABREAST):
        p, q, s = f[0, i], f[1, i], f[2, i]
        c = p * p - 4.0 * s
        wide = 4.0 * p * p - 3.0 * c
        dip = (math.sqrt(wide if wide > 0.0 else 0.0) - 2.0 * p) / 3.0
        y = ((dip + 2.0 * p) * dip + c) * dip - q * q
        # Beyond its last dip it is convex; if that is above 0, it is concave up to the only root.
        concave = dip > 0.0 and y > 0.0
        size = abs(q)
        # Lagrange's bound of the roots.
        above = size + math.sqrt(size) - (2.0 * p if p < 0.0 else 0.0)
        above += math.sqrt(-c if c < 0.0 else 0.0)
        z[i], sides[i] = 0.0 if concave else above, -1.0 if concave else 1.0
    for _ in range(NEWTON):
        for i in range(ABREAST):
            p, q, t = f[0, i], f[1, i], z[i]
            c = p * p - 4.0 * f[2, i]
            y = ((t + 2.0 * p) * t + c) * t - q * q
            step = y / ((3.0 * t + 4.0 * p) * t + c)
            # From these sides the steps never pass the root, but for rounding.
            z[i] = t - (step if y * sides[i] > 0.0 else 0.0)


@inlined
def _write_factors(f: Floats, z: Floats, pairs: Floats) -> None:
    """Replace z by h, and write the squares of half the distances of both factors' roots.

    Below 0: there are none; NaN: rounding decides if there are.
    """
    for i in range(ABREAST):
        p, q, s, square = f[0, i], f[1, i], f[2, i], z[i]
        h = math.sqrt(square if square > 0.0 else 0.0)
        mixed = (p + square) * (p + square) - 4.0 * s
        apart = math.sqrt(mixed if mixed > 0.0 else 0.0)
        apart = q / h if square > SMALL else apart if q > 0.0 else -apart
        low, high = 0.5 * (p + square - apart), 0.5 * (p + square + apart)
        lower, upper = 0.25 * square - low, 0.25 * square - high
        left = abs(low * high - s) + abs(h * apart - q)
        nearest = abs(lower) if abs(lower) < abs(upper) else abs(upper)
        doubt = 0.0 if left < LEFT else math.nan
        doubt = doubt if nearest > BLUR else math.nan
        z[i], pairs[0, i], pairs[1, i] = h, lower + doubt, upper + doubt


@inlined
def _polish(f: Floats, z: Floats, pair: Floats, row: int, roots: Floats) -> None:
    """Write one of the four roots, the lower or the upper one of either factor's; NaN: blurred."""
    middle, sign = -0.5 if row < 2 else 0.5, -1.0 if row % 2 == 0 else 1.0
    for i in range(ABREAST):
        p, q, s = f[0, i], f[1, i], f[2, i]
        begin = middle * z[i] + sign * math.sqrt(pair[i] if pair[i] > 0.0 else 0.0)
        t = begin - (((begin * begin + p) * begin + q) * begin + s) / (
            (4.0 * begin * begin + 2.0 * p) * begin + q
        )
        slope = (4.0 * t * t + 2.0 * p) * t + q
        step = (((t * t + p) * t + q) * t + s) / slope
        doubt = 0.0 if abs(slope) > FLAT else math.nan
        doubt = doubt if abs(t - begin) < MOVED else math.nan
        doubt = doubt if abs(step) < SETTLED else math.nan
        roots[i] = t - step + doubt
