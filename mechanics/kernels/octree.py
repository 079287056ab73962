"""Boxes of grid nodes: their centres, their halves, and codes that all nodes of one share.

A box has first and last indices along every axis, shape (axes, boxes) each; a node at indices i is
`minima + i steps`, and flat nodes are counted with the last axis fastest.
"""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.kernels.codes import UNSEEN
from mechanics.kernels.compiling import inlined, kernel

ROUNDING = 8.0 * 2.0**-52
"""How far a node or a centre may be off, as a share of its terms."""


class Boxes(NamedTuple):
    """First and last indices of boxes, shape (axes, boxes) each."""

    first: Integers
    last: Integers


@kernel
def centres(
    boxes: Boxes,
    minima: Floats,
    steps: Floats,
    columns: Integers,
    fixed: Floats,
) -> tuple[Floats, Floats]:
    """Return the poses of the centres of boxes, and how far their nodes are from those at most.

    Shapes (coordinates, boxes) and (axes, boxes), for each axis by itself, rounding included.
    """
    axes, count = boxes.first.shape
    poses, halves = np.empty((fixed.size, count)), np.empty((axes, count))
    for k in range(fixed.size):
        poses[k] = fixed[k]
    for a in range(axes):
        centre, half, low, step = poses[columns[a]], halves[a], minima[a], steps[a]
        for i in range(count):
            first, last = boxes.first[a, i], boxes.last[a, i]
            centre[i] = low + 0.5 * (first + last) * step
            half[i] = 0.5 * (last - first) * step + ROUNDING * (abs(low) + last * step)
    return poses, halves


@inlined
def _nodes(boxes: Boxes, i: int) -> int:
    """Return how many nodes a box has."""
    count = 1
    for a in range(boxes.first.shape[0]):
        count *= boxes.last[a, i] - boxes.first[a, i] + 1
    return count


@inlined
def _halved(boxes: Boxes, halves: Floats, kinds: Integers, a: int, i: int) -> bool:
    """Return whether a box is halved along an axis: not if it is far longer along another.

    Only axes of a kind are compared, lengths and angles.
    """
    halved = bool(boxes.last[a, i] > boxes.first[a, i])
    for b in range(kinds.size):
        rival = kinds[b] == kinds[a] and boxes.last[b, i] > boxes.first[b, i]
        halved = halved and not bool(rival and halves[b, i] > 2.0 * halves[a, i])
    return halved


@kernel
def halved(boxes: Boxes, codes: Bytes, halves: Floats, kinds: Integers, fewest: int) -> Boxes:
    """Return the halves, along all axes where they are long, of the boxes that are not told.

    Parameters
    ----------
    codes : of each box, `UNSEEN` if not told, shape (boxes,).
    halves : half the length of each box along each axis, shape (axes, boxes).
    kinds : shape (axes,); lengths along axes of one kind can be compared.
    fewest : boxes of no more nodes have no halves.
    """
    axes, count = boxes.first.shape
    parts = np.zeros(count, np.int64)
    for i in range(count):
        if codes[i] == UNSEEN and _nodes(boxes, i) > fewest:
            parts[i] = 1
            for a in range(axes):
                parts[i] *= 2 if _halved(boxes, halves, kinds, a, i) else 1
    total = parts.sum()
    fresh = Boxes(np.empty((axes, total), np.int64), np.empty((axes, total), np.int64))
    at = 0
    for i in range(count):
        for part in range(parts[i]):
            rest = part
            for a in range(axes):
                first, last = boxes.first[a, i], boxes.last[a, i]
                if _halved(boxes, halves, kinds, a, i):
                    middle = (first + last) // 2
                    first, last = (middle + 1, last) if rest % 2 else (first, middle)
                    rest //= 2
                fresh.first[a, at], fresh.last[a, at] = first, last
            at += 1
    return fresh


@inlined
def _line(boxes: Boxes, i: int, line: int, shape: Integers) -> int:
    """Return the flat node at which a line of a box begins."""
    flat, stride, rest = int(boxes.first[-1, i]), int(shape[-1]), line
    for a in range(shape.size - 2, -1, -1):
        length = int(boxes.last[a, i] - boxes.first[a, i]) + 1
        flat += (int(boxes.first[a, i]) + rest % length) * stride
        rest //= length
        stride *= int(shape[a])
    return flat


@kernel
def fill(boxes: Boxes, own: Bytes, shape: Integers, start: int, codes: Bytes) -> None:
    """Give the nodes of each box that is told its code; `codes` is of the nodes from `start` on."""
    for i in range(own.size):
        if own[i] == UNSEEN:
            continue
        length = boxes.last[-1, i] - boxes.first[-1, i] + 1
        for line in range(_nodes(boxes, i) // length):
            flat = _line(boxes, i, line, shape) - start
            codes[flat : flat + length] = own[i]


@kernel
def holding(boxes: Boxes, shape: Integers, start: int, among: Booleans) -> Booleans:
    """Return which boxes have any of the nodes that `among` says of those from `start` on."""
    count = boxes.first.shape[1]
    kept = np.zeros(count, np.bool_)
    for i in range(count):
        length = boxes.last[-1, i] - boxes.first[-1, i] + 1
        for line in range(_nodes(boxes, i) // length):
            flat = _line(boxes, i, line, shape) - start
            # All of a line at once: leaving at the first would stop the compiler vectorising.
            found = 0
            for node in range(flat, flat + length):
                found |= among[node]
            kept[i] = found != 0
            if kept[i]:
                break
    return kept


@kernel
def ends(nodes: Integers, shape: Integers) -> tuple[Integers, Integers]:
    """Return the least and the greatest indices of flat nodes, shape (axes,) each."""
    last = shape.size - 1
    low, high = shape.copy(), np.full(shape.size, -1)
    begin = -int(shape[last])
    for node in nodes:
        if not begin <= node < begin + shape[last]:
            # Only where a line begins is a node taken apart.
            rest = node // shape[last]
            begin = rest * shape[last]
            for a in range(last - 1, -1, -1):
                low[a], high[a] = min(low[a], rest % shape[a]), max(high[a], rest % shape[a])
                rest //= shape[a]
        low[last], high[last] = min(low[last], node - begin), max(high[last], node - begin)
    return low, high


@kernel
def moved(nodes: Integers, shape: Integers, shift: Integers, into: Integers) -> Integers:
    """Return flat nodes counted anew, in boxes of another shape, their indices moved by a shift."""
    last = shape.size - 1
    flat = np.empty_like(nodes)
    begin, shifted = -int(shape[last]), 0
    for i in range(nodes.size):
        if not begin <= nodes[i] < begin + shape[last]:
            rest, stride = nodes[i] // shape[last], into[last]
            begin = rest * shape[last]
            shifted = shift[last] - begin
            for a in range(last - 1, -1, -1):
                shifted += (rest % shape[a] + shift[a]) * stride
                rest //= shape[a]
                stride *= into[a]
        flat[i] = nodes[i] + shifted
    return flat
