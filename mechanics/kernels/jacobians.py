"""Jx: what the platform's twists do along the rods."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import Vector


@kernel
def rod_wrench(u: Vector, rho: Vector) -> tuple[float, float, float, float, float, float]:
    """Return [u, rho x u]: the wrench about the reference point of a unit force along a rod."""
    return (
        u[0],
        u[1],
        u[2],
        rho[1] * u[2] - rho[2] * u[1],
        rho[2] * u[0] - rho[0] * u[2],
        rho[0] * u[1] - rho[1] * u[0],
    )


@inlined
def project(twists: Floats, wrenches: Floats, rows: Floats, k: int) -> None:
    """Write a row of Jx, [u, rho x u] E, from the wrenches, shape (6, poses)."""
    for j in range(twists.shape[1]):
        first = True
        for t in range(6):
            share = twists[t, j]
            if share != 0.0 and first:
                for i in range(wrenches.shape[1]):
                    rows[k, j, i] = share * wrenches[t, i]
                first = False
            elif share != 0.0:
                for i in range(wrenches.shape[1]):
                    rows[k, j, i] += share * wrenches[t, i]


@kernel
def platform_jacobians(twists: Floats, directions: Floats, arms: Floats, rows: Floats) -> None:
    """Write Jx, shape (legs, coordinates, poses): row i is [u_i, rho_i x u_i] E."""
    wrenches = np.empty((6, rows.shape[2]))
    for k in range(rows.shape[0]):
        for i in range(rows.shape[2]):
            u = directions[k, 0, i], directions[k, 1, i], directions[k, 2, i]
            rho = arms[k, 0, i], arms[k, 1, i], arms[k, 2, i]
            (
                wrenches[0, i],
                wrenches[1, i],
                wrenches[2, i],
                wrenches[3, i],
                wrenches[4, i],
                wrenches[5, i],
            ) = rod_wrench(u, rho)
        project(twists, wrenches, rows, k)
