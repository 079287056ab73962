"""Where the platform is at the origins of grid lines."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.line_ends import ABREAST
from mechanics.kernels.placing import move_into, turn_into

TOGETHER = 8 * ABREAST
"""Lines placed at once: enough to hide the cost of a call."""


class Places(NamedTuple):
    """Where the platform is at the origins of lines: (3, lines), (9, lines or 1)."""

    positions: Floats
    rotations: Floats


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
    rotations = np.empty((9, TOGETHER if turned else 1))
    if not turned:
        pose = np.empty((fixed.size, 1))
        for k in range(fixed.size):
            pose[k, 0] = fixed[k]
        turn_into(fixed.size, turning, axis, pose, np.empty((6, 1)), rotations)
    return Places(np.empty((3, TOGETHER)), rotations)


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
    poses = np.empty((fixed.size, TOGETHER))
    for k in range(fixed.size):
        for i in range(TOGETHER):
            poses[k, i] = minima[-1] if k == columns[-1] else fixed[k]
    repeat = 1
    for a in range(shape.size - 2, -1, -1):
        k, index, left = columns[a], begin // repeat % shape[a], repeat - begin % repeat
        for i in range(TOGETHER):
            poses[k, i] = minima[a] + index * steps[a]
            left -= 1
            if left == 0:
                index, left = index + 1 if index + 1 < shape[a] else 0, repeat
        repeat *= shape[a]
    move_into(twists, poses, places.positions)
    if places.rotations.shape[1] > 1:
        turn_into(fixed.size, turning, axis, poses, np.empty((6, TOGETHER)), places.rotations)
