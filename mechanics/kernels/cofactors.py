"""Cofactors and determinants of 2 x 2, 3 x 3, 4 x 4 and 6 x 6 matrices, many at a time.

Cofactors over the determinant are the inverse transposed: no pivoting, no division before the
last step, and what is singular to rounding shows as a determinant of exactly 0. The larger matrices
are expanded after Laplace along two halves of their rows (of six: `cofactors_six`).
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.cofactors_six import LANES, expand_six
from mechanics.kernels.compiling import inlined, kernel

EPSILON = 2.0**-52


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
        expand_six(a, c, det, minors)
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
