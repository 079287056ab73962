"""The largest box of cells that are all inside, exactly; cells are counted, steps play no part.

A box is a rectangle that the planes from a first to a last one have in common. Sets of such
ranges are split again and again, the set with the greatest bound first: no box of a set is longer
than its longest range, nor wider than the largest rectangle of the planes that all ranges share.
"""

import heapq

import numpy as np
from numpy.typing import NDArray

from mechanics.arrays import Booleans, Integers
from mechanics.kernels.compiling import kernel

Depths = NDArray[np.uint16]
Ranges = tuple[int, int, int, int]
"""A set of ranges of planes: those that start at a to b and end at c to d, for (a, b, c, d)."""


@kernel
def depths(inside: Booleans) -> Depths:
    """Return how many cells are inside from each on along the first axis, itself included.

    The shape is that of `inside`, (planes, rows, columns); 65535 planes at most.
    """
    planes, rows, columns = inside.shape
    values = np.zeros((planes, rows, columns), np.uint16)
    for z in range(planes - 1, -1, -1):
        for y in range(rows):
            for x in range(columns):
                if inside[z, y, x]:
                    further = values[z + 1, y, x] if z + 1 < planes else 0
                    values[z, y, x] = further + 1
    return values


@kernel
def widest_below(heights: Integers, starts: Integers, levels: Integers, found: Integers) -> None:
    """Put the largest rectangle that stands on a row into `found`, if larger than that there.

    `heights` has a 0 at its end; `starts` and `levels` are room for a stack of rectangles that
    still grow to the right. `found` is (area, height, first column, last column).
    """
    open_ = 0
    for x in range(heights.size):
        start = x
        while open_ > 0 and levels[open_ - 1] > heights[x]:
            open_ -= 1
            start = starts[open_]
            area = levels[open_] * (x - start)
            if area > found[0]:
                found[:] = (area, levels[open_], start, x - 1)
        if heights[x] > 0 and (open_ == 0 or levels[open_ - 1] < heights[x]):
            starts[open_], levels[open_] = start, heights[x]
            open_ += 1


@kernel
def largest_rectangle(plane: Depths, depth: int, floor: int) -> tuple[int, Integers]:
    """Return area and bounds of the largest rectangle of cells of at least this depth.

    The bounds are first and last row, first and last column. What is not larger than `floor` is
    not looked for: the area is `floor` then, and the bounds mean nothing.
    """
    rows, columns = plane.shape
    heights = np.zeros(columns + 1, np.int64)
    starts, levels = np.empty(columns, np.int64), np.empty(columns, np.int64)
    found = np.array([floor, 0, 0, 0])
    bounds = np.zeros(4, np.int64)
    for y in range(rows):
        total = 0
        for x in range(columns):
            heights[x] = heights[x] + 1 if plane[y, x] >= depth else 0
            total += heights[x]
        if total <= found[0]:
            continue
        before = found[0]
        widest_below(heights, starts, levels, found)
        if found[0] > before:
            bounds[:] = (y + 1 - found[1], y, found[2], found[3])
    return found[0], bounds


@kernel
def halves(ranges: Ranges) -> tuple[Ranges, Ranges]:
    """Return two halves of a set of ranges; those of the first share the same planes as all did."""
    a, b, c, d = ranges
    if b - a >= d - c:
        m = (a + b) // 2
        return (m + 1, b, c, d), (a, m, c, d)
    m = (c + d) // 2
    return (a, b, c, m), (a, b, m + 1, d)


@kernel
def largest_box(values: Depths) -> tuple[int, Integers]:
    """Return how many cells the largest box has and its first and last plane, row and column.

    `values` are the `depths` of the cells; the bounds mean nothing if no cell is inside.
    """
    planes, rows, columns = values.shape
    plane = rows * columns
    best, bounds = 0, np.zeros(6, np.int64)
    queue = [(-planes * plane, plane, (0, planes - 1, 0, planes - 1))]
    while queue and -queue[0][0] > best:
        _, known, ranges = heapq.heappop(queue)
        same, other = halves(ranges)
        length = same[3] - same[0] + 1
        if length * known > best:
            heapq.heappush(queue, (-length * known, known, same))
        a, b, c, d = other
        length, shared = d - a + 1, c - b + 1
        area = plane
        if length > 0 and shared > 0:
            area, rectangle = largest_rectangle(values[b], shared, best // length)
            if shared * area > best:
                best = shared * area
                bounds[0], bounds[1], bounds[2:] = b, c, rectangle
        if length * area > best:
            heapq.heappush(queue, (-length * area, area, other))
    return best, bounds
