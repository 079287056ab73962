"""Octrees: nodes of a grid told box by box, so that the cost follows a surface and not its box."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.grid import Grid
from mechanics.kernels.octree import UNSEEN, Boxes, centres, fill, halved, holding
from mechanics.motions import Motion

WIDENED = 1.0 + 2.0**-48
"""What a sum of a few squares, and its root, may have lost to rounding is less than this."""


class Reach(NamedTuple):
    """How far the nodes of each box are from its centre at most, shape (boxes,) each.

    Parameters
    ----------
    positions : of the platform's reference point. [m]
    turns : the angle between the orientations; a platform point at distance b from the reference
        point is at most `positions` + b `turns` from where it is at the centre. [rad]
    """

    positions: Floats
    turns: Floats


Judge = Callable[[Floats, Reach], Bytes]
"""Says of centres, shape (coordinates, boxes), and their reach which code all nodes of each box
have, shape (boxes,): `UNSEEN` where no bound tells."""
Ask = Callable[[Integers], Bytes]
"""Says which codes flat nodes have, each by itself."""


def decide(
    motion: Motion,
    grid: Grid,
    start: int,
    stop: int,
    judge: Judge,
    ask: Ask,
    *,
    among: Booleans | None = None,
    fewest: int = 4,
) -> Bytes:
    """Return the codes of flat nodes `start` to `stop`, shape (stop - start,), as `ask` has them.

    Boxes of nodes are judged, those that are not told halved along their axes, until they are told
    or have few nodes, which are asked one by one, in ascending order and all in one call.

    Parameters
    ----------
    motion : whose coordinates the grid's axes drive.
    judge : must tell nothing but what `ask` would say of every node of a box.
    among : shape (stop - start,): if given, the codes of other nodes mean nothing.
    fewest : boxes of no more nodes are not judged.
    """
    codes = np.full(stop - start, UNSEEN, np.uint8)
    if grid.axes:
        _judge_boxes(motion, grid, start, stop, judge, among, fewest, codes)
    open_ = codes == UNSEEN
    if among is not None:
        open_ &= among
    nodes = np.flatnonzero(open_)
    if nodes.size:
        codes[nodes] = ask(start + nodes)
    return codes


def _judge_boxes(
    motion: Motion,
    grid: Grid,
    start: int,
    stop: int,
    judge: Judge,
    among: Booleans | None,
    fewest: int,
    codes: Bytes,
) -> None:
    """Write the codes of the nodes that judgements of boxes tell."""
    minima, steps, shape, columns, fixed = grid.kernel
    kinds = (_speeds(motion, grid)[0] > 0.0).astype(np.int64)
    boxes = boxes_of(grid.shape, start, stop)
    while boxes.first.shape[1]:
        poses, halves = centres(boxes, minima, steps, columns, fixed)
        own = judge(poses, reach_of(motion, grid, halves))
        fill(boxes, own, shape, start, codes)
        boxes = halved(boxes, own, halves, kinds, fewest)
        if among is not None:
            kept = holding(boxes, shape, start, among)
            boxes = Boxes(*(np.ascontiguousarray(part[:, kept]) for part in boxes))


def _speeds(motion: Motion, grid: Grid) -> Floats:
    """Return how fast each axis of a grid moves and turns the platform, shape (2, axes)."""
    columns = list(grid.columns)
    speeds: Floats = np.sqrt(np.sum(np.square(motion.twists.reshape(2, 3, -1)), axis=1))[:, columns]
    return speeds


def reach_of(motion: Motion, grid: Grid, halves: Floats) -> Reach:
    """Return how far nodes are from centres; the twists of a motion are orthonormal.

    `halves`, shape (axes, boxes), is half the length of each box along each axis. [m or rad]
    """
    moved, turned = _speeds(motion, grid)[:, :, None] * halves
    positions = np.sqrt(np.sum(np.square(moved), axis=0))
    return Reach(positions * WIDENED, np.sum(turned, axis=0) * WIDENED)


def boxes_of(shape: Sequence[int], start: int, stop: int) -> Boxes:
    """Return the at most 2 axes - 1 boxes that flat nodes `start` to `stop` of a grid are."""
    ends = np.array(list(_boxes_of(shape, start, stop)), np.int64).reshape(-1, len(shape), 2)
    return Boxes(*(np.ascontiguousarray(ends[:, :, k].T) for k in range(2)))


def _boxes_of(shape: Sequence[int], start: int, stop: int) -> list[list[tuple[int, int]]]:
    """Return first and last indices along each axis, of each box."""
    if start >= stop:
        return []
    if len(shape) == 1:
        return [[(start, stop - 1)]]
    plane, inner = int(np.prod(shape[1:])), shape[1:]
    first, head = divmod(start, plane)
    last, tail = divmod(stop, plane)
    if first == last:
        return [[(first, first), *box] for box in _boxes_of(inner, head, tail)]
    before = _boxes_of(inner, head, plane) if head else []
    whole = [(first + (head > 0), last - 1), *((0, count - 1) for count in inner)]
    return [
        *([(first, first), *box] for box in before),
        *([whole] if whole[0][0] <= whole[0][1] else []),
        *([(last, last), *box] for box in _boxes_of(inner, 0, tail)),
    ]
