"""What forty paths ended in: real and complex modes, multiple ones, and ends where h = 0.

The count is certified by numbers, not by intervals: every path ended, no two in one simple root,
and with each root there is its conjugate, as the equations are real.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mechanics.arrays import Booleans, Complexes, Floats, Integers
from mechanics.kernels.endpoints import nearest
from mechanics.kernels.path_steps import ARRIVED, AT_INFINITY, LOST, SINGULAR

INFINITE = 1e-7
"""A solution of this |h| / |e|^2 or less is no pose."""

TWIN_INFINITE = 1e-5
"""Ends that fell together are no pose if |h| / |e|^2 is not above this: those are multiple."""

NEARLY_REAL = 3e-3
"""How far from real an end may be that is tried as a real mode; Newton's method decides."""


@dataclass(frozen=True)
class Endpoints:
    """Where the paths ended.

    Parameters
    ----------
    solutions : array, shape (paths, 6): e, of length 1, S3 and D3.
    outcomes : array, shape (paths,): what became of each path.
    tolerance : solutions nearer than this are one.
    final : whether paths that fell together have been followed with care already.
    """

    solutions: Complexes
    outcomes: Integers
    tolerance: float
    final: bool

    @cached_property
    def _nearest(self) -> tuple[Floats, Floats, Floats]:
        """How far each is from its own conjugate, from the simple ends', and from those."""
        return nearest(self.solutions, self.outcomes == ARRIVED)

    @cached_property
    def h(self) -> Complexes:
        """e.e of each solution."""
        products: Complexes = np.sum(self.solutions[:, :4] ** 2, axis=1)
        return products

    @cached_property
    def twins(self) -> Booleans:
        """Which simple ends fell together with another."""
        found: Booleans = (self._nearest[2] < self.tolerance) & (self.outcomes == ARRIVED)
        return found

    @cached_property
    def infinite(self) -> Booleans:
        """Which ends are no pose, h being 0 there."""
        size = np.abs(self.h)
        gone: Booleans = (self.outcomes == AT_INFINITY) | (size < INFINITE)
        return gone | (self.twins & (size < TWIN_INFINITE)) if self.final else gone

    @cached_property
    def doubtful(self) -> Booleans:
        """Which paths do not count: lost, fallen together, or without their conjugate."""
        alone = (self._nearest[1] >= self.tolerance) & (self.outcomes == ARRIVED)
        doubt = (self.twins | alone) & ~self.infinite
        found: Booleans = doubt | (self.outcomes == LOST)
        return found

    @cached_property
    def multiple(self) -> Booleans:
        """Which ends are roots that several paths share."""
        found: Booleans = (self.outcomes == SINGULAR) & ~self.infinite
        return found

    @cached_property
    def real(self) -> Booleans:
        """Which ends are simple real roots."""
        found: Booleans = (
            (self._nearest[0] < self.tolerance) & (self.outcomes == ARRIVED) & ~self.infinite
        )
        return found

    @cached_property
    def nearly_real(self) -> Booleans:
        """Which ends are worth trying as real modes."""
        found: Booleans = (
            (self._nearest[0] < NEARLY_REAL) & (self.outcomes != LOST) & ~self.infinite
        )
        return found

    def real_parts(self, chosen: Booleans) -> Floats:
        """Return the chosen solutions, turned so that e is as real as can be, without the rest."""
        h, solutions = self.h[chosen], self.solutions[chosen]
        phase = np.sqrt(h / np.abs(h)).conj()[:, None]
        parts: Floats = np.hstack([solutions[:, :4] * phase, solutions[:, 4:] * phase**2]).real
        return parts
