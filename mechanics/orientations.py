"""Workspaces over many orientations: where conditions hold at some of them, or at every one."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from mechanics.arrays import Booleans, Bytes, Floats
from mechanics.conditions.condition import Condition
from mechanics.grid import Grid
from mechanics.kernels.orientations import at_every, at_some
from mechanics.mechanism import Mechanism
from mechanics.workspace import INSIDE, Scan, line_runs, provable, scan

UNSEEN = 255
"""The code of a node before its first orientation: none is as high."""


def scan_orientations(
    mechanism: Mechanism,
    conditions: Sequence[Condition],
    grid: Grid,
    orientations: Grid,
    start: int,
    stop: int,
    *,
    every: bool,
    extent: float | None,
) -> Scan:
    """Return which flat nodes `start` to `stop` belong at some, or at every, orientation.

    A node's code is 0 if all conditions hold together at some orientation, or at every one; else
    that of the first condition at which no orientation is left, or which any breaks, with the
    first of its parts that does.

    Parameters
    ----------
    grid : positions; what its `fixed` says of turns does not matter.
    orientations : a grid over turns of the platform, whose `fixed` is that of `grid`.
    every : at every orientation, not at some.
    extent : size of the range that the orientations stand for; the field `free_orientation` is
        the share of it at which the conditions hold. None: the field is not kept.
        [rad to the number of turns]
    """
    codes = np.full(stop - start, INSIDE if every else UNSEEN, np.uint8)
    held = np.zeros(stop - start, np.int64)
    ranks = _ranks(conditions)
    dear = 1 + sum(len(c.legs) for c in conditions[: provable(mechanism, conditions, grid)])
    for o in range(orientations.size):
        turned = replace(grid, fixed=orientations.poses(o, o + 1)[:, 0])
        among = None if extent is not None else _open(codes, dear, every)
        found = scan(mechanism, conditions, turned, {}, start, stop, among=among)
        if every:
            at_every(found.codes, found.lengths, codes, held)
        else:
            at_some(found.codes, found.lengths, ranks, codes, held)
    values, lengths = line_runs(codes, start, grid.shape[-1])
    if extent is None:
        return Scan(values, lengths, {})
    share = held[codes == INSIDE] * (extent / orientations.size)
    return Scan(values, lengths, {"free_orientation": share})


def _open(codes: Bytes, dear: int, every: bool) -> Booleans:
    """Return for which nodes the conditions from code `dear` on can still change anything."""
    if every:
        undecided: Booleans = (codes == INSIDE) | (codes >= dear)
        return undecided
    missing: Booleans = codes != INSIDE
    return missing


def _ranks(conditions: Sequence[Condition]) -> Floats:
    """Return how far each code's node came, shape (256,): how many conditions held."""
    ranks = np.full(256, -1.0)
    code = 1
    for number, condition in enumerate(conditions):
        ranks[code : code + len(condition.legs)] = number
        code += len(condition.legs)
    ranks[INSIDE] = len(conditions)
    return ranks
