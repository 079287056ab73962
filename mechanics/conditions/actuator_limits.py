"""Actuator limits: every leg's drive stays between its stops."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import margin_between, nearest_bound
from mechanics.conditions.condition import Breach, Condition, TurnTest
from mechanics.configuration import Configuration
from mechanics.kernels import bands
from mechanics.kernels.line_ends import LIMITS, NOTHING
from mechanics.kernels.waves import TURN
from mechanics.legs import CRANK
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import SLACK, Margins, Neighbourhood, within


class ActuatorLimits(Condition):
    """Each drive lies within its leg's limits; of a crank, its angle in some turn."""

    reason = "actuator_limits"

    def __init__(self, mechanism: Mechanism) -> None:
        legs = mechanism.legs
        self.legs = tuple(range(mechanism.leg_count))
        self._lower = legs.lower_limit[:, None]
        self._upper = legs.upper_limit[:, None]
        turning = (legs.drive == CRANK)[:, None]
        both_stops = np.isfinite(self._upper) & np.isfinite(self._lower)
        # With one stop or none, some turn of a crank is always free.
        self._free = turning & ~both_stops
        self._turned = turning & both_stops
        self.line_tests = tuple(NOTHING if free else LIMITS for free in self._free[:, 0])
        self.turn_tests = tuple(
            TurnTest(bands.NOTHING if free else bands.LIMITS) for free in self._free[:, 0]
        )
        ends = np.where(self._turned, [self._lower, self._upper], 0.0)
        self._middle = 0.5 * (ends[0] + ends[1])

    def check(self, block: Configuration) -> Floats:
        """Return how far inside its limits each drive is. [rad or m]"""
        return self.margins(block.actuators)

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far inside its limits each drive may be. [rad or m]"""
        return within(self.check(near.centre), near.strokes * (1.0 + SLACK) + SLACK)

    def explain(self, block: Configuration) -> Breach:
        """Return the drive, a crank in the turn nearest to its limits, and the limit."""
        return self.nearest(block.actuators)

    def margins(self, actuators: Floats) -> Floats:
        """Return how far inside its limits each leg's drive is, shape (legs, rows). [rad or m]

        `actuators`, shape (drives, rows), has a wrist's motors too, if there are any.
        """
        own = actuators[: len(self.legs)]
        margins = margin_between(self._nearest_turns(own), self._lower, self._upper)
        unbounded = np.where(np.isnan(own), np.nan, np.inf)
        return np.where(self._free, unbounded, margins)

    def nearest(self, actuators: Floats) -> Breach:
        """Return drive coordinates, of cranks in the turn nearest to their limits, and those."""
        own = actuators[: len(self.legs)]
        return nearest_bound(self._nearest_turns(own), self._lower, self._upper)

    def _nearest_turns(self, values: Floats) -> Floats:
        """Return the turn of each angle that lies deepest inside, or least outside, its limits."""
        turns = np.where(self._turned, np.round((self._middle - values) / TURN), 0.0)
        turned: Floats = values + TURN * turns
        return turned
