"""Cofactors and determinants of 6 x 6 matrices, after Laplace along two halves of their rows.

The 20 minors of each half are made once and shared by the determinant and by all cofactors.
"""

from mechanics.arrays import Floats
from mechanics.kernels.compiling import fused, inlined, kernel

Row = tuple[float, ...]

LANES = 64
"""Matrices expanded together, in scratch arrays that stay in the nearest cache."""


@inlined
def expand_six(a: Floats, c: Floats, det: Floats, minors: Floats) -> None:
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
