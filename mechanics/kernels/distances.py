"""The node that lies farthest from all others of a mask's complement, found exactly.

Squared distances are minima over one axis after the other: along the first by counting nodes,
along the others as the lower envelope of one parabola a node. Whole planes are kept of the first
pass only, as integers; the others run in one plane and are left where they cannot matter.

References
----------
Felzenszwalb, Huttenlocher, 2012, doi:10.4086/toc.2012.v008a019.
"""

import numpy as np
from numpy.typing import NDArray

from mechanics.arrays import Booleans, Floats
from mechanics.kernels.compiling import kernel

Counts = NDArray[np.int32]


@kernel
def counts(inside: Booleans) -> Counts:
    """Return how many nodes along the first axis the nearest outside is away, 0 outside.

    The shape is that of `inside`, (planes, rows, columns); beyond the planes all is outside.
    """
    planes, rows, columns = inside.shape
    values = np.zeros((planes, rows, columns), np.int32)
    for z in range(planes):
        for y in range(rows):
            for x in range(columns):
                if inside[z, y, x]:
                    values[z, y, x] = (values[z - 1, y, x] if z > 0 else 0) + 1
    for z in range(planes - 1, -1, -1):
        for y in range(rows):
            for x in range(columns):
                further = values[z + 1, y, x] if z + 1 < planes else 0
                values[z, y, x] = min(values[z, y, x], further + 1)
    return values


@kernel
def lower_envelope(
    heights: Floats, step: float, sites: Counts, bounds: Floats, values: Floats
) -> None:
    """Write min over j of `heights[j] + (step (i - j))^2` for every i.

    `sites`, shape (nodes,), and `bounds`, shape (nodes + 1,), are room for the parabolas that
    stand in the envelope and for where each begins. [nodes]
    """
    square = step * step
    last = 0
    sites[0], bounds[0] = 0, -np.inf
    for j in range(1, heights.size):
        while True:
            i = sites[last]
            meet = ((heights[j] - heights[i]) / square + (j * j - i * i)) / (2.0 * (j - i))
            if last == 0 or meet > bounds[last]:
                break
            last -= 1
        last += 1
        sites[last], bounds[last] = j, meet
    bounds[last + 1] = np.inf
    last = 0
    for i in range(heights.size):
        while bounds[last + 1] < i:
            last += 1
        values[i] = heights[sites[last]] + square * (i - sites[last]) ** 2


@kernel
def within_rows(distances: Counts, steps: Floats, plane: Floats) -> None:
    """Write the squared distances within a plane's rows, added to those from its own neighbours.

    `distances` and `plane` have shape (rows, columns).
    """
    rows, columns = distances.shape
    sites, bounds = np.empty(columns, np.int32), np.empty(columns + 1)
    heights = np.empty(columns)
    for y in range(rows):
        for x in range(columns):
            heights[x] = (steps[0] * distances[y, x]) ** 2
        lower_envelope(heights, steps[2], sites, bounds, plane[y])


@kernel
def farthest(distances: Counts, steps: Floats) -> tuple[float, int]:
    """Return the greatest squared distance to the outside and a flat node that has it.

    Parameters
    ----------
    distances : what `counts` returned.
    steps : array, shape (3,), between planes, rows and columns. [m or rad]

    Returns
    -------
    float
        0 if no node is inside. [m^2 or rad^2]
    int
        The flat node; always the same one if several are as far.
    """
    planes, rows, columns = distances.shape
    deepest = np.zeros(planes, np.int32)
    for z in range(planes):
        deepest[z] = distances[z].max()
    sites, bounds = np.empty(rows, np.int32), np.empty(rows + 1)
    line, values, plane = np.empty(rows), np.empty(rows), np.empty((rows, columns))
    best, node = 0.0, 0
    for z in np.argsort(-deepest, kind="mergesort"):
        # No node is farther than it is along one axis: what is left cannot matter.
        if (steps[0] * deepest[z]) ** 2 <= best:
            break
        within_rows(distances[z], steps, plane)
        for x in range(columns):
            line[:] = plane[:, x]
            if line.max() > best:
                lower_envelope(line, steps[1], sites, bounds, values)
                if values.max() > best:
                    best, row = values.max(), int(values.argmax())
                    node = (z * rows + row) * columns + x
    return best, node
