"""Angles, and values between bounds: what conditions have in common."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.condition import Breach


def margin_between(values: Floats, lower: float | Floats, upper: float | Floats) -> Floats:
    """Return how far inside [lower, upper] the values are; < 0: outside, NaN stays NaN."""
    return np.minimum(values - lower, upper - values)


def nearest_bound(values: Floats, lower: float | Floats, upper: float | Floats) -> Breach:
    """Return the values beside the bound that each breaks or is nearest to."""
    return Breach(values, np.where(values - lower < upper - values, lower, upper))


def at_most(values: Floats, limit: float | Floats) -> Breach:
    """Return the values beside the limit that none of them may exceed."""
    return Breach(values, np.broadcast_to(limit, values.shape))


def angles_between(first: Floats, second: Floats) -> Floats:
    """Return the angles, shape (parts, poses), of vectors, shape (parts, 3, poses) each. [rad]"""
    # The arc cosine alone would lose half the digits where the vectors fold or align.
    sines = np.linalg.norm(np.cross(first, second, axis=1), axis=1)
    angles: Floats = np.arctan2(sines, products(first, second))
    return angles


def products(first: Floats, second: Floats) -> Floats:
    """Return the inner products, shape (parts, poses), of vectors, shape (parts, 3, poses) each.

    Summed in the same order always: `einsum` has another for one pose than for many, and what
    holds at a pose would depend on its company.
    """
    total: Floats = first[:, 0] * second[:, 0]
    for j in (1, 2):
        total += first[:, j] * second[:, j]
    return total
