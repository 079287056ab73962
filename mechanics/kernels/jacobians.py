"""Jx and the rows of the inverse transposed Jacobian, from rod directions and arms."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import kernel


@kernel
def platform_jacobians(twists: Floats, directions: Floats, arms: Floats) -> Floats:
    """Return Jx, shape (legs, coordinates, poses): row i is [u_i, rho_i x u_i] E."""
    count, _, poses = directions.shape
    coordinates = twists.shape[1]
    rows = np.empty((count, coordinates, poses))
    for k in range(count):
        u = directions[k]
        rho = arms[k]
        for i in range(poses):
            m0 = rho[1, i] * u[2, i] - rho[2, i] * u[1, i]
            m1 = rho[2, i] * u[0, i] - rho[0, i] * u[2, i]
            m2 = rho[0, i] * u[1, i] - rho[1, i] * u[0, i]
            for j in range(coordinates):
                t = twists[:, j]
                rows[k, j, i] = (
                    u[0, i] * t[0]
                    + u[1, i] * t[1]
                    + u[2, i] * t[2]
                    + m0 * t[3]
                    + m1 * t[4]
                    + m2 * t[5]
                )
    return rows


@kernel
def cofactors_2(a: Floats, c: Floats, det: Floats, i: int) -> None:
    """Write the cofactors and the determinant of the 2 x 2 matrix at pose i."""
    c[0, 0, i] = a[1, 1, i]
    c[0, 1, i] = -a[1, 0, i]
    c[1, 0, i] = -a[0, 1, i]
    c[1, 1, i] = a[0, 0, i]
    det[i] = a[0, 0, i] * a[1, 1, i] - a[0, 1, i] * a[1, 0, i]


@kernel
def cofactors_3(a: Floats, c: Floats, det: Floats, i: int) -> None:
    """Write the cofactors and the determinant of the 3 x 3 matrix at pose i."""
    for p in range(3):
        q, r = (p + 1) % 3, (p + 2) % 3
        for j in range(3):
            k, m = (j + 1) % 3, (j + 2) % 3
            c[p, j, i] = a[q, k, i] * a[r, m, i] - a[q, m, i] * a[r, k, i]
    det[i] = a[0, 0, i] * c[0, 0, i] + a[0, 1, i] * c[0, 1, i] + a[0, 2, i] * c[0, 2, i]


@kernel
def cofactors(matrices: Floats) -> tuple[Floats, Floats]:
    """Return the cofactors, shape as `matrices` (n, n, poses), and the determinants, n = 2 or 3.

    Cofactors over the determinant are the inverse transposed: no pivoting, no division before
    the last step, and what is exactly singular has the determinant 0.
    """
    adjugates = np.empty_like(matrices)
    determinants = np.empty(matrices.shape[2])
    for i in range(matrices.shape[2]):
        if matrices.shape[0] == 2:
            cofactors_2(matrices, adjugates, determinants, i)
        else:
            cofactors_3(matrices, adjugates, determinants, i)
    return adjugates, determinants
