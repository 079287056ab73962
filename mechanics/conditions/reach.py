"""Reach: the inverse problem has a solution."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.condition import Breach, Condition, TurnTest
from mechanics.configuration import Configuration
from mechanics.kernels import bands
from mechanics.kernels.line_ends import REACH
from mechanics.legs import STRUT
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Margins, Neighbourhood


class Reach(Condition):
    """Every leg's equation has a real solution."""

    reason = "reach"

    def __init__(self, mechanism: Mechanism) -> None:
        self.legs = tuple(range(mechanism.leg_count))
        self.line_tests = (REACH,) * mechanism.leg_count
        self.turn_tests = (TurnTest(bands.REACH),) * mechanism.leg_count

    def check(self, block: Configuration) -> Floats:
        """Return the margins of the leg equations. [m^2]"""
        return block.reach

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return 0 where legs certainly reach, below 0 where they certainly do not.

        The rod that would reach, nearest to a leg's own, differs by no more than the joint moves.
        """
        legs = near.centre.mechanism.legs
        missing = np.abs(near.centre.needed_rods - legs.rod_length[:, None])
        rodless = (legs.drive == STRUT)[:, None]
        return Margins(
            np.where(np.isfinite(near.swings), 0.0, -np.inf),
            np.where(rodless, np.inf, near.shifts - missing),
        )

    def explain(self, block: Configuration) -> Breach:
        """Return the rod length that would reach, beside the leg's own. [m]"""
        own = block.mechanism.legs.rod_length[:, None]
        return Breach(block.needed_rods, np.broadcast_to(own, block.needed_rods.shape))
