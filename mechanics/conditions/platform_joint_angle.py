"""The joint at the platform end of each rod: it swings no farther than its cone allows."""

from mechanics.arrays import Floats
from mechanics.conditions.bounds import angles_between, at_most
from mechanics.conditions.condition import Breach, Condition
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import SLACK, Margins, Neighbourhood, within


class PlatformJointAngle(Condition):
    """The angle between each rod and the rest direction of its joint at C is within a limit.

    Parameters
    ----------
    axes : array, shape (legs, 3): the rods' directions, from base to platform, with the joints
        at rest, in the frame of what the legs carry: the platform, or what holds its wrist and
        does not turn; of any length but 0.
    limit : [rad]
    """

    reason = "platform_joint_angle"

    def __init__(self, mechanism: Mechanism, axes: Floats, limit: float) -> None:
        self.legs = tuple(range(mechanism.leg_count))
        self._axes = axes
        self._limit = limit

    def check(self, block: Configuration) -> Floats:
        """Return how far below the limit the angle at each joint is. [rad]"""
        return self._limit - self._angles(block)

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far below the limit the angle at each joint may be. [rad]"""
        turned = near.swings + near.turns
        return within(self.check(near.centre), turned * (1.0 + SLACK) + SLACK)

    def explain(self, block: Configuration) -> Breach:
        """Return the angles at the joints, and the limit. [rad]"""
        return at_most(self._angles(block), self._limit)

    def _angles(self, block: Configuration) -> Floats:
        if block.mechanism.wrist is not None:
            return angles_between(block.rods[0], self._axes[:, :, None])
        rotations = block.placement[1].reshape(3, 3, -1)
        x, y, z = self._axes.T[:, :, None, None]
        # In one order, as `products` are summed, whatever a pose's company.
        rest = rotations[:, 0] * x + rotations[:, 1] * y + rotations[:, 2] * z
        return angles_between(block.rods[0], rest)
