"""Grids of poses: nodes `min + i step` along some coordinates, the others fixed."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.placing import grid_poses

TOLERANCE = 1e-9
"""A last node this many steps past the maximum still counts."""


@dataclass(frozen=True)
class Axis:
    """Nodes `minimum + i step` while they are not above `maximum`. [m or rad]"""

    coordinate: str
    minimum: float
    maximum: float
    step: float

    @property
    def intervals(self) -> float:
        """How many whole steps fit; a float, since a wild request may ask for any number."""
        return math.floor((self.maximum - self.minimum) / self.step + TOLERANCE)

    @property
    def count(self) -> int:
        """How many nodes there are."""
        return int(self.intervals) + 1

    @property
    def nodes(self) -> Floats:
        """The nodes, shape (count,)."""
        return self.minimum + np.arange(self.count, dtype=np.float64) * self.step


@dataclass(frozen=True)
class Grid:
    """Axes, in the order of the arrays, over the coordinates of a motion.

    Parameters
    ----------
    axes : nodes are counted with the last one fastest; a grid of no axes is one pose.
    columns : for each axis, the index of its coordinate in a pose.
    fixed : array, shape (coordinates,): the value of every coordinate that no axis drives.
    """

    axes: tuple[Axis, ...]
    columns: tuple[int, ...]
    fixed: Floats

    @property
    def shape(self) -> tuple[int, ...]:
        """How many nodes each axis has."""
        return tuple(axis.count for axis in self.axes)

    @property
    def size(self) -> int:
        """How many nodes there are in all."""
        return math.prod(self.shape)

    @property
    def cell(self) -> float:
        """The measure of one node's cell, the product of the steps."""
        return math.prod(axis.step for axis in self.axes)

    @cached_property
    def kernel(self) -> tuple[Floats, Floats, Integers, Integers, Floats]:
        """What kernels take of a grid: minima, steps, shape, columns and fixed coordinates."""
        return (
            np.array([axis.minimum for axis in self.axes]),
            np.array([axis.step for axis in self.axes]),
            np.array(self.shape, dtype=np.int64),
            np.array(self.columns, dtype=np.int64),
            self.fixed,
        )

    def poses(self, start: int, stop: int) -> Floats:
        """Return the poses, shape (coordinates, stop - start), of a range of flat nodes."""
        return self.poses_at(np.arange(start, stop))

    def poses_at(self, nodes: Integers) -> Floats:
        """Return the poses, shape (coordinates, nodes), of flat nodes."""
        poses: Floats = grid_poses(nodes, *self.kernel)
        return poses
