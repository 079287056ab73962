"""The angle between two rods that share a joint of the platform."""

from itertools import combinations

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import angles_between, margin_between, nearest_bound
from mechanics.conditions.condition import Breach, Condition
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import SLACK, Margins, Neighbourhood, within


def rods_at_shared_joints(mechanism: Mechanism) -> list[tuple[int, int]]:
    """Return the pairs of legs whose rods end in one point of the platform."""
    points = mechanism.platform_joints
    scale = max(1e-9, float(np.max(np.abs(points))), float(mechanism.legs.rod_length.max()))
    return [
        (i, j)
        for i, j in combinations(range(len(points)), 2)
        if np.linalg.norm(points[i] - points[j]) <= 1e-9 * scale
    ]


class RodRodAngle(Condition):
    """The angle between the rods at each shared joint, 0 folded, is within bounds. [rad]"""

    reason = "rod_rod_angle"

    def __init__(self, mechanism: Mechanism, lower: float, upper: float) -> None:
        pairs = rods_at_shared_joints(mechanism)
        self.legs = tuple(i for i, _ in pairs)
        self.partners = tuple(j for _, j in pairs)
        self._first = [i for i, _ in pairs]
        self._second = [j for _, j in pairs]
        self._lower = lower
        self._upper = upper

    def check(self, block: Configuration) -> Floats:
        """Return how far inside its bounds the angle at each shared joint is. [rad]"""
        return margin_between(self._angles(block), self._lower, self._upper)

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far inside its bounds the angle at each shared joint may be. [rad]"""
        turned = near.swings[self._first] + near.swings[self._second]
        return within(self.check(near.centre), turned * (1.0 + SLACK) + SLACK)

    def explain(self, block: Configuration) -> Breach:
        """Return the angles at the shared joints and the bounds nearest to them. [rad]"""
        return nearest_bound(self._angles(block), self._lower, self._upper)

    def _angles(self, block: Configuration) -> Floats:
        directions = block.rods[0]
        return angles_between(directions[self._first], directions[self._second])
