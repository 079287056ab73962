"""Values between two bounds: what conditions on angles and efforts have in common."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.conditions.condition import Breach


def margin_between(values: Floats, lower: float | Floats, upper: float | Floats) -> Floats:
    """Return how far inside [lower, upper] the values are; < 0: outside, NaN stays NaN."""
    return np.minimum(values - lower, upper - values)


def nearest_bound(values: Floats, lower: float | Floats, upper: float | Floats) -> Breach:
    """Return the values beside the bound that each breaks or is nearest to."""
    return Breach(values, np.where(values - lower < upper - values, lower, upper))
