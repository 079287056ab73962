"""Blocks of grid lines along none of which a leg can pass its test, told by their ends alone.

Where only the position changes, the lines of one row of the grid are evenly apart: seen along the
lines, a leg's spans lie on a segment, and no crank reaches farther than both its links, no rod
farther from its rail than it is long.
"""

import math

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import inlined
from mechanics.kernels.legs import arm, span
from mechanics.kernels.line_ends import BLUR, LEAN, REACH, Line, Part
from mechanics.legs import CRANK, RAIL

WORTH = 16
"""Lines a row below which a block has too many rows for their ends to be looked at."""

Flat = tuple[float, float]


@inlined
def out_of_reach(
    part: Part,
    line: Line,
    motion: tuple[Floats, int, Floats],
    grid: tuple[Floats, Floats, Integers, Integers, Floats],
    rotations: Floats,
    lines: tuple[int, int],
) -> bool:
    """Return whether no node of `lines`, from the first to before the second, passes a reach.

    False: some may. Rotations have shape (9, 1), the one of all nodes.
    """
    twists, shape = motion[0], grid[2]
    at, behind = lines
    row = shape[-2] if shape.size > 1 else 1
    radius = _reach(part, line.j)
    if not radius < math.inf or (row < WORTH and shape.size > 2):
        return False
    rho = arm(part.leg, rotations, 0)
    # As far beyond as no rounding reaches.
    radius = radius * (1.0 + BLUR) + line.near * line.step
    while at < behind:
        end = min(behind, at - at % row + row)
        begins = _across(part, line.j, span(part.leg, _position(twists, grid, at), rho))
        ends = _across(part, line.j, span(part.leg, _position(twists, grid, end - 1), rho))
        if not _least_square(begins, ends) > radius * radius:
            return False
        at = end
    return True


@inlined
def _reach(part: Part, j: int) -> float:
    """Return how far across the lines, as `_across` has it, a leg reaches; inf: not known. [m]"""
    leg = part.leg
    if part.test == REACH and part.drive == CRANK:
        return leg.crank_length + leg.rod_length
    if part.test == REACH and part.drive == RAIL and not 0.0 < _flat(part, j) <= LEAN:
        return leg.rod_length
    return math.inf


@inlined
def _flat(part: Part, j: int) -> float:
    """Return the square of the sine between a rail and the lines."""
    b, c = part.leg.axis[(j + 1) % 3], part.leg.axis[(j + 2) % 3]
    return b * b + c * c


@inlined
def _position(
    twists: Floats, grid: tuple[Floats, Floats, Integers, Integers, Floats], line: int
) -> tuple[float, float, float]:
    """Return where the platform is at the first node of a line. [m]"""
    minima, steps, shape, columns, fixed = grid
    x = y = z = 0.0
    for k in range(twists.shape[1]):
        rest, value = line, fixed[k]
        for a in range(shape.size - 1, -1, -1):
            index = 0 if a == shape.size - 1 else rest % shape[a]
            value = minima[a] + index * steps[a] if columns[a] == k else value
            rest = rest if a == shape.size - 1 else rest // shape[a]
        x += twists[0, k] * value
        y += twists[1, k] * value
        z += twists[2, k] * value
    return x, y, z


@inlined
def _across(part: Part, j: int, d: tuple[float, float, float]) -> Flat:
    """Return what of a span lies across lines and, for rails aslant of these, across the rail."""
    u, v = d[(j + 1) % 3], d[(j + 2) % 3]
    if part.drive == RAIL:
        flat = _flat(part, j)
        if flat > 0.0:
            b, c = part.leg.axis[(j + 1) % 3], part.leg.axis[(j + 2) % 3]
            return (u * c - v * b) / math.sqrt(flat), 0.0
    return u, v


@inlined
def _least_square(begins: Flat, ends: Flat) -> float:
    """Return the least square of the distance to a segment from the origin."""
    u, v = ends[0] - begins[0], ends[1] - begins[1]
    square = u * u + v * v
    share = -(begins[0] * u + begins[1] * v) / square if square > 0.0 else 0.0
    share = min(1.0, max(0.0, share))
    a, b = begins[0] + share * u, begins[1] + share * v
    return a * a + b * b
