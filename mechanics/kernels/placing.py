"""From a pose's coordinates to the platform's position and rotation; the poses of a grid.

All arrays carry the poses on their last axis, so that inner loops run over adjacent numbers.
"""

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.turns import about_axis, about_fixed_axes

TURNING_NONE = 0
TURNING_ABOUT_AXIS = 1
TURNING_ABOUT_FIXED_AXES = 2


@inlined
def place_into(
    twists: Floats,
    turning: int,
    axis: Floats,
    poses: Floats,
    turns: Floats,
    positions: Floats,
    rotations: Floats,
) -> None:
    """Write positions, shape (3, poses), and rotations, shape (9, poses) row by row.

    `turns`, shape (6, poses), is overwritten with sines and cosines.
    """
    coordinates = twists.shape[1]
    count = positions.shape[1]
    for j in range(3):
        for i in range(count):
            positions[j, i] = 0.0
        for k in range(coordinates):
            share = twists[j, k]
            if share != 0.0:
                for i in range(count):
                    positions[j, i] += share * poses[k, i]
    if turning == TURNING_ABOUT_AXIS:
        about_axis(poses, coordinates - 1, axis, turns, rotations)
    elif turning == TURNING_ABOUT_FIXED_AXES:
        about_fixed_axes(poses, coordinates - 3, turns, rotations)
    else:
        for k in range(9):
            for i in range(count):
                rotations[k, i] = 1.0 if k % 4 == 0 else 0.0


@kernel
def place(
    twists: Floats, turning: int, axis: Floats, poses: Floats, positions: Floats, rotations: Floats
) -> None:
    """Write positions, shape (3, poses), and rotations, shape (9, poses) row by row."""
    turns = np.empty((6, poses.shape[1]))
    place_into(twists, turning, axis, poses, turns, positions, rotations)


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
