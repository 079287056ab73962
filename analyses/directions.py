"""Orientations told by two unit vectors instead of three angles."""

from collections.abc import Sequence

import numpy as np

from analyses.errors import AnalysisError, pointer
from mechanics.arrays import Floats
from mechanics.kernels.placing import TURNING_ABOUT_FIXED_AXES
from mechanics.motions import Motion
from mechanics.rotations import fixed_axis_angles
from schemas.inverse_kinematics import Axes

SLACK = 1e-6
"""How far vectors may be from unit length and from a right angle: what six digits make of them."""


def check_directions(motion: Motion, poses: Sequence[object], directions: Sequence[Axes]) -> None:
    """Raise AnalysisError unless every pose has two unit vectors at a right angle.

    Parameters
    ----------
    motion : what the platform does; it must turn about three axes.
    poses : as many as there must be pairs of vectors.
    directions : the platform's x and y axes in the base frame, a pair a pose.
    """
    if motion.turning != TURNING_ABOUT_FIXED_AXES:
        detail = f"the motion {motion.name} has no angles rx, ry, rz that they could stand for"
        raise AnalysisError(("/directions", detail))
    if len(directions) != len(poses):
        detail = f"must have one pair per pose, that is {len(poses)}; given {len(directions)}"
        raise AnalysisError(("/directions", detail))
    pairs = np.array(directions, dtype=float)
    lengths = np.linalg.norm(pairs, axis=2)
    for row, part in np.argwhere(np.abs(lengths - 1.0) > SLACK)[:1]:
        detail = f"must be a unit vector; its length is {lengths[row, part]:.9g}"
        raise AnalysisError((pointer("directions", row, part), detail))
    cosines = np.sum(pairs[:, 0] * pairs[:, 1], axis=1)
    for (row,) in np.argwhere(np.abs(cosines) > SLACK)[:1]:
        apart = np.degrees(np.arccos(np.clip(cosines[row], -1.0, 1.0)))
        detail = f"must be perpendicular to the other one; they are {apart:.6g} degrees apart"
        raise AnalysisError((pointer("directions", row, 1), detail))


def angles_of(directions: Sequence[Axes]) -> Floats:
    """Return rx, ry, rz, one row a pair, of platforms whose x and y axes point there. [rad]

    The second vector gives way where the two are not quite at a right angle.
    """
    first, second = np.moveaxis(np.array(directions, dtype=float), 1, 0)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second -= np.sum(first * second, axis=1, keepdims=True) * first
    second /= np.linalg.norm(second, axis=1, keepdims=True)
    rotations = np.stack([first, second, np.cross(first, second)], axis=2)
    return fixed_axis_angles(rotations.reshape(-1, 9).T).T
