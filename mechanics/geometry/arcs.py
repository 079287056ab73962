"""Regions bounded by circular arcs: area, centroid, bounds, and the boundary as closed loops."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats, Integers

TURN = 2.0 * np.pi

_NEARLY_STRAIGHT = 0.3


class Arcs(NamedTuple):
    """Arcs of circles, one row each, the region on their left.

    Parameters
    ----------
    centre : array, shape (arcs, 2). [m]
    radius : array, shape (arcs,). [m]
    start, sweep : arrays, shape (arcs,), the first angle and the signed turn from it,
        counterclockwise > 0; a whole circle turns by 2 pi. [rad]
    """

    centre: Floats
    radius: Floats
    start: Floats
    sweep: Floats

    def at(self, angle: Floats) -> Floats:
        """Return the points at an angle of each arc's circle, shape (arcs, 2). [m]"""
        directions = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        points: Floats = self.centre + self.radius[:, None] * directions
        return points

    @property
    def ends(self) -> tuple[Floats, Floats]:
        """First and last points, shape (arcs, 2) each. [m]"""
        return self.at(self.start), self.at(self.start + self.sweep)

    def take(self, rows: Integers) -> "Arcs":
        """Return some of the arcs."""
        return Arcs(*(column[rows] for column in self))


class Arc(NamedTuple):
    """An arc of a boundary. Angles in rad, `end` > `start` where it runs counterclockwise."""

    centre: tuple[float, float]
    radius: float
    start: float
    end: float


@dataclass(frozen=True)
class Loop:
    """A closed line of arcs: counterclockwise around a component, clockwise around a hole.

    Parameters
    ----------
    arcs : in the order in which the loop runs through them.
    area : what it encloses, < 0 for a hole. [m^2]
    """

    arcs: tuple[Arc, ...]
    area: float

    @property
    def is_hole(self) -> bool:
        """Whether the region lies outside."""
        return self.area < 0.0


@dataclass(frozen=True)
class ArcRegion:
    """A region of the plane, closed, without the points and lines that enclose no area.

    Circles that touch without crossing are not cut where they touch: what holds together in a
    single point counts as one part.
    """

    arcs: Arcs

    @property
    def is_empty(self) -> bool:
        """Whether there is no area at all."""
        return not self.arcs.radius.size

    @cached_property
    def area(self) -> float:
        """The area, by Green's theorem. [m^2]"""
        return area(self.arcs)

    @cached_property
    def centroid(self) -> Floats | None:
        """Centre of the area, shape (2,); None if it is empty. [m]"""
        return None if self.is_empty else _centroid(self.arcs)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats] | None:
        """Least and greatest x and y, shape (2,) each; None if it is empty. [m]"""
        return None if self.is_empty else _bounds(self.arcs)

    @cached_property
    def loops(self) -> tuple[Loop, ...]:
        """The boundary: components from large to small, then holes from large to small."""
        loops = [_loop(self.arcs.take(rows)) for rows in _chains(self.arcs)]
        return tuple(sorted(loops, key=lambda loop: (loop.is_hole, -abs(loop.area))))

    @property
    def components(self) -> int:
        """How many parts there are."""
        return sum(not loop.is_hole for loop in self.loops)

    @property
    def holes(self) -> int:
        """How many holes there are in all parts together."""
        return sum(loop.is_hole for loop in self.loops)


def area(arcs: Arcs) -> float:
    """Return the area on the left of arcs that close, in whatever order they come. [m^2]

    Polygon of the arcs' ends and segments between arcs and chords, each from numbers of the
    region's own size: a small region keeps its digits, wherever it is.
    """
    if not arcs.radius.size:
        return 0.0
    first, last = arcs.ends
    origin = first.mean(axis=0)
    return float(np.sum(_wedges(first - origin, last - origin) + _segments(arcs)))


def _wedges(first: Floats, last: Floats) -> Floats:
    """Return the areas of the triangles between the origin and the chords."""
    areas: Floats = 0.5 * (first[:, 0] * last[:, 1] - first[:, 1] * last[:, 0])
    return areas


def _segments(arcs: Arcs) -> Floats:
    """Return the areas between arcs and chords, signed as the arcs' turns."""
    areas: Floats = 0.5 * arcs.radius**2 * _less_sine(arcs.sweep)
    return areas


def _less_sine(angle: Floats) -> Floats:
    """Return angle - sin(angle), by its series where the difference would cancel."""
    square = np.minimum(angle**2, _NEARLY_STRAIGHT**2)
    series = np.ones_like(angle)
    for divisor in (210.0, 156.0, 110.0, 72.0, 42.0, 20.0):
        series = 1.0 - square / divisor * series
    straight = np.abs(angle) < _NEARLY_STRAIGHT
    less: Floats = np.where(straight, angle**3 / 6.0 * series, angle - np.sin(angle))
    return less


def _centroid(arcs: Arcs) -> Floats:
    first, last = arcs.ends
    origin = first.mean(axis=0)
    first, last = first - origin, last - origin
    triangles, segments = _wedges(first, last), _segments(arcs)
    middle = arcs.start + 0.5 * arcs.sweep
    outwards = np.stack([np.cos(middle), np.sin(middle)], axis=-1)
    lever = 2.0 / 3.0 * arcs.radius**3 * np.sin(0.5 * arcs.sweep) ** 3
    moments = (
        triangles[:, None] * (first + last) / 3.0
        + segments[:, None] * (arcs.centre - origin)
        + lever[:, None] * outwards
    )
    centre: Floats = origin + moments.sum(axis=0) / np.sum(triangles + segments)
    return centre


def _bounds(arcs: Arcs) -> tuple[Floats, Floats]:
    points = np.concatenate(arcs.ends)
    low = np.minimum(arcs.start, arcs.start + arcs.sweep)
    for axis, side in ((0, 1.0), (1, 1.0), (0, -1.0), (1, -1.0)):
        angle = 0.5 * np.pi * (axis + 1.0 - side)
        passed = np.mod(angle - low, TURN) <= np.abs(arcs.sweep)
        tops = arcs.centre[passed]
        tops[:, axis] += side * arcs.radius[passed]
        points = np.concatenate([points, tops])
    return points.min(axis=0), points.max(axis=0)


def _chains(arcs: Arcs) -> list[Integers]:
    """Return the rows of the arcs of each loop, in order.

    Every end goes on to the start that is nearest, all together: whatever rounding did to the
    corners, the loops close.
    """
    whole = np.flatnonzero(np.abs(arcs.sweep) >= TURN)
    rest = np.flatnonzero(np.abs(arcs.sweep) < TURN)
    chains = [np.array([row]) for row in whole]
    following = dict(zip(rest.tolist(), rest[_successors(arcs.take(rest))].tolist(), strict=True))
    while following:
        first, row = following.popitem()
        chain = [first]
        while row != first:
            chain.append(row)
            row = following.pop(row)
        chains.append(np.array(chain))
    return chains


def _successors(arcs: Arcs) -> Integers:
    """Return the row on which each arc goes on."""
    if not arcs.radius.size:
        return np.zeros(0, np.int64)
    from scipy.optimize import linear_sum_assignment

    first, last = arcs.ends
    gaps = np.linalg.norm(last[:, None] - first[None], axis=-1) / arcs.radius.max()
    rows: Integers = linear_sum_assignment(gaps)[1]
    return rows


def _loop(arcs: Arcs) -> Loop:
    rows = zip(arcs.centre, arcs.radius, arcs.start, arcs.sweep, strict=True)
    parts = [
        Arc((float(c[0]), float(c[1])), float(r), float(a), float(a + turn))
        for c, r, a, turn in rows
    ]
    return Loop(tuple(parts), area(arcs))
