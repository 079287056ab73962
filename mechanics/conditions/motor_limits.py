"""Motor limits: every motor of a wrist stays between its stops."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import margin_between, nearest_bound
from mechanics.conditions.condition import Breach, Condition
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Margins, Neighbourhood


class MotorLimits(Condition):
    """Each motor of the wrist, if there is one, lies within its limits.

    A motor turns more than once, so what it stands at is held against them as it is.
    """

    reason = "actuator_limits"

    def __init__(self, mechanism: Mechanism) -> None:
        wrist = mechanism.wrist
        self._first = mechanism.leg_count
        self.legs = tuple(range(mechanism.leg_count, mechanism.drive_count))
        self._lower = np.empty((0, 1)) if wrist is None else wrist.lower_limit[:, None]
        self._upper = np.empty((0, 1)) if wrist is None else wrist.upper_limit[:, None]

    def check(self, block: Configuration) -> Floats:
        """Return how far inside its limits each motor is. [rad]"""
        return self.margins(block.actuators)

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return nothing of motors: what has a wrist has no bounds."""
        unknown = np.full((len(self.legs), near.centre.count), np.nan)
        return Margins(unknown, unknown)

    def explain(self, block: Configuration) -> Breach:
        """Return the motors' coordinates, and the limits nearest to them. [rad]"""
        return self.nearest(block.actuators)

    def margins(self, actuators: Floats) -> Floats:
        """Return how far inside its limits each motor is, shape (motors, rows). [rad]

        `actuators`, shape (drives, rows), has the legs' drives first.
        """
        return margin_between(actuators[self._first :], self._lower, self._upper)

    def nearest(self, actuators: Floats) -> Breach:
        """Return the motors' coordinates among all drives', and the limits nearest to them."""
        return nearest_bound(actuators[self._first :], self._lower, self._upper)
