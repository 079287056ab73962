"""Octrees: nodes of a grid told box by box, so that the cost follows a surface and not its box."""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.grid import Grid
from mechanics.kernels.codes import UNSEEN
from mechanics.kernels.octree import Boxes, centres, ends, fill, halved, holding, moved
from mechanics.motions import Motion

WIDENED = 1.0 + 2.0**-48
"""What a sum of a few squares, and its root, may have lost to rounding is less than this."""


FORESEEN = 512
"""So many boxes are judged to see what all will take."""


class Work(NamedTuple):
    """How many boxes are judged, and of how many nodes each is asked by itself."""

    judged: float
    asked: float


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


class Window(NamedTuple):
    """A box of a grid's nodes: the indices of its first, and how many it has along each axis."""

    first: Integers
    shape: tuple[int, ...]

    def of(self, grid: Grid, nodes: Integers) -> Integers:
        """Return which flat nodes of the grid the window's flat nodes are."""
        own, whole = np.array(self.shape), np.array(grid.shape)
        flat: Integers = moved(nodes, own, self.first, whole)
        return flat


def window_about(grid: Grid, nodes: Integers) -> tuple[Window, Integers]:
    """Return the smallest window that has these flat nodes, at least one, and which they are there.

    Shape (nodes,), counted in the window.
    """
    shape = np.array(grid.shape)
    first, last = ends(nodes, shape)
    window = Window(first, tuple((last - first + 1).tolist()))
    return window, moved(nodes, shape, -first, np.array(window.shape))


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
    window: Window | None = None,
    among: Booleans | None = None,
    fewest: int = 4,
) -> Bytes:
    """Return the codes of flat nodes `start` to `stop`, shape (stop - start,), as `ask` has them.

    Boxes of nodes are judged, those that are not told halved along their axes, until they are told
    or have few nodes, which are asked one by one, in ascending order and all in one call.

    Parameters
    ----------
    motion : whose coordinates the grid's axes drive.
    window : if given, all that is said of flat nodes here is said of this part of the grid.
    judge : must tell nothing but what `ask` would say of every node of a box.
    among : shape (stop - start,): if given, the codes of other nodes mean nothing.
    fewest : boxes of no more nodes are not judged.
    """
    codes = np.full(stop - start, UNSEEN, np.uint8)
    if grid.axes:
        window = window or _whole(grid)
        boxes, shape = boxes_of(window.shape, start, stop), np.array(window.shape)
        for some, own in _levels(motion, grid, window, boxes, judge, fewest, start, among):
            fill(some, own, shape, start, codes)
    open_ = codes == UNSEEN
    if among is not None:
        open_ &= among
    nodes = np.flatnonzero(open_)
    if nodes.size:
        codes[nodes] = ask(start + nodes)
    return codes


def foresee(motion: Motion, grid: Grid, judge: Judge, fewest: int) -> Work:
    """Return what `decide` will take for all nodes of a grid, from the larger boxes alone.

    What is not told of them is the share near a surface, which narrows as boxes do, and the share
    that no box tells.
    """
    if not grid.axes:
        return Work(0.0, float(grid.size))
    judged, mean, shares, boxes = 0.0, 1.0, [1.0], boxes_of(grid.shape, 0, grid.size)
    for some, own in _levels(motion, grid, _whole(grid), boxes, judge, fewest):
        sizes = np.prod(some.last - some.first + 1, axis=0)[own == UNSEEN]
        judged += own.size
        shares.append(float(sizes.sum()) / grid.size)
        mean = float(sizes.mean()) if sizes.size else 1.0
        if own.size >= FORESEEN:
            break
    never = max(0.0, 2.0 * shares[-1] - shares[-2])
    beside = shares[-1] - never
    axes = sum(count > 1 for count in grid.shape)
    while mean > fewest:
        side = mean ** (1.0 / axes)
        mean /= 2.0**axes
        judged += (never + beside) * grid.size / max(1.0, mean)
        # A box of n nodes a side is only n - 1 steps wide.
        beside *= max(0.0, (0.5 * side - 1.0) / (side - 1.0))
    return Work(judged, (never + beside) * grid.size)


def _levels(
    motion: Motion,
    grid: Grid,
    window: Window,
    boxes: Boxes,
    judge: Judge,
    fewest: int,
    start: int = 0,
    among: Booleans | None = None,
) -> Iterator[tuple[Boxes, Bytes]]:
    """Yield a window's boxes and what is judged of them, then the halves of those not told."""
    minima, steps, _, columns, fixed = grid.kernel
    origin, shape = window.first[:, None], np.array(window.shape)
    kinds = (_speeds(motion, grid)[0] > 0.0).astype(np.int64)
    while boxes.first.shape[1]:
        placed = Boxes(boxes.first + origin, boxes.last + origin)
        poses, halves = centres(placed, minima, steps, columns, fixed)
        own = judge(poses, reach_of(motion, grid, halves))
        yield boxes, own
        boxes = halved(boxes, own, halves, kinds, fewest)
        if among is not None:
            kept = holding(boxes, shape, start, among)
            boxes = Boxes(*(np.ascontiguousarray(part[:, kept]) for part in boxes))


def _whole(grid: Grid) -> Window:
    return Window(np.zeros(len(grid.axes), np.int64), grid.shape)


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
