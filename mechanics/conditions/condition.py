"""What a condition of a workspace is."""

from abc import ABC, abstractmethod
from typing import NamedTuple

from mechanics.arrays import Floats
from mechanics.configuration import Configuration

NO_LEG = -1
"""The leg of a part that all legs make together."""


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
    line_tests: tuple[int, ...] | None = None
    """The test of each part that decides it along whole lines, if there are."""

    @abstractmethod
    def check(self, block: Configuration) -> Floats:
        """Return by how much each part holds, shape (parts, poses); < 0 or NaN: it does not."""

    @abstractmethod
    def explain(self, block: Configuration) -> Breach:
        """Return the value that each part measured and the limit that it is held against."""
