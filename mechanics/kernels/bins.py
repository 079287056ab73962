"""Counting values by bins."""

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import kernel


@kernel
def fill(values: Floats, edges: Floats, counts: Integers) -> None:
    """Add to the counts of the bins, shape (edges - 1,), the values within the edges.

    A bin holds its lower edge, and the last its upper one too. The edges are about equally far
    apart; they decide, and their distance only says where to begin.
    """
    bins = counts.size
    low, high = edges[0], edges[bins]
    scale = bins / (high - low)
    for value in values:
        if not low <= value <= high:
            continue
        place = (value - low) * scale
        i = int(place) if 0.0 <= place < bins else bins - 1
        while i > 0 and value < edges[i]:
            i -= 1
        while i < bins - 1 and value >= edges[i + 1]:
            i += 1
        counts[i] += 1
