"""Cofactors and determinants of 2 x 2, 3 x 3, 4 x 4 and 6 x 6 matrices, many at a time.

Cofactors over the determinant are the inverse transposed: no pivoting, no division before the
last step, and what is singular to rounding shows as a determinant of exactly 0. The larger matrices
are expanded after Laplace along two halves of their rows: minors of each half are made once and
shared by the determinant and by all cofactors.
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel

Row = tuple[float, ...]

EPSILON = 2.0**-52
LANES = 32
"""6 x 6 matrices expanded together, in scratch arrays that stay in the nearest cache."""


@kernel
def write_cofactors(matrices: Floats, adjugates: Floats, determinants: Floats) -> None:
    """Write the cofactors, shape as `matrices` (n, n, poses), and the determinants."""
    size = matrices.shape[0]
    if size == 2:
        _two(matrices, adjugates, determinants)
    elif size == 3:
        _three(matrices, adjugates, determinants)
    elif size == 4:
        _four(matrices, adjugates, determinants)
    else:
        _six_by_lanes(matrices, adjugates, determinants)
    _settle(matrices, determinants)


@kernel
def _settle(matrices: Floats, determinants: Floats) -> None:
    """Set determinants to 0 that are no larger than their own rounding error.

    That error is some units of the last place of the product of the rows' sizes (Hadamard).
    """
    size, _, count = matrices.shape
    bounds = np.full(count, 4.0 * size * EPSILON)
    squares = np.empty(count)
    for p in range(size):
        squares[:] = 0.0
        for j in range(size):
            entries = matrices[p, j]
            for i in range(count):
                squares[i] += entries[i] * entries[i]
        for i in range(count):
            bounds[i] *= math.sqrt(squares[i])
    for i in range(count):
        if abs(determinants[i]) <= bounds[i]:
            determinants[i] = 0.0


@kernel
def _two(a: Floats, c: Floats, det: Floats) -> None:
    for i in range(det.size):
        c[0, 0, i] = a[1, 1, i]
        c[0, 1, i] = -a[1, 0, i]
        c[1, 0, i] = -a[0, 1, i]
        c[1, 1, i] = a[0, 0, i]
        det[i] = a[0, 0, i] * a[1, 1, i] - a[0, 1, i] * a[1, 0, i]


@kernel
def _three(a: Floats, c: Floats, det: Floats) -> None:
    for p in range(3):
        one, two = a[(p + 1) % 3], a[(p + 2) % 3]
        for j in range(3):
            k, m = (j + 1) % 3, (j + 2) % 3
            for i in range(det.size):
                c[p, j, i] = one[k, i] * two[m, i] - one[m, i] * two[k, i]
    for i in range(det.size):
        det[i] = a[0, 0, i] * c[0, 0, i] + a[0, 1, i] * c[0, 1, i] + a[0, 2, i] * c[0, 2, i]


@kernel
def _four(a: Floats, c: Floats, det: Floats) -> None:
    """Expand the row that a cofactor leaves in its own half by minors of the other half."""
    for i in range(det.size):
        for p in range(4):
            partner = p ^ 1
            one, two = (2, 3) if p < 2 else (0, 1)
            for j in range(4):
                k, m, n = _others(j)
                total = (
                    a[partner, k, i] * (a[one, m, i] * a[two, n, i] - a[one, n, i] * a[two, m, i])
                    - a[partner, m, i] * (a[one, k, i] * a[two, n, i] - a[one, n, i] * a[two, k, i])
                    + a[partner, n, i] * (a[one, k, i] * a[two, m, i] - a[one, m, i] * a[two, k, i])
                )
                # Moving the partner in front of the two others changes no sign.
                c[p, j, i] = total if (p + j) % 2 == 0 else -total
        det[i] = (
            a[0, 0, i] * c[0, 0, i]
            + a[0, 1, i] * c[0, 1, i]
            + a[0, 2, i] * c[0, 2, i]
            + a[0, 3, i] * c[0, 3, i]
        )


@kernel
def _others(j: int) -> tuple[int, int, int]:
    """Return the columns of four but the j-th, ascending."""
    return (1 if j == 0 else 0), (1 if j > 1 else 2), (2 if j == 3 else 3)


@kernel
def _six_by_lanes(matrices: Floats, adjugates: Floats, determinants: Floats) -> None:
    # Scratch of known size, made here: the compiler sees that nothing overlaps, and vectorises.
    a, c, det = np.ones((6, 6, LANES)), np.empty((6, 6, LANES)), np.empty(LANES)
    count = determinants.size
    for first in range(0, count, LANES):
        lanes = min(LANES, count - first)
        for p in range(6):
            for j in range(6):
                for i in range(lanes):
                    a[p, j, i] = matrices[p, j, first + i]
        _expand(a, c, det)
        for p in range(6):
            for j in range(6):
                for i in range(lanes):
                    adjugates[p, j, first + i] = c[p, j, i]
        for i in range(lanes):
            determinants[first + i] = det[i]


@inlined
def _expand(a: Floats, c: Floats, det: Floats) -> None:
    """Write cofactors and determinants of 6 x 6 matrices, one a lane."""
    for i in range(LANES):
        x0, x1, x2 = _row(a, 0, i), _row(a, 1, i), _row(a, 2, i)
        y0, y1, y2 = _row(a, 3, i), _row(a, 4, i), _row(a, 5, i)
        upper, lower = _pairs(x1, x2), _pairs(y1, y2)
        above, below = _triples(x0, upper), _triples(y0, lower)
        first = _row_of_cofactors(upper, below)
        _store(c, 0, i, first, 1.0)
        _store(c, 1, i, _row_of_cofactors(_pairs(x2, x0), below), 1.0)
        _store(c, 2, i, _row_of_cofactors(_pairs(x0, x1), below), 1.0)
        _store(c, 3, i, _row_of_cofactors(lower, above), -1.0)
        _store(c, 4, i, _row_of_cofactors(_pairs(y2, y0), above), -1.0)
        _store(c, 5, i, _row_of_cofactors(_pairs(y0, y1), above), -1.0)
        det[i] = (
            (x0[0] * first[0] + x0[1] * first[1])
            + (x0[2] * first[2] + x0[3] * first[3])
            + (x0[4] * first[4] + x0[5] * first[5])
        )


@kernel
def _row(a: Floats, p: int, i: int) -> Row:
    return a[p, 0, i], a[p, 1, i], a[p, 2, i], a[p, 3, i], a[p, 4, i], a[p, 5, i]


@kernel
def _store(c: Floats, p: int, i: int, row: Row, sign: float) -> None:
    c[p, 0, i] = sign * row[0]
    c[p, 1, i] = sign * row[1]
    c[p, 2, i] = sign * row[2]
    c[p, 3, i] = sign * row[3]
    c[p, 4, i] = sign * row[4]
    c[p, 5, i] = sign * row[5]


@kernel
def _pairs(x: Row, y: Row) -> Row:
    """Return the 15 minors of two rows, columns (0, 1), (0, 2), ... (4, 5)."""
    return (
        x[0] * y[1] - x[1] * y[0],
        x[0] * y[2] - x[2] * y[0],
        x[0] * y[3] - x[3] * y[0],
        x[0] * y[4] - x[4] * y[0],
        x[0] * y[5] - x[5] * y[0],
        x[1] * y[2] - x[2] * y[1],
        x[1] * y[3] - x[3] * y[1],
        x[1] * y[4] - x[4] * y[1],
        x[1] * y[5] - x[5] * y[1],
        x[2] * y[3] - x[3] * y[2],
        x[2] * y[4] - x[4] * y[2],
        x[2] * y[5] - x[5] * y[2],
        x[3] * y[4] - x[4] * y[3],
        x[3] * y[5] - x[5] * y[3],
        x[4] * y[5] - x[5] * y[4],
    )


@kernel
def _triples(x: Row, p: Row) -> Row:
    """Return the 20 minors of three rows, the last two given by their 15 minors `p`."""
    return (
        x[0] * p[5] - x[1] * p[1] + x[2] * p[0],
        x[0] * p[6] - x[1] * p[2] + x[3] * p[0],
        x[0] * p[7] - x[1] * p[3] + x[4] * p[0],
        x[0] * p[8] - x[1] * p[4] + x[5] * p[0],
        x[0] * p[9] - x[2] * p[2] + x[3] * p[1],
        x[0] * p[10] - x[2] * p[3] + x[4] * p[1],
        x[0] * p[11] - x[2] * p[4] + x[5] * p[1],
        x[0] * p[12] - x[3] * p[3] + x[4] * p[2],
        x[0] * p[13] - x[3] * p[4] + x[5] * p[2],
        x[0] * p[14] - x[4] * p[4] + x[5] * p[3],
        x[1] * p[9] - x[2] * p[6] + x[3] * p[5],
        x[1] * p[10] - x[2] * p[7] + x[4] * p[5],
        x[1] * p[11] - x[2] * p[8] + x[5] * p[5],
        x[1] * p[12] - x[3] * p[7] + x[4] * p[6],
        x[1] * p[13] - x[3] * p[8] + x[5] * p[6],
        x[1] * p[14] - x[4] * p[8] + x[5] * p[7],
        x[2] * p[12] - x[3] * p[10] + x[4] * p[9],
        x[2] * p[13] - x[3] * p[11] + x[5] * p[9],
        x[2] * p[14] - x[4] * p[11] + x[5] * p[10],
        x[3] * p[14] - x[4] * p[13] + x[5] * p[12],
    )


@kernel
def _row_of_cofactors(p: Row, t: Row) -> Row:
    """Return the six cofactors of a row, up to the sign of its half.

    `p` are the minors of the two other rows of its half, in cyclic order, which takes up the
    row's own sign; `t` those of the other half. Laplace's expansion over the columns left.
    """
    return (
        p[5] * t[19]
        - p[6] * t[18]
        + p[7] * t[17]
        - p[8] * t[16]
        + p[9] * t[15]
        - p[10] * t[14]
        + p[11] * t[13]
        + p[12] * t[12]
        - p[13] * t[11]
        + p[14] * t[10],
        -p[1] * t[19]
        + p[2] * t[18]
        - p[3] * t[17]
        + p[4] * t[16]
        - p[9] * t[9]
        + p[10] * t[8]
        - p[11] * t[7]
        - p[12] * t[6]
        + p[13] * t[5]
        - p[14] * t[4],
        p[0] * t[19]
        - p[2] * t[15]
        + p[3] * t[14]
        - p[4] * t[13]
        + p[6] * t[9]
        - p[7] * t[8]
        + p[8] * t[7]
        + p[12] * t[3]
        - p[13] * t[2]
        + p[14] * t[1],
        -p[0] * t[18]
        + p[1] * t[15]
        - p[3] * t[12]
        + p[4] * t[11]
        - p[5] * t[9]
        + p[7] * t[6]
        - p[8] * t[5]
        - p[10] * t[3]
        + p[11] * t[2]
        - p[14] * t[0],
        p[0] * t[17]
        - p[1] * t[14]
        + p[2] * t[12]
        - p[4] * t[10]
        + p[5] * t[8]
        - p[6] * t[6]
        + p[8] * t[4]
        + p[9] * t[3]
        - p[11] * t[1]
        + p[13] * t[0],
        -p[0] * t[16]
        + p[1] * t[13]
        - p[2] * t[11]
        + p[3] * t[10]
        - p[5] * t[7]
        + p[6] * t[5]
        - p[7] * t[4]
        - p[9] * t[2]
        + p[10] * t[1]
        - p[12] * t[0],
    )
