"""Whole lines of a grid, cut into runs by the tests that have closed forms along them.

Between two ends that `line_ends` knows the verdict is the same at all nodes; the first test that
fails gives a run its code. Where rounding could blur an end, every node decides for itself.
"""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import arm, numbers, span
from mechanics.kernels.line_blocks import out_of_reach
from mechanics.kernels.line_cuts import Scratch, cut, holds, room_for_scratch
from mechanics.kernels.line_ends import ABREAST, FIRST, HOLE, HOLE_STOP, LIMITS, STOP, Line, Part
from mechanics.kernels.line_places import Places, place_lines, room_for_places
from mechanics.legs import CRANK, Legs


class Tests(NamedTuple):
    """What nodes are held against, in order: a test of a leg, and the code of who fails."""

    test: Integers
    leg: Integers
    code: Integers


class Runs(NamedTuple):
    """Runs by their first nodes and codes."""

    starts: Integers
    codes: Bytes


class Stack(NamedTuple):
    """The stretches of a line still to be told, the leftmost on top.

    Parameters
    ----------
    ats : where each begins; at the bottom, where the line ends.
    marks : the code of each if it is decided.
    dues : the next test that each is held against.
    """

    ats: Floats
    marks: Bytes
    dues: Integers


@kernel
def walk(
    tests: Tests,
    legs: Legs,
    motion: tuple[Floats, int, Floats],
    grid: tuple[Floats, Floats, Integers, Integers, Floats],
    near: float,
    start: int,
    stop: int,
) -> tuple[Bytes, Integers, int]:
    """Return codes and lengths of the runs of flat nodes from `start`, and the first not told.

    That is `stop` unless lines have many runs. A node's code is that of the first test that fails
    there, or 0. The last axis must be a translation; `grid` is what `grid_poses` takes. Nodes
    within `near` of a root decide for themselves. [m]
    """
    minima, steps, shape, columns, _ = grid
    nodes = shape[-1]
    line = Line(columns[-1], nodes, minima[-1], steps[-1], near / steps[-1])
    origin = start // nodes
    behind = (stop - 1) // nodes + 1 if start < stop else origin
    room = min(4 * (behind - origin) + ABREAST * nodes, stop - start)
    runs = Runs(np.empty(room, np.int64), np.empty(room, np.uint8))
    places = room_for_places(motion, grid)
    # Numbers alone: an array handed on is counted, block by block.
    parts = _parts(tests, legs)
    scratch = room_for_scratch(_limited_cranks(tests, legs))
    # What a test leaves of a line may be cut twice.
    most = 2 * len(parts)
    cuts, asked = np.empty((most, 4, ABREAST)), np.empty(most, np.int64)
    stack = Stack(np.empty(nodes + 2), np.empty(nodes + 2, np.uint8), np.empty(nodes + 2, np.int64))
    written, told = 0, start
    for begin in range(origin, behind, ABREAST):
        lines = min(ABREAST, behind - begin)
        end = min((begin + lines) * nodes, stop)
        if written + end - told > room:
            break
        within, used = begin * nodes >= start and (begin + lines) * nodes <= stop, 0
        if within and _none_in_reach(parts, line, motion, grid, places, begin, lines):
            scratch.whole[:] = parts[0].code
        else:
            place_lines(motion, grid, begin, places)
            used = _cut_all(parts, line, places, lines, scratch, cuts, asked)
        if within and _all_whole(scratch.whole, lines):
            written = _write_whole(begin, nodes, lines, scratch.whole, runs, written)
        else:
            at = begin, lines, start, stop
            written = _write_runs(
                parts, line, places, scratch.whole, cuts, asked, used, at, stack, runs, written
            )
        told = end
    return runs.codes[:written].copy(), _lengths(runs.starts, written, told), told


@inlined
def _parts(tests: Tests, legs: Legs) -> list[Part]:
    """Return the tests with the numbers of their legs."""
    parts = []
    for p in range(tests.test.size):
        k = tests.leg[p]
        parts.append(Part(tests.test[p], legs.drive[k], numbers(legs, k), tests.code[p], k))
    return parts


@inlined
def _limited_cranks(tests: Tests, legs: Legs) -> int:
    """Return of how many legs the reach is to be kept: none, if no crank has stops."""
    limited = 0
    for p in range(tests.test.size):
        if tests.test[p] == LIMITS and legs.drive[tests.leg[p]] == CRANK:
            limited = legs.drive.size
    return limited


@inlined
def _none_in_reach(
    parts: list[Part],
    line: Line,
    motion: tuple[Floats, int, Floats],
    grid: tuple[Floats, Floats, Integers, Integers, Floats],
    places: Places,
    begin: int,
    lines: int,
) -> bool:
    """Return whether no node of a block of lines is seen, without a look at any, to pass."""
    if len(parts) == 0 or places.rotations.shape[1] > 1:
        return False
    return out_of_reach(parts[0], line, motion, grid, places.rotations, (begin, begin + lines))


@inlined
def _cut_all(
    parts: list[Part],
    line: Line,
    places: Places,
    lines: int,
    scratch: Scratch,
    cuts: Floats,
    asked: Integers,
) -> int:
    """Write the cuts of the tests that some line may fail, and which these are; return how many."""
    bounds = scratch.bounds
    for i in range(ABREAST):
        bounds[0, i], bounds[1, i] = 0.0, line.nodes if i < lines else 0.0
    scratch.whole[:] = 0
    count = 0
    for p in range(len(parts)):
        alive = 0
        for i in range(ABREAST):
            alive += 1 if bounds[0, i] < bounds[1, i] else 0
        if alive == 0:
            break
        known = count
        count = cut(parts[p], line, places, scratch, cuts, count)
        for q in range(known, count):
            asked[q] = p
    return count


@inlined
def _lengths(starts: Integers, written: int, told: int) -> Integers:
    """Return how many nodes each run has, the last of which ends before node `told`."""
    lengths = np.empty(written, np.int64)
    for run in range(written - 1):
        lengths[run] = starts[run + 1] - starts[run]
    if written > 0:
        lengths[written - 1] = told - starts[written - 1]
    return lengths


@inlined
def _all_whole(whole: Integers, lines: int) -> bool:
    """Return whether all nodes of each line have one code."""
    several = 0
    for i in range(lines):
        several += 1 if whole[i] < 0 else 0
    return several == 0


@inlined
def _write_whole(
    begin: int, nodes: int, lines: int, whole: Integers, runs: Runs, written: int
) -> int:
    """Write one run a line; return how many runs there are."""
    starts, codes = runs
    for i in range(lines):
        starts[written + i] = (begin + i) * nodes
        codes[written + i] = whole[i]
    return written + lines


@inlined
def _write_runs(  # noqa: C901, PLR0915  (arrays handed on are counted, stretch by stretch)
    parts: list[Part],
    line: Line,
    places: Places,
    whole: Integers,
    cuts: Floats,
    asked: Integers,
    size: int,
    at: tuple[int, int, int, int],
    stack: Stack,
    runs: Runs,
    written: int,
) -> int:
    """Write the runs of lines; return how many runs there are."""
    begin, lines, start, stop = at
    starts, codes = runs
    ats, marks, dues = stack
    nodes = line.nodes
    for c in range(lines):
        first = (begin + c) * nodes
        if whole[c] >= 0 and first >= start and first + nodes <= stop:
            starts[written], codes[written] = first, whole[c]
            written += 1
            continue
        a, b = float(max(0, start - first)), float(min(nodes, stop - first))
        mark, p, top, former = 0, 0, 0, -1
        ats[0] = b
        while True:
            while p < size and a < b:
                begins, ends = cuts[p, FIRST, c], cuts[p, STOP, c]
                hole, hole_ends = cuts[p, HOLE, c], cuts[p, HOLE_STOP, c]
                part = parts[asked[p]]
                code = part.code
                p += 1
                if np.isnan(begins) or np.isnan(hole):
                    stretch = c, int(a), int(b), p, size
                    top = _by_nodes(part, stretch, line, places, stack, top)
                    b = a
                    break
                if a < begins:
                    if code != former:
                        starts[written], codes[written] = first + int(a), code
                        written += 1
                        former = code
                    a = begins
                    if a >= b:
                        break
                if ends < b:
                    b = max(a, ends)
                    top += 1
                    ats[top], marks[top], dues[top] = b, code, size
                if hole < hole_ends and hole < b and a < hole_ends:
                    if hole_ends < b:
                        top += 1
                        ats[top], marks[top], dues[top] = max(a, hole_ends), 0, p
                    b = max(a, hole)
                    top += 1
                    ats[top], marks[top], dues[top] = b, code, size
            if a < b and mark != former:
                starts[written], codes[written] = first + int(a), mark
                written += 1
                former = mark
            if top == 0:
                break
            a, b, mark, p = ats[top], ats[top - 1], marks[top], dues[top]
            top -= 1
    return written


@kernel
def _by_nodes(
    part: Part,
    stretch: tuple[int, int, int, int, int],
    line: Line,
    places: Places,
    stack: Stack,
    top: int,
) -> int:
    """Stack the stretches that the nodes of one decide, one by one; return the stack's top."""
    test, drive, leg, code, _ = part
    c, begin, end, due, size = stretch
    ats, marks, dues = stack
    rho = arm(leg, places.rotations, c if places.rotations.shape[1] > 1 else 0)
    p = places.positions[0, c], places.positions[1, c], places.positions[2, c]
    former = -1
    for node in range(end - 1, begin - 1, -1):
        t = line.minimum + node * line.step
        at = t if line.j == 0 else p[0], t if line.j == 1 else p[1], t if line.j == 2 else p[2]
        mark = 0 if holds(test, drive, leg, span(leg, at, rho)) else code
        if mark != former:
            top += 1
            marks[top], dues[top] = mark, due if mark == 0 else size
            former = mark
        ats[top] = node
    return top
