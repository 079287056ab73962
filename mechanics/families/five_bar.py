"""The five-bar: two cranks in a plane whose rods meet in the platform's point."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.families.planar import planar_cranks
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
    half = 0.5 * base_distance
    legs = planar_cranks(
        base_point=np.array([[-half, 0.0], [half, 0.0]]),
        crank_length=crank_length,
        rod_length=rod_length,
        platform_point=np.zeros((2, 2)),
        limits=limits,
        working_mode=working_mode,
    )
    return Mechanism(PLANAR_TRANSLATION, legs)
