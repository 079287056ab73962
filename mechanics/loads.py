"""Loads on the platform: of known direction, or of known size only."""

from dataclasses import dataclass, field

import numpy as np

from mechanics.arrays import Floats


@dataclass(frozen=True)
class Load:
    """A force and a moment about the reference point, each in its own worst direction.

    Parameters
    ----------
    force, moment : sizes, not below 0. [N, N m]
    known : array, shape (6, poses) or (6, 1): a wrench on top whose direction is
        known. [N, N m]
    """

    force: float = 0.0
    moment: float = 0.0
    known: Floats = field(default_factory=lambda: np.zeros((6, 1)))
