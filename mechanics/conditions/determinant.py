"""Determinant: |det Jx| stays away from 0."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.bounds import nearest_bound
from mechanics.conditions.condition import NO_LEG, Breach, Condition
from mechanics.configuration import Configuration
from mechanics.neighbourhoods import Margins, Neighbourhood


class Determinant(Condition):
    """The determinant's size, in the unit twists of the motion, is at least a limit.

    A condition on the mechanism as a whole. [m to the number of turns]
    """

    reason = "determinant"
    fails_at_singularities = True
    legs = (NO_LEG,)

    def __init__(self, limit: float) -> None:
        self._limit = limit

    def check(self, block: Configuration) -> Floats:
        """Return by how much |det Jx| is above the limit. [m to the number of turns]"""
        return self._sizes(block) - self._limit

    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return by how much |det Jx| may be above the limit. [m to the number of turns]"""
        share = near.kept * (1.0 - near.blurs)
        sizes = self._sizes(near.centre)
        return Margins(sizes * share - self._limit, sizes / share - self._limit)

    def explain(self, block: Configuration) -> Breach:
        """Return |det Jx|, and the limit. [m to the number of turns]"""
        return nearest_bound(self._sizes(block), self._limit, np.inf)

    def _sizes(self, block: Configuration) -> Floats:
        sizes: Floats = np.abs(block.determinants)[None]
        return sizes
