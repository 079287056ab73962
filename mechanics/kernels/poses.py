"""From a pose's coordinates to the platform's position and rotation.

All arrays carry the poses on their last axis, so that inner loops run over adjacent numbers.
"""

import math

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import kernel

TURNING_NONE = 0
TURNING_ABOUT_AXIS = 1


@kernel
def about_axis(angle: float, x: float, y: float, z: float) -> tuple[float, ...]:
    """Return the nine entries, row by row, of the turn by `angle` about the unit axis (x, y, z)."""
    c = math.cos(angle)
    s = math.sin(angle)
    v = 1.0 - c
    return (
        c + v * x * x,
        v * x * y - s * z,
        v * x * z + s * y,
        v * x * y + s * z,
        c + v * y * y,
        v * y * z - s * x,
        v * x * z - s * y,
        v * y * z + s * x,
        c + v * z * z,
    )


@kernel
def place(twists: Floats, turning: int, axis: Floats, poses: Floats) -> tuple[Floats, Floats]:
    """Return positions, shape (3, poses), and rotations, shape (9, poses) row by row."""
    coordinates, count = poses.shape
    positions = np.zeros((3, count))
    for k in range(coordinates):
        for j in range(3):
            if twists[j, k] != 0.0:
                for i in range(count):
                    positions[j, i] += twists[j, k] * poses[k, i]
    rotations = np.zeros((9, count))
    for i in range(count):
        rotations[0, i] = rotations[4, i] = rotations[8, i] = 1.0
    if turning == TURNING_ABOUT_AXIS:
        for i in range(count):
            entries = about_axis(poses[coordinates - 1, i], axis[0], axis[1], axis[2])
            for k in range(9):
                rotations[k, i] = entries[k]
    return positions, rotations


@kernel
def grid_poses(
    start: int,
    stop: int,
    minima: Floats,
    steps: Floats,
    shape: Integers,
    columns: Integers,
    fixed: Floats,
) -> Floats:
    """Return the poses, shape (coordinates, nodes), of the grid's flat nodes start..stop.

    `columns` says which coordinate each axis drives; the others keep their value in `fixed`.
    """
    poses = np.empty((fixed.size, stop - start))
    for k in range(fixed.size):
        poses[k, :] = fixed[k]
    for n in range(start, stop):
        rest = n
        for a in range(shape.size - 1, -1, -1):
            poses[columns[a], n - start] = minima[a] + (rest % shape[a]) * steps[a]
            rest //= shape[a]
    return poses
