"""A mechanism is a motion and the legs that make it."""

from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import GeometryError, PoseError, WorkingModeError
from mechanics.legs import STRUT, Legs
from mechanics.motions import Motion

WorkingMode = tuple[int, ...]


@dataclass(frozen=True)
class Mechanism:
    """A platform with as many driven legs as its motion has coordinates.

    Raises
    ------
    GeometryError : the number of legs is not the motion's number of coordinates.
    """

    motion: Motion
    legs: Legs

    def __post_init__(self) -> None:
        """Refuse legs that are too few or too many."""
        if self.leg_count != len(self.motion.coordinates):
            raise GeometryError(
                f"the motion {self.motion.name} has {len(self.motion.coordinates)} coordinates "
                f"and needs as many legs; given {self.leg_count}"
            )

    @property
    def leg_count(self) -> int:
        """How many legs there are."""
        return int(self.legs.drive.size)

    @property
    def working_modes(self) -> list[WorkingMode]:
        """All working modes, the signs of every leg, +1 before -1; a strut has no other than 1."""
        return list(product(*((1,) if d == STRUT else (1, -1) for d in self.legs.drive)))

    @property
    def characteristic_length(self) -> float:
        """The rms distance of the platform's joints from the reference point. [m]

        1 for mechanisms whose joints meet there, where no turn is measured with it.
        """
        points = self.legs.platform_point
        length = float(np.sqrt(np.mean(np.sum(points**2, axis=1))))
        return length or 1.0

    @property
    def coordinate_scales(self) -> Floats:
        """What makes Jx's columns comparable, shape (coordinates,): turns' length, else 1."""
        turning = np.array([c in self.motion.turns for c in self.motion.coordinates])
        return np.where(turning, self.characteristic_length, 1.0)

    def in_working_mode(self, signs: WorkingMode) -> "Mechanism":
        """Return the same mechanism with another branch of its inverse solution.

        Raises
        ------
        WorkingModeError : there is no such working mode.
        """
        if tuple(signs) not in self.working_modes:
            raise WorkingModeError(signs, self.leg_count)
        return replace(self, legs=self.legs._replace(working_mode=np.array(signs, dtype=float)))

    def columns(self, poses: Floats) -> Floats:
        """Return poses, given one a row, as the contiguous columns that kernels take.

        Raises
        ------
        PoseError : `poses` has another number of columns than the motion has coordinates.
        """
        poses = np.asarray(poses, dtype=float)
        if poses.ndim != 2 or poses.shape[1] != len(self.motion.coordinates):
            raise PoseError(poses.shape, self.motion.coordinates)
        return np.ascontiguousarray(poses.T)
