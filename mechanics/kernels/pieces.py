"""Pieces of runs: consecutive nodes of a grid line that are inside and have a sign in common."""

import numpy as np
from numpy.typing import NDArray

from mechanics.arrays import Bytes, Integers
from mechanics.kernels.compiling import kernel

Signs = NDArray[np.int8]


@kernel
def count_of_sign(codes: Bytes, lengths: Integers, line: int, signs: Signs, sign: int) -> int:
    """Return how many pieces have this sign; `signs` has one for every node inside, in order."""
    count, node, inside, stop = 0, 0, 0, -1
    for run in range(codes.size):
        if codes[run] == 0:
            for i in range(lengths[run]):
                if signs[inside + i] == sign:
                    count += node + i != stop or stop % line == 0
                    stop = node + i + 1
            inside += lengths[run]
        node += lengths[run]
    return count


@kernel
def of_sign(
    codes: Bytes, lengths: Integers, line: int, signs: Signs, sign: int
) -> tuple[Integers, Integers]:
    """Return first nodes, and those after the last, of the pieces that have this sign."""
    size = count_of_sign(codes, lengths, line, signs, sign)
    starts, stops = np.empty(size, np.int64), np.empty(size, np.int64)
    last, node, inside, stop = -1, 0, 0, -1
    for run in range(codes.size):
        if codes[run] == 0:
            for i in range(lengths[run]):
                if signs[inside + i] == sign:
                    if node + i != stop or stop % line == 0:
                        last += 1
                        starts[last] = node + i
                    stop = node + i + 1
                    stops[last] = stop
            inside += lengths[run]
        node += lengths[run]
    return starts, stops


@kernel
def recode(
    codes: Bytes, lengths: Integers, starts: Integers, stops: Integers, code: int
) -> tuple[Bytes, Integers]:
    """Return the runs with another code for nodes inside that are in none of these pieces.

    Every piece lies within one run.
    """
    size = codes.size + 2 * starts.size
    values, counts = np.empty(size, np.uint8), np.empty(size, np.int64)
    new, piece, node = 0, 0, 0
    for run in range(codes.size):
        end = node + lengths[run]
        while codes[run] == 0 and piece < starts.size and starts[piece] < end:
            if node < starts[piece]:
                values[new], counts[new] = code, starts[piece] - node
                new += 1
            values[new], counts[new] = 0, stops[piece] - starts[piece]
            node = stops[piece]
            piece, new = piece + 1, new + 1
        if node < end:
            values[new] = code if codes[run] == 0 else codes[run]
            counts[new] = end - node
            node, new = end, new + 1
    return values[:new], counts[:new]
