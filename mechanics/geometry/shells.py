"""Spherical shells, the regions of struts in space, and the volume that they have in common."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, pairwise
from math import inf, isfinite, sqrt

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.errors import GeometryError
from mechanics.geometry.arcs import ArcRegion, area
from mechanics.geometry.circles import INSIDE, OUTSIDE, Circles, boundary

# Heights too many cost a little time, heights too few cost digits: what is near enough counts.
_SURELY_APART = 1e-7
_IN_ONE_LINE = 1e-9
_ROUNDING = 1e-13
_ACCURACY = 1e-11


@dataclass(frozen=True)
class Shell:
    """The points between two spheres about one centre, both included.

    Parameters
    ----------
    centre : array, shape (3,). [m]
    inner, outer : radii; inner 0 is a ball, outer inf all of space but a ball. [m]

    Raises
    ------
    GeometryError : the radii are not 0 <= inner <= outer, or a number is none.
    """

    centre: Floats
    inner: float
    outer: float

    def __post_init__(self) -> None:
        """Refuse radii that make no shell."""
        numbers = bool(np.all(np.isfinite(self.centre))) and isfinite(self.inner)
        if not (numbers and 0.0 <= self.inner <= self.outer):
            raise GeometryError(
                f"a shell needs a finite centre and radii 0 <= inner <= outer; "
                f"given {np.asarray(self.centre).tolist()}, {self.inner}, {self.outer}"
            )

    def contains(self, points: Floats) -> Booleans:
        """Return which points, shape (..., 3), lie in it. [m]"""
        away = np.linalg.norm(points - self.centre, axis=-1)
        inside: Booleans = (away >= self.inner) & (away <= self.outer)
        return inside


@dataclass(frozen=True)
class Volume:
    """A volume found by adding up cross-sections.

    Parameters
    ----------
    value : [m^3]
    error : an estimate of how far off the value may be; rounding included. [m^3]
    heights : array, ascending, where sections may change their shape; the first and the last
        are the least and the greatest z. Empty if there is no volume. [m]
    """

    value: float
    error: float
    heights: Floats


@dataclass(frozen=True)
class ShellRegion:
    """What shells have in common.

    Parameters
    ----------
    shells : in any order.

    Raises
    ------
    GeometryError : none of them has an outer sphere.
    """

    shells: tuple[Shell, ...]

    def __post_init__(self) -> None:
        """Refuse a region that never ends."""
        if not any(shell.outer < inf for shell in self.shells):
            raise GeometryError(
                "at least one shell must have an outer sphere: there is no end else"
            )

    def section(self, height: float) -> ArcRegion:
        """Return the cross-section at z = height, exactly. [m]"""
        return ArcRegion(boundary(self._circles(height)))

    @cached_property
    def volume(self) -> Volume:
        """The volume: exact sections, added up between the heights at which they change shape.

        Between such heights the area is smooth but for roots of the distance to the ends, and
        z = middle - half cos(t) takes them away: few sections give all digits.
        """
        from scipy.integrate import quad

        heights = self._heights()
        value = error = 0.0
        for low, high in pairwise(heights.tolist()):
            middle, half = 0.5 * (low + high), 0.5 * (high - low)

            def slab(t: float, middle: float = middle, half: float = half) -> float:
                return self._area(middle - half * np.cos(t)) * half * float(np.sin(t))

            # Its full output says what would otherwise be a warning; the error says it as well.
            part, doubt = quad(
                slab, 0.0, np.pi, epsabs=self._fine, epsrel=_ACCURACY, limit=200, full_output=1
            )[:2]
            value, error = value + part, error + doubt
        return Volume(float(value), float(error), heights)

    @cached_property
    def _spheres(self) -> tuple[Floats, Floats, Floats]:
        """Centres, radii and sides of all spheres."""
        rows = [
            (*shell.centre, radius, side)
            for shell in self.shells
            for radius, side in ((shell.outer, INSIDE), (shell.inner, OUTSIDE))
            if 0.0 < radius < inf
        ]
        table = np.array(rows, dtype=float)
        return table[:, :3], table[:, 3], table[:, 4]

    @cached_property
    def _size(self) -> float:
        return min(shell.outer for shell in self.shells)

    @property
    def _fine(self) -> float:
        """A volume that is nothing beside the smallest ball."""
        return 1e-14 * self._size**3

    def _circles(self, height: float) -> Circles:
        centre, radius, side = self._spheres
        off = np.abs(height - centre[:, 2])
        cut = np.sqrt(np.maximum(0.0, (radius - off) * (radius + off)))
        return Circles(centre[:, :2], cut, side)

    def _area(self, height: float) -> float:
        return area(boundary(self._circles(height)))

    def _heights(self) -> Floats:
        """Return where sections may change shape: at tops and bottoms of faces, edges, corners."""
        if self._size == 0.0:
            return np.zeros(0)
        centre, radius, _ = self._spheres
        points = np.array([p for find in (_poles, _edges, _corners) for p in find(centre, radius)])
        found = np.sort(points[self._holds(points), 2])
        new = np.diff(found, prepend=-inf) > _ROUNDING * (self._size + np.abs(found))
        heights = found[new]
        filled = np.flatnonzero([self._area(0.5 * (low + high)) for low, high in pairwise(heights)])
        if not filled.size:
            return np.zeros(0)
        between: Floats = heights[filled[0] : filled[-1] + 2]
        return between

    def _holds(self, points: Floats) -> Booleans:
        """Return which points lie in all shells, or so near that it is hard to say."""
        centre, radius, side = self._spheres
        away = np.linalg.norm(points[:, None] - centre, axis=-1)
        holds: Booleans = np.all(side * (away - radius) <= _SURELY_APART * radius.max(), axis=1)
        return holds


def _poles(centre: Floats, radius: Floats) -> Iterator[Floats]:
    """Yield the tops and bottoms of spheres."""
    up = np.array([0.0, 0.0, 1.0])
    for middle, size in zip(centre, radius, strict=True):
        yield from (middle + size * up, middle - size * up)


def _edges(centre: Floats, radius: Floats) -> Iterator[Floats]:
    """Yield the tops and bottoms of the circles in which two spheres meet."""
    for i, j in combinations(range(radius.size), 2):
        span = centre[j] - centre[i]
        apart = float(np.linalg.norm(span))
        if apart <= _ROUNDING * (radius[i] + radius[j]):
            continue
        normal = span / apart
        along = 0.5 * (apart + (radius[i] - radius[j]) * (radius[i] + radius[j]) / apart)
        square = (radius[i] - along) * (radius[i] + along)
        if square < -_SURELY_APART * radius[i] ** 2:
            continue
        yield from _tops(centre[i] + along * normal, normal, sqrt(max(0.0, square)))


def _tops(middle: Floats, normal: Floats, size: float) -> Iterator[Floats]:
    """Yield the top and the bottom of a circle; of a level one some points all around."""
    up = np.array([0.0, 0.0, 1.0]) - normal[2] * normal
    slope = float(np.linalg.norm(up))
    # All of a level circle is as high; where only a part bounds the region, the part has corners.
    across = up / slope if slope > _IN_ONE_LINE else np.array([1.0, 0.0, 0.0])
    yield from (middle + size * across, middle - size * across)


def _corners(centre: Floats, radius: Floats) -> Iterator[Floats]:
    """Yield the points in which three spheres meet."""
    for i, j, k in combinations(range(radius.size), 3):
        first, second = centre[j] - centre[i], centre[k] - centre[i]
        across = np.cross(first, second)
        square = float(across @ across)
        if square <= (_IN_ONE_LINE * float(first @ first + second @ second)) ** 2:
            continue
        lengths = 0.5 * np.array(
            [
                first @ first + radius[i] ** 2 - radius[j] ** 2,
                second @ second + radius[i] ** 2 - radius[k] ** 2,
            ]
        )
        foot = np.cross(lengths[0] * second - lengths[1] * first, across) / square
        rest = radius[i] ** 2 - float(foot @ foot)
        if rest >= -_SURELY_APART * radius[i] ** 2:
            off = sqrt(max(0.0, rest) / square) * across
            yield from (centre[i] + foot + off, centre[i] + foot - off)


def intersect(shells: Sequence[Shell]) -> ShellRegion:
    """Return what all shells have in common.

    Raises
    ------
    GeometryError : none of them has an outer sphere.
    """
    return ShellRegion(tuple(shells))
