"""What an analysis is."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from analyses.plan import Plan, cut
from schemas.quantities import Model

Arrays = dict[str, NDArray[Any]]
Stretches = Callable[[], Iterable[Arrays]]
"""Starts anew at every call and yields the arrays of all stretches, in order."""

POSES_PER_BLOCK = 2048
RequestT = TypeVar("RequestT", bound=Model)


class Analysis(ABC, Generic[RequestT]):
    """Answers one kind of request: checks it, prices it, computes it stretch by stretch.

    A direct answer and a job go the same way: stretches are computed and then assembled.
    """

    name: str
    needs_gears = False
    """Whether only mechanisms with motors behind gears can be asked about."""

    @abstractmethod
    def check(self, request: RequestT, node_limit: int) -> None:
        """Raise AnalysisError if the request makes no sense; nothing large is allocated."""

    @abstractmethod
    def items(self, request: RequestT) -> int:
        """Return how many poses, grid nodes or meshes are to be examined."""

    @abstractmethod
    def seconds_per_item(self, request: RequestT) -> float:
        """Return what one item costs on one core of a common machine. [s]"""

    @abstractmethod
    def result_bytes(self, request: RequestT) -> int:
        """Return the size of the result, arrays included. [B]"""

    @abstractmethod
    def compute(self, request: RequestT, start: int, stop: int) -> Arrays:
        """Return the arrays of the items `start` to `stop`."""

    @abstractmethod
    def assemble(self, request: RequestT, stretches: Stretches) -> Model:
        """Return the result from all stretches, in order."""

    def line(self, request: RequestT) -> int:
        """Return how many consecutive items are best kept together."""
        return 1

    def seconds(self, request: RequestT) -> float:
        """Return what the whole request costs on one core. [s]"""
        return self.items(request) * self.seconds_per_item(request)

    def plan(self, request: RequestT, tile_seconds: float) -> Plan:
        """Return how the request is cut into tiles."""
        return cut(
            self.items(request), self.seconds_per_item(request), tile_seconds, self.line(request)
        )


def by_blocks(compute: Callable[[int, int], Arrays], start: int, stop: int) -> Arrays:
    """Return the arrays of the poses `start` to `stop`, computed block by block.

    All that is known of a block stays in cache; of a hundred thousand poses it would not.
    """
    return joined(
        compute(first, min(first + POSES_PER_BLOCK, stop))
        for first in range(start, stop, POSES_PER_BLOCK)
    )


def joined(stretches: Iterable[Arrays], axes: dict[str, int] | None = None) -> Arrays:
    """Return the stretches' arrays joined along their items, axis 0 unless `axes` names another."""
    parts = list(stretches)
    along = axes or {}
    return {
        name: np.concatenate([part[name] for part in parts], axis=along.get(name, 0))
        for name in parts[0]
    }
