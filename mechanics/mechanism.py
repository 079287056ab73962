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
