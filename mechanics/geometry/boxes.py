"""Volumes of workspaces at one orientation between proven bounds, by boxes within boxes."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from math import inf
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.errors import NotOfferedError
from mechanics.geometry.leg_regions import (
    SPACE,
    leg_centres,
    require_no_crank_limits,
    require_translations,
)
from mechanics.legs import CRANK, RAIL, STRUT
from mechanics.mechanism import Mechanism

BOXES = 200_000
"""How many undecided boxes are cut at most before the bounds are taken as they are."""

_TOGETHER = 16384
_ROUNDING = 1e-12


class Reaches(NamedTuple):
    """Where the legs let the reference point go: a solid around a line each, one row a leg.

    The point at `along` on the line and `off` it is in a leg's reach when the nearest place of
    the moving joint is at most `longest` and the farthest at least `shortest` away. A crank is
    a torus, solid where crank and rod are as long as each other; a rail a cylinder; a strut,
    whose joint stands, a shell.

    Parameters
    ----------
    centre, axis : arrays, shape (legs, 3). [m, -]
    crank : array, shape (legs,), the circle's radius, 0 if there is none. [m]
    shortest, longest : arrays, shape (legs,). [m]
    still : array, shape (legs,), 0 where the joint can follow along the line, else 1.
    """

    centre: Floats
    axis: Floats
    crank: Floats
    shortest: Floats
    longest: Floats
    still: Floats

    def contains(self, points: Floats) -> Booleans:
        """Return which points, shape (points, 3), all legs reach. [m]"""
        along, off = self._cylindrical(points)
        inside: Booleans = np.all(
            (np.hypot(off - self.crank, along) <= self.longest)
            & (np.hypot(off + self.crank, along) >= self.shortest),
            axis=1,
        )
        return inside

    def _cylindrical(self, points: Floats) -> tuple[Floats, Floats]:
        """Return along and off each leg's line, shape (points, legs); 0 along where not still."""
        spans = points[:, None] - self.centre
        along = np.einsum("plk,lk->pl", spans, self.axis)
        off = np.linalg.norm(spans - along[..., None] * self.axis, axis=-1)
        return along * self.still, off

    def judge(self, middles: Floats, half: Floats) -> tuple[Booleans, Booleans]:
        """Return which boxes lie inside for certain, and which outside, shape (boxes,) each.

        Parameters
        ----------
        middles : array, shape (boxes, 3). [m]
        half : array, shape (3,), half the boxes' sides. [m]
        """
        along, off = self._cylindrical(middles)
        deep, wide = self._extents(half)
        low, high = np.maximum(0.0, np.abs(along) - deep), np.abs(along) + deep
        ring = np.abs(off - self.crank)
        nearest = np.hypot(np.maximum(0.0, ring - wide), low), np.hypot(ring + wide, high)
        rim = np.maximum(0.0, off - wide) + self.crank, off + wide + self.crank
        farthest = np.hypot(rim[0], low), np.hypot(rim[1], high)
        slack = _ROUNDING * (np.abs(middles).max() + farthest[1].max())
        inside = (nearest[1] <= self.longest - slack) & (farthest[0] >= self.shortest + slack)
        outside = (nearest[0] > self.longest + slack) | (farthest[1] < self.shortest - slack)
        certain: tuple[Booleans, Booleans] = np.all(inside, axis=1), np.any(outside, axis=1)
        return certain

    def _extents(self, half: Floats) -> tuple[Floats, Floats]:
        """Return how far a box's points are from its middle along and off each line, at most."""
        deep = np.abs(self.axis) @ half * self.still
        corners = half * np.array(list(product((1.0, -1.0), repeat=3)))
        along = corners @ self.axis.T
        off = np.linalg.norm(corners[:, None] - along[..., None] * self.axis, axis=-1)
        return deep, off.max(axis=0)


@dataclass(frozen=True)
class BoundedVolume:
    """A volume between proven bounds. [m^3]

    `estimate` adds to the boxes that are inside the undecided ones whose middles are.
    """

    lower: float
    upper: float
    estimate: float


def reaches(mechanism: Mechanism, pose: Floats, *, limited: bool) -> Reaches:
    """Return where the legs of a mechanism let its reference point go in space.

    Parameters
    ----------
    mechanism : of a motion with all three translations.
    pose : array, shape (coordinates,); only the platform's turns count. [m, rad]
    limited : whether actuator limits hold (class constructive) or not (theoretical).

    Raises
    ------
    NotOfferedError : the motion lacks a translation, or limits hold for a crank or a rail.
    PoseError : `pose` has another number of coordinates than the motion.

    References
    ----------
    Erastova, Laryushkin, 2017, doi:10.18698/0536-1044-2017-8-78-87: the tori of the 3-RRRR.
    """
    require_translations(mechanism, SPACE)
    legs = mechanism.legs
    strut, rail = legs.drive == STRUT, legs.drive == RAIL
    if limited:
        _require_no_stops(mechanism)
    bounds = (np.maximum(0.0, legs.lower_limit), legs.upper_limit) if limited else (0.0, inf)
    return Reaches(
        centre=leg_centres(mechanism, pose),
        axis=legs.axis,
        crank=np.where(legs.drive == CRANK, legs.crank_length, 0.0),
        shortest=np.where(strut, bounds[0], np.where(rail, 0.0, legs.rod_length)),
        longest=np.where(strut, bounds[1], legs.rod_length),
        still=np.where(rail, 0.0, 1.0),
    )


def bound_volume(legs: Reaches, boxes: int = BOXES) -> BoundedVolume:
    """Return the volume that all legs reach, between proven bounds.

    Boxes are cut into eight until they are inside, or outside, for certain, or until there are
    too many. The bounds close in as one over the square root of `boxes`.

    Parameters
    ----------
    boxes : how many undecided boxes to cut in one round at most.

    Raises
    ------
    NotOfferedError : no leg but rails bounds the workspace.
    """
    low, high = bounding_box(legs)
    if np.any(high <= low):
        return BoundedVolume(0.0, 0.0, 0.0)
    half = 0.5 * (high - low)
    undecided = (low + half)[None]
    inside = 0.0
    while undecided.size and undecided.shape[0] <= boxes:
        half = 0.5 * half
        cell = 8.0 * float(np.prod(half))
        found = [_sift(legs, part, half) for part in _eighths(undecided, half)]
        inside += cell * sum(count for count, _ in found)
        undecided = np.concatenate([left for _, left in found])
    cell = 8.0 * float(np.prod(half))
    likely = cell * sum(int(legs.contains(part).sum()) for part in _parts(undecided))
    return BoundedVolume(inside, inside + cell * undecided.shape[0], inside + likely)


def _require_no_stops(mechanism: Mechanism) -> None:
    legs = mechanism.legs
    stopped = np.isfinite(legs.lower_limit) | np.isfinite(legs.upper_limit)
    for leg in range(mechanism.leg_count):
        require_no_crank_limits(legs, leg)
        if legs.drive[leg] == RAIL and stopped[leg]:
            raise NotOfferedError("the limits of its rail cut its region along spheres", leg=leg)


def bounding_box(legs: Reaches) -> tuple[Floats, Floats]:
    """Return the least and the greatest corner of a box around all that the legs reach."""
    size = np.where(legs.still > 0.0, legs.crank + legs.longest, inf)
    if not np.any(size < inf):
        raise NotOfferedError("no leg bounds the workspace")
    ends = legs.centre[size < inf], size[size < inf, None]
    low: Floats = np.max(ends[0] - ends[1], axis=0)
    high: Floats = np.min(ends[0] + ends[1], axis=0)
    return low, high


def _parts(middles: Floats) -> Iterator[Floats]:
    for first in range(0, middles.shape[0], _TOGETHER):
        yield middles[first : first + _TOGETHER]


def _eighths(middles: Floats, half: Floats) -> Iterator[Floats]:
    """Yield the middles of the eight parts of each box, some boxes at a time."""
    corners = half * np.array(list(product((-1.0, 1.0), repeat=3)))
    for part in _parts(middles):
        yield from _parts((part[:, None] + corners).reshape(-1, 3))


def _sift(legs: Reaches, middles: Floats, half: Floats) -> tuple[int, Floats]:
    """Return how many boxes are inside for certain, and the middles of those undecided."""
    inside, outside = legs.judge(middles, half)
    return int(inside.sum()), middles[~(inside | outside)]
