"""A block of poses of a mechanism, and everything about them, each thing computed once."""

from functools import cached_property

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.kernels import batches, cofactors, efforts, jacobians, legs, pressure, spectra
from mechanics.kernels.placing import gather
from mechanics.mechanism import Mechanism

SINGULAR = 1e-10
"""A pose counts as of type 2 where the inverse condition number is not above this."""


class Configuration:
    """The drives of a mechanism at a block of poses; what nobody asks for is not computed.

    Every array carries the poses on its last axis. A leg that cannot reach has NaN, and so
    has what needs all legs.

    Parameters
    ----------
    mechanism : the mechanism, in its working mode.
    poses : array, shape (coordinates, poses), contiguous. [m, rad]
    """

    def __init__(self, mechanism: Mechanism, poses: Floats) -> None:
        self.mechanism = mechanism
        self.poses = poses

    @property
    def count(self) -> int:
        """How many poses there are."""
        return int(self.poses.shape[1])

    def has(self, name: str) -> bool:
        """Return whether the property of this name is already computed."""
        return name in vars(self)

    def take(self, chosen: Booleans) -> "Configuration":
        """Return the chosen poses, shape (poses,), with all that is already computed of them."""
        taken = Configuration(self.mechanism, self.poses)
        indices = np.flatnonzero(chosen)
        for name, value in vars(self).items():
            if isinstance(value, np.ndarray):
                vars(taken)[name] = _columns(value, indices)
            elif isinstance(value, tuple):
                vars(taken)[name] = tuple(_columns(part, indices) for part in value)
        return taken

    def _array(self, *shape: int) -> Floats:
        return np.empty((*shape, self.count))

    @property
    def _legs(self) -> int:
        return self.mechanism.leg_count

    @property
    def _drives(self) -> int:
        return self.mechanism.drive_count

    @property
    def _angles(self) -> Floats:
        """The angles rx, ry, rz of a platform on a wrist, shape (3, poses). [rad]"""
        return self.poses[-3:]

    @cached_property
    def placement(self) -> tuple[Floats, Floats]:
        """Positions, shape (3, poses), and rotations, shape (9, poses) row by row. [m, -]"""
        return self.mechanism.motion.place(self.poses)

    @cached_property
    def attachment(self) -> tuple[Floats, Floats]:
        """Arms rho and spans d = c - A of the legs, shape (legs, 3, poses) each. [m]"""
        arms, spans = self._array(self._legs, 3), self._array(self._legs, 3)
        legs.attach(self.mechanism.legs, *self.placement, arms, spans)
        return arms, spans

    @cached_property
    def reach(self) -> Floats:
        """By how much each leg's equation is solvable, shape (legs, poses); < 0: not. [m^2]"""
        margins = self._array(self._legs)
        legs.reach_margins(self.mechanism.legs, self.attachment[1], margins)
        return margins

    @cached_property
    def needed_rods(self) -> Floats:
        """The rod, nearest to the leg's own, that would reach, shape (legs, poses). [m]"""
        needed = self._array(self._legs)
        legs.needed_rods(self.mechanism.legs, self.attachment[1], needed)
        return needed

    @cached_property
    def travel(self) -> Floats:
        """Cosine and sine of cranks, coordinate of rails and struts, shape (legs, 2, poses)."""
        travel = self._array(self._legs, 2)
        legs.travels(self.mechanism.legs, self.attachment[1], travel)
        return travel

    @cached_property
    def actuators(self) -> Floats:
        """Drive coordinates, shape (drives, poses); crank angles in (-pi, pi]. [rad or m]"""
        values = self._array(self._drives)
        own = values[: self._legs]
        if self.has("travel"):
            legs.coordinates(self.mechanism.legs, self.travel, own)
        else:
            motion = self.mechanism.motion
            batches.actuators(motion.kernel, self.mechanism.legs, self.poses, own)
        if self.mechanism.wrist is not None:
            values[self._legs :] = self.mechanism.wrist.motors(self._angles)
        return values

    @cached_property
    def rods(self) -> tuple[Floats, Floats]:
        """Rod directions u, shape (legs, 3, poses), and the legs' part of Jpsi. [-, m or -]"""
        directions, rates = self._array(self._legs, 3), self._array(self._legs)
        legs.rods(self.mechanism.legs, self.attachment[1], self.travel, directions, rates)
        return directions, rates

    @cached_property
    def platform_jacobians(self) -> Floats:
        """Jx, shape (drives, coordinates, poses). [- for translations, m for turns]

        A wrist holds the turns one by one, measured at the characteristic length like those of
        the legs; which motor turns how is then in Jpsi. So det Jx is 0 where the legs lose hold,
        and not where motors cannot turn the platform every way.
        """
        twists = self.mechanism.motion.twists
        rows = self._array(self._drives, twists.shape[1])
        own = rows[: self._legs]
        jacobians.platform_jacobians(twists, self.rods[0], self.attachment[0], own)
        if self.mechanism.wrist is not None:
            held = self.mechanism.characteristic_length * twists[3:]
            rows[self._legs :] = held[:, :, None]
        return rows

    @cached_property
    def cofactors(self) -> tuple[Floats, Floats]:
        """Cofactors of Jx, shape (drives, coordinates, poses), and det Jx, shape (poses,)."""
        matrices = self.platform_jacobians
        adjugates, determinants = np.empty_like(matrices), self._array()
        cofactors.write_cofactors(matrices, adjugates, determinants)
        return adjugates, determinants

    @property
    def determinants(self) -> Floats:
        """Det Jx, shape (poses,). [m to the number of turns]"""
        return self.cofactors[1]

    @cached_property
    def rate_rows(self) -> tuple[Floats, Floats]:
        """Rows of J, shape (drives, coordinates, poses), and what each is to be divided by.

        The divisors, shape (drives, poses), are 0 where a drive cannot move the platform.
        """
        if self.mechanism.wrist is None:
            return self.platform_jacobians, self.rods[1]
        rows, divisors = self.platform_jacobians.copy(), self._array(self._drives)
        divisors[: self._legs] = self.rods[1]
        rows[self._legs :, 3:], divisors[self._legs :] = self.mechanism.wrist.rates(self._angles)
        return rows, divisors

    @cached_property
    def twist_columns(self) -> tuple[Floats, Floats]:
        """Columns of J^-1, shape (drives, coordinates, poses), and what each is a multiple of.

        The factors, shape (drives, poses), are still to be divided by det Jx. The same columns
        are the rows of J^-T, finite where drives cannot move the platform.
        """
        adjugates, rates = self.cofactors[0], self.rods[1]
        if self.mechanism.wrist is None:
            return adjugates, rates
        columns, factors = adjugates.copy(), np.ones((self._drives, self.count))
        factors[: self._legs] = rates
        held = self.mechanism.characteristic_length * self.mechanism.wrist.turns(self._angles)
        columns[self._legs :] = np.einsum("jin,jcn->icn", held, adjugates[self._legs :])
        return columns, factors

    @cached_property
    def condition_numbers(self) -> Floats:
        """Of Jx with turns at the characteristic length, shape (poses,); inf where singular.

        Singular is what has an inverse condition number of `SINGULAR` or less.
        """
        numbers = self._array()
        scales = self.mechanism.coordinate_scales
        spectra.condition_numbers(self.platform_jacobians, scales, numbers)
        numbers[numbers >= 1.0 / SINGULAR] = np.inf
        return numbers

    @cached_property
    def pressure_angles(self) -> Floats:
        """Pressure angles, shape (drives, poses), within [0, pi/2]. [rad]

        With all other drives braked, drive i moves the platform by J^-1 e_i; its pressure angle
        is between the velocity of the leg's joint on the platform and the line of the rod's
        force. At a type 2 singularity the platform's free motion takes its place. For an arc the
        force acts along the great circle from the platform's axis to the intermediate one.
        """
        angles = self._array(self._drives)
        if self.mechanism.wrist is not None:
            angles[self._legs :] = self.mechanism.wrist.pressure_angles(self._angles)
        pressure.pressure_angles(
            self.mechanism.motion.twists,
            self.mechanism.legs.joints,
            self.cofactors[0],
            self.rods[0],
            self.attachment[0],
            angles[: self._legs],
        )
        return angles

    @cached_property
    def effort_rows(self) -> Floats:
        """Rows of J^-T as wrenches, shape (drives, 6, poses), forces before moments."""
        rows = self._array(self._drives, 6)
        columns, factors = self.twist_columns
        twists = self.mechanism.motion.twists
        efforts.effort_rows(columns, self.determinants, factors, twists, rows)
        return rows


def _columns(values: Floats, chosen: Integers) -> Floats:
    *own, count = values.shape
    return gather(values.reshape(-1, count), chosen).reshape(*own, chosen.size)
