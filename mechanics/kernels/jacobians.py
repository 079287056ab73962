"""Jx: what the platform's twists do along the rods."""

from mechanics.arrays import Floats
from mechanics.kernels.compiling import kernel


@kernel
def platform_jacobians(twists: Floats, directions: Floats, arms: Floats, rows: Floats) -> None:
    """Write Jx, shape (legs, coordinates, poses): row i is [u_i, rho_i x u_i] E."""
    count, _, poses = directions.shape
    for k in range(count):
        u, rho = directions[k], arms[k]
        for j in range(twists.shape[1]):
            row = rows[k, j]
            row[:] = 0.0
            for t in range(6):
                share = twists[t, j]
                if share == 0.0:
                    continue
                if t < 3:
                    for i in range(poses):
                        row[i] += share * u[t, i]
                else:
                    m, n = (t + 1) % 3, (t + 2) % 3
                    for i in range(poses):
                        row[i] += share * (rho[m, i] * u[n, i] - rho[n, i] * u[m, i])
