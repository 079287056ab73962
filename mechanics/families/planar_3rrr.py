"""The planar 3-RRR: a triangular platform carried by three cranks and rods."""

import math

from mechanics.arrays import Floats
from mechanics.errors import require_positive
from mechanics.families.circles import outward
from mechanics.families.five_bar import planar_leg
from mechanics.legs import gather
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
    require_positive(base_side=base_side, platform_radius=platform_radius)
    base_radius = base_side / math.sqrt(3.0)
    legs = [
        planar_leg(base_radius * out, platform_radius * out, crank_length, rod_length)
        for out in outward()
    ]
    return Mechanism(PLANAR, gather(legs, limits, working_mode))
