"""The five-bar: two cranks in a plane whose rods meet in the platform's point."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import require_positive
from mechanics.legs import CRANK, PLANE_JOINTS, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import PLANAR_TRANSLATION


def five_bar(
    *,
    base_distance: float,
    crank_length: float,
    rod_length: float,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return a five-bar with base joints at (-base_distance/2, 0) and (base_distance/2, 0).

    Parameters
    ----------
    base_distance, crank_length, rod_length : lengths of the links. [m]
    limits : array, shape (2, 2), least and greatest crank angle of each leg. [rad]
    working_mode : array, shape (2,), +1 or -1 each.

    Raises
    ------
    GeometryError : a length is not positive.

    References
    ----------
    Erastova, Laryushkin, 2017, doi:10.18698/0536-1044-2017-8-78-87, fig. 7.
    """
    require_positive(base_distance=base_distance)
    half = 0.5 * base_distance
    legs = [
        planar_leg(np.array([x, 0.0, 0.0]), np.zeros(3), crank_length, rod_length)
        for x in (-half, half)
    ]
    return Mechanism(PLANAR_TRANSLATION, gather(legs, limits, working_mode))


def planar_leg(
    base_point: Floats, platform_point: Floats, crank_length: float, rod_length: float
) -> Leg:
    """Return a leg of three revolutes in the plane: its crank turns about +z from +x."""
    return Leg(
        CRANK,
        base_point,
        platform_point,
        axis=(0.0, 0.0, 1.0),
        zero_direction=(1.0, 0.0, 0.0),
        crank_length=crank_length,
        rod_length=rod_length,
        joints=PLANE_JOINTS,
        hinge=(0.0, 0.0, 1.0),
    )
