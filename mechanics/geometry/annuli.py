"""Annuli, the regions of planar legs, and what several of them have in common, exactly."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, isfinite

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.errors import GeometryError
from mechanics.geometry.arcs import ArcRegion
from mechanics.geometry.circles import INSIDE, OUTSIDE, Circles, boundary


@dataclass(frozen=True)
class Annulus:
    """The points between two circles about one centre, both included.

    Parameters
    ----------
    centre : array, shape (2,). [m]
    inner, outer : radii; inner 0 is a disc, outer inf the plane but for a hole. [m]

    Raises
    ------
    GeometryError : the radii are not 0 <= inner <= outer, or a number is none.
    """

    centre: Floats
    inner: float
    outer: float

    def __post_init__(self) -> None:
        """Refuse radii that make no annulus."""
        numbers = bool(np.all(np.isfinite(self.centre))) and isfinite(self.inner)
        if not (numbers and 0.0 <= self.inner <= self.outer):
            raise GeometryError(
                f"an annulus needs a finite centre and radii 0 <= inner <= outer; "
                f"given {np.asarray(self.centre).tolist()}, {self.inner}, {self.outer}"
            )

    def contains(self, points: Floats) -> Booleans:
        """Return which points, shape (..., 2), lie in it. [m]"""
        away = np.hypot(points[..., 0] - self.centre[0], points[..., 1] - self.centre[1])
        inside: Booleans = (away >= self.inner) & (away <= self.outer)
        return inside


def contains(annuli: Sequence[Annulus], points: Floats) -> Booleans:
    """Return which points, shape (..., 2), lie in all annuli. [m]"""
    inside: Booleans = np.all([annulus.contains(points) for annulus in annuli], axis=0)
    return inside


def intersect(annuli: Sequence[Annulus]) -> ArcRegion:
    """Return what all annuli have in common.

    Parameters
    ----------
    annuli : in any order; they may touch, coincide, lie in one another, or miss each other.

    Raises
    ------
    GeometryError : none of them has an outer circle.

    References
    ----------
    Erastova, Laryushkin, 2017, doi:10.18698/0536-1044-2017-8-78-87 (the geometric way).
    """
    rows = [
        (*annulus.centre, radius, side)
        for annulus in annuli
        for radius, side in ((annulus.outer, INSIDE), (annulus.inner, OUTSIDE))
        if radius < inf
    ]
    if not any(annulus.outer < inf for annulus in annuli):
        raise GeometryError("at least one annulus must have an outer circle: there is no end else")
    table = np.array(rows, dtype=float)
    return ArcRegion(boundary(Circles(table[:, :2], table[:, 2], table[:, 3])))
