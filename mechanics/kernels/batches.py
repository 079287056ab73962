"""Whole batches run through scratch arrays that stay in the nearest cache.

The same formulas as a `Configuration` goes through, some poses at a time; the last stretch is
filled up with copies of its last pose, so that every loop has its full length.
"""

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import (
    crank_angle,
    crank_equation,
    crank_turn,
    rail_coordinate,
    span,
    strut_length,
)
from mechanics.kernels.placing import place
from mechanics.legs import CRANK, RAIL, Legs

LANES = 128
"""Poses that go through the scratch arrays together."""


@kernel
def actuators(
    twists: Floats, turning: int, axis: Floats, legs: Legs, poses: Floats, values: Floats
) -> None:
    """Write the drive coordinates, shape (legs, poses), of poses, shape (coordinates, poses)."""
    size, total = values.shape
    block = np.empty((poses.shape[0], LANES))
    positions, rotations = np.empty((3, LANES)), np.empty((9, LANES))
    found = np.empty((size, LANES))
    for first in range(0, total, LANES):
        count = min(LANES, total - first)
        for k in range(block.shape[0]):
            for i in range(LANES):
                block[k, i] = poses[k, min(first + i, total - 1)]
        place(twists, turning, axis, block, positions, rotations)
        for k in range(size):
            _drive_coordinates(legs, k, positions, rotations, found)
            for i in range(count):
                values[k, first + i] = found[k, i]


@inlined
def _drive_coordinates(
    legs: Legs, k: int, positions: Floats, rotations: Floats, found: Floats
) -> None:
    """Write one leg's drive coordinates in one pass, without keeping what lies between."""
    value = found[k]
    if legs.drive[k] == CRANK:
        for i in range(LANES):
            x, y, z = span(legs, k, positions, rotations, i)
            P, Q, S, root = crank_equation(legs, k, x, y, z)
            c, s = crank_turn(P, Q, S, root, legs.working_mode[k])
            value[i] = crank_angle(c, s)
    elif legs.drive[k] == RAIL:
        for i in range(LANES):
            x, y, z = span(legs, k, positions, rotations, i)
            value[i] = rail_coordinate(legs, k, x, y, z)
    else:
        for i in range(LANES):
            x, y, z = span(legs, k, positions, rotations, i)
            value[i] = strut_length(x, y, z)
