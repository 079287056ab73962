"""Which nodes of whole lines pass a test: the ends in closed form, settled by the nodes beside.

The node nearest to an end decides for itself, by the very formulas that a block of poses goes
through; every other node stands half a step or more from any end, farther than rounding reaches.
"""

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import (
    Numbers,
    Vector,
    arm,
    crank_equation,
    rail_coordinate,
    rail_equation,
    span,
    strut_length,
)
from mechanics.kernels.line_ends import (
    ABREAST,
    FIRST,
    HOLE,
    LIMITS,
    REACH,
    STOP,
    Line,
    Part,
    write_ends,
)
from mechanics.legs import CRANK, RAIL, STRUT

TO_WHOLE = 1.5 * 2.0**52
"""What, added to a number and taken away again, leaves the nearest whole one."""


@kernel
def holds(test: int, drive: int, leg: Numbers, d: Vector) -> bool:
    """Return whether a leg passes a test at one span d."""
    if test == REACH:
        if drive == CRANK:
            _, _, S, root = crank_equation(leg, d[0], d[1], d[2])
            return bool(root - abs(S) >= 0.0)
        if drive == RAIL:
            return bool(rail_equation(leg, d[0], d[1], d[2])[1] >= 0.0)
        return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > 0.0
    q = rail_coordinate(leg, d[0], d[1], d[2]) if drive == RAIL else strut_length(d[0], d[1], d[2])
    return bool(q - leg.lower_limit >= 0.0 and leg.upper_limit - q >= 0.0)


@kernel
def cut(
    part: Part,
    line: Line,
    positions: Floats,
    rotations: Floats,
    least: Floats,
    most: Floats,
    cuts: Floats,
) -> bool:
    """Write which nodes of each line pass, shape (4, lines); return whether any may fail.

    Rows as `FIRST`.. say; NaN: only the nodes themselves can tell. `least` and `most`, shape
    (lines,), bound the nodes that are still inside, and are drawn closer; lines without any are
    passed over. There are a multiple of `ABREAST` lines.
    """
    spans, ends = np.empty((6, ABREAST)), np.empty((4, ABREAST))
    nodes = np.empty((4, ABREAST))
    asked = False
    for begin in range(0, least.size, ABREAST):
        alive = 0
        for i in range(ABREAST):
            alive += 1 if least[begin + i] < most[begin + i] else 0
        if alive == 0:
            continue
        _load(part.leg, line, positions, rotations, begin, spans)
        sides = write_ends(part, line, spans, ends)
        asked = asked or sides > 0
        for side in range(2):
            if sides >> side & 1:
                _settle(part, line, spans, ends, 2 * side, nodes)
            else:
                for i in range(ABREAST):
                    nodes[2 * side, i] = -1.0 if side == 0 else line.nodes
                    nodes[2 * side + 1, i] = line.nodes if side == 0 else -1.0
        for row in range(4):
            for i in range(ABREAST):
                cuts[row, begin + i] = nodes[row, i]
        _draw_closer(nodes, begin, least, most)
    return asked


@inlined
def _draw_closer(nodes: Floats, begin: int, least: Floats, most: Floats) -> None:
    """Bound the nodes inside by those of a test; not where they are not known, NaN."""
    for i in range(ABREAST):
        node = nodes[FIRST, i]
        least[begin + i] = node if node > least[begin + i] else least[begin + i]
    for i in range(ABREAST):
        node = nodes[STOP, i]
        most[begin + i] = node if node < most[begin + i] else most[begin + i]


@inlined
def _load(
    leg: Numbers, line: Line, positions: Floats, rotations: Floats, begin: int, spans: Floats
) -> None:
    """Write d of the lines' origins, t = minimum, to rows 0..2, and rho_j to row 3. [m]"""
    if rotations.shape[1] == 1:
        rho = arm(leg, rotations, 0)
        for i in range(ABREAST):
            p = positions[0, begin + i], positions[1, begin + i], positions[2, begin + i]
            spans[0, i], spans[1, i], spans[2, i] = span(leg, p, rho)
            spans[3, i] = rho[0] if line.j == 0 else rho[1] if line.j == 1 else rho[2]
    else:
        for i in range(ABREAST):
            rho = arm(leg, rotations, begin + i)
            p = positions[0, begin + i], positions[1, begin + i], positions[2, begin + i]
            spans[0, i], spans[1, i], spans[2, i] = span(leg, p, rho)
            spans[3, i] = rho[0] if line.j == 0 else rho[1] if line.j == 1 else rho[2]


@inlined
def _settle(part: Part, line: Line, spans: Floats, ends: Floats, side: int, nodes: Floats) -> None:
    """Write the nodes of the ends in rows side and side + 1: the nearest one decides."""
    j = line.j
    for row in range(side, side + 2):
        for i in range(ABREAST):
            place = ends[row, i]
            # So that NaN stays what it is.
            place = -2.0 if place < -2.0 else place
            place = line.nodes + 1.0 if place > line.nodes + 1.0 else place
            node = (place + TO_WHOLE) - TO_WHOLE
            spans[5, i] = node
            spans[4, i] = line.minimum + node * line.step + spans[3, i] - part.leg.base_point[j]
        # A stretch ends after its last node, a hole begins after the last that passes.
        _decide(part, j, spans, row in (STOP, HOLE), row, nodes)


@inlined
def _decide(part: Part, j: int, spans: Floats, after: bool, row: int, nodes: Floats) -> None:
    """Write the nodes in row 5 of the spans, or the next ones where a leg passes, or does not."""
    test, drive, leg = part
    # Row numbers, not rows: a view of an array counts references.
    x, y, z = 4 if j == 0 else 0, 4 if j == 1 else 1, 4 if j == 2 else 2
    if test == LIMITS and drive == RAIL:
        for i in range(ABREAST):
            passes = holds(LIMITS, RAIL, leg, (spans[x, i], spans[y, i], spans[z, i]))
            nodes[row, i] = spans[5, i] + (1.0 if passes == after else 0.0)
    elif test == LIMITS:
        for i in range(ABREAST):
            passes = holds(LIMITS, STRUT, leg, (spans[x, i], spans[y, i], spans[z, i]))
            nodes[row, i] = spans[5, i] + (1.0 if passes == after else 0.0)
    elif drive == CRANK:
        for i in range(ABREAST):
            passes = holds(REACH, CRANK, leg, (spans[x, i], spans[y, i], spans[z, i]))
            nodes[row, i] = spans[5, i] + (1.0 if passes == after else 0.0)
    elif drive == RAIL:
        for i in range(ABREAST):
            passes = holds(REACH, RAIL, leg, (spans[x, i], spans[y, i], spans[z, i]))
            nodes[row, i] = spans[5, i] + (1.0 if passes == after else 0.0)
    else:
        for i in range(ABREAST):
            nodes[row, i] = spans[5, i]
