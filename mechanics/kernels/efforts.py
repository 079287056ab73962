"""Drive efforts T = -J^-T P, and their greatest over all directions of a load of given size."""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import kernel


@kernel
def effort_rows(
    adjugates: Floats, determinants: Floats, drive_rates: Floats, twists: Floats, rows: Floats
) -> None:
    """Write the rows of J^-T as wrenches, shape (drives, 6, poses): force part, moment part.

    J^-T = Jpsi Jx^-T: finite where Jpsi = 0 (type 1), not finite where det Jx = 0 (type 2).
    """
    count, coordinates, poses = adjugates.shape
    scales = np.empty(poses)
    rows[:] = 0.0
    for k in range(count):
        for i in range(poses):
            scales[i] = drive_rates[k, i] / determinants[i] if determinants[i] else math.nan
        for j in range(coordinates):
            for t in range(6):
                unit = twists[t, j]
                if unit != 0.0:
                    for i in range(poses):
                        rows[k, t, i] += unit * adjugates[k, j, i] * scales[i]


@kernel
def part_norms_of(rows: Floats, k: int, i: int) -> tuple[float, float]:
    """Return the sizes of the force part and of the moment part of one drive's row."""
    x, y, z = rows[k, 0, i], rows[k, 1, i], rows[k, 2, i]
    u, v, w = rows[k, 3, i], rows[k, 4, i], rows[k, 5, i]
    return math.sqrt(x * x + y * y + z * z), math.sqrt(u * u + v * v + w * w)


@kernel
def part_norms(rows: Floats) -> tuple[Floats, Floats]:
    """Return the sizes of the force parts and of the moment parts, shape (drives, poses)."""
    count, _, poses = rows.shape
    forces = np.empty((count, poses))
    moments = np.empty((count, poses))
    for k in range(count):
        for i in range(poses):
            forces[k, i], moments[k, i] = part_norms_of(rows, k, i)
    return forces, moments


@kernel
def known_efforts(rows: Floats, wrenches: Floats) -> Floats:
    """Return the signed efforts -J^-T P, shape (drives, poses), of wrenches (6, poses or 1)."""
    count, _, poses = rows.shape
    signed = np.zeros((count, poses))
    every = wrenches.shape[1] == poses
    for k in range(count):
        for t in range(6):
            for i in range(poses):
                signed[k, i] -= rows[k, t, i] * wrenches[t, i if every else 0]
    return signed
