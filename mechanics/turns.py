"""One turn of the platform, over which conditions are asked together."""

from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.placing import move
from mechanics.motions import Motion
from mechanics.rotations import fixed_axis_angles


@dataclass(frozen=True)
class Turn:
    """One turn of the platform, from `low` to `high`, at most a whole turn apart. [rad]

    Parameters
    ----------
    motion : what the platform does.
    coordinate : the turn's name.
    column : which of the motion's coordinates it is; None: a spin about the platform's own z
        axis, added to what the three angles of a spherical motion say.
    step : the largest between two angles at which conditions without closed forms are looked at,
        before it is sought where between them their verdicts change. [rad]
    """

    motion: Motion
    coordinate: str
    column: int | None
    low: float
    high: float
    step: float

    def places(self, poses: Floats) -> tuple[Floats, Floats, Floats]:
        """Return where the platform is while the angle of this turn is 0, and the turn's axis.

        Parameters
        ----------
        poses : array, shape (coordinates, poses); what they say of this turn does not matter.

        Returns
        -------
        positions, rotations, axes
            Arrays, shapes (3, poses), (9, poses) row by row and (3, poses), the last two with
            one column if that stands for all. [m, -, -]
        """
        return self.positions(poses), *self.frames(poses)

    def positions(self, poses: Floats) -> Floats:
        """Return where the reference point is, shape (3, poses). [m]"""
        positions: Floats = move(self.motion.twists, np.ascontiguousarray(poses))
        return positions

    def frames(self, poses: Floats) -> tuple[Floats, Floats]:
        """Return the rotations and axes of `places`; a pose's do not depend on its company."""
        if self.column is None:
            rotations = self.motion.place(poses)[1]
            return rotations, np.ascontiguousarray(rotations[[2, 5, 8]])
        turns = np.delete(poses, self.column, axis=0)[len(self.motion.translations) :]
        alike = not turns.size or bool(np.all(turns == turns[:, :1]))
        first = poses[:, :1].copy() if alike else poses.copy()
        first[self.column] = 0.0
        rotations = self.motion.place(first)[1]
        quarter = first.copy()
        quarter[self.column] = 0.5 * np.pi
        one, other = rotations.reshape(3, 3, -1), self.motion.place(quarter)[1].reshape(3, 3, -1)
        # A quarter turn about n is n n' + [n], of which the second part is antisymmetric.
        i, j = np.array([2, 0, 1]), np.array([1, 2, 0])
        axes = 0.5 * (_product(other, one, i, j) - _product(other, one, j, i))
        return rotations, np.ascontiguousarray(axes)

    def poses(self, poses: Floats, owners: Integers, angles: Floats) -> Floats:
        """Return the poses, shape (coordinates, angles), that this turn makes of its owners."""
        turned = poses[:, owners]
        if self.column is not None:
            turned[self.column] = angles
            return np.ascontiguousarray(turned)
        rotations = self.motion.place(np.ascontiguousarray(turned))[1].reshape(3, 3, -1)
        c, s = np.cos(angles), np.sin(angles)
        x, y = rotations[:, 0].copy(), rotations[:, 1].copy()
        rotations[:, 0], rotations[:, 1] = c * x + s * y, c * y - s * x
        return fixed_axis_angles(rotations.reshape(9, -1))


def _product(one: Floats, other: Floats, rows: Integers, columns: Integers) -> Floats:
    """Return elements of one times the transpose of the other, summed in the same order always."""
    terms = [one[rows, k] * other[columns, k] for k in range(3)]
    total: Floats = terms[0] + terms[1] + terms[2]
    return total
