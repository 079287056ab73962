"""Cofactors and determinants of 2 x 2, 3 x 3, 4 x 4 and 6 x 6 matrices, many at a time.

Cofactors over the determinant are the inverse transposed: no pivoting, no division before the
last step, and what is singular to rounding shows as a determinant of exactly 0. The larger matrices
are expanded after Laplace along two halves of their rows: minors of each half are made once and
shared by the determinant and by all cofactors.
"""

import math
from itertools import combinations

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import inlined, kernel

EPSILON = 2.0**-52
LANES = 32
"""Matrices expanded together: their minors stay in the nearest cache."""


def _sign(order: tuple[int, ...]) -> int:
    """Return the sign of a permutation."""
    swaps = sum(a > b for a, b in combinations(order, 2))
    return -1 if swaps % 2 else 1


_PAIRS_6: list[tuple[int, ...]] = list(combinations(range(6), 2))
_TRIPLES_6: list[tuple[int, ...]] = list(combinations(range(6), 3))


def _determinant_terms_6() -> Integers:
    """Return, shape (20, 3), sign, upper triple and lower triple of each term."""
    terms = []
    for t, triple in enumerate(_TRIPLES_6):
        rest = tuple(c for c in range(6) if c not in triple)
        terms.append((_sign(triple + rest), t, _TRIPLES_6.index(rest)))
    return np.array(terms, dtype=np.int64)


def _columns_left_6() -> tuple[Integers, Integers]:
    """Return the ten pairs of the five columns but one, and the triples that are left beside.

    Shapes (6, 10) each, by the column that is left out.
    """
    pairs, triples = np.empty((6, 10), np.int64), np.empty((6, 10), np.int64)
    for column in range(6):
        columns = [c for c in range(6) if c != column]
        for n, pair in enumerate(combinations(columns, 2)):
            pairs[column, n] = _PAIRS_6.index(pair)
            triples[column, n] = _TRIPLES_6.index(tuple(c for c in columns if c not in pair))
    return pairs, triples


_DETERMINANT_6 = _determinant_terms_6()
_PAIRS_LEFT_6, _TRIPLES_LEFT_6 = _columns_left_6()
_PAIR_COLUMNS_6 = np.array(_PAIRS_6)
_TRIPLE_COLUMNS_6 = np.array(_TRIPLES_6)
_TRIPLE_PAIRS_6 = np.array(
    [
        [_PAIRS_6.index((q, r)), _PAIRS_6.index((p, r)), _PAIRS_6.index((p, q))]
        for p, q, r in _TRIPLES_6
    ]
)


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
    """Expand as many matrices as there are lanes at a time, in scratch arrays of fixed strides."""
    a = np.ones((6, 6, LANES))
    c = np.empty((6, 6, LANES))
    det = np.empty(LANES)
    pairs = np.empty((6, 15, LANES))
    triples = np.empty((2, 20, LANES))
    count = determinants.size
    for first in range(0, count, LANES):
        lanes = min(LANES, count - first)
        for p in range(6):
            for j in range(6):
                for i in range(lanes):
                    a[p, j, i] = matrices[p, j, first + i]
        _six(a, c, det, pairs, triples)
        for p in range(6):
            for j in range(6):
                for i in range(lanes):
                    adjugates[p, j, first + i] = c[p, j, i]
        for i in range(lanes):
            determinants[first + i] = det[i]


@inlined
def _six(a: Floats, c: Floats, det: Floats, pairs: Floats, triples: Floats) -> None:
    for half in range(2):
        _minors(a, half, pairs, triples[half])
    det[:] = 0.0
    for n in range(20):
        sign = float(_DETERMINANT_6[n, 0])
        t, u = triples[0, _DETERMINANT_6[n, 1]], triples[1, _DETERMINANT_6[n, 2]]
        for i in range(LANES):
            det[i] += sign * (t[i] * u[i])
    for row in range(6):
        half = row // 3
        for j in range(6):
            sign = float(1 - 2 * ((half + j) % 2))
            _sum_of_products(
                _PAIRS_LEFT_6[j], _TRIPLES_LEFT_6[j], sign, pairs[row], triples[1 - half], c[row, j]
            )


@inlined
def _minors(a: Floats, half: int, pairs: Floats, triples: Floats) -> None:
    """Write the minors of three rows: of the two others than each, and of all three."""
    for p in range(3):
        one, two = a[3 * half + (p + 1) % 3], a[3 * half + (p + 2) % 3]
        for n in range(15):
            x, y = _PAIR_COLUMNS_6[n, 0], _PAIR_COLUMNS_6[n, 1]
            minor = pairs[3 * half + p, n]
            ox, oy, tx, ty = one[x], one[y], two[x], two[y]
            for i in range(LANES):
                minor[i] = ox[i] * ty[i] - oy[i] * tx[i]
    for n in range(20):
        x, y, z = _TRIPLE_COLUMNS_6[n, 0], _TRIPLE_COLUMNS_6[n, 1], _TRIPLE_COLUMNS_6[n, 2]
        first = pairs[3 * half, _TRIPLE_PAIRS_6[n, 0]]
        second = pairs[3 * half, _TRIPLE_PAIRS_6[n, 1]]
        third = pairs[3 * half, _TRIPLE_PAIRS_6[n, 2]]
        ax, ay, az = a[3 * half, x], a[3 * half, y], a[3 * half, z]
        minor = triples[n]
        for i in range(LANES):
            minor[i] = ax[i] * first[i] - ay[i] * second[i] + az[i] * third[i]


@inlined
def _sum_of_products(
    p: Integers, t: Integers, sign: float, pairs: Floats, triples: Floats, total: Floats
) -> None:
    """Write a cofactor: minors of two rows times minors of three, over the five columns left."""
    p0, p1, p2, p3, p4 = pairs[p[0]], pairs[p[1]], pairs[p[2]], pairs[p[3]], pairs[p[4]]
    p5, p6, p7, p8, p9 = pairs[p[5]], pairs[p[6]], pairs[p[7]], pairs[p[8]], pairs[p[9]]
    t0, t1, t2, t3, t4 = triples[t[0]], triples[t[1]], triples[t[2]], triples[t[3]], triples[t[4]]
    t5, t6, t7, t8, t9 = triples[t[5]], triples[t[6]], triples[t[7]], triples[t[8]], triples[t[9]]
    for i in range(LANES):
        # A pair (a, b) of the five columns stands in front of the rest after a + b - 1 swaps.
        total[i] = sign * (
            (p0[i] * t0[i] - p1[i] * t1[i] + p2[i] * t2[i] - p3[i] * t3[i] + p4[i] * t4[i])
            - (p5[i] * t5[i] - p6[i] * t6[i] - p7[i] * t7[i] + p8[i] * t8[i] - p9[i] * t9[i])
        )
