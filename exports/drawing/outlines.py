"""Boundaries of regions on a plane grid."""

import numpy as np
import numpy.typing as npt
from contourpy import LineType, contour_generator
from matplotlib.path import Path

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]

_HALF_WAY = 0.5
_SMOOTHINGS = 6
# In steps of the grid; a boundary around a corner passes its node at the square root of 1/8.
_FARTHEST_SHIFT = 0.34
# A loop around a few nodes would shrink to nothing.
_LEAST_SMOOTHED = 16


def boundary_length(inside: Bools) -> int:
    """Return how many pairs of neighbouring nodes the boundary parts."""
    return sum(int(np.count_nonzero(np.diff(inside, axis=axis))) for axis in (0, 1))


def outline_of(x: Floats, y: Floats, inside: Bools) -> Path:
    """Return the closed boundary of a region, half-way between nodes inside and outside.

    The steps of the grid are smoothed away, but never so far that a node changes sides:
    where between two nodes the boundary runs is not known anyway.

    Parameters
    ----------
    x, y : array, shape (nodes,)
        Nodes of the two axes.
    inside : array of bool, shape (nodes of x, nodes of y)
        The region; False along all four edges.

    Returns
    -------
    matplotlib Path
        One loop a boundary, outer ones and holes turning opposite ways.
    """
    membership = inside.T.astype(np.float64)
    generator = contour_generator(x, y, membership, line_type=LineType.Separate)
    steps = np.array([x[1] - x[0], y[1] - y[0]])
    loops = [_smoothed(np.asarray(loop) / steps) * steps for loop in generator.lines(_HALF_WAY)]
    codes = [_loop_codes(len(loop)) for loop in loops]
    return Path(np.concatenate(loops), np.concatenate(codes))


def _smoothed(loop: Floats) -> Floats:
    """Return a loop in steps of the grid, its last point again its first, with round corners."""
    if len(loop) < _LEAST_SMOOTHED:
        return loop
    points = loop[:-1]
    for _ in range(_SMOOTHINGS):
        points = points / 2 + (np.roll(points, 1, axis=0) + np.roll(points, -1, axis=0)) / 4
    shift = points - loop[:-1]
    length = np.hypot(*shift.T)[:, np.newaxis]
    points = loop[:-1] + shift * np.minimum(1.0, _FARTHEST_SHIFT / np.maximum(length, 1e-9))
    return np.concatenate([points, points[:1]])


def _loop_codes(points: int) -> npt.NDArray[np.uint8]:
    codes = np.full(points, Path.LINETO, dtype=np.uint8)
    codes[0], codes[-1] = Path.MOVETO, Path.CLOSEPOLY
    return codes
