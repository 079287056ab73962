"""Regions of a grid: what is inside, in how many parts, how large and where."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.grid import Grid
from mechanics.kernels import runs as kernels
from mechanics.kernels.codes import INSIDE


@dataclass(frozen=True)
class Component:
    """A connected part of a region; nodes are neighbours when their cells share a face.

    Bounds and centroid have one number per axis of the grid. [m or rad]
    """

    nodes: int
    minimum: Floats
    maximum: Floats
    centroid: Floats


@dataclass(frozen=True)
class Region:
    """The runs of a whole grid.

    Parameters
    ----------
    grid : the grid.
    codes, lengths : arrays, shape (runs,), the reason code and the nodes of each run, in the
        order of the flat nodes; tiles may have cut runs.
    """

    grid: Grid
    codes: Bytes
    lengths: Integers

    def nodes_by_code(self) -> Integers:
        """Return how many nodes have each code, shape (256,)."""
        counts = np.zeros(256, np.int64)
        np.add.at(counts, self.codes, self.lengths)
        return counts

    @cached_property
    def _inside(self) -> tuple[Integers, Integers]:
        codes, lengths = kernels.join(self.codes, self.lengths, self.grid.shape[-1])
        stops = np.cumsum(lengths)
        inside = codes == INSIDE
        return (stops - lengths)[inside], stops[inside]

    @cached_property
    def _shape(self) -> Integers:
        return np.array(self.grid.shape, dtype=np.int64)

    @property
    def nodes(self) -> int:
        """How many nodes are inside."""
        starts, stops = self._inside
        return int(np.sum(stops - starts))

    @property
    def measure(self) -> float:
        """Length, area or volume: every node inside stands for one cell."""
        return self.nodes * self.grid.cell

    @property
    def measure_error(self) -> float:
        """How far off the measure may be, if nothing lies between the nodes unseen.

        A flat boundary cuts as many cells as there are pairs of neighbours on its two sides,
        and each of them is counted wrongly by half a cell at most. So are those at the grid's
        ends, beyond which nothing is known, and which may be meant to end at their nodes. What is
        thinner than a step is not seen, so this bounds the error of smooth regions but proves
        nothing.
        """
        faces = kernels.faces(*self._inside, self._shape) + self._faces_at_ends()
        return 0.5 * faces * self.grid.cell

    def _faces_at_ends(self) -> int:
        """Return how many faces the cells inside have at the grid's own ends."""
        starts, stops = self._inside
        stride = self.grid.shape[-1]
        faces = int(np.sum(starts % stride == 0) + np.sum(stops % stride == 0))
        for count in self.grid.shape[-2::-1]:
            index = starts // stride % count
            ends = (index == 0).astype(np.int64) + (index == count - 1)
            faces += int(np.sum((stops - starts) * ends))
            stride *= count
        return faces

    @cached_property
    def components(self) -> list[Component]:
        """The connected parts, the largest first."""
        starts, stops = self._inside
        numbers = kernels.connect(starts, stops, self._shape)
        count = int(numbers.max()) + 1 if numbers.size else 0
        nodes, least, greatest, sums = kernels.extents(starts, stops, self._shape, numbers, count)
        order = np.argsort(-nodes, kind="stable")
        return [
            Component(
                int(nodes[c]),
                self._position(least[c]),
                self._position(greatest[c]),
                self._position(sums[c] / nodes[c]),
            )
            for c in order
        ]

    def node_nearest(self, position: Floats) -> int | None:
        """Return the flat node inside that is nearest, in steps, to a position; None if empty."""
        starts, stops = self._inside
        if not starts.size:
            return None
        origin = np.array([axis.minimum for axis in self.grid.axes])
        steps = np.array([axis.step for axis in self.grid.axes])
        goal = (position - origin) / steps
        line = self.grid.shape[-1]
        indices = np.array(np.unravel_index(starts, self.grid.shape), dtype=float)
        along = np.clip(goal[-1], starts % line, starts % line + stops - starts - 1).round()
        indices[-1] = along
        nearest = int(np.argmin(np.sum((indices - goal[:, None]) ** 2, axis=0)))
        return int(starts[nearest] - starts[nearest] % line + along[nearest])

    def _position(self, indices: Floats | Integers) -> Floats:
        origin = np.array([axis.minimum for axis in self.grid.axes])
        steps = np.array([axis.step for axis in self.grid.axes])
        position: Floats = origin + indices * steps
        return position
