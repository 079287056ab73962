"""Motions: which coordinates a platform's pose has, and which twists it can follow."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import GeometryError
from mechanics.kernels.placing import (
    TURNING_ABOUT_AXIS,
    TURNING_ABOUT_FIXED_AXES,
    TURNING_NONE,
    place,
)


@dataclass(frozen=True)
class Motion:
    """The coordinates of a pose, in order, and a basis of the twists that the platform has.

    Parameters
    ----------
    name : the field's name of the motion.
    coordinates : names in the order of a pose's numbers; translations first. [m, rad]
    twists : array, shape (6, coordinates): orthonormal unit twists (v, omega), the linear
        velocity of the reference point first. Column k moves along coordinate k; three turning
        angles instead have the turns about the fixed x, y and z as their columns.
    turning : how the last coordinates turn the platform (`kernels.placing.TURNING_*`).
    axis : array, shape (3,), the unit axis of the only turn, where there is one.
    """

    name: str
    coordinates: tuple[str, ...]
    twists: Floats
    turning: int
    axis: Floats

    @cached_property
    def translations(self) -> tuple[str, ...]:
        """The coordinates that move the reference point. [m]"""
        return tuple(c for c, v in zip(self.coordinates, self.twists[:3].T, strict=True) if v.any())

    @cached_property
    def turns(self) -> tuple[str, ...]:
        """The coordinates that turn the platform. [rad]"""
        return tuple(c for c in self.coordinates if c not in self.translations)

    @property
    def kernel(self) -> tuple[Floats, int, Floats]:
        """What kernels take of a motion: twists, turning and axis."""
        return self.twists, self.turning, self.axis

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
        positions = np.empty((3, poses.shape[1]))
        rotations = np.empty((9, poses.shape[1]))
        place(*self.kernel, poses, positions, rotations)
        return positions, rotations


_NO_AXIS = np.zeros(3)


def _twists(*directions: int) -> Floats:
    return np.ascontiguousarray(np.eye(6)[:, directions])


PLANAR_TRANSLATION = Motion("planar_translation", ("x", "y"), _twists(0, 1), TURNING_NONE, _NO_AXIS)
PLANAR = Motion(
    "planar", ("x", "y", "phi"), _twists(0, 1, 5), TURNING_ABOUT_AXIS, np.array([0.0, 0.0, 1.0])
)
TRANSLATION = Motion("translation", ("x", "y", "z"), _twists(0, 1, 2), TURNING_NONE, _NO_AXIS)
SPHERICAL = Motion(
    "spherical", ("rx", "ry", "rz"), _twists(3, 4, 5), TURNING_ABOUT_FIXED_AXES, _NO_AXIS
)
SPATIAL = Motion(
    "spatial",
    ("x", "y", "z", "rx", "ry", "rz"),
    _twists(0, 1, 2, 3, 4, 5),
    TURNING_ABOUT_FIXED_AXES,
    _NO_AXIS,
)


def schoenflies(axis: Floats) -> Motion:
    """Return the motion of three translations and one turn about `axis`, shape (3,).

    Raises
    ------
    GeometryError : the axis is zero.
    """
    length = float(np.linalg.norm(axis))
    if length < 1e-12:
        raise GeometryError(f"the axis of the turn must not be zero; given {list(axis)}")
    unit = np.asarray(axis, dtype=float) / length
    twists = np.zeros((6, 4))
    twists[:3, :3] = np.eye(3)
    twists[3:, 3] = unit
    return Motion("schoenflies", ("x", "y", "z", "theta"), twists, TURNING_ABOUT_AXIS, unit)
