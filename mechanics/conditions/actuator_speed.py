"""Actuator speed: no drive turns faster than it can, wherever the platform is heading."""

from mechanics.arrays import Floats
from mechanics.conditions.bounds import at_most
from mechanics.conditions.condition import Breach, Condition
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Margins, Neighbourhood
from mechanics.velocity import Speed, greatest_rates, greatest_rates_near


class ActuatorSpeed(Condition):
    """The greatest rate of each drive is at most its limit, shape (drives,). [rad/s or m/s]"""

    reason = "actuator_speed"

    def __init__(self, mechanism: Mechanism, speed: Speed, limits: Floats) -> None:
        self.legs = tuple(range(mechanism.drive_count))
        self._speed = speed
        self._limits = limits[:, None]

    def check(self, block: Configuration) -> Floats:
        """Return how far below its limit each drive's greatest rate is. [rad/s or m/s]"""
        return self._limits - greatest_rates(block, self._speed)

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far below its limit each drive's greatest rate may be. [rad/s or m/s]"""
        least, greatest = greatest_rates_near(near, self._speed)
        return Margins(self._limits - greatest, self._limits - least)

    def explain(self, block: Configuration) -> Breach:
        """Return the drives' greatest rates, and their limits. [rad/s or m/s]"""
        return at_most(greatest_rates(block, self._speed), self._limits)
