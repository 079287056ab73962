"""How often a field has which values, told from tiles that are read twice and never kept."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.bins import fill

BINS = 64


@dataclass(frozen=True)
class Histogram:
    """Counts of a field's values in equal bins from the least to the greatest.

    Parameters
    ----------
    edges : array, shape (bins + 1,), ascending, the first the least value and the last the
        greatest; empty if no value is finite. In the field's unit.
    counts : array, shape (bins,): a bin holds its lower edge, and the last its upper one too. If
        all values are the same, the last bin has them.
    undefined : how many values are NaN.
    infinite : how many are infinite, of either sign.
    """

    edges: Floats
    counts: Integers
    undefined: int
    infinite: int


def histogram(read: Callable[[], Iterable[Floats]], bins: int = BINS) -> Histogram:
    """Return the histogram of all values that are finite.

    Parameters
    ----------
    read : yields the field tile by tile, arrays of any shape; it is called twice and must yield
        the same again.
    bins : how many there shall be.
    """
    low, high, undefined, infinite = np.inf, -np.inf, 0, 0
    for tile in read():
        finite = tile[np.isfinite(tile)]
        low, high = finite.min(initial=low), finite.max(initial=high)
        missing = int(np.isnan(tile).sum())
        undefined += missing
        infinite += tile.size - finite.size - missing
    if low > high:
        return Histogram(np.empty(0), np.empty(0, np.int64), undefined, infinite)
    edges = _edges(float(low), float(high), bins)
    counts = np.zeros(bins, np.int64)
    for tile in read():
        fill(np.ascontiguousarray(tile, dtype=np.float64).ravel(), edges, counts)
    return Histogram(edges, counts, undefined, infinite)


def _edges(low: float, high: float, bins: int) -> Floats:
    """Return equally spaced edges; the ends are exact, and no difference overflows."""
    part = np.arange(bins + 1) / bins
    edges = np.clip(low * (1.0 - part) + high * part, low, high)
    return np.maximum.accumulate(edges)
