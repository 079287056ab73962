"""Points and directions that families set around the z axis."""

import numpy as np

from mechanics.arrays import Floats


def outward() -> Floats:
    """Return unit vectors, shape (3, 3), at 90, 210 and 330 degrees in the plane z = 0.

    Written with roots, not with sines of angles: a mirrored grid then gives mirrored figures.
    """
    half, side = 0.5, 0.5 * np.sqrt(3.0)
    return np.array([[0.0, 1.0, 0.0], [-side, -half, 0.0], [side, -half, 0.0]])


UP = np.array([0.0, 0.0, 1.0])
