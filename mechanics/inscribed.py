"""The largest ball and the largest box inside a region, as far as its nodes can tell.

Between the nodes nothing is known. What neighbouring nodes enclose, a box of one step a side with
a node in each corner, is taken to be inside if all these nodes are; nothing else is, and nothing
beyond the grid. Both shapes lie in the union of such boxes, so that in a region that is convex
they are truly inside, and in any other as far as it is smooth at the scale of a step.
"""

import math
from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.grid import Grid
from mechanics.kernels import boxes, distances
from mechanics.kernels.codes import INSIDE
from mechanics.motions import Motion
from mechanics.regions import Region

AXES = 3
"""Grids of more axes are not offered shapes."""


@dataclass(frozen=True)
class Ball:
    """An interval, a disc or a ball.

    Parameters
    ----------
    centre : array, shape (axes,): a node of the grid. [m or rad]
    radius : above 0. [m or rad]
    """

    centre: Floats
    radius: float

    @property
    def measure(self) -> float:
        """Length, area or volume."""
        unit = (2.0, math.pi, 4.0 / 3.0 * math.pi)[self.centre.size - 1]
        return unit * self.radius**self.centre.size


@dataclass(frozen=True)
class Box:
    """An interval, a rectangle or a cuboid along the axes.

    Parameters
    ----------
    minimum, maximum : arrays, shape (axes,): two opposite corners, nodes of the grid. [m or rad]
    """

    minimum: Floats
    maximum: Floats

    @property
    def measure(self) -> float:
        """Length, area or volume."""
        return float(np.prod(self.maximum - self.minimum))


def offers_box(grid: Grid) -> bool:
    """Return whether the grid has few enough axes."""
    return len(grid.axes) <= AXES


def offers_ball(grid: Grid, motion: Motion) -> bool:
    """Return whether the grid has few enough axes, and all of one unit: else nothing is round."""
    turns = {axis.coordinate in motion.turns for axis in grid.axes}
    return offers_box(grid) and len(turns) == 1


def largest_ball(region: Region, motion: Motion) -> Ball | None:
    """Return the largest ball about a node; None if not offered, or nowhere is room for one.

    With its centre between the nodes a ball could be larger by half a cell's diagonal at most.

    Parameters
    ----------
    region : of a grid of 1 to 3 axes; at most 6 bytes a node are taken for it while it runs.
    motion : says which axes are turns.
    """
    grid = region.grid
    if not offers_ball(grid, motion):
        return None
    # The enclosed boxes about a node are all inside, or else its distance is 0.
    core = _all_corners(_all_corners(_dense(region)))
    if not core.any():
        return None
    deep = np.pad(core, 1)
    missing = AXES - deep.ndim
    shape = (deep.shape[0], *(1,) * missing, *deep.shape[1:])
    steps = np.insert(_steps(grid), 1, np.ones(missing))
    square, node = distances.farthest(distances.counts(deep.reshape(shape)), steps)
    indices = np.array(np.unravel_index(node, deep.shape))
    return Ball(_position(grid, indices), math.sqrt(square))


def largest_box(region: Region) -> Box | None:
    """Return the box of greatest measure; None if not offered, or no box has all corners inside.

    Exact. A line or a plane is looked through once; in space a plane is, for every range of planes
    that the bounds do not rule out: about half the square of their number at worst.

    Parameters
    ----------
    region : of a grid of 1 to 3 axes; at most 4 bytes a node are taken for it while it runs.
    """
    grid = region.grid
    if not offers_box(grid):
        return None
    cells = _all_corners(_dense(region))
    if not cells.any():
        return None
    solid = cells.reshape((1,) * (AXES - cells.ndim) + cells.shape)
    # The fewer the planes, the fewer their ranges.
    order = np.argsort(solid.shape, kind="stable")
    planes = np.ascontiguousarray(np.transpose(solid, order))
    _, bounds = boxes.largest_box(boxes.depths(planes))
    corners = np.empty((AXES, 2), np.int64)
    corners[order] = bounds.reshape(AXES, 2) + np.array([0, 1])
    least, greatest = corners[AXES - cells.ndim :].T
    return Box(_position(grid, least), _position(grid, greatest))


def _dense(region: Region) -> Booleans:
    """Return which nodes are inside, in the grid's shape."""
    inside: Booleans = np.repeat(region.codes == INSIDE, region.lengths)
    return inside.reshape(region.grid.shape)


def _all_corners(inside: Booleans) -> Booleans:
    """Return where neighbouring nodes are all inside; the shape has one less along every axis."""
    for axis in range(inside.ndim):
        along = np.moveaxis(inside, axis, 0)
        inside = np.moveaxis(along[:-1] & along[1:], 0, axis)
    return inside


def _steps(grid: Grid) -> Floats:
    return np.array([axis.step for axis in grid.axes])


def _position(grid: Grid, indices: Integers) -> Floats:
    origin = np.array([axis.minimum for axis in grid.axes])
    position: Floats = origin + indices * _steps(grid)
    return position
