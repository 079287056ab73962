"""The joint at the base end of each rod: it swings no farther than its cone allows."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import angles_between, at_most
from mechanics.conditions.condition import Breach, Condition
from mechanics.configuration import Configuration
from mechanics.legs import CRANK
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import SLACK, Margins, Neighbourhood, within


class BaseJointAngle(Condition):
    """The angle between each rod and the rest direction of its joint at B is within a limit.

    A strut's joint stands on the base; a carriage or a crank carries that of its rod along, and
    a crank turns it.

    Parameters
    ----------
    axes : array, shape (legs, 3): the rods' directions, from base to platform, with the joints
        at rest, in the base frame while all drives stand at 0; of any length but 0.
    limit : [rad]
    """

    reason = "base_joint_angle"

    def __init__(self, mechanism: Mechanism, axes: Floats, limit: float) -> None:
        legs = mechanism.legs
        self.legs = tuple(range(mechanism.leg_count))
        self._limit = limit
        self._turning = (legs.drive == CRANK)[:, None, None]
        # Of a turning direction: along the crank's axis, across it, and a quarter turn on.
        along = np.sum(legs.axis * axes, axis=1, keepdims=True) * legs.axis
        self._along = along[:, :, None]
        self._across = (axes - along)[:, :, None]
        self._quarter = np.cross(legs.axis, axes)[:, :, None]

    def check(self, block: Configuration) -> Floats:
        """Return how far below the limit the angle at each joint is. [rad]"""
        return self._limit - self._angles(block)

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far below the limit the angle at each joint may be. [rad]"""
        turned = near.swings + np.where(self._turning[:, 0], near.strokes, 0.0)
        return within(self.check(near.centre), turned * (1.0 + SLACK) + SLACK)

    def explain(self, block: Configuration) -> Breach:
        """Return the angles at the joints, and the limit. [rad]"""
        return at_most(self._angles(block), self._limit)

    def _angles(self, block: Configuration) -> Floats:
        cosines = np.where(self._turning, block.travel[:, :1], 1.0)
        sines = np.where(self._turning, block.travel[:, 1:], 0.0)
        rest = self._along + self._across * cosines + self._quarter * sines
        return angles_between(block.rods[0], rest)
