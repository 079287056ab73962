"""Runs along grid lines: consecutive nodes of a line that share a code; 0 means inside.

Flat nodes are counted with the last axis fastest; a line is `line` consecutive flat nodes.
"""

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.kernels.compiling import kernel


@kernel
def nodes_with(code: int, codes: Bytes, lengths: Integers, start: int) -> Integers:
    """Return the flat nodes of the runs that have this code; the first run begins at `start`."""
    total = 0
    for run in range(codes.size):
        if codes[run] == code:
            total += lengths[run]
    nodes = np.empty(total, np.int64)
    written, node = 0, start
    for run in range(codes.size):
        if codes[run] == code:
            for k in range(lengths[run]):
                nodes[written] = node + k
                written += 1
        node += lengths[run]
    return nodes


@kernel
def refine(
    codes: Bytes, lengths: Integers, verdicts: Bytes, line: int, start: int
) -> tuple[Bytes, Integers]:
    """Return the runs with the nodes of code 0 given their own verdicts, one each, in order.

    No run may go beyond its line.
    """
    count, used = 0, 0
    for run in range(codes.size):
        count += 1
        if codes[run] == 0:
            for k in range(1, lengths[run]):
                count += verdicts[used + k] != verdicts[used + k - 1]
            used += lengths[run]
    fine, sizes = np.empty(count, np.uint8), np.empty(count, np.int64)
    last, used, node = -1, 0, start
    for run in range(codes.size):
        for k in range(lengths[run] if codes[run] == 0 else 1):
            code = verdicts[used + k] if codes[run] == 0 else codes[run]
            size = 1 if codes[run] == 0 else lengths[run]
            if last >= 0 and fine[last] == code and node % line != 0:
                sizes[last] += size
            else:
                last += 1
                fine[last], sizes[last] = code, size
            node += size
        if codes[run] == 0:
            used += lengths[run]
    return fine[: last + 1], sizes[: last + 1]


@kernel
def join(codes: Bytes, lengths: Integers, line: int) -> tuple[Bytes, Integers]:
    """Return the runs of a whole grid with those joined that tiles have cut within a line."""
    joined_codes = np.empty_like(codes)
    joined_lengths = np.empty_like(lengths)
    last = -1
    node = 0
    for run in range(codes.size):
        if last >= 0 and node % line != 0 and joined_codes[last] == codes[run]:
            joined_lengths[last] += lengths[run]
        else:
            last += 1
            joined_codes[last] = codes[run]
            joined_lengths[last] = lengths[run]
        node += lengths[run]
    return joined_codes[: last + 1], joined_lengths[: last + 1]


@kernel
def faces(starts: Integers, stops: Integers, shape: Integers) -> int:
    """Return how many pairs of neighbouring nodes have one inside and one outside.

    `starts` and `stops` are the flat bounds of the runs inside, in order.
    """
    line = shape[-1]
    total = 0
    for run in range(starts.size):
        total += starts[run] % line != 0
        total += stops[run] % line != 0
    stride = 1
    for axis in range(shape.size - 2, -1, -1):
        stride *= shape[axis + 1]
        other = 0
        for run in range(starts.size):
            length = stops[run] - starts[run]
            index = starts[run] // stride % shape[axis]
            total += length * ((index > 0) + (index + 1 < shape[axis]))
            if index > 0:
                a, b = starts[run] - stride, stops[run] - stride
                while stops[other] <= a:
                    other += 1
                k = other
                while k < run and starts[k] < b:
                    total -= 2 * (min(b, stops[k]) - max(a, starts[k]))
                    k += 1
    return total


@kernel
def root_of(parents: Integers, run: int) -> int:
    """Return the representative of a run's component, halving the path to it."""
    while parents[run] != run:
        parents[run] = parents[parents[run]]
        run = parents[run]
    return run


@kernel
def connect(starts: Integers, stops: Integers, shape: Integers) -> Integers:
    """Return for each run inside the number of its component; neighbours share a cell's face."""
    parents = np.arange(starts.size)
    stride = 1
    for axis in range(shape.size - 2, -1, -1):
        stride *= shape[axis + 1]
        other = 0
        for run in range(starts.size):
            if starts[run] // stride % shape[axis] == 0:
                continue
            a, b = starts[run] - stride, stops[run] - stride
            while stops[other] <= a:
                other += 1
            k = other
            while k < run and starts[k] < b:
                one, two = root_of(parents, run), root_of(parents, k)
                parents[max(one, two)] = min(one, two)
                k += 1
    numbers = np.empty(starts.size, np.int64)
    count = 0
    for run in range(starts.size):
        root = root_of(parents, run)
        if root == run:
            numbers[run] = count
            count += 1
        else:
            numbers[run] = numbers[root]
    return numbers


@kernel
def extents(
    starts: Integers, stops: Integers, shape: Integers, numbers: Integers, count: int
) -> tuple[Integers, Integers, Integers, Floats]:
    """Return nodes, least and greatest indices and sums of indices of every component.

    Shapes (components,), (components, axes) twice, and (components, axes).
    """
    axes = shape.size
    nodes = np.zeros(count, np.int64)
    least = np.empty((count, axes), np.int64)
    greatest = np.full((count, axes), -1, np.int64)
    sums = np.zeros((count, axes))
    for k in range(axes):
        least[:, k] = shape[k]
    for run in range(starts.size):
        c = numbers[run]
        length = stops[run] - starts[run]
        nodes[c] += length
        rest = starts[run]
        for k in range(axes - 1, -1, -1):
            first = rest % shape[k]
            last = first + length - 1 if k == axes - 1 else first
            rest //= shape[k]
            least[c, k] = min(least[c, k], first)
            greatest[c, k] = max(greatest[c, k], last)
            sums[c, k] += length * 0.5 * (first + last)
    return nodes, least, greatest, sums
