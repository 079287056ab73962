"""What a condition of a workspace is."""

import math
from abc import ABC, abstractmethod
from typing import NamedTuple

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.neighbourhoods import Margins, Neighbourhood

NO_LEG = -1
"""The leg of a part that all legs make together."""


class TurnTest(NamedTuple):
    """A test that decides a part at all angles of a turn (`kernels.sweeps`).

    The last two bound |d|^2, where the test is one of that. [m^2]
    """

    test: int
    least: float = -math.inf
    greatest: float = math.inf


class Breach(NamedTuple):
    """What was measured and the limit nearest to it, shape (parts, poses) each."""

    value: Floats
    limit: Floats


class Condition(ABC):
    """Something that must hold at a pose, part by part; a part belongs to a leg or to `NO_LEG`.

    A condition's `reason` names it on the wire; `legs` holds the leg of each of its parts.
    """

    reason: str
    legs: tuple[int, ...]
    partners: tuple[int, ...] | None = None
    """The other leg of each part, of conditions between two legs."""
    line_tests: tuple[int, ...] | None = None
    """The test of each part that decides it along whole lines, if there are."""
    turn_tests: tuple[TurnTest, ...] | None = None
    """The test of each part that decides it at all angles of a turn, if there are."""
    quick: bool = False
    """Whether it takes no longer at ten nodes than bounds on it near one."""
    fails_at_singularities: bool = False
    """Whether it fails near every pose at which det Jx is 0, however near that is."""

    @abstractmethod
    def check(self, block: Configuration) -> Floats:
        """Return by how much each part holds, shape (parts, poses); < 0 or NaN: it does not."""

    @abstractmethod
    def margins_near(self, near: Neighbourhood) -> Margins:
        """Return bounds on by how much parts hold anywhere near the centres, rounding included.

        A part holds at every pose near a centre if the least is not below 0, and at none if the
        greatest is; otherwise single poses are asked. So only signs count, not what is measured.
        """

    @abstractmethod
    def explain(self, block: Configuration) -> Breach:
        """Return the value that each part measured and the limit that it is held against."""
