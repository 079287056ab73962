"""A block of poses of a mechanism, and everything about them, each thing computed once."""

from functools import cached_property

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.kernels import efforts, jacobians, legs
from mechanics.mechanism import Mechanism


class Configuration:
    """The legs of a mechanism at a block of poses; what nobody asks for is not computed.

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

    def take(self, chosen: Booleans) -> "Configuration":
        """Return the chosen poses, shape (poses,), with all that is already computed of them."""
        taken = Configuration(self.mechanism, self.poses)
        for name, value in vars(self).items():
            if isinstance(value, np.ndarray):
                vars(taken)[name] = np.ascontiguousarray(value[..., chosen])
            elif isinstance(value, tuple):
                vars(taken)[name] = tuple(np.ascontiguousarray(v[..., chosen]) for v in value)
        return taken

    @cached_property
    def attachment(self) -> tuple[Floats, Floats]:
        """Arms rho and spans d = c - A of the legs, shape (legs, 3, poses) each. [m]"""
        return legs.attach(self.mechanism.legs, *self.mechanism.motion.place(self.poses))

    @cached_property
    def reach(self) -> Floats:
        """By how much each leg's equation is solvable, shape (legs, poses); < 0: not. [m^2]"""
        return legs.reach_margins(self.mechanism.legs, self.attachment[1])

    @cached_property
    def needed_rods(self) -> Floats:
        """The rod, nearest to the leg's own, that would reach, shape (legs, poses). [m]"""
        return legs.needed_rods(self.mechanism.legs, self.attachment[1])

    @cached_property
    def cranks(self) -> tuple[Floats, Floats]:
        """Cosines and sines of the crank angles, shape (legs, poses) each."""
        return legs.cranks(self.mechanism.legs, self.attachment[1])

    @cached_property
    def actuators(self) -> Floats:
        """Drive coordinates, shape (legs, poses); crank angles in (-pi, pi]. [rad]"""
        return legs.angles(*self.cranks)

    @cached_property
    def rods(self) -> tuple[Floats, Floats]:
        """Rod directions u, shape (legs, 3, poses), and the diagonal of Jpsi. [-, m]"""
        return legs.rods(self.mechanism.legs, self.attachment[1], *self.cranks)

    @cached_property
    def platform_jacobians(self) -> Floats:
        """Jx, shape (legs, coordinates, poses). [- for translations, m for turns]"""
        twists = self.mechanism.motion.twists
        return jacobians.platform_jacobians(twists, self.rods[0], self.attachment[0])

    @cached_property
    def cofactors(self) -> tuple[Floats, Floats]:
        """Cofactors of Jx, shape (legs, coordinates, poses), and det Jx, shape (poses,)."""
        return jacobians.cofactors(self.platform_jacobians)

    @property
    def determinants(self) -> Floats:
        """Det Jx, shape (poses,). [m to the number of turns]"""
        return self.cofactors[1]

    @cached_property
    def effort_rows(self) -> Floats:
        """Rows of J^-T as wrenches, shape (drives, 6, poses), forces before moments."""
        return efforts.effort_rows(*self.cofactors, self.rods[1], self.mechanism.motion.twists)
