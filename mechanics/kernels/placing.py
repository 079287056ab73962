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
def move_into(twists: Floats, poses: Floats, positions: Floats) -> None:
    """Write positions, shape (3, poses)."""
    for j in range(3):
        for i in range(positions.shape[1]):
            positions[j, i] = 0.0
        for k in range(twists.shape[1]):
            share = twists[j, k]
            if share != 0.0:
                for i in range(positions.shape[1]):
                    positions[j, i] += share * poses[k, i]


@kernel
def move(twists: Floats, poses: Floats) -> Floats:
    """Return positions, shape (3, poses)."""
    positions = np.empty((3, poses.shape[1]))
    move_into(twists, poses, positions)
    return positions


@inlined
def turn_into(
    coordinates: int, turning: int, axis: Floats, poses: Floats, turns: Floats, rotations: Floats
) -> None:
    """Write rotations, shape (9, poses) row by row; `turns`, shape (6, poses), is scratch."""
    if turning == TURNING_ABOUT_AXIS:
        about_axis(poses, coordinates - 1, axis, turns, rotations)
    elif turning == TURNING_ABOUT_FIXED_AXES:
        about_fixed_axes(poses, coordinates - 3, turns, rotations)
    else:
        for k in range(9):
            for i in range(rotations.shape[1]):
                rotations[k, i] = 1.0 if k % 4 == 0 else 0.0


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
    move_into(twists, poses, positions)
    turn_into(twists.shape[1], turning, axis, poses, turns, rotations)


@kernel
def place(
    twists: Floats, turning: int, axis: Floats, poses: Floats, positions: Floats, rotations: Floats
) -> None:
    """Write positions, shape (3, poses), and rotations, shape (9, poses) row by row."""
    turns = np.empty((6, poses.shape[1]))
    place_into(twists, turning, axis, poses, turns, positions, rotations)


@kernel
def grid_poses(
    nodes: Integers,
    minima: Floats,
    steps: Floats,
    shape: Integers,
    columns: Integers,
    fixed: Floats,
) -> Floats:
    """Return the poses, shape (coordinates, nodes), of flat nodes of a grid.

    Coordinates that no axis drives keep their value in `fixed`.
    """
    poses = np.empty((fixed.size, nodes.size))
    for k in range(fixed.size):
        poses[k] = fixed[k]
    at = np.zeros(shape.size, np.int64)
    last = shape.size - 1
    for i in range(nodes.size):
        if last >= 0 and i > 0 and nodes[i] == nodes[i - 1] + 1 and at[last] + 1 < shape[last]:
            at[last] += 1
        else:
            # Only where a line begins is a node taken apart.
            rest = nodes[i]
            for a in range(last, -1, -1):
                at[a] = rest % shape[a]
                rest //= shape[a]
        for a in range(last + 1):
            poses[columns[a], i] = minima[a] + at[a] * steps[a]
    return poses


@kernel
def gather(values: Floats, chosen: Integers) -> Floats:
    """Return the chosen columns of values, shape (rows, poses)."""
    gathered = np.empty((values.shape[0], chosen.size))
    for k in range(values.shape[0]):
        for i in range(chosen.size):
            gathered[k, i] = values[k, chosen[i]]
    return gathered
