"""A platform on six rods as sixty numbers, and the way back from solutions to poses.

The equations are those of `mechanics.kernels.platform_equations`. Origins are the joints of the
longest rod, whose length is the unit; the axes of base and platform are those of their joints,
the one along which these spread least last.
"""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from mechanics.arrays import Complexes, Floats, Integers

Numbers = TypeVar("Numbers", Floats, Complexes)

PAIRS = [(i, j) for i in range(4) for j in range(i, 4)]
"""Which products e_i e_j the ten coefficients of a quadric belong to."""

_FIRST, _SECOND = np.array(PAIRS).T
_TWICE = np.where(_FIRST == _SECOND, 1.0, 2.0)
_NUMBER = {(i, j): n for n, pair in enumerate(PAIRS) for i, j in (pair, pair[::-1])}

LEAST_RANK = 1e-9
"""Base and platform count as affinely related below this share of the greatest singular value."""


def _quadric(terms: dict[tuple[int, int], float]) -> Floats:
    """Return the coefficients of a sum of products e_i e_j, those of i != j halved."""
    row = np.zeros(10)
    for (i, j), factor in terms.items():
        row[_NUMBER[i, j]] = factor if i == j else factor / 2.0
    return row


def _squares(a: int, b: int, c: int, d: int) -> dict[tuple[int, int], float]:
    return {(0, 0): a, (1, 1): b, (2, 2): c, (3, 3): d}


NORM = _quadric(_squares(1, 1, 1, 1))
"""h = e.e"""

ROTATION = np.array(
    [
        _quadric(_squares(1, 1, -1, -1)),
        _quadric({(1, 2): 2, (0, 3): -2}),
        _quadric({(1, 3): 2, (0, 2): 2}),
        _quadric({(1, 2): 2, (0, 3): 2}),
        _quadric(_squares(1, -1, 1, -1)),
        _quadric({(2, 3): 2, (0, 1): -2}),
        _quadric({(1, 3): 2, (0, 2): -2}),
        _quadric({(2, 3): 2, (0, 1): 2}),
        _quadric(_squares(1, -1, -1, 1)),
    ]
)
"""M = h R(e), row by row."""

# With e = e' i, number n of e' is number n ^ 1 of e, with a sign; likewise j and k.
FRAME_SIGNS = np.array([[1.0, 1, 1, 1], [1, -1, -1, 1], [1, 1, -1, -1], [1, -1, 1, -1]])
_SWAPPED = np.array([False, True, True, False])
_ROWS = np.array([[0, 1, 2, 3, 4], [0, 3, 2, 1, 4], [2, 1, 0, 3, 4], [2, 3, 0, 1, 4]])
_COLUMNS = np.array(
    [
        [_NUMBER[i ^ u, j ^ u] for i, j in PAIRS] + ([11, 10] if _SWAPPED[u] else [10, 11])
        for u in range(4)
    ]
)
_COLUMN_SIGNS = np.array([[s[i] * s[j] for i, j in PAIRS] + [1, 1] for s in FRAME_SIGNS])


@dataclass(frozen=True)
class NormalForm:
    """A platform's equations and how they were scaled and turned.

    Parameters
    ----------
    coefficients : array, shape (5, 12): of S1, S2, D1, D2 and of the row that vanishes.
    leg : the longest rod.
    scale : its length. [m]
    base_axes, platform_axes : arrays, shape (3, 3), one axis a row.
    rank : least over greatest singular value of the rows that were solved; 0 where base and
        platform are affinely related.
    """

    coefficients: Floats
    leg: int
    scale: float
    base_axes: Floats
    platform_axes: Floats
    rank: float


def normal_form(base: Floats, platform: Floats, lengths: Floats, turn: float = 0.0) -> NormalForm:
    """Return the platform's equations.

    Parameters
    ----------
    base, platform : arrays, shape (6, 3), the ends of the rods. [m]
    lengths : array, shape (6,). [m]
    turn : by how much the platform's axes are turned about the last; base axes the other way. [rad]
    """
    leg = int(np.argmax(lengths))
    scale = float(lengths[leg])
    base_axes, platform_axes = principal_axes(np.array([base, platform]))
    base_axes, platform_axes = _turned(base_axes, -turn), _turned(platform_axes, 0.7 * turn)
    others = np.arange(6) != leg
    a = (base[others] - base[leg]) @ base_axes.T / scale
    b = (platform[others] - platform[leg]) @ platform_axes.T / scale
    k = 0.5 * ((lengths[others] / scale) ** 2 - 1.0 - np.sum(a * a + b * b, axis=1))
    products = (a[:, :, None] * b[:, None, :]).reshape(5, 9)
    # b.Q - a.P = right side, unknowns P1, P2, Q1, Q2; P3 = (S3 + D3) / 2, Q3 = (S3 - D3) / 2.
    right = np.empty((5, 12))
    right[:, :10] = products @ ROTATION + k[:, None] * NORM
    right[:, 10], right[:, 11] = 0.5 * (a[:, 2] - b[:, 2]), 0.5 * (a[:, 2] + b[:, 2])
    u, sizes, v = np.linalg.svd(np.hstack([-a[:, :2], b[:, :2]]))
    right = u.T @ right
    rank = float(sizes[3] / sizes[0]) if sizes[0] > 0.0 else 0.0
    if rank < LEAST_RANK:
        return NormalForm(right, leg, scale, base_axes, platform_axes, 0.0)
    P1, P2, Q1, Q2 = v.T @ (right[:4] / sizes[:, None])
    rest = right[4] / (np.linalg.norm(right[4]) or 1.0)
    coefficients = np.array([P1 + Q1, P2 + Q2, P1 - Q1, P2 - Q2, rest])
    return NormalForm(coefficients, leg, scale, base_axes, platform_axes, rank)


def principal_axes(points: Floats) -> Floats:
    """Return right-handed axes of sets of points, one axis a row, that of the least spread last."""
    away = points - points.mean(axis=1, keepdims=True)
    # Eigenvectors of the least spread come first, as columns.
    axes: Floats = np.swapaxes(np.linalg.eigh(np.swapaxes(away, 1, 2) @ away)[1], 1, 2)[:, ::-1]
    axes = np.ascontiguousarray(axes)
    axes[np.linalg.det(axes) < 0.0, 0] *= -1.0
    return axes


def _turned(axes: Floats, angle: float) -> Floats:
    if angle == 0.0:
        return axes
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ axes


def in_all_frames(coefficients: Numbers) -> Numbers:
    """Return the coefficients for e = e', e' i, e' j and e' k, shape (4, 5, 12)."""
    chosen = coefficients[_ROWS[:, :, None], _COLUMNS[:, None, :]]
    turned: Numbers = chosen * _COLUMN_SIGNS[:, None, :]
    return turned


def to_frames(solutions: Complexes) -> tuple[Floats, Integers]:
    """Return solutions e, S3, D3, shape (solutions, 6), each in the frame where e0 is largest.

    Scaled to e0 = 1 there: e1, e2, e3, S3, D3, real and imaginary parts in turns, shape
    (solutions, 10), and the number of the frame.
    """
    frames = np.argmax(np.abs(solutions[:, :4]), axis=1)
    turned = _turn_by(solutions, frames)
    scaled = turned[:, 1:] / turned[:, :1]
    scaled[:, 3:] /= turned[:, :1]
    return scaled.view(float), frames


def _turn_by(solutions: Complexes, frames: Integers) -> Complexes:
    places = np.arange(4) ^ frames[:, None]
    turned = solutions.copy()
    turned[:, :4] = np.take_along_axis(solutions, places, axis=1) * FRAME_SIGNS[frames]
    turned[:, 4:] = np.where(_SWAPPED[frames, None], solutions[:, :3:-1], solutions[:, 4:])
    return turned


def quadratic_monomials(e: Numbers) -> Numbers:
    """Return the products that a row of coefficients is multiplied by, shape (n, 10)."""
    products: Numbers = e[:, _FIRST] * e[:, _SECOND] * _TWICE
    return products


def poses(form: NormalForm, solutions: Floats) -> tuple[Floats, Floats]:
    """Return positions (solutions, 3) and rotations (solutions, 3, 3) of real solutions. [m, -]

    Positions are those of the origin that the platform's points were given from, which is the
    joint of the longest rod: the caller moves them on.
    """
    e, free = solutions[:, :4], solutions[:, 4:]
    products = quadratic_monomials(e)
    h = products @ NORM
    X = np.hstack([products, free]) @ form.coefficients[:4].T
    P = 0.5 * np.column_stack([X[:, 0] + X[:, 2], X[:, 1] + X[:, 3], free.sum(axis=1)])
    turns = (products @ ROTATION.T / h[:, None]).reshape(-1, 3, 3)
    positions = form.scale * (P / h[:, None]) @ form.base_axes
    rotations: Floats = form.base_axes.T @ turns @ form.platform_axes
    return positions, rotations
