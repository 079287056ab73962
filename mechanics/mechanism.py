"""A mechanism is a motion and the legs that make it, with a wrist or without."""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import GeometryError, PoseError, WorkingModeError
from mechanics.legs import STRUT, Legs
from mechanics.motions import TRANSLATION, Motion
from mechanics.wrists import Wrist

WorkingMode = tuple[int, ...]


@dataclass(frozen=True)
class Mechanism:
    """A platform with as many drives as its motion has coordinates: one a leg, then a wrist's.

    Legs under a wrist end in its centre, a point of the platform like any other; that they carry
    something which does not turn shows where their joints really are. A wrist makes all turns, so
    the motion is spatial.

    Raises
    ------
    GeometryError : the number of drives is not the motion's number of coordinates.
    """

    motion: Motion
    legs: Legs
    wrist: Wrist | None = None

    def __post_init__(self) -> None:
        """Refuse drives that are too few or too many."""
        if self.drive_count != len(self.motion.coordinates):
            raise GeometryError(
                f"the motion {self.motion.name} has {len(self.motion.coordinates)} coordinates "
                f"and needs as many legs; given {self.drive_count}"
            )

    @property
    def leg_count(self) -> int:
        """How many legs there are."""
        return int(self.legs.drive.size)

    @property
    def drive_count(self) -> int:
        """How many drives there are: those of the legs, then the motors of the wrist."""
        return self.leg_count + self._motor_count

    @property
    def _motor_count(self) -> int:
        return 0 if self.wrist is None else len(self.wrist.gains)

    @property
    def working_modes(self) -> list[WorkingMode]:
        """All working modes, the signs of every drive, +1 before -1.

        A strut has no other than 1, nor has a motor of the wrist.
        """
        branches = [(1,) if d == STRUT else (1, -1) for d in self.legs.drive]
        return list(product(*branches, *[(1,)] * self._motor_count))

    @property
    def working_mode(self) -> WorkingMode:
        """The signs of every drive in which the inverse problem is solved."""
        return (*(int(sign) for sign in self.legs.working_mode), *(1,) * self._motor_count)

    @property
    def base_joints(self) -> Floats:
        """Where the legs' base points really are, shape (legs, 3). [m]"""
        return self.legs.base_point + self._joints

    @property
    def platform_joints(self) -> Floats:
        """The legs' joints on what they carry, apart from each other as they really are. [m]"""
        return self.legs.platform_point + self._joints

    @property
    def _joints(self) -> Floats:
        return np.zeros((self.leg_count, 3)) if self.wrist is None else self.wrist.joints

    @property
    def carrier(self) -> "Mechanism":
        """The translation of the wrist's centre, which the legs alone make."""
        ends = np.zeros_like(self.legs.platform_point)
        return Mechanism(TRANSLATION, self.legs._replace(platform_point=ends))

    @cached_property
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
            raise WorkingModeError(signs, self.drive_count)
        own = np.array(signs[: self.leg_count], dtype=float)
        return replace(self, legs=self.legs._replace(working_mode=own))

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
