"""Regions made from masks: what is inside is given node by node."""

import numpy as np
import numpy.typing as npt

from mechanics.grid import Axis, Grid
from mechanics.regions import Region

Mask = npt.NDArray[np.bool_]
ORIGIN = -1.0


def region_of(
    inside: Mask, steps: tuple[float, ...], names: tuple[str, ...] = ("x", "y", "z")
) -> Region:
    """Return the region of a mask; runs end with the grid's lines, and in the middle of them."""
    axes = tuple(
        Axis(name, ORIGIN, ORIGIN + step * (count - 1), step)
        for name, step, count in zip(names, steps, inside.shape, strict=False)
    )
    codes = np.where(inside, 0, 3).astype(np.uint8).ravel()
    nodes = np.arange(codes.size)
    line = inside.shape[-1]
    ends = (nodes % line == 0) | (nodes % line == line // 2) | (np.diff(codes, prepend=9) != 0)
    bounds = np.append(nodes[ends], codes.size)
    grid = Grid(axes, tuple(range(inside.ndim)), np.zeros(3))
    return Region(grid, codes[bounds[:-1]], np.diff(bounds))


def dense(region: Region) -> npt.NDArray[np.uint8]:
    """Return the code of every node, in the grid's shape."""
    return np.repeat(region.codes, region.lengths).reshape(region.grid.shape)
