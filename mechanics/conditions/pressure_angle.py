"""Pressure angle: every drive pushes its joint on the platform nearly where that can go."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import at_most
from mechanics.conditions.condition import Breach, Condition
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Margins, Neighbourhood


class PressureAngle(Condition):
    """The pressure angle of each drive is at most a limit. [rad]"""

    reason = "pressure_angle"
    fails_at_singularities = True

    def __init__(self, mechanism: Mechanism, limit: float) -> None:
        self.legs = tuple(range(mechanism.drive_count))
        self._limit = limit
        self._cosine = float(np.cos(limit))

    def check(self, block: Configuration) -> Floats:
        """Return how far below the limit each pressure angle is. [rad]"""
        return self._limit - block.pressure_angles

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far the cosine of each pressure angle may be above that of the limit."""
        least, greatest = near.pressure_cosines
        return Margins(least - self._cosine, greatest - self._cosine)

    def explain(self, block: Configuration) -> Breach:
        """Return the pressure angles, and the limit. [rad]"""
        return at_most(block.pressure_angles, self._limit)
