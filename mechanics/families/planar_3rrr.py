"""The planar 3-RRR: a triangular platform carried by three cranks and rods."""

import math

from mechanics.arrays import Floats
from mechanics.families.planar import planar_cranks, triangle
from mechanics.mechanism import Mechanism
from mechanics.motions import PLANAR


def planar_3rrr(
    *,
    base_side: float,
    platform_radius: float,
    crank_length: float,
    rod_length: float,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return a 3-RRR whose base and platform are equilateral triangles.

    The origin is the base triangle's centroid; vertices at 90, 210 and 330 degrees, the
    platform's likewise at phi = 0.

    Parameters
    ----------
    base_side : side of the base triangle. [m]
    platform_radius : circumradius of the platform triangle. [m]
    crank_length, rod_length : lengths of the links. [m]
    limits : array, shape (3, 2), least and greatest crank angle of each leg. [rad]
    working_mode : array, shape (3,), +1 or -1 each.

    Raises
    ------
    GeometryError : a length is not positive.

    References
    ----------
    Laryushkin, Glazunov, Erastova, 2016, fig. 2.
    """
    legs = planar_cranks(
        base_point=triangle(base_side / math.sqrt(3.0)),
        crank_length=crank_length,
        rod_length=rod_length,
        platform_point=triangle(platform_radius),
        limits=limits,
        working_mode=working_mode,
    )
    return Mechanism(PLANAR, legs)
