"""The angle between crank and rod: no leg folds or stretches too far."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import margin_between, nearest_bound, products
from mechanics.conditions.condition import Breach, Condition, TurnTest
from mechanics.configuration import Configuration
from mechanics.kernels import bands
from mechanics.legs import ARC_JOINTS, CRANK
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Margins, Neighbourhood


def legs_with_elbows(mechanism: Mechanism) -> list[int]:
    """Return the legs that have a crank and a rod."""
    legs = mechanism.legs
    return np.flatnonzero((legs.drive == CRANK) & (legs.joints != ARC_JOINTS)).tolist()


class CrankRodAngle(Condition):
    """The inside angle at each elbow, 0 folded and pi stretched, is within bounds. [rad]"""

    reason = "crank_rod_angle"

    def __init__(self, mechanism: Mechanism, lower: float, upper: float) -> None:
        self.legs = tuple(legs_with_elbows(mechanism))
        self._lower = lower
        self._upper = upper
        self.turn_tests = tuple(self._turn_test(mechanism, k) for k in self.legs)

    def check(self, block: Configuration) -> Floats:
        """Return how far inside its bounds each elbow's angle is. [rad]"""
        return margin_between(self._angles(block), self._lower, self._upper)

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far inside its bounds each elbow's angle may be. [rad]"""
        chosen = list(self.legs)
        least, greatest = (self._bent(near.centre.mechanism, squares) for squares in near.squares)
        reached = np.where(np.isfinite(near.swings[chosen]), 0.0, np.nan)
        return Margins(
            np.minimum(least - self._lower, self._upper - greatest) + reached,
            np.minimum(greatest - self._lower, self._upper - least),
        )

    def explain(self, block: Configuration) -> Breach:
        """Return the elbows' angles and the bounds nearest to them. [rad]"""
        return nearest_bound(self._angles(block), self._lower, self._upper)

    def _turn_test(self, mechanism: Mechanism, k: int) -> TurnTest:
        crank, rod = mechanism.legs.crank_length[k], mechanism.legs.rod_length[k]

        def square(angle: float) -> float:
            return float(crank**2 + rod**2 - 2.0 * crank * rod * np.cos(angle))

        # What no elbow can pass is left out: rounding has no say in it.
        least = square(self._lower) if self._lower > 0.0 else -np.inf
        greatest = square(self._upper) if self._upper < np.pi else np.inf
        return TurnTest(bands.SPAN, least, greatest)

    def _angles(self, block: Configuration) -> Floats:
        spans = block.attachment[1]
        angles = self._bent(block.mechanism, products(spans, spans))
        return np.where(block.reach[list(self.legs)] >= 0.0, angles, np.nan)

    def _bent(self, mechanism: Mechanism, squares: Floats) -> Floats:
        """Return the elbows' angles at which |d|^2, shape (legs, poses), is so much. [rad]"""
        # By the law of cosines in the triangle A, B, c: the same in both working modes.
        chosen = list(self.legs)
        legs = mechanism.legs
        crank, rod = legs.crank_length[chosen, None], legs.rod_length[chosen, None]
        cosines = (crank**2 + rod**2 - squares[chosen]) / (2.0 * crank * rod)
        angles: Floats = np.arccos(np.clip(cosines, -1.0, 1.0))
        return angles
