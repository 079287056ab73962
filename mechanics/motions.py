"""Motions: which coordinates a platform's pose has, and which twists it can follow."""

from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.poses import TURNING_ABOUT_AXIS, TURNING_NONE, place


@dataclass(frozen=True)
class Motion:
    """The coordinates of a pose, in order, and the unit twist of each.

    Parameters
    ----------
    name : the field's name of the motion.
    coordinates : names in the order of a pose's numbers; translations first. [m, rad]
    twists : array, shape (6, coordinates); column k is the unit twist (v, omega) of
        coordinate k, the linear velocity of the reference point first.
    turning : how the last coordinates turn the platform (`kernels.poses.TURNING_*`).
    axis : array, shape (3,), the unit axis of the only turn, where there is one.
    """

    name: str
    coordinates: tuple[str, ...]
    twists: Floats
    turning: int
    axis: Floats

    @property
    def translations(self) -> tuple[str, ...]:
        """The coordinates that move the reference point. [m]"""
        return tuple(c for c, v in zip(self.coordinates, self.twists[:3].T, strict=True) if v.any())

    @property
    def turns(self) -> tuple[str, ...]:
        """The coordinates that turn the platform. [rad]"""
        return tuple(c for c in self.coordinates if c not in self.translations)

    def place(self, poses: Floats) -> tuple[Floats, Floats]:
        """Return where the platform is at each pose.

        Parameters
        ----------
        poses : array, shape (coordinates, poses). [m, rad]

        Returns
        -------
        positions : array, shape (3, poses), the reference point p. [m]
        rotations : array, shape (9, poses), the rotation matrix row by row.
        """
        positions, rotations = place(self.twists, self.turning, self.axis, poses)
        return positions, rotations


def _twists(*directions: int) -> Floats:
    return np.ascontiguousarray(np.eye(6)[:, directions])


PLANAR_TRANSLATION = Motion(
    "planar_translation", ("x", "y"), _twists(0, 1), TURNING_NONE, np.zeros(3)
)
PLANAR = Motion(
    "planar", ("x", "y", "phi"), _twists(0, 1, 5), TURNING_ABOUT_AXIS, np.array([0.0, 0.0, 1.0])
)
