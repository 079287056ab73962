"""Waves over a turn, m + c cos t + s sin t, and the roots of what products of two of them make."""

import math
from typing import NamedTuple

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel

LEAST_CELL = 1e-8
"""Half the width at which a root counts as there, if nothing says that it is not. [rad]"""
ROUNDING = 8.0 * 2.0**-52
"""How far a sum may be off, as a share of its terms."""
STEADY = 1e-14
"""A function whose change is this small beside its mean has no roots."""
CELLS = 6
"""Into how many cells the angles are cut at first."""
MOST_CELLS = 64
"""Of every cell one half waits while the other is looked at: CELLS and one a halving."""
TURN = 2.0 * math.pi


class Wave(NamedTuple):
    """The function m + c cos t + s sin t."""

    m: float
    c: float
    s: float


class Ripple(NamedTuple):
    """The function m + c cos t + s sin t + cc cos 2t + ss sin 2t."""

    m: float
    c: float
    s: float
    cc: float
    ss: float


@inlined
def squared(a: Wave) -> Ripple:
    """Return the square of a wave."""
    return Ripple(
        a.m * a.m + 0.5 * (a.c * a.c + a.s * a.s),
        2.0 * a.m * a.c,
        2.0 * a.m * a.s,
        0.5 * (a.c * a.c - a.s * a.s),
        a.c * a.s,
    )


@inlined
def added(a: Ripple, b: Ripple, share: float) -> Ripple:
    """Return a + share b."""
    return Ripple(
        a.m + share * b.m,
        a.c + share * b.c,
        a.s + share * b.s,
        a.cc + share * b.cc,
        a.ss + share * b.ss,
    )


@inlined
def height(f: Ripple, t: float) -> float:
    """Return f(t)."""
    c, s = math.cos(t), math.sin(t)
    return f.m + f.c * c + f.s * s + f.cc * (c * c - s * s) + 2.0 * f.ss * c * s


@inlined
def slope(f: Ripple, t: float) -> float:
    """Return f'(t)."""
    c, s = math.cos(t), math.sin(t)
    return f.s * c - f.c * s + 2.0 * (f.ss * (c * c - s * s) - 2.0 * f.cc * c * s)


@inlined
def bend(f: Ripple, t: float) -> float:
    """Return f''(t)."""
    c, s = math.cos(t), math.sin(t)
    return -f.c * c - f.s * s - 4.0 * (f.cc * (c * c - s * s) + 2.0 * f.ss * c * s)


@kernel
def wave_roots(f: Wave, low: float, high: float, roots: Floats, count: int) -> int:
    """Add the roots of a wave from low to high, at most a turn apart; return how many there are."""
    size = math.hypot(f.c, f.s)
    if not abs(f.m) <= size or size == 0.0:
        return count
    middle, half = math.atan2(f.s, f.c), math.acos(-f.m / size)
    for root in (middle - half, middle + half):
        first = root + TURN * math.ceil((low - root) / TURN)
        if first <= high:
            roots[count] = first
            count += 1
    return count


@kernel
def ripple_roots(f: Ripple, low: float, high: float, cells: Floats, roots: Floats) -> int:
    """Write the at most four roots from low to high; return how many there are.

    A cell is left out where Taylor's bound says that f has no root in it, searched where f' has
    none, so that f has one at most, and else halved: no root is lost but such as rounding cannot
    tell from a neighbour.
    `cells`, shape (2, MOST_CELLS), is scratch.
    """
    bound = math.hypot(f.c, f.s) + 8.0 * math.hypot(f.cc, f.ss)
    if bound <= STEADY * abs(f.m) or bound == 0.0:
        return 0
    blur = ROUNDING * (abs(f.m) + bound)
    for k in range(CELLS):
        # Neighbours share their edge to the last bit: between two edges a root could hide.
        cells[0, k] = low + (high - low) * (k / CELLS)
        cells[1, k] = low + (high - low) * ((k + 1) / CELLS)
    count, waiting = 0, CELLS
    while waiting > 0 and count < roots.size:
        waiting -= 1
        one, other = cells[0, waiting], cells[1, waiting]
        t, h = 0.5 * (one + other), 0.5 * (other - one)
        y, dy, ddy = abs(height(f, t)), abs(slope(f, t)), abs(bend(f, t))
        change = h * (dy + h * (0.5 * ddy + h * bound / 6.0))
        if y > blur + change:
            continue
        if dy > h * (ddy + 0.5 * h * bound):
            count = _only_root(f, one, other, roots, count)
        elif h < LEAST_CELL or not one < t < other or y + change <= blur:
            # Neighbours of a root that is touched are as undecided as the cell that holds it.
            if count == 0 or abs(roots[count - 1] - t) > 100.0 * LEAST_CELL + 4.0 * h:
                roots[count] = t
                count += 1
        else:
            cells[0, waiting], cells[1, waiting] = one, t
            cells[0, waiting + 1], cells[1, waiting + 1] = t, other
            waiting += 2
    return count


@kernel
def _only_root(f: Ripple, low: float, high: float, roots: Floats, count: int) -> int:
    """Add the root between two angles, where f rises or falls all the way, if there is one."""
    y = height(f, low)
    rising = y < 0.0
    if (height(f, high) < 0.0) == rising:
        return count
    t = 0.5 * (low + high)
    for _ in range(60):
        y = height(f, t)
        if (y < 0.0) == rising:
            low = t
        else:
            high = t
        # Newton's step, but never out of what is known to hold the root.
        last, t = t, t - y / slope(f, t)
        if not low < t < high:
            t = 0.5 * (low + high)
        if abs(t - last) <= 2.0**-52 * max(1.0, abs(t)):
            break
    roots[count] = t
    return count + 1
