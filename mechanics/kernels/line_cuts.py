"""Which nodes of whole lines pass a test: the ends in closed form, settled by the nodes beside.

A node so near to an end that rounding might reach it decides for itself, by the very formulas
that a block of poses goes through.
"""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import (
    Numbers,
    Vector,
    arm,
    crank_equation,
    rail_equation,
    span,
)
from mechanics.kernels.line_ends import (
    ABREAST,
    FIRST,
    HOLE,
    HOLE_STOP,
    REACH,
    SECOND,
    STOP,
    Line,
    Part,
    aslant,
    write_ends,
)
from mechanics.kernels.line_places import Places
from mechanics.kernels.line_stops import stop_ends
from mechanics.kernels.line_torus import torus_ends
from mechanics.kernels.stops import within_stops
from mechanics.legs import CRANK, RAIL

TO_WHOLE = 1.5 * 2.0**52
"""What, added to a number and taken away again, leaves the nearest whole one."""
SEVERAL = -1
"""What stands for the code of a line whose nodes have several, or are still to be asked."""


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
    return within_stops(drive, leg, d)


class Scratch(NamedTuple):
    """What is known of `ABREAST` lines while one test after another is asked.

    Parameters
    ----------
    spans : d of a leg at the lines' origins and rho_j, shape (4, lines). [m]
    ends : where a test begins to hold and so on, shape (8, lines). [steps]
    bounds : between which nodes a line is still inside, shape (2, lines).
    whole : the code that all nodes of a line have, shape (lines,): 0 as long as all pass,
        `SEVERAL` once they do not all have the same.
    reached : the ends of the reach of cranks, shape (legs, 4, lines), if any has stops. [steps]
    events : where a crank is at a stop, shape (4, lines). [steps]
    """

    spans: Floats
    ends: Floats
    bounds: Floats
    whole: Integers
    reached: Floats
    events: Floats


@inlined
def room_for_scratch(legs: int) -> Scratch:
    """Return the room for what is known of lines."""
    return Scratch(
        np.empty((4, ABREAST)),
        np.empty((8, ABREAST)),
        np.empty((2, ABREAST)),
        np.empty(ABREAST, np.int64),
        np.empty((legs, 4, ABREAST)),
        np.empty((4, ABREAST)),
    )


@inlined
def cut(part: Part, line: Line, places: Places, scratch: Scratch, cuts: Floats, count: int) -> int:
    """Write which nodes of each line pass to `cuts[count]`; return how many there are now.

    Rows as `FIRST`.. say; NaN: only the nodes themselves can tell. A test that all nodes pass is
    not kept, one that leaves two holes is kept twice.
    """
    spans, ends, bounds, whole = scratch.spans, scratch.ends, scratch.bounds, scratch.whole
    _load(part.leg, line, places, spans)
    sides = _find_ends(part, line, scratch)
    for first in range(0, 2 * SECOND, SECOND):
        if sides & 3 == 0:
            sides >>= 2
            continue
        for side in range(2):
            if sides >> side & 1:
                _settle(part, line, spans, ends, first, 2 * side, cuts, count)
            else:
                for i in range(ABREAST):
                    cuts[count, 2 * side, i] = -1.0 if side == 0 else line.nodes
                    cuts[count, 2 * side + 1, i] = line.nodes if side == 0 else -1.0
        for i in range(ABREAST):
            # Not where they are not known, NaN.
            begins, stops = cuts[count, FIRST, i], cuts[count, STOP, i]
            bounds[0, i] = begins if begins > bounds[0, i] else bounds[0, i]
            bounds[1, i] = stops if stops < bounds[1, i] else bounds[1, i]
            hole, hole_ends = cuts[count, HOLE, i], cuts[count, HOLE_STOP, i]
            known = begins == begins and hole == hole
            none = known and (begins >= line.nodes or stops <= 0.0)
            all_through = begins <= 0.0 and stops >= line.nodes
            every = known and all_through and (hole >= line.nodes or hole_ends <= 0.0)
            code = part.code if none else 0 if every else SEVERAL
            whole[i] = code if whole[i] == 0 else whole[i]
        count += 1
        sides >>= 2
    return count


@inlined
def _find_ends(part: Part, line: Line, scratch: Scratch) -> int:
    """Write where the verdict on lines changes; return 1 + 2: stretch and hole, 8: a second one."""
    spans, ends, bounds, _, reached, events = scratch
    crank = part.drive == CRANK
    if crank and part.test != REACH:
        known = reached[part.own]
        return stop_ends(part.leg, line, spans, known, bounds, events, ends)
    if crank and aslant(part.leg, line.j):
        sides = torus_ends(part.leg, line, spans, ends)
    else:
        sides = write_ends(part, line, spans, ends)
    if crank and reached.shape[0] > 0:
        for row in range(4):
            for i in range(ABREAST):
                reached[part.own, row, i] = ends[row, i]
    return sides


@inlined
def _load(leg: Numbers, line: Line, places: Places, spans: Floats) -> None:
    """Write d of the lines' origins, t = minimum, to rows 0..2, and rho_j to row 3. [m]"""
    positions, rotations = places.positions, places.rotations
    if rotations.shape[1] == 1:
        rho = arm(leg, rotations, 0)
        for i in range(ABREAST):
            p = positions[0, i], positions[1, i], positions[2, i]
            spans[0, i], spans[1, i], spans[2, i] = span(leg, p, rho)
            spans[3, i] = rho[0] if line.j == 0 else rho[1] if line.j == 1 else rho[2]
    else:
        for i in range(ABREAST):
            rho = arm(leg, rotations, i)
            p = positions[0, i], positions[1, i], positions[2, i]
            spans[0, i], spans[1, i], spans[2, i] = span(leg, p, rho)
            spans[3, i] = rho[0] if line.j == 0 else rho[1] if line.j == 1 else rho[2]


@inlined
def _settle(
    part: Part,
    line: Line,
    spans: Floats,
    ends: Floats,
    first: int,
    side: int,
    cuts: Floats,
    count: int,
) -> None:
    """Write the first nodes beyond the ends in rows side and side + 1, counted from `first` on."""
    for row in range(side, side + 2):
        close = 0
        for i in range(ABREAST):
            place = ends[first + row, i]
            # So that NaN stays what it is, and between nodes, where none is close.
            place = -1.5 if place < -1.5 else place
            place = line.nodes + 0.5 if place > line.nodes + 0.5 else place
            node = (place + TO_WHOLE) - TO_WHOLE
            cuts[count, row, i] = node + (1.0 if place > node else 0.0)
            close += 1 if abs(place - node) < line.near else 0
        if close > 0:
            _ask(part, line, spans, ends[first + row], row, cuts[count, row])


@kernel
def _ask(part: Part, line: Line, spans: Floats, places: Floats, row: int, nodes: Floats) -> None:
    """Let the nodes that are close to an end decide for themselves."""
    j = line.j
    for i in range(ABREAST):
        node = (places[i] + TO_WHOLE) - TO_WHOLE
        if not abs(places[i] - node) < line.near:
            continue
        t = line.minimum + node * line.step + spans[3, i] - part.leg.base_point[j]
        d = (
            t if j == 0 else spans[0, i],
            t if j == 1 else spans[1, i],
            t if j == 2 else spans[2, i],
        )
        # A stretch ends after its last node, a hole begins after the last that passes.
        after = row in (STOP, HOLE)
        passes = holds(part.test, part.drive, part.leg, d)
        nodes[i] = node + (1.0 if passes == after else 0.0)
