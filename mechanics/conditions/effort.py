"""Effort: no drive bears more than its limit, whatever the direction of the load."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.condition import Breach, Condition
from mechanics.configuration import Configuration
from mechanics.effort import worst_efforts, worst_efforts_near
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Margins, Neighbourhood


class Effort(Condition):
    """The greatest effort of each drive is at most its limit, shape (drives,). [N m or N]"""

    reason = "effort"
    quick = True
    fails_at_singularities = True

    def __init__(self, mechanism: Mechanism, load: Load, limits: Floats) -> None:
        self.legs = tuple(range(mechanism.drive_count))
        self._load = load
        self._limits = limits[:, None]

    def check(self, block: Configuration) -> Floats:
        """Return how far below its limit each drive's greatest effort is. [N m or N]"""
        return self._limits - worst_efforts(block, self._load)

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far below its limit each drive's greatest effort may be. [N m or N]"""
        least, greatest = worst_efforts_near(near, self._load)
        return Margins(self._limits - greatest, self._limits - least)

    def explain(self, block: Configuration) -> Breach:
        """Return the drives' greatest efforts and their limits. [N m or N]"""
        values = worst_efforts(block, self._load)
        return Breach(values, np.broadcast_to(self._limits, values.shape))
