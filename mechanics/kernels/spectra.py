"""Condition numbers of small square matrices, many at a time, by one-sided Jacobi rotations.

Columns are turned pair by pair until all are perpendicular; their sizes are then the singular
values, the least of them as accurate as the largest. No branch depends on a pose's company: what
has converged is left as it is, however long the others take.
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel

LANES = 64
"""Matrices worked on together, in scratch arrays that stay in the nearest cache."""

SWEEPS = 30
"""More than enough: 6 x 6 matrices take about six."""

PERPENDICULAR = 4.0 * 2.0**-52
"""Columns whose cosine is not above this are left as they are."""


@kernel
def condition_numbers(matrices: Floats, scales: Floats, numbers: Floats) -> None:
    """Write the ratios of the greatest to the least singular value, shape (poses,).

    Parameters
    ----------
    matrices : array, shape (n, n, poses).
    scales : array, shape (n,): what the columns are divided by first.
    numbers : array, shape (poses,); infinite where a matrix is singular, NaN where one has NaN.
    """
    size, count = matrices.shape[0], numbers.size
    columns, pair = np.empty((6, 6, LANES)), np.empty((5, LANES))
    for first in range(0, count, LANES):
        lanes = min(LANES, count - first)
        for j in range(size):
            for k in range(size):
                for i in range(LANES):
                    columns[j, k, i] = 0.0
                for i in range(lanes):
                    columns[j, k, i] = matrices[k, j, first + i] / scales[j]
        turn_all(size, columns, pair)
        extremes(size, columns, pair)
        for i in range(lanes):
            numbers[first + i] = ratio(pair[0, i], pair[1, i], pair[2, i])


@inlined
def turn_all(size: int, columns: Floats, pair: Floats) -> None:
    """Make the columns, shape (n, n, lanes), perpendicular to each other."""
    for _ in range(SWEEPS):
        turned = 0
        for p in range(size - 1):
            for q in range(p + 1, size):
                turned += turn_pair(size, columns[p], columns[q], pair)
        if turned == 0:
            break


@kernel
def turn_pair(size: int, first: Floats, second: Floats, pair: Floats) -> int:
    """Make two columns, shape (n, lanes), perpendicular; return how many were not yet."""
    alpha, beta, gamma, cosine, sine = pair[0], pair[1], pair[2], pair[3], pair[4]
    for i in range(LANES):
        alpha[i], beta[i], gamma[i] = 0.0, 0.0, 0.0
    for k in range(size):
        for i in range(LANES):
            alpha[i] += first[k, i] * first[k, i]
            beta[i] += second[k, i] * second[k, i]
            gamma[i] += first[k, i] * second[k, i]
    turned = 0
    for i in range(LANES):
        off = abs(gamma[i]) > PERPENDICULAR * math.sqrt(alpha[i] * beta[i])
        zeta = (beta[i] - alpha[i]) / (2.0 * gamma[i]) if off else 1.0
        size_of_t = 1.0 / (abs(zeta) + math.sqrt(1.0 + zeta * zeta))
        tangent = size_of_t if zeta >= 0.0 else -size_of_t
        share = 1.0 / math.sqrt(1.0 + tangent * tangent)
        cosine[i] = share if off else 1.0
        sine[i] = share * tangent if off else 0.0
        turned += 1 if off else 0
    if turned == 0:
        return 0
    for k in range(size):
        for i in range(LANES):
            a, b = first[k, i], second[k, i]
            first[k, i] = cosine[i] * a - sine[i] * b
            second[k, i] = sine[i] * a + cosine[i] * b
    return turned


@inlined
def extremes(size: int, columns: Floats, pair: Floats) -> None:
    """Write the squares of the greatest and of the least column, and the sum of all squares."""
    for i in range(LANES):
        pair[0, i], pair[1, i], pair[2, i] = 0.0, math.inf, 0.0
    for j in range(size):
        for i in range(LANES):
            pair[3, i] = 0.0
        for k in range(size):
            for i in range(LANES):
                pair[3, i] += columns[j, k, i] * columns[j, k, i]
        for i in range(LANES):
            pair[0, i] = max(pair[0, i], pair[3, i])
            pair[1, i] = min(pair[1, i], pair[3, i])
            pair[2, i] += pair[3, i]


@kernel
def ratio(greatest: float, least: float, total: float) -> float:
    """Return the root of greatest / least, inf if least is 0 and NaN if the total is not finite."""
    if not total < math.inf:
        return math.nan
    return math.inf if least == 0.0 else math.sqrt(greatest / least)
