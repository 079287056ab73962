"""What we are measured against: the same questions in vectorised NumPy."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def reach_grid(
    base: Floats, platform: Floats, near: float, far: float, x: Floats, y: Floats
) -> Floats:
    """Return which nodes every planar leg reaches at phi = 0: annuli about base - platform."""
    inside = np.ones((x.size, y.size), dtype=bool)
    for centre in base - platform:
        squares = (x[:, None] - centre[0]) ** 2 + (y[None, :] - centre[1]) ** 2
        inside &= (squares <= far * far) & (squares >= near * near)
    return inside


def worst_efforts(jacobians: Floats, force: float) -> Floats:
    """Return the greatest efforts, shape (poses, drives), from Jacobians by batched inversion."""
    inverses = np.linalg.inv(jacobians)
    efforts: Floats = force * np.linalg.norm(inverses[:, :2, :], axis=1)
    return efforts
