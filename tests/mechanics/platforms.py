"""A hexapod on struts, in some orientation, for more than one test."""

import math

import numpy as np

from mechanics.families.hexapods import gough_stewart
from mechanics.mechanism import Mechanism

TURNED = np.array([0.0, 0.0, 0.0, 0.1, -0.2, 0.3])


def hexagon(radius: float, spread: float) -> list[list[float]]:
    angles = [math.radians(a + s) for a in (90, 210, 330) for s in (-spread, spread)]
    return [[radius * math.cos(a), radius * math.sin(a), 0.0] for a in angles]


def hexapod(lower: float = 0.6, upper: float = 0.9) -> Mechanism:
    return gough_stewart(
        base_points=hexagon(0.5, 15.0),
        platform_points=hexagon(0.3, 45.0),
        limits=np.array([[lower, upper]] * 6),
        working_mode=np.ones(6),
    )
