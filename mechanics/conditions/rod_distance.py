"""The distance between rods: none comes so near to another that they touch."""

from itertools import combinations

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import nearest_bound
from mechanics.conditions.condition import Breach, Condition
from mechanics.conditions.rod_rod_angle import rods_at_shared_joints
from mechanics.configuration import Configuration
from mechanics.kernels.segments import distances
from mechanics.legs import ARC_JOINTS, STRUT
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import SLACK, Margins, Neighbourhood, within
from mechanics.skeletons import joints


def separate_rods(mechanism: Mechanism) -> list[tuple[int, int]]:
    """Return the pairs of legs with straight rods that share no joint, on platform or base."""
    legs = mechanism.legs
    straight = np.flatnonzero(legs.joints != ARC_JOINTS).tolist()
    joined = set(rods_at_shared_joints(mechanism))
    scale = max(1e-9, float(np.max(np.abs(legs.base_point))))
    for i, j in combinations(np.flatnonzero(legs.drive == STRUT).tolist(), 2):
        # Only struts end on the base; what cranks and carriages carry moves with each.
        if np.linalg.norm(legs.base_point[i] - legs.base_point[j]) <= 1e-9 * scale:
            joined.add((i, j))
    return [pair for pair in combinations(straight, 2) if pair not in joined]


class RodDistance(Condition):
    """The least distance between every two rods that share no joint is at least a limit. [m]

    Rods are straight lines from B to C, a parallelogram its middle one and a strut from A to C.
    """

    reason = "rod_distance"

    def __init__(self, mechanism: Mechanism, limit: float) -> None:
        pairs = separate_rods(mechanism)
        self.legs = tuple(i for i, _ in pairs)
        self.partners = tuple(j for _, j in pairs)
        self._first = np.array([i for i, _ in pairs], dtype=np.int64)
        self._second = np.array([j for _, j in pairs], dtype=np.int64)
        self._struts = (mechanism.legs.drive == STRUT)[:, None, None]
        self._limit = limit

    def check(self, block: Configuration) -> Floats:
        """Return by how much each pair of rods is farther apart than it must be. [m]"""
        return self._distances(block) - self._limit

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return by how much each pair of rods may be farther apart than it must be. [m]"""
        moved = np.maximum(near.shifts, near.elbow_shifts)
        change = moved[self._first] + moved[self._second]
        return within(self.check(near.centre), change * (1.0 + SLACK))

    def explain(self, block: Configuration) -> Breach:
        """Return the distances, and the limit. [m]"""
        return nearest_bound(self._distances(block), self._limit, np.inf)

    def _distances(self, block: Configuration) -> Floats:
        found = joints(block)
        starts = np.where(self._struts, found.base, found.elbow)
        values = np.empty((self._first.size, block.count))
        distances(self._first, self._second, starts, found.platform, values)
        return values
