"""Quadrics of a quaternion as rows of ten coefficients, and how they look in other frames.

A row is that of a symmetric matrix: the coefficients of e_i e_j, those of i != j halved, in the
order of `PAIRS`. Twelve numbers of a platform's equations are such a row and factors of S3, D3.
"""

from typing import TypeVar

import numpy as np

from mechanics.arrays import Complexes, Floats
from mechanics.kernels.compiling import kernel

Numbers = TypeVar("Numbers", Floats, Complexes)

PAIRS = [(i, j) for i in range(4) for j in range(i, 4)]
"""Which products e_i e_j the ten coefficients of a quadric belong to."""

# Rows, not columns of one array: only arrays in one piece become part of a kernel.
FIRST, SECOND = np.array([i for i, _ in PAIRS]), np.array([j for _, j in PAIRS])
TWICE = np.where(FIRST == SECOND, 1.0, 2.0)
"""How often each product occurs in the sum over all i and j."""

_NUMBER = {(i, j): n for n, pair in enumerate(PAIRS) for i, j in (pair, pair[::-1])}


def _quadric(terms: dict[tuple[int, int], float]) -> Floats:
    """Return the coefficients of a sum of products e_i e_j, those of i != j halved."""
    row = np.zeros(10)
    for (i, j), factor in terms.items():
        row[_NUMBER[i, j]] = factor if i == j else factor / 2.0
    return row


def _squares(a: int, b: int, c: int, d: int) -> dict[tuple[int, int], float]:
    return {(0, 0): a, (1, 1): b, (2, 2): c, (3, 3): d}


NORM = _quadric(_squares(1, 1, 1, 1))
"""h = e.e"""

ROTATION = np.array(
    [
        _quadric(_squares(1, 1, -1, -1)),
        _quadric({(1, 2): 2, (0, 3): -2}),
        _quadric({(1, 3): 2, (0, 2): 2}),
        _quadric({(1, 2): 2, (0, 3): 2}),
        _quadric(_squares(1, -1, 1, -1)),
        _quadric({(2, 3): 2, (0, 1): -2}),
        _quadric({(1, 3): 2, (0, 2): -2}),
        _quadric({(2, 3): 2, (0, 1): 2}),
        _quadric(_squares(1, -1, -1, 1)),
    ]
)
"""M = h R(e), row by row."""

# With e = e' i, number n of e' is number n ^ 1 of e, with a sign; likewise j and k.
FRAME_SIGNS = np.array([[1.0, 1, 1, 1], [1, -1, -1, 1], [1, 1, -1, -1], [1, -1, 1, -1]])
SWAPPED = np.array([False, True, True, False])
"""Whether S3 and D3 change places."""

_ROWS = np.array([[0, 1, 2, 3, 4], [0, 3, 2, 1, 4], [2, 1, 0, 3, 4], [2, 3, 0, 1, 4]])
_COLUMNS = np.array(
    [
        [_NUMBER[i ^ u, j ^ u] for i, j in PAIRS] + ([11, 10] if SWAPPED[u] else [10, 11])
        for u in range(4)
    ]
)
_COLUMN_SIGNS = np.array([[s[i] * s[j] for i, j in PAIRS] + [1, 1] for s in FRAME_SIGNS])


@kernel
def in_all_frames(coefficients: Numbers) -> Numbers:
    """Return coefficients, shape (5, 12), for e = e', e' i, e' j and e' k: shape (4, 60)."""
    turned: Numbers = np.empty((4, 60), coefficients.dtype)
    for u in range(4):
        for r in range(5):
            for c in range(12):
                number = coefficients[_ROWS[u, r], _COLUMNS[u, c]]
                turned[u, 12 * r + c] = _COLUMN_SIGNS[u, c] * number
    return turned


@kernel
def row_at(row: Floats, solution: Floats) -> float:
    """Return a row of ten coefficients, or of twelve, at e0, e1, e2, e3, S3, D3."""
    total = 0.0
    for n in range(10):
        total += row[n] * TWICE[n] * solution[FIRST[n]] * solution[SECOND[n]]
    for n in range(10, row.size):
        total += row[n] * solution[n - 6]
    return total
