"""The platform whose forty complex solutions are known, from which all others are reached.

Its coefficients are random complex numbers, normal with the size that platforms have: 0.5, of the
last two 0.1, in the last row 0.2. `starts.npz` keeps three such platforms with their solutions.
`solve` has found these: monomials at the solutions are the null space of all multiples of the
equations up to degree eight (Macaulay's matrix), and multiplying them by an unknown has the
solutions as eigenvectors.
"""

from functools import cache
from itertools import product
from pathlib import Path
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Complexes, Floats, Integers
from mechanics.assembly.normal_form import to_frames
from mechanics.kernels.quadrics import PAIRS, in_all_frames

PATHS = 40

_FILE = Path(__file__).with_name("starts.npz")
_DEGREE = 8

Exponents = tuple[int, ...]
"""Of e0, e1, e2, e3 and of lambda, which counts twice."""

Polynomial = dict[Exponents, complex]


class Start(NamedTuple):
    """A platform and its solutions, as `mechanics.kernels.homotopy.track` takes them.

    Parameters
    ----------
    coefficients : array, shape (4, 120), in all frames, real and imaginary parts in turns.
    points : array, shape (40, 10), each solution in its frame.
    frames : array, shape (40,).
    """

    coefficients: Floats
    points: Floats
    frames: Integers


@cache
def stored() -> tuple[Start, ...]:
    """Return the stored platforms."""
    return tuple(prepared(*pair) for pair in read())


def read() -> list[tuple[Complexes, Complexes]]:
    """Return coefficients, shape (5, 12), and solutions, shape (40, 6), of the stored platforms."""
    with np.load(_FILE) as file:
        return list(zip(file["coefficients"], file["solutions"], strict=True))


def prepared(coefficients: Complexes, solutions: Complexes) -> Start:
    """Return a platform of these coefficients and solutions e, S3, D3, ready for `track`."""
    return Start(in_all_frames(coefficients).view(float), *to_frames(solutions))


def solve(coefficients: Complexes, random: np.random.Generator) -> Complexes:
    """Return all solutions e, S3, D3 of a general platform, shape (40, 6), to about 1e-8.

    Raises
    ------
    ArithmeticError : it has another number of solutions.
    """
    free, along = _left_over(coefficients[4])
    monomials = _monomials(_DEGREE)
    number = {m: n for n, m in enumerate(monomials)}
    rows = _multiples(_equations(coefficients, free, along), number)
    sizes, conjugates = np.linalg.svd(rows, full_matrices=True)[1:]
    rank = int(np.count_nonzero(sizes > 1e-10 * sizes[0]))
    if len(monomials) - rank != PATHS:
        raise ArithmeticError(f"{len(monomials) - rank} solutions instead of {PATHS}")
    values = _values(conjugates[rank:].conj().T, number, random)
    return _points(values, number, free, along)


def _left_over(row: Complexes) -> tuple[Complexes, Complexes]:
    """Return S3, D3 where the fifth row vanishes: quadrics (2, 10), and their rates by lambda."""
    k = row[10:]
    return -np.outer(k.conj(), row[:10]) / np.vdot(k, k), np.array([-k[1], k[0]])


def _monomials(degree: int) -> list[Exponents]:
    """Return all monomials of this degree."""
    powers = product(range(degree + 1), repeat=5)
    return [m for m in powers if m[0] + m[1] + m[2] + m[3] + 2 * m[4] == degree]


def _times(a: Polynomial, b: Polynomial) -> Polynomial:
    total: Polynomial = {}
    for m, x in a.items():
        for n, y in b.items():
            exponents = tuple(i + j for i, j in zip(m, n, strict=True))
            total[exponents] = total.get(exponents, 0.0) + x * y
    return total


def _sum(*terms: tuple[complex, Polynomial]) -> Polynomial:
    total: Polynomial = {}
    for factor, polynomial in terms:
        for m, x in polynomial.items():
            total[m] = total.get(m, 0.0) + factor * x
    return total


def _unknown(k: int) -> Polynomial:
    return {tuple(int(k == i) for i in range(5)): 1.0}


def _equations(coefficients: Complexes, free: Complexes, along: Complexes) -> list[Polynomial]:
    """Return P e = e Q, S.D = 0 and |S + D|^2 / 4 = h^2 as polynomials."""
    e = [_unknown(k) for k in range(4)]
    products = [_times(e[i], e[j]) for i, j in PAIRS]
    factors = [1.0 if i == j else 2.0 for i, j in PAIRS]

    def quadric(row: Complexes, rate: complex = 0.0) -> Polynomial:
        terms = zip(row * factors, products, strict=True)
        return _sum((rate, _unknown(4)), *terms)

    S3, D3 = (quadric(row, rate) for row, rate in zip(free, along, strict=True))
    quarter = [
        _sum((1, quadric(row[:10])), (row[10], S3), (row[11], D3)) for row in coefficients[:4]
    ]
    S, D = [*quarter[:2], S3], [*quarter[2:], D3]
    h = _sum(*((1, _times(x, x)) for x in e))
    P = [_sum((0.5, s), (0.5, d)) for s, d in zip(S, D, strict=True)]
    cycle = [(1, 2, 3), (2, 3, 1), (3, 1, 2)]
    return [
        _sum(*((1, _times(D[i - 1], e[i])) for i in (1, 2, 3))),
        *(
            _sum(
                (1, _times(e[0], D[i - 1])),
                (1, _times(S[j - 1], e[k])),
                (-1, _times(S[k - 1], e[j])),
            )
            for i, j, k in cycle
        ),
        _sum(*((1, _times(s, d)) for s, d in zip(S, D, strict=True))),
        _sum(*((1, _times(p, p)) for p in P), (-1, _times(h, h))),
    ]


def _multiples(equations: list[Polynomial], number: dict[Exponents, int]) -> Complexes:
    """Return the rows of all multiples of the equations up to the degree."""
    rows = []
    for equation, degree in zip(equations, (3, 3, 3, 3, 4, 4), strict=True):
        for m in _monomials(_DEGREE - degree):
            row = np.zeros(len(number), dtype=complex)
            for n, x in _times({m: 1.0}, equation).items():
                row[number[n]] = x
            rows.append(row / np.linalg.norm(row))
    return np.array(rows)


def _values(
    space: Complexes, number: dict[Exponents, int], random: np.random.Generator
) -> Complexes:
    """Return all monomials at all solutions, shape (monomials, solutions), up to factors."""
    lower = _monomials(_DEGREE - 1)
    shifted = []
    for k in range(4):
        places = [number[(*m[:k], m[k] + 1, *m[k + 1 :])] for m in lower]
        shifted.append(space[places])
    one, other = random.normal(size=(2, 4)) @ np.reshape(shifted, (4, -1))
    shape = shifted[0].shape
    multiplication = np.linalg.lstsq(one.reshape(shape), other.reshape(shape), rcond=None)[0]
    values: Complexes = space @ np.linalg.eig(multiplication)[1]
    return values


def _points(
    values: Complexes, number: dict[Exponents, int], free: Complexes, along: Complexes
) -> Complexes:
    """Return e, of length 1, and S3, D3 from the values of the monomials."""

    def powers(k: int, n: int, **more: int) -> int:
        return number[tuple(n * (i == k) + more.get(f"e{i}", 0) for i in range(5))]

    found = np.empty((values.shape[1], 6), dtype=complex)
    for point, column in zip(found, values.T, strict=True):
        k = int(np.argmax([abs(column[powers(i, _DEGREE)]) for i in range(4)]))
        e = np.array([column[powers(k, _DEGREE - 1, **{f"e{i}": 1})] for i in range(4)])
        e /= column[powers(k, _DEGREE)]
        parameter = column[powers(k, _DEGREE - 2, e4=1)] / column[powers(k, _DEGREE)]
        point[:4] = e
        products = np.array([e[i] * e[j] * (1.0 if i == j else 2.0) for i, j in PAIRS])
        point[4:] = free @ products + along * parameter
        size = np.linalg.norm(e)
        point[:4] /= size
        point[4:] /= size * size
    return found
