"""Linear systems of a few unknowns, many at a time, as regular as each happens to be."""

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import kernel

_LOST = 1e-15
"""A pivot below this share of the first is taken as 0."""


@kernel
def solve_each(matrices: Floats, rights: Floats, solutions: Floats) -> None:
    """Write x, shape (n, poses), of A x = b, A of shape (n, n, poses).

    Gauss with complete pivoting: where A is singular to rounding, the unknowns that it leaves
    open are 0, and the equations that contradict the others are left out.
    """
    n = rights.shape[0]
    a, b, order = np.empty((n, n)), np.empty(n), np.empty(n, np.int64)
    for i in range(rights.shape[1]):
        for p in range(n):
            b[p] = rights[p, i]
            order[p] = p
            for q in range(n):
                a[p, q] = matrices[p, q, i]
        rank = _eliminate(a, b, order)
        for p in range(n):
            solutions[order[p], i] = 0.0
        for p in range(rank - 1, -1, -1):
            total = b[p]
            for q in range(p + 1, rank):
                total -= a[p, q] * solutions[order[q], i]
            solutions[order[p], i] = total / a[p, p]


@kernel
def _eliminate(a: Floats, b: Floats, order: Integers) -> int:
    """Make A upper triangular in place, with the order of its columns; return its rank."""
    n = b.size
    first = 0.0
    for k in range(n):
        row, column = _pivot(a, k)
        size = abs(a[row, column])
        first = max(first, size)
        if not size > _LOST * first:
            return k
        for q in range(n):
            a[k, q], a[row, q] = a[row, q], a[k, q]
        for p in range(n):
            a[p, k], a[p, column] = a[p, column], a[p, k]
        b[k], b[row] = b[row], b[k]
        order[k], order[column] = order[column], order[k]
        for p in range(k + 1, n):
            share = a[p, k] / a[k, k]
            b[p] -= share * b[k]
            for q in range(k, n):
                a[p, q] -= share * a[k, q]
    return n


@kernel
def _pivot(a: Floats, k: int) -> tuple[int, int]:
    """Return row and column of the largest number that is left from row and column k on."""
    row, column = k, k
    for p in range(k, a.shape[0]):
        for q in range(k, a.shape[0]):
            if abs(a[p, q]) > abs(a[row, column]):
                row, column = p, q
    return row, column
