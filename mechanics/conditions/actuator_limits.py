"""Actuator limits: every drive stays between its stops."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import margin_between, nearest_bound
from mechanics.conditions.condition import Breach, Condition
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism

TURN = 2.0 * np.pi


class ActuatorLimits(Condition):
    """Some turn psi + 2 pi k of each crank lies within the leg's limits."""

    reason = "actuator_limits"

    def __init__(self, mechanism: Mechanism) -> None:
        self.legs = tuple(range(mechanism.leg_count))
        self._lower = mechanism.legs.lower_limit[:, None]
        self._upper = mechanism.legs.upper_limit[:, None]
        # With one stop or none, some turn of a crank is always free.
        self._bounded = np.isfinite(self._upper) & np.isfinite(self._lower)
        ends = np.where(self._bounded, [self._lower, self._upper], 0.0)
        self._middle = 0.5 * (ends[0] + ends[1])

    def check(self, block: Configuration) -> Floats:
        """Return how far inside its limits each drive is. [rad]"""
        margins = margin_between(self._nearest_turns(block), self._lower, self._upper)
        free = np.where(np.isnan(block.actuators), np.nan, np.inf)
        return np.where(self._bounded, margins, free)

    def explain(self, block: Configuration) -> Breach:
        """Return the crank angle, in the turn nearest to its limits, and the limit. [rad]"""
        return nearest_bound(self._nearest_turns(block), self._lower, self._upper)

    def _nearest_turns(self, block: Configuration) -> Floats:
        """Return the turn of each angle that lies deepest inside, or least outside, its limits."""
        angles = block.actuators
        turned: Floats = angles + TURN * np.round((self._middle - angles) / TURN)
        return turned
