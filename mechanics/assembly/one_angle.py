"""Planes that turn with one angle and a sphere: where all of them meet.

The planes M(phi) s = -k(phi) give the point s linearly; |s| = rho is left, a trigonometric
polynomial in phi. Planar, Schoenflies and spherical motions all come down to this.
"""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.assembly.trigonometric import ANGLES, zeros

_NOTHING_LEFT = 1e-13
"""A polynomial below this share of its terms vanishes at every angle."""

_NEARLY_PARALLEL = 1e-3
"""Below this share of its terms a determinant is not divided by."""


class Meetings(NamedTuple):
    """Where planes and sphere may meet, one row a proposal.

    Parameters
    ----------
    cases : array, shape (proposals,): which case it belongs to.
    angles : array, shape (proposals,). [rad]
    points : array, shape (proposals, dimensions): s.
    free : array, shape (cases,): whether every angle would do.
    """

    cases: Integers
    angles: Floats
    points: Floats
    free: Booleans


def meetings(planes: Floats, squares: Floats, degree: int) -> Meetings:
    """Return proposals for all angles and points at which the planes meet the sphere.

    Parameters
    ----------
    planes : array, shape (cases, 3, m, m + 1): of [M | k] the constant part and those of
        cos(phi) and sin(phi); m is 2 or 3.
    squares : array, shape (cases,): rho^2.
    degree : of the polynomial |adj(M) k|^2 - rho^2 det(M)^2.
    """
    around = _turned(planes[:, :, None], ANGLES)
    points, dets = _cramer(around)
    values = np.sum(points**2, axis=-1) - squares[:, None] * dets**2
    sizes, others = _norms(planes[..., :-1]), _norms(planes[..., -1:])
    m = planes.shape[2]
    terms = sizes ** (2 * m - 2) * (others**2 + np.abs(squares) * sizes**2)
    free = ~(np.abs(values).max(axis=1) > _NOTHING_LEFT * terms)
    angles = np.full((len(planes), 2 * degree), np.nan)
    angles[~free] = zeros(values[~free], degree)
    cases, columns = np.nonzero(np.isfinite(angles))
    return _points(planes, squares, cases, angles[cases, columns], free)


def _turned(planes: Floats, angles: Floats) -> Floats:
    """Return [M | k] at angles, shape (..., m, m + 1), of its parts on the second axis."""
    c, s = np.cos(angles)[:, None, None], np.sin(angles)[:, None, None]
    turned: Floats = planes[:, 0] + c * planes[:, 1] + s * planes[:, 2]
    return turned


def _norms(parts: Floats) -> Floats:
    norms: Floats = np.sqrt(np.sum(parts**2, axis=(1, 2, 3)))
    return norms


def _points(
    planes: Floats, squares: Floats, cases: Integers, angles: Floats, free: Booleans
) -> Meetings:
    """Return what the planes meet in at the angles: a point, or a line's two on the sphere."""
    at = _turned(planes[cases], angles)
    above, dets = _cramer(at)
    sizes = _norms(planes[..., :-1])[cases]
    lines = ~(np.abs(dets) > _NEARLY_PARALLEL * sizes ** at.shape[1])
    ends = _on_lines(at[lines], squares[cases[lines]])
    single = -above[~lines] / dets[~lines, None]
    return Meetings(
        np.concatenate([cases[~lines], cases[lines], cases[lines]]),
        np.concatenate([angles[~lines], angles[lines], angles[lines]]),
        np.concatenate([single, ends[0], ends[1]]),
        free,
    )


def _cramer(planes: Floats) -> tuple[Floats, Floats]:
    """Return adj(M) k and det M of [M | k], shape (..., m, m + 1)."""
    rows, k = planes[..., :-1], planes[..., -1]
    if rows.shape[-1] == 2:
        a, b = rows[..., 0, :], rows[..., 1, :]
        det = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
        x = b[..., 1] * k[..., 0] - a[..., 1] * k[..., 1]
        y = a[..., 0] * k[..., 1] - b[..., 0] * k[..., 0]
        return np.stack([x, y], axis=-1), det
    a, b, c = (rows[..., row, :] for row in range(3))
    columns = np.cross(b, c), np.cross(c, a), np.cross(a, b)
    weighed = sum(k[..., row, None] * column for row, column in enumerate(columns))
    return np.asarray(weighed), np.sum(a * columns[0], axis=-1)


def _on_lines(planes: Floats, squares: Floats) -> Floats:
    """Return, shape (2, cases, m), where the line of nearly parallel planes cuts the sphere.

    The line runs along the singular vector of the least singular value.
    """
    left, values, right = np.linalg.svd(planes[..., :-1])
    along = right[:, -1]
    sides = np.sum(left * planes[..., -1:], axis=1)[:, :-1]
    wide = values[:, :-1] > 1e-12 * values[:, :1]
    shares = np.where(wide, sides / np.where(wide, values[:, :-1], 1.0), 0.0)
    foot = -np.sum(shares[..., None] * right[:, :-1], axis=1)
    rest = np.sqrt(np.maximum(0.0, squares - np.sum(foot**2, axis=1)))
    return np.stack([foot + rest[:, None] * along, foot - rest[:, None] * along])
