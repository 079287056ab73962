"""Reach: the inverse problem has a solution."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.condition import Breach, Condition, TurnTest
from mechanics.configuration import Configuration
from mechanics.kernels import bands
from mechanics.kernels.line_ends import REACH
from mechanics.mechanism import Mechanism


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

    def explain(self, block: Configuration) -> Breach:
        """Return the rod length that would reach, beside the leg's own. [m]"""
        own = block.mechanism.legs.rod_length[:, None]
        return Breach(block.needed_rods, np.broadcast_to(own, block.needed_rods.shape))
