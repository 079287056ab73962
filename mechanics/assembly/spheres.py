"""Where two circles or three spheres meet; with it, platforms that do not turn.

A leg then holds the reference point on a sphere about B - c0.
"""

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.proposals import Proposals

ROUTE = "closed form"

_TOUCHING = 1e-6
"""Spheres that miss each other by less are proposed to touch, as a share of a square of radius."""

_IN_LINE = 1e-7
"""Centres are in one line below this sine: of a point too few digits are left then."""

_COINCIDENT = 1e-12
"""Centres are one if they are nearer, as a share of the greatest length."""


def meet(centres: Floats, squares: Floats) -> tuple[Floats, Booleans]:
    """Return the two points in which circles or spheres meet, and whether they are so determined.

    The differences of their equations are lines or planes, whose common point or line is
    cut with the first of them.

    Parameters
    ----------
    centres : array, shape (..., n, n): n circles (2) in the plane or spheres (3) in space. [m]
    squares : array, shape (..., n), of the radii. [m^2]

    Returns
    -------
    points : array, shape (..., 2, n); NaN where they do not meet, twice the same where they touch.
    determined : array, shape (...,): not so where the centres coincide or stand in one line.
    """
    rows = centres[..., 1:, :] - centres[..., :1, :]
    lengths = np.sum(rows**2, axis=-1)
    heights = 0.5 * (squares[..., :1] - squares[..., 1:] + lengths)
    along, foot = _line(rows, heights)
    normal = np.sum(along**2, axis=-1)
    # Not-a-number, where an earlier joint is out of reach already, leaves nothing open.
    in_line = normal <= _IN_LINE**2 * np.prod(lengths, axis=-1)
    # Centres that coincide are told apart by rounding, which grows with their distance from 0.
    sizes = np.max(squares, axis=-1) + np.max(np.sum(centres**2, axis=-1), axis=-1)
    determined = ~(in_line | (np.min(lengths, axis=-1) <= _COINCIDENT**2 * sizes))
    with np.errstate(divide="ignore", invalid="ignore"):
        foot = foot / normal[..., None]
        rest = squares[..., 0] - np.sum(foot**2, axis=-1)
        near = np.abs(rest) <= _TOUCHING * squares[..., 0]
        rest = np.where(near, np.maximum(rest, 0.0), rest)
        reach = np.sqrt(rest / normal)[..., None] * along
    middle = centres[..., 0, :] + foot
    return np.stack([middle + reach, middle - reach], axis=-2), determined


def _line(rows: Floats, heights: Floats) -> tuple[Floats, Floats]:
    """Return a direction n of the line r_i s = h_i, and |n|^2 times its point next to 0."""
    if rows.shape[-1] == 2:
        r = rows[..., 0, :]
        return np.stack([-r[..., 1], r[..., 0]], axis=-1), heights[..., :1] * r
    a, b = rows[..., 0, :], rows[..., 1, :]
    n = np.cross(a, b)
    foot = heights[..., :1] * np.cross(b, n) + heights[..., 1:] * np.cross(n, a)
    return n, foot


def propose(legs: BrakedLegs) -> Proposals:
    """Return proposals for all modes of braked legs under a platform that does not turn."""
    basis = legs.mechanism.motion.twists[:3]
    points = legs.mechanism.legs.platform_point
    centres = legs.rod_starts.transpose(2, 0, 1) - points
    flat = centres @ basis
    # What the motion cannot change is taken off the rod: a sphere cut by the plane of motion.
    rest = np.sum((centres - flat @ basis.T) ** 2, axis=2)
    ends, determined = meet(flat, legs.rod_lengths.T**2 - rest)
    cases, sides = np.nonzero(np.all(np.isfinite(ends), axis=2))
    return Proposals(cases, ends[cases, sides].T, determined, (ROUTE,) * len(centres))
