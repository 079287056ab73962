"""Legs whose drives stand still: where their rods begin, and what they ask of a pose."""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.kernels import jacobians, legs
from mechanics.kernels.cofactors import write_cofactors
from mechanics.legs import CRANK, RAIL, STRUT
from mechanics.mechanism import Mechanism

_LEAST_ROD = 1e-9
"""A strut shorter than this has no direction. [m]"""


class LegErrors(NamedTuple):
    """How far a block of poses is from closing the legs.

    Parameters
    ----------
    excess : array, shape (legs, poses): distance of c from B less the rod's length. [m]
    sides : array, shape (legs, poses): what Jx times a small twist must be to make up for it.
    rows : array, shape (legs, coordinates, poses): Jx.
    drive_rates : array, shape (legs, poses): the diagonal of Jpsi.
    """

    excess: Floats
    sides: Floats
    rows: Floats
    drive_rates: Floats


class BrakedLegs:
    """The legs of a mechanism with their drives at given coordinates, one column a case.

    Parameters
    ----------
    mechanism : the mechanism; its working mode does not matter.
    actuators : array, shape (legs, cases). [rad or m]
    """

    def __init__(self, mechanism: Mechanism, actuators: Floats) -> None:
        self.mechanism = mechanism
        self.actuators = np.ascontiguousarray(actuators)
        of = mechanism.legs
        cranks = np.flatnonzero(of.drive == CRANK)
        # Nothing turns by what is no angle; such cases are not `possible`.
        angles = np.where(np.isfinite(actuators[cranks]), actuators[cranks], 0.0)
        self._travel = np.stack([self.actuators, np.zeros_like(self.actuators)], axis=1)
        self._travel[cranks, 0], self._travel[cranks, 1] = np.cos(angles), np.sin(angles)
        struts = (of.drive == STRUT)[:, None]
        self.rod_lengths = np.where(struts, actuators, of.rod_length[:, None])
        self._scales = np.where(struts, actuators, of.rod_scale[:, None])

    def take(self, cases: Integers) -> "BrakedLegs":
        """Return the legs at the chosen cases, in their order."""
        return BrakedLegs(self.mechanism, self.actuators[:, cases])

    @property
    def possible(self) -> Booleans:
        """Whether drives can stand so, shape (cases,): finite, and struts of some length."""
        sound = np.isfinite(self.actuators) & (self.rod_lengths >= _LEAST_ROD)
        possible: Booleans = np.all(sound, axis=0)
        return possible

    @cached_property
    def rod_starts(self) -> Floats:
        """The ends B of the rods that the drives move, shape (legs, 3, cases). [m]"""
        of = self.mechanism.legs
        c, s = self._travel[:, 0, None], self._travel[:, 1, None]
        e, f = of.zero_direction[:, :, None], of.quarter_direction[:, :, None]
        r, drive = of.crank_length[:, None, None], of.drive[:, None, None]
        moved = np.where(drive == CRANK, r * (e * c + f * s), 0.0)
        moved = np.where(drive == RAIL, of.axis[:, :, None] * c, moved)
        starts: Floats = of.base_point[:, :, None] + moved
        return starts

    @property
    def sizes(self) -> Floats:
        """The greatest length that takes part, shape (cases,): what rounding is held against."""
        of = self.mechanism.legs
        joints = np.linalg.norm(of.platform_point, axis=1).max()
        starts = np.linalg.norm(self.rod_starts, axis=1).max(axis=0)
        longest = np.maximum(self.rod_lengths.max(axis=0), of.crank_length.max())
        sizes: Floats = np.maximum(np.maximum(starts, longest), joints)
        return sizes

    @property
    def extents(self) -> Floats:
        """The greatest length wherever the mechanism stands, shape (cases,): what it can span."""
        of, starts = self.mechanism.legs, self.rod_starts
        joints = np.linalg.norm(of.platform_point - of.platform_point[0], axis=1).max()
        apart = np.linalg.norm(starts - starts[:1], axis=1).max(axis=0)
        longest = np.maximum(self.rod_lengths.max(axis=0), of.crank_length.max())
        extents: Floats = np.maximum(np.maximum(apart, longest), joints)
        return extents

    def errors(self, poses: Floats) -> LegErrors:
        """Return by how much the legs do not close, one pose a case, shape (coordinates, cases).

        Jx belongs to the leg equations |c - B|^2 = L^2, and the sides to |c - B| = L: the screws
        that close the legs are the same, and paper 002's iteration is the latter.

        References
        ----------
        Glazunov et al., the iterative solution of the direct problem.
        """
        of, twists = self.mechanism.legs, self.mechanism.motion.twists
        count, cases = of.drive.size, poses.shape[1]
        arms, spans, directions = (np.empty((count, 3, cases)) for _ in range(3))
        rates = np.empty((count, cases))
        legs.attach(of, *self.mechanism.motion.place(poses), arms, spans)
        legs.rods(of, spans, self._travel, directions, rates)
        rows = np.empty((count, twists.shape[1], cases))
        jacobians.platform_jacobians(twists, directions, arms, rows)
        lengths = self._scales * np.sqrt(np.sum(directions**2, axis=1))
        excess = lengths - self.rod_lengths
        return LegErrors(excess, -excess * lengths / self._scales, rows, rates)


def determinants(rows: Floats) -> Floats:
    """Return det Jx, shape (poses,), as `Configuration` does. [m to the number of turns]"""
    found = np.empty(rows.shape[2])
    write_cofactors(np.ascontiguousarray(rows), np.empty_like(rows), found)
    return found
