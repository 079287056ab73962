"""Cofactors and determinants of 2 x 2, 3 x 3, 4 x 4 and 6 x 6 matrices, many at a time.

Cofactors over the determinant are the inverse transposed: no pivoting, no division before the
last step, and what is singular to rounding shows as a determinant of exactly 0. The larger matrices
are expanded after Laplace along two halves of their rows: minors of each half are made once and
shared by the determinant and by all cofactors.
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import fused, inlined, kernel

Row = tuple[float, ...]

EPSILON = 2.0**-52
LANES = 64
"""6 x 6 matrices expanded together, in scratch arrays that stay in the nearest cache."""


@kernel
def write_cofactors(matrices: Floats, adjugates: Floats, determinants: Floats) -> None:
    """Write the cofactors, shape as `matrices` (n, n, poses), and the determinants."""
    # Scratch of known size, made here: the compiler sees that nothing overlaps, and vectorises.
    a, c = np.ones((6, 6, LANES)), np.empty((6, 6, LANES))
    det, minors = np.empty(LANES), np.empty((20, LANES))
    size, count = matrices.shape[0], determinants.size
    for first in range(0, count, LANES):
        lanes = min(LANES, count - first)
        for p in range(size):
            for j in range(size):
                for i in range(lanes):
                    a[p, j, i] = matrices[p, j, first + i]
        expand(size, a, c, det, minors)
        for p in range(size):
            for j in range(size):
                for i in range(lanes):
                    adjugates[p, j, first + i] = c[p, j, i]
        for i in range(lanes):
            determinants[first + i] = det[i]


@inlined
def expand(size: int, a: Floats, c: Floats, det: Floats, minors: Floats) -> None:
    """Write cofactors and determinants of size x size matrices, one a lane.

    Determinants no larger than their own rounding error are set to 0: that error is some units
    of the last place of the product of the rows' sizes (Hadamard). `minors`, shape (20, lanes),
    is scratch.
    """
    if size == 2:
        _two(a, c, det)
    elif size == 3:
        _three(a, c, det)
    elif size == 4:
        _four(a, c, det)
    else:
        _six(a, c, det, minors)
    _zero_rounding(size, a, det, minors[0], minors[1])


@inlined
def _zero_rounding(size: int, a: Floats, det: Floats, product: Floats, square: Floats) -> None:
    """Set determinants to 0 that are no larger than 4 n units of the product of their rows."""
    for i in range(LANES):
        product[i] = 1.0
    for p in range(size):
        # Number by number for all poses: a sum inside the loop over poses is not vectorised.
        for i in range(LANES):
            square[i] = 0.0
        for j in range(size):
            for i in range(LANES):
                square[i] += a[p, j, i] * a[p, j, i]
        for i in range(LANES):
            product[i] *= square[i]
    for i in range(LANES):
        bound = 4.0 * size * EPSILON * math.sqrt(product[i])
        det[i] = 0.0 if abs(det[i]) <= bound else det[i]


@inlined
def _two(a: Floats, c: Floats, det: Floats) -> None:
    for i in range(LANES):
        c[0, 0, i] = a[1, 1, i]
        c[0, 1, i] = -a[1, 0, i]
        c[1, 0, i] = -a[0, 1, i]
        c[1, 1, i] = a[0, 0, i]
        det[i] = a[0, 0, i] * a[1, 1, i] - a[0, 1, i] * a[1, 0, i]


@inlined
def _three(a: Floats, c: Floats, det: Floats) -> None:
    for p in range(3):
        one, two = (p + 1) % 3, (p + 2) % 3
        for j in range(3):
            k, m = (j + 1) % 3, (j + 2) % 3
            for i in range(LANES):
                c[p, j, i] = a[one, k, i] * a[two, m, i] - a[one, m, i] * a[two, k, i]
    for i in range(LANES):
        det[i] = a[0, 0, i] * c[0, 0, i] + a[0, 1, i] * c[0, 1, i] + a[0, 2, i] * c[0, 2, i]


@inlined
def _four(a: Floats, c: Floats, det: Floats) -> None:
    """Expand the row that a cofactor leaves in its own half by minors of the other half."""
    for p in range(4):
        partner = p ^ 1
        one, two = (2, 3) if p < 2 else (0, 1)
        for j in range(4):
            k, m, n = _others(j)
            # Moving the partner in front of the two others changes no sign.
            sign = 1.0 if (p + j) % 2 == 0 else -1.0
            for i in range(LANES):
                c[p, j, i] = sign * (
                    a[partner, k, i] * (a[one, m, i] * a[two, n, i] - a[one, n, i] * a[two, m, i])
                    - a[partner, m, i] * (a[one, k, i] * a[two, n, i] - a[one, n, i] * a[two, k, i])
                    + a[partner, n, i] * (a[one, k, i] * a[two, m, i] - a[one, m, i] * a[two, k, i])
                )
    for i in range(LANES):
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


@inlined
def _six(a: Floats, c: Floats, det: Floats, minors: Floats) -> None:
    """Expand each half of the rows by the 20 minors of the other half, shape (20, lanes)."""
    for half in range(2):
        own, other = 3 * half, 3 - 3 * half
        # Short loops, each of which keeps what it needs in registers.
        for i in range(LANES):
            pairs = _pairs(_row(a, other + 1, i), _row(a, other + 2, i))
            _store_minors(minors, i, _triples(_row(a, other, i), pairs))
        for p in range(3):
            # The lower half comes with the other sign: its two rows swapped.
            one, two = own + (p + 1 + half) % 3, own + (p + 2 - half) % 3
            for i in range(LANES):
                pairs = _pairs(_row(a, one, i), _row(a, two, i))
                _store(c, own + p, i, _row_of_cofactors(pairs, _minors(minors, i)))
    for i in range(LANES):
        det[i] = (
            (a[0, 0, i] * c[0, 0, i] + a[0, 1, i] * c[0, 1, i])
            + (a[0, 2, i] * c[0, 2, i] + a[0, 3, i] * c[0, 3, i])
            + (a[0, 4, i] * c[0, 4, i] + a[0, 5, i] * c[0, 5, i])
        )


@kernel
def _minors(minors: Floats, i: int) -> Row:
    return (
        minors[0, i],
        minors[1, i],
        minors[2, i],
        minors[3, i],
        minors[4, i],
        minors[5, i],
        minors[6, i],
        minors[7, i],
        minors[8, i],
        minors[9, i],
        minors[10, i],
        minors[11, i],
        minors[12, i],
        minors[13, i],
        minors[14, i],
        minors[15, i],
        minors[16, i],
        minors[17, i],
        minors[18, i],
        minors[19, i],
    )


@kernel
def _store_minors(minors: Floats, i: int, t: Row) -> None:
    minors[0, i] = t[0]
    minors[1, i] = t[1]
    minors[2, i] = t[2]
    minors[3, i] = t[3]
    minors[4, i] = t[4]
    minors[5, i] = t[5]
    minors[6, i] = t[6]
    minors[7, i] = t[7]
    minors[8, i] = t[8]
    minors[9, i] = t[9]
    minors[10, i] = t[10]
    minors[11, i] = t[11]
    minors[12, i] = t[12]
    minors[13, i] = t[13]
    minors[14, i] = t[14]
    minors[15, i] = t[15]
    minors[16, i] = t[16]
    minors[17, i] = t[17]
    minors[18, i] = t[18]
    minors[19, i] = t[19]


@kernel
def _row(a: Floats, p: int, i: int) -> Row:
    return a[p, 0, i], a[p, 1, i], a[p, 2, i], a[p, 3, i], a[p, 4, i], a[p, 5, i]


@kernel
def _store(c: Floats, p: int, i: int, row: Row) -> None:
    c[p, 0, i] = row[0]
    c[p, 1, i] = row[1]
    c[p, 2, i] = row[2]
    c[p, 3, i] = row[3]
    c[p, 4, i] = row[4]
    c[p, 5, i] = row[5]


@fused
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


@fused
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


@fused
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
