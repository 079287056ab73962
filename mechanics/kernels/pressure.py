"""Pressure angles: between where a drive moves a leg's joint and where the leg pushes it."""

import math

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import kernel
from mechanics.kernels.legs import Vector
from mechanics.legs import ARC_JOINTS


@kernel
def force_line(u: Vector, arm: Vector, joints: int) -> Vector:
    """Return the line of a leg's force: along its rod, of an arc along the great circle."""
    if joints != ARC_JOINTS:
        return u
    along = u[0] * arm[0] + u[1] * arm[1] + u[2] * arm[2]
    return u[0] - along * arm[0], u[1] - along * arm[1], u[2] - along * arm[2]


@kernel
def angle_between_lines(a: Vector, b: Vector) -> float:
    """Return the angle, within [0, pi/2], of two lines; NaN where one has no direction. [rad]"""
    x = a[1] * b[2] - a[2] * b[1]
    y = a[2] * b[0] - a[0] * b[2]
    z = a[0] * b[1] - a[1] * b[0]
    across = math.sqrt(x * x + y * y + z * z)
    along = abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])
    return math.nan if across + along == 0.0 else math.atan2(across, along)


@kernel
def pressure_angles(
    twists: Floats,
    joints: Integers,
    adjugates: Floats,
    directions: Floats,
    arms: Floats,
    angles: Floats,
) -> None:
    """Write the pressure angles, shape (legs, poses), within [0, pi/2]. [rad]

    Row k of the cofactors of Jx has the direction of the platform's motion while all drives
    but k are braked, at a singular pose too; the angle is at the leg's joint on the platform.
    """
    t = np.empty(6)
    for k in range(angles.shape[0]):
        for i in range(angles.shape[1]):
            for row in range(6):
                t[row] = 0.0
                for j in range(twists.shape[1]):
                    t[row] += twists[row, j] * adjugates[k, j, i]
            arm = arms[k, 0, i], arms[k, 1, i], arms[k, 2, i]
            velocity = (
                t[0] + t[4] * arm[2] - t[5] * arm[1],
                t[1] + t[5] * arm[0] - t[3] * arm[2],
                t[2] + t[3] * arm[1] - t[4] * arm[0],
            )
            u = directions[k, 0, i], directions[k, 1, i], directions[k, 2, i]
            angles[k, i] = angle_between_lines(velocity, force_line(u, arm, joints[k]))
