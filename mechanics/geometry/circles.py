"""Arrangements of circles: which arcs bound what lies inside some discs and outside others."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.geometry.arcs import TURN, Arcs

INSIDE, OUTSIDE = 1.0, -1.0
"""On which side of a circle the region lies."""

_ROUNDING = 1e-14
_LEAST_SWEEP = 1e-14
_ALL_OF_IT = 4.0


class Circles(NamedTuple):
    """Circles, one row each.

    Parameters
    ----------
    centre : array, shape (circles, 2). [m]
    radius : array, shape (circles,). [m]
    side : array, shape (circles,), `INSIDE` or `OUTSIDE`.
    """

    centre: Floats
    radius: Floats
    side: Floats


NO_ARCS = Arcs(np.zeros((0, 2)), np.zeros(0), np.zeros(0), np.zeros(0))


def boundary(circles: Circles) -> Arcs:
    """Return the arcs that bound the points inside and outside of the discs as asked.

    On each circle the part inside any other disc is one arc, so its part of the boundary is an
    intersection of intervals of its angle: nothing hinges on whether a point lies on a line.

    Circles that come within 1e-14 of the scene's size of touching are taken as touching, and as
    one where they coincide; no circle of that size or below counts.
    """
    tolerance = _ROUNDING * _size(circles)
    distinct = _distinct(circles, tolerance)
    return NO_ARCS if distinct is None else _arcs(distinct, tolerance)


def _size(circles: Circles) -> float:
    greatest = np.max(circles.radius, initial=0.0) + np.max(np.abs(circles.centre), initial=0.0)
    return float(greatest)


def _distinct(circles: Circles, tolerance: float) -> Circles | None:
    """Return the circles that count, each once; None if they leave no area."""
    centre, radius, side = circles
    points = radius <= tolerance
    apart = _distances(centre) + np.abs(radius[:, None] - radius)
    same = apart <= tolerance
    opposite = side[:, None] != side
    if np.any(points & (side == INSIDE)) or np.any(same & opposite & ~points & ~points[:, None]):
        return None
    repeated = np.any(np.tril(same & ~opposite, -1), axis=1)
    kept = ~(points | repeated)
    return Circles(centre[kept], radius[kept], side[kept])


def _distances(centre: Floats) -> Floats:
    spans = centre[None] - centre[:, None]
    distances: Floats = np.hypot(spans[..., 0], spans[..., 1])
    return distances


def _arcs(circles: Circles, tolerance: float) -> Arcs:
    centre, radius, side = circles
    spans = centre[None] - centre[:, None]
    towards = np.arctan2(spans[..., 1], spans[..., 0])
    reach = _half_angles(_distances(centre), radius, tolerance)
    starts = _cuts(towards, reach)
    ends = np.concatenate([starts[:, 1:], starts[:, :1] + TURN], axis=1)
    kept = (ends - starts > _LEAST_SWEEP) & _wanted(0.5 * (starts + ends), towards, reach, side)
    rows, columns = np.nonzero(kept)
    low, high = starts[rows, columns], ends[rows, columns]
    inwards = side[rows]
    first = np.where(inwards == INSIDE, low, high)
    return Arcs(centre[rows], radius[rows], first, inwards * (high - low))


def _half_angles(apart: Floats, radius: Floats, tolerance: float) -> Floats:
    """Return half the angle of circle i that lies in disc j, shape (circles, circles).

    0 where it lies outside; `_ALL_OF_IT`, which is beyond pi, where it lies inside.
    """
    own, other = radius[:, None], radius[None]
    total, excess = own + other, own - other
    along = apart**2 + excess * total
    across = (total + apart) * (total - apart) * (apart + excess) * (apart - excess)
    half = np.arctan2(np.sqrt(np.maximum(across, 0.0)), along)
    half[(apart >= total - tolerance) | (apart <= excess + tolerance)] = 0.0
    half[apart <= tolerance - excess] = _ALL_OF_IT
    return half


def _cuts(towards: Floats, reach: Floats) -> Floats:
    """Return where other circles cut each circle, ascending, shape (circles, 2 circles).

    Circles are cut in different numbers of places: the rows are filled up with their first cut,
    or with 0 where there is none, and the arcs of no length between equal cuts are left out.
    """
    crossed = np.tile((reach > 0.0) & (reach < _ALL_OF_IT), 2)
    angles = np.mod(np.concatenate([towards - reach, towards + reach], axis=1), TURN)
    first = np.min(angles, axis=1, initial=TURN, where=crossed, keepdims=True)
    filled = np.where(crossed, angles, np.where(crossed.any(axis=1, keepdims=True), first, 0.0))
    return np.sort(filled, axis=1)


def _wanted(middle: Floats, towards: Floats, reach: Floats, side: Floats) -> Booleans:
    """Return whether the arcs about these angles lie on the asked side of all other circles."""
    off = middle[:, :, None] - towards[:, None]
    off -= TURN * np.round(off / TURN)
    inside = np.abs(off) < reach[:, None]
    right = inside == (side == INSIDE)
    own = np.arange(side.size)
    right[own, :, own] = True
    wanted: Booleans = np.all(right, axis=2)
    return wanted
