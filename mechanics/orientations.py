"""Workspaces over many orientations: where conditions hold at some of them, or at every one."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from mechanics.arrays import Booleans, Bytes
from mechanics.conditions.condition import Condition
from mechanics.grid import Grid
from mechanics.kernels.orientations import at_every, at_some
from mechanics.mechanism import Mechanism
from mechanics.sweeps import Sweep
from mechanics.turns import Turn
from mechanics.workspace import INSIDE, UNSEEN, Scan, line_runs, provable, ranks_of, scan


@dataclass(frozen=True)
class Orientations:
    """The orientations that a workspace's type runs over.

    Parameters
    ----------
    grid : a grid of turns of the platform, each orientation tried by itself; it may have no axes.
        Its `fixed` is that of the positions' grid.
    turn : one more turn, over all of its angles, together with each orientation of the grid.
    extent : the size of the whole range. [rad to the number of turns]
    """

    grid: Grid
    turn: Turn | None
    extent: float

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The turns that the range is of."""
        last = () if self.turn is None else (self.turn.coordinate,)
        return (*(axis.coordinate for axis in self.grid.axes), *last)


def scan_orientations(
    mechanism: Mechanism,
    conditions: Sequence[Condition],
    grid: Grid,
    orientations: Orientations,
    start: int,
    stop: int,
    *,
    every: bool,
    measured: bool,
) -> Scan:
    """Return which flat nodes `start` to `stop` belong at some, or at every, orientation.

    A node's code is 0 if all conditions hold together at some orientation, or at every one; else
    that of the first condition at which no orientation is left, or which any breaks, with the
    first of its parts that does.

    Parameters
    ----------
    grid : positions; what its `fixed` says of turns does not matter.
    every : at every orientation, not at some.
    measured : whether the field `free_orientation` is kept, the size of the part of the range at
        which the conditions hold. [rad to the number of turns]
    """
    codes = np.full(stop - start, INSIDE if every else UNSEEN, np.uint8)
    held = np.zeros(stop - start)
    ranks = ranks_of(conditions)
    dear = 1 + sum(len(c.legs) for c in conditions[: provable(mechanism, conditions, grid)])
    for o in range(orientations.grid.size):
        turned = replace(grid, fixed=orientations.grid.poses(o, o + 1)[:, 0])
        if orientations.turn is None:
            among = None if measured else _open(codes, dear, every)
            found = scan(mechanism, conditions, turned, {}, start, stop, among=among)
            fresh = np.repeat(found.codes, found.lengths)
            sizes = (fresh == INSIDE).astype(np.float64)
        else:
            fresh = np.full(codes.size, INSIDE if every else UNSEEN, np.uint8)
            sizes = np.zeros(codes.size)
            asked = np.flatnonzero(_undecided(codes, every, measured))
            sweep = Sweep(mechanism, conditions, turned, orientations.turn, every, measured)
            fresh[asked], sizes[asked] = sweep.verdicts(start + asked)
        if every:
            at_every(fresh, sizes, codes, held)
        else:
            at_some(fresh, sizes, ranks, codes, held)
    values, lengths = line_runs(codes, start, grid.shape[-1])
    if not measured:
        return Scan(values, lengths, {})
    share = orientations.extent / orientations.grid.size
    return Scan(values, lengths, {"free_orientation": held[codes == INSIDE] * share})


def _open(codes: Bytes, dear: int, every: bool) -> Booleans:
    """Return for which nodes the conditions from code `dear` on can still change anything."""
    if every:
        undecided: Booleans = (codes == INSIDE) | (codes >= dear)
        return undecided
    missing: Booleans = codes != INSIDE
    return missing


def _undecided(codes: Bytes, every: bool, measured: bool) -> Booleans:
    """Return which nodes another orientation can still change."""
    # The first code cannot become an earlier one.
    settled = codes == 1 if every else (codes == INSIDE) & (not measured)
    open_: Booleans = ~settled
    return open_
