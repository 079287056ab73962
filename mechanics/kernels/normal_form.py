"""A platform on six rods as sixty numbers, and the way back from solutions to poses.

The equations are those of `platform_equations`. Both systems that are solved on the way are small
and solved alike: rows are turned among each other, pair by pair, until all are perpendicular
(Jacobi's one-sided rotations, which find singular values). Of the points of a body, a row a
coordinate, that leaves the axes along which they spread independently; of the rods' equations,
rows that give one unknown after the other, and one without unknowns.
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import kernel
from mechanics.kernels.quadrics import NORM, ROTATION, row_at

LEAST_RANK = 1e-9
"""Base and platform count as affinely related below this share of the greatest singular value."""

PERPENDICULAR = 4.0 * 2.0**-52
"""Rows whose product is not above this share of the greater one's square are left as they are."""

SWEEPS = 20
"""More than enough: five rows take about five."""


@kernel
def faulty_rod(base: Floats, platform: Floats, lengths: Floats) -> int:
    """Return the first rod that has no length or ends at no finite point, or -1."""
    for k in range(lengths.size):
        if not 0.0 < lengths[k] < math.inf:
            return k
        for j in range(3):
            if not (math.isfinite(base[k, j]) and math.isfinite(platform[k, j])):
                return k
    return -1


@kernel
def turn_pair(rows: Floats, p: int, q: int, width: int) -> bool:
    """Turn two rows until their first `width` numbers are perpendicular; return if they were not.

    The numbers behind those turn along.
    """
    alpha, beta, gamma = 0.0, 0.0, 0.0
    for k in range(width):
        alpha += rows[p, k] * rows[p, k]
        beta += rows[q, k] * rows[q, k]
        gamma += rows[p, k] * rows[q, k]
    if abs(gamma) <= PERPENDICULAR * max(alpha, beta):
        return False
    zeta = (beta - alpha) / (2.0 * gamma)
    tangent = math.copysign(1.0 / (abs(zeta) + math.sqrt(1.0 + zeta * zeta)), zeta)
    cosine = 1.0 / math.sqrt(1.0 + tangent * tangent)
    sine = cosine * tangent
    for k in range(rows.shape[1]):
        a, b = rows[p, k], rows[q, k]
        rows[p, k] = cosine * a - sine * b
        rows[q, k] = sine * a + cosine * b
    return True


@kernel
def make_perpendicular(rows: Floats, width: int) -> Floats:
    """Turn rows until their first `width` numbers are perpendicular; return the rows' sizes."""
    count = rows.shape[0]
    for _ in range(SWEEPS):
        turned = False
        for p in range(count - 1):
            for q in range(p + 1, count):
                turned |= turn_pair(rows, p, q, width)
        if not turned:
            break
    sizes = np.zeros(count)
    for p in range(count):
        for k in range(width):
            sizes[p] += rows[p, k] * rows[p, k]
        sizes[p] = math.sqrt(sizes[p])
    return sizes


@kernel
def principal_axes(points: Floats, turn: float) -> Floats:
    """Return right-handed axes of points, one a row, that of the least spread last.

    The two others are turned about the last by this angle.
    """
    count = points.shape[0]
    rows = np.zeros((3, count + 3))
    for j in range(3):
        rows[j, count + j] = 1.0
        centre = np.mean(points[:, j])
        for k in range(count):
            rows[j, k] = points[k, j] - centre
    last = np.argmin(make_perpendicular(rows, count))
    # In this order they are right-handed: turning rows does not mirror them.
    a, b = rows[(last + 1) % 3, count:], rows[(last + 2) % 3, count:]
    axes = np.empty((3, 3))
    c, s = math.cos(turn), math.sin(turn)
    for j in range(3):
        axes[0, j], axes[1, j] = c * a[j] - s * b[j], s * a[j] + c * b[j]
        axes[2, j] = rows[last, count + j]
    return axes


@kernel
def seen_from(axes: Floats, points: Floats, point: int, origin: int, scale: float) -> Floats:
    """Return the way from one point to another along axes, over a length."""
    away = np.zeros(3)
    for i in range(3):
        for j in range(3):
            away[i] += axes[i, j] * (points[point, j] - points[origin, j]) / scale
    return away


@kernel
def write_rod(a: Floats, b: Floats, length: float, row: Floats) -> None:
    """Write b.Q - a.P = a'M b + k h as a row.

    First what P1, P2, Q1, Q2 are multiplied by, then the right side: ten coefficients of a
    quadric, and those of S3 and D3, as P3 = (S3 + D3) / 2 and Q3 = (S3 - D3) / 2.
    """
    k = 0.5 * (length * length - 1.0)
    for j in range(3):
        k -= 0.5 * (a[j] * a[j] + b[j] * b[j])
    row[0], row[1], row[2], row[3] = -a[0], -a[1], b[0], b[1]
    for n in range(10):
        row[4 + n] = k * NORM[n]
        for j in range(9):
            row[4 + n] += a[j // 3] * b[j % 3] * ROTATION[j, n]
    row[14], row[15] = 0.5 * (a[2] - b[2]), 0.5 * (a[2] + b[2])


@kernel
def eliminate(rows: Floats, coefficients: Floats) -> float:
    """Write the coefficients of S1, S2, D1, D2 and of the row that vanishes, shape (5, 12).

    Return the least over the greatest singular value of the four rows that were solved.
    """
    sizes = make_perpendicular(rows, 4)
    rest, greatest = np.argmin(sizes), np.max(sizes)
    least, unit = greatest, 0.0
    for p in range(5):
        least = least if p == rest else min(least, sizes[p])
    for n in range(12):
        unit += rows[rest, 4 + n] * rows[rest, 4 + n]
    if not least > LEAST_RANK * greatest:
        return 0.0
    share = 1.0 / math.sqrt(unit) if unit > 0.0 else 1.0
    for n in range(12):
        P1, P2, Q1, Q2 = 0.0, 0.0, 0.0, 0.0
        for p in range(5):
            if p != rest:
                x = rows[p, 4 + n] / (sizes[p] * sizes[p])
                P1, P2 = P1 + rows[p, 0] * x, P2 + rows[p, 1] * x
                Q1, Q2 = Q1 + rows[p, 2] * x, Q2 + rows[p, 3] * x
        coefficients[0, n], coefficients[1, n] = P1 + Q1, P2 + Q2
        coefficients[2, n], coefficients[3, n] = P1 - Q1, P2 - Q2
        coefficients[4, n] = share * rows[rest, 4 + n]
    return least / greatest


@kernel
def normal_form(
    base: Floats, platform: Floats, lengths: Floats, turn: float
) -> tuple[Floats, Floats, Floats, int, float]:
    """Return coefficients (5, 12), axes of base and platform (3, 3), the longest rod, the rank.

    See `mechanics.assembly.normal_form.NormalForm`.
    """
    leg = int(np.argmax(lengths))
    scale = lengths[leg]
    base_axes, platform_axes = principal_axes(base, -turn), principal_axes(platform, 0.7 * turn)
    rows, coefficients = np.empty((5, 16)), np.zeros((5, 12))
    n = 0
    for k in range(6):
        if k != leg:
            a = seen_from(base_axes, base, k, leg, scale)
            b = seen_from(platform_axes, platform, k, leg, scale)
            write_rod(a, b, lengths[k] / scale, rows[n])
            n += 1
    rank = eliminate(rows, coefficients)
    return coefficients, base_axes, platform_axes, leg, rank


@kernel
def real_pose(
    coefficients: Floats, base_axes: Floats, platform_axes: Floats, solution: Floats
) -> tuple[Floats, Floats]:
    """Return position (3,), over the scale, and rotation (3, 3) of a real solution.

    The position is that of the platform's joint of the longest rod from the base's.
    """
    h = row_at(NORM, solution)
    S1, S2 = row_at(coefficients[0], solution), row_at(coefficients[1], solution)
    D1, D2 = row_at(coefficients[2], solution), row_at(coefficients[3], solution)
    P = (0.5 * (S1 + D1), 0.5 * (S2 + D2), 0.5 * (solution[4] + solution[5]))
    position, rotation = np.zeros(3), np.zeros((3, 3))
    for k in range(3):
        for i in range(3):
            position[i] += base_axes[k, i] * P[k] / h
        for n in range(3):
            turn = row_at(ROTATION[3 * k + n], solution) / h
            for i in range(3):
                for j in range(3):
                    rotation[i, j] += base_axes[k, i] * turn * platform_axes[n, j]
    return position, rotation


@kernel
def real_poses(
    coefficients: Floats,
    base_axes: Floats,
    platform_axes: Floats,
    base: Floats,
    platform: Floats,
    scale: float,
    solutions: Floats,
) -> tuple[Floats, Floats]:
    """Return positions (3, poses) and rotations (9, poses) of real solutions, shape (poses, 6).

    `base` and `platform`, shape (3,), are the ends of the longest rod, `scale` its length. [m]
    """
    count = solutions.shape[0]
    positions, rotations = np.empty((3, count)), np.empty((9, count))
    for n in range(count):
        position, rotation = real_pose(coefficients, base_axes, platform_axes, solutions[n])
        for i in range(3):
            positions[i, n] = base[i] + scale * position[i]
            for j in range(3):
                rotations[3 * i + j, n] = rotation[i, j]
                positions[i, n] -= rotation[i, j] * platform[j]
    return positions, rotations
