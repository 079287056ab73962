"""What the planar crank families share: cranks about +z from +x, points on circles."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.legs import Legs, crank_legs


def planar_cranks(
    *,
    base_point: Floats,
    crank_length: float,
    rod_length: float,
    platform_point: Floats,
    limits: Floats,
    working_mode: Floats,
) -> Legs:
    """Return crank legs in the plane z = 0, their points given as shape (legs, 2). [m, rad]"""
    count = len(base_point)
    return crank_legs(
        base_point=np.c_[base_point, np.zeros(count)],
        axis=np.tile([0.0, 0.0, 1.0], (count, 1)),
        zero_direction=np.tile([1.0, 0.0, 0.0], (count, 1)),
        crank_length=np.asarray(crank_length),
        rod_length=np.asarray(rod_length),
        platform_point=np.c_[platform_point, np.zeros(count)],
        limits=limits,
        working_mode=working_mode,
    )


def triangle(radius: float) -> Floats:
    """Return the vertices, shape (3, 2), of the triangle of this circumradius at 90, 210, 330 deg.

    Written with roots, not with sines of angles: a mirrored grid then gives mirrored figures.
    """
    half, side = 0.5 * radius, 0.5 * np.sqrt(3.0) * radius
    return np.array([[0.0, radius], [-side, -half], [side, -half]])
