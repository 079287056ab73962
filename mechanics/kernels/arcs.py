"""Arcs of a turn, kept as ascending intervals of angles: cut, taken away from, put together.

The arcs of pose i are `starts[k, i]` to `stops[k, i]`, k below its count; what an operation leaves
of them goes to `left`, shape (2, arcs), and it returns how many are left.
"""

import math

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.waves import TURN, Wave


@inlined
def beside(X: Wave, low: float, high: float) -> int:
    """Return 1 where a wave lies from low to high all round, -1 where nowhere, else 0."""
    size = math.sqrt(X.c * X.c + X.s * X.s)
    least, greatest = X.m - size, X.m + size
    if least >= low and greatest <= high:
        return 1
    return 0 if greatest >= low and least <= high and low <= high else -1


@kernel
def between(
    X: Wave,
    middle: float,
    low: float,
    high: float,
    i: int,
    count: int,
    starts: Floats,
    stops: Floats,
    left: Floats,
) -> int:
    """Leave the arcs on which a wave, now in and now out, lies from low to high; -1: all.

    It is highest at its middle: high enough near it, and low enough away from it.
    """
    size = math.sqrt(X.c * X.c + X.s * X.s)
    # What touches a bound may, rounded, be beyond it.
    near = 0.0 if X.m + size <= high else math.acos(max(-1.0, (high - X.m) / size))
    far = math.pi if X.m - size >= low else math.acos(min(1.0, (low - X.m) / size))
    if near == 0.0:
        kept = _overlap(middle - far, middle + far, i, count, starts, stops, left, 0)
    elif far == math.pi:
        kept = _overlap(middle + near, middle + TURN - near, i, count, starts, stops, left, 0)
    else:
        kept = _overlap(middle - far, middle - near, i, count, starts, stops, left, 0)
        kept = _overlap(middle + near, middle + far, i, count, starts, stops, left, kept)
    return kept if changed(left, kept, i, count, starts, stops) else -1


@kernel
def _overlap(
    start: float,
    stop: float,
    i: int,
    count: int,
    starts: Floats,
    stops: Floats,
    left: Floats,
    kept: int,
) -> int:
    """Add what an arc, in every turn of it, has in common with those of pose i."""
    shift = TURN * math.ceil((starts[0, i] - stop) / TURN)
    while start + shift <= stops[count - 1, i]:
        for k in range(count):
            one = max(start + shift, starts[k, i])
            other = min(stop + shift, stops[k, i])
            if one <= other:
                kept = _insert(one, other, left, kept)
        shift += TURN
    return kept


@inlined
def _insert(start: float, stop: float, left: Floats, kept: int) -> int:
    """Add an arc in its place."""
    k = kept
    while k > 0 and left[0, k - 1] > start:
        left[0, k], left[1, k] = left[0, k - 1], left[1, k - 1]
        k -= 1
    left[0, k], left[1, k] = start, stop
    return kept + 1


@kernel
def cut(
    events: Floats, met: int, i: int, count: int, starts: Floats, stops: Floats, left: Floats
) -> int:
    """Write the arcs cut at the first `met` events, which are sorted; return how many pieces."""
    for one in range(1, met):
        k, event = one, events[one]
        while k > 0 and events[k - 1] > event:
            events[k] = events[k - 1]
            k -= 1
        events[k] = event
    pieces = 0
    for k in range(count):
        start = starts[k, i]
        for event in events[:met]:
            if start < event < stops[k, i]:
                left[0, pieces], left[1, pieces] = start, event
                start = event
                pieces += 1
        left[0, pieces], left[1, pieces] = start, stops[k, i]
        pieces += 1
    return pieces


@inlined
def keep(left: Floats, k: int, kept: int, holds: bool) -> int:
    """Keep piece k, joined to the last one kept if they touch; return how many are kept."""
    if not holds:
        return kept
    if kept > 0 and left[1, kept - 1] == left[0, k]:
        left[1, kept - 1] = left[1, k]
        return kept
    left[0, kept], left[1, kept] = left[0, k], left[1, k]
    return kept + 1


@inlined
def changed(left: Floats, kept: int, i: int, count: int, starts: Floats, stops: Floats) -> bool:
    """Return whether what is left is less than all."""
    differing = 0
    for k in range(min(kept, count)):
        differing += left[0, k] != starts[k, i] or left[1, k] != stops[k, i]
    return kept != count or differing > 0
