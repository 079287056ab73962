"""Where the platform is at the origins of grid lines."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.line_ends import ABREAST
from mechanics.kernels.placing import move_into, turn_into


class Places(NamedTuple):
    """Where the platform is at the origins of `ABREAST` lines: (3, lines), (9, lines or 1).

    Poses and turns, shapes (coordinates, lines) and (6, lines), are scratch.
    """

    positions: Floats
    rotations: Floats
    poses: Floats
    turns: Floats


@inlined
def room_for_places(
    motion: tuple[Floats, int, Floats],
    grid: tuple[Floats, Floats, Integers, Integers, Floats],
) -> Places:
    """Return the room for places; the one rotation there is if no axis of the grid turns."""
    twists, turning, axis = motion
    fixed = grid[4]
    turned = False
    for column in grid[3]:
        moving = 0.0
        for j in range(3):
            moving += abs(twists[j, column])
        turned = turned or moving == 0.0
    rotations = np.empty((9, ABREAST if turned else 1))
    if not turned:
        pose = np.empty((fixed.size, 1))
        for k in range(fixed.size):
            pose[k, 0] = fixed[k]
        turn_into(fixed.size, turning, axis, pose, np.empty((6, 1)), rotations)
    poses = np.empty((fixed.size, ABREAST))
    return Places(np.empty((3, ABREAST)), rotations, poses, np.empty((6, ABREAST)))


@kernel
def place_lines(
    motion: tuple[Floats, int, Floats],
    grid: tuple[Floats, Floats, Integers, Integers, Floats],
    begin: int,
    places: Places,
) -> None:
    """Place the platform at the origin of line `begin` and of those after it."""
    twists, turning, axis = motion
    minima, steps, shape, columns, fixed = grid
    poses = places.poses
    for k in range(fixed.size):
        value = minima[-1] if k == columns[-1] else fixed[k]
        for i in range(ABREAST):
            poses[k, i] = value
    repeat = 1
    for a in range(shape.size - 2, -1, -1):
        k, index, at, left = columns[a], begin // repeat % shape[a], 0, repeat - begin % repeat
        if repeat == 1:
            left = shape[a] - index
        # Stretches without a branch: along the innermost axis all of it, else of equal nodes.
        while at < ABREAST:
            end, ramp = min(at + left, ABREAST), 1 if repeat == 1 else 0
            for i in range(at, end):
                poses[k, i] = minima[a] + (index + ramp * (i - at)) * steps[a]
            at, left = end, shape[a] if repeat == 1 else repeat
            index = 0 if repeat == 1 or index + 1 == shape[a] else index + 1
        repeat *= shape[a]
    move_into(twists, poses, places.positions)
    if places.rotations.shape[1] > 1:
        turn_into(fixed.size, turning, axis, poses, places.turns, places.rotations)
