"""Whole lines of a grid, cut into runs by the tests that have closed forms along them.

Between two ends that `line_ends` knows the verdict is the same at all nodes; the first test that
fails gives a run its code. Where rounding could blur an end, every node decides for itself.
"""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import arm, numbers, span
from mechanics.kernels.line_cuts import cut, holds
from mechanics.kernels.line_ends import FIRST, HOLE, HOLE_STOP, STOP, Line, Part
from mechanics.kernels.line_places import TOGETHER, Places, place_lines, room_for_places
from mechanics.legs import Legs


class Tests(NamedTuple):
    """What nodes are held against, in order: a test of a leg, and the code of who fails."""

    test: Integers
    leg: Integers
    code: Integers


class Runs(NamedTuple):
    """Runs by their first nodes and codes; there is room for more."""

    starts: Integers
    codes: Bytes


@kernel
def walk(
    tests: Tests,
    legs: Legs,
    motion: tuple[Floats, int, Floats],
    grid: tuple[Floats, Floats, Integers, Integers, Floats],
    start: int,
    stop: int,
) -> tuple[Bytes, Integers]:
    """Return codes and lengths of the runs of the flat nodes start..stop.

    A node's code is that of the first test that fails there, or 0. The last axis must be a
    translation; `grid` is what `grid_poses` takes.
    """
    minima, steps, shape, columns, _ = grid
    line = Line(columns[-1], shape[-1], minima[-1], steps[-1])
    count = (stop - 1) // line.nodes - start // line.nodes + 1
    runs = _room(4 * count + line.nodes)
    places = room_for_places(motion, grid)
    cuts, asked = np.empty((tests.test.size, 4, TOGETHER)), np.empty(tests.test.size, np.int64)
    written = 0
    for begin in range(start // line.nodes, start // line.nodes + count, TOGETHER):
        lines = min(TOGETHER, start // line.nodes + count - begin)
        place_lines(motion, grid, begin, places)
        used = _cut_all(tests, legs, line, places, lines, cuts, asked)
        done = 0
        while done < lines:
            done, written = _write_runs(
                tests,
                legs,
                line,
                places,
                cuts,
                asked[:used],
                (begin, done, lines, start, stop),
                runs,
                written,
            )
            if done < lines:
                runs = _larger(runs, written)
    lengths = np.empty(written, np.int64)
    for run in range(written - 1):
        lengths[run] = runs.starts[run + 1] - runs.starts[run]
    if written > 0:
        lengths[written - 1] = stop - runs.starts[written - 1]
    return runs.codes[:written].copy(), lengths


@inlined
def _room(size: int) -> Runs:
    return Runs(np.empty(size, np.int64), np.empty(size, np.uint8))


@kernel
def _larger(runs: Runs, written: int) -> Runs:
    """Return the runs written so far with as much room again."""
    larger = _room(2 * runs.codes.size)
    larger.starts[:written] = runs.starts[:written]
    larger.codes[:written] = runs.codes[:written]
    return larger


@inlined
def _cut_all(
    tests: Tests,
    legs: Legs,
    line: Line,
    places: Places,
    lines: int,
    cuts: Floats,
    asked: Integers,
) -> int:
    """Write the cuts of the tests that some line may fail, and which these are; return how many."""
    least, most = np.empty(TOGETHER), np.empty(TOGETHER)
    for c in range(TOGETHER):
        least[c], most[c] = 0.0, line.nodes if c < lines else 0.0
    count = 0
    for p in range(tests.test.size):
        k = tests.leg[p]
        part = Part(tests.test[p], legs.drive[k], numbers(legs, k))
        if cut(part, line, places.positions, places.rotations, least, most, cuts[count]):
            asked[count] = p
            count += 1
    return count


@kernel
def _write_runs(  # noqa: C901, PLR0915  (arrays handed on are counted, stretch by stretch)
    tests: Tests,
    legs: Legs,
    line: Line,
    places: Places,
    cuts: Floats,
    asked: Integers,
    bounds: tuple[int, int, int, int, int],
    runs: Runs,
    written: int,
) -> tuple[int, int]:
    """Write the runs of lines; return up to which line there was room, and how many runs.

    Of each line a stack of stretches is kept, the leftmost on top: where it begins, its code if
    it is decided, and the next test that it is held against.
    """
    begin, done, lines, start, stop = bounds
    starts, codes = runs
    nodes = line.nodes
    ats, marks = np.empty(nodes + 2), np.empty(nodes + 2, np.uint8)
    dues = np.empty(nodes + 2, np.int64)
    size = asked.size
    failed = np.empty(size, np.uint8)
    for p in range(size):
        failed[p] = tests.code[asked[p]]
    for c in range(done, lines):
        if written + nodes > codes.size:
            return c, written
        first = (begin + c) * nodes
        ats[0] = min(nodes, stop - first)
        ats[1], marks[1], dues[1] = max(0, start - first), 0, 0
        top, former = 1, -1
        while top > 0:
            a, b, mark, p = ats[top], ats[top - 1], marks[top], dues[top]
            top -= 1
            while p < size and a < b:
                begins, ends = cuts[p, FIRST, c], cuts[p, STOP, c]
                hole, hole_ends = cuts[p, HOLE, c], cuts[p, HOLE_STOP, c]
                code = failed[p]
                p += 1
                if np.isnan(begins) or np.isnan(hole):
                    k = asked[p - 1]
                    top = _by_nodes(
                        tests.test[k],
                        tests.leg[k],
                        legs,
                        line,
                        places,
                        c,
                        (int(a), int(b)),
                        (code, p, size, top),
                        (ats, marks, dues),
                    )
                    b = a
                    break
                if ends < b:
                    b = max(a, ends)
                    top += 1
                    ats[top], marks[top], dues[top] = b, code, size
                if a < begins:
                    if code != former:
                        starts[written], codes[written] = first + int(a), code
                        written += 1
                        former = code
                    a = begins
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
    return lines, written


@kernel
def _by_nodes(
    test: int,
    k: int,
    legs: Legs,
    line: Line,
    places: Places,
    c: int,
    stretch: tuple[int, int],
    coded: tuple[int, int, int, int],
    stack: tuple[Floats, Bytes, Integers],
) -> int:
    """Stack the stretches that the nodes of one decide, one by one; return the stack's top."""
    code, due, size, top = coded
    ats, marks, dues = stack
    leg = numbers(legs, k)
    rho = arm(leg, places.rotations, c if places.rotations.shape[1] > 1 else 0)
    p = places.positions[0, c], places.positions[1, c], places.positions[2, c]
    former = -1
    for node in range(stretch[1] - 1, stretch[0] - 1, -1):
        t = line.minimum + node * line.step
        at = (
            t if line.j == 0 else p[0],
            t if line.j == 1 else p[1],
            t if line.j == 2 else p[2],
        )
        mark = 0 if holds(test, legs.drive[k], leg, span(leg, at, rho)) else code
        if mark != former:
            top += 1
            marks[top], dues[top] = mark, due if mark == 0 else size
            former = mark
        ats[top] = node
    return top
