"""From a pose's coordinates to the platform's position and rotation; the poses of a grid.

All arrays carry the poses on their last axis, so that inner loops run over adjacent numbers.
"""

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import kernel
from mechanics.kernels.turns import about_axis, about_fixed_axes

TURNING_NONE = 0
TURNING_ABOUT_AXIS = 1
TURNING_ABOUT_FIXED_AXES = 2


@kernel
def place(
    twists: Floats, turning: int, axis: Floats, poses: Floats, positions: Floats, rotations: Floats
) -> None:
    """Write positions, shape (3, poses), and rotations, shape (9, poses) row by row."""
    coordinates, count = poses.shape
    positions[:] = 0.0
    for k in range(coordinates):
        for j in range(3):
            share = twists[j, k]
            if share != 0.0:
                for i in range(count):
                    positions[j, i] += share * poses[k, i]
    if turning == TURNING_ABOUT_AXIS:
        about_axis(poses[coordinates - 1], axis, rotations)
    elif turning == TURNING_ABOUT_FIXED_AXES:
        about_fixed_axes(poses[coordinates - 3 :], rotations)
    else:
        rotations[:] = 0.0
        for k in range(0, 9, 4):
            rotations[k] = 1.0


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


@kernel
def gather(values: Floats, chosen: Integers) -> Floats:
    """Return the chosen columns of values, shape (rows, poses)."""
    gathered = np.empty((values.shape[0], chosen.size))
    for k in range(values.shape[0]):
        for i in range(chosen.size):
            gathered[k, i] = values[k, chosen[i]]
    return gathered
