"""Condition number: the platform is held about as well in all directions."""

from mechanics.arrays import Floats
from mechanics.conditions.bounds import at_most
from mechanics.conditions.condition import NO_LEG, Breach, Condition
from mechanics.configuration import Configuration
from mechanics.neighbourhoods import Margins, Neighbourhood


class ConditionNumber(Condition):
    """The condition number of Jx, turns measured at the characteristic length, is within a limit.

    A condition on the mechanism as a whole.
    """

    reason = "condition_number"
    fails_at_singularities = True
    legs = (NO_LEG,)

    def __init__(self, limit: float) -> None:
        self._limit = limit

    def check(self, block: Configuration) -> Floats:
        """Return how far below the limit the condition number is."""
        return self._limit - block.condition_numbers[None]

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return how far below the limit the condition number may be."""
        least, greatest = near.condition_numbers
        return Margins(self._limit - greatest[None], self._limit - least[None])

    def explain(self, block: Configuration) -> Breach:
        """Return the condition number, and the limit."""
        return at_most(block.condition_numbers[None], self._limit)
