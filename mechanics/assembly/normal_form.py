"""A platform on six rods as sixty numbers, and the way back from solutions to poses.

The equations are those of `mechanics.kernels.platform_equations`. Origins are the joints of the
longest rod, whose length is the unit; the axes of base and platform are those of their joints,
the one along which these spread least last.
"""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Complexes, Floats, Integers
from mechanics.assembly.rods import Rods
from mechanics.kernels import normal_form as kernels
from mechanics.kernels.quadrics import FRAME_SIGNS, SWAPPED


class NormalForm(NamedTuple):
    """A platform's equations and how they were scaled and turned.

    Parameters
    ----------
    coefficients : array, shape (5, 12): of S1, S2, D1, D2 and of the row that vanishes.
    base_axes, platform_axes : arrays, shape (3, 3), one axis a row.
    leg : the longest rod, whose length is the unit.
    rank : least over greatest singular value of the rows that were solved; 0 where base and
        platform are affinely related.
    """

    coefficients: Floats
    base_axes: Floats
    platform_axes: Floats
    leg: int
    rank: float

    @property
    def affine(self) -> bool:
        """Whether base and platform are affinely related: the equations then say too little."""
        return self.rank == 0.0


def normal_form(rods: Rods, turn: float = 0.0) -> NormalForm:
    """Return the platform's equations.

    Parameters
    ----------
    turn : by how much the axes of the base are turned back about the last, and, a little less,
        those of the platform on. [rad]
    """
    return NormalForm(*kernels.normal_form(rods.base, rods.platform, rods.lengths, turn))


def poses(rods: Rods, form: NormalForm, solutions: Floats) -> tuple[Floats, Floats]:
    """Return positions (3, solutions) and rotations (9, solutions) of real solutions. [m, -]"""
    ends = (rods.base[form.leg], rods.platform[form.leg])
    return kernels.real_poses(*form[:3], *ends, rods.lengths[form.leg], solutions)


def to_frames(solutions: Complexes) -> tuple[Floats, Integers]:
    """Return solutions e, S3, D3, shape (solutions, 6), each in the frame where e0 is largest.

    Scaled to e0 = 1 there: e1, e2, e3, S3, D3, real and imaginary parts in turns, shape
    (solutions, 10), and the number of the frame.
    """
    frames = np.argmax(np.abs(solutions[:, :4]), axis=1)
    turned = _turn_by(solutions, frames)
    scaled = turned[:, 1:] / turned[:, :1]
    scaled[:, 3:] /= turned[:, :1]
    return scaled.view(float), frames


def _turn_by(solutions: Complexes, frames: Integers) -> Complexes:
    places = np.arange(4) ^ frames[:, None]
    turned = solutions.copy()
    turned[:, :4] = np.take_along_axis(solutions, places, axis=1) * FRAME_SIGNS[frames]
    turned[:, 4:] = np.where(SWAPPED[frames, None], solutions[:, :3:-1], solutions[:, 4:])
    return turned
