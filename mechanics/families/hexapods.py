"""Hexapods: six legs and all six motions; struts, rails with rods, or cranks with rods."""

from collections.abc import Sequence

import numpy as np

from mechanics.arrays import Floats
from mechanics.legs import BALL_JOINTS, CRANK, RAIL, STRUT, STRUT_JOINTS, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import SPATIAL

Points = Sequence[Sequence[float]]


def gough_stewart(
    *, base_points: Points, platform_points: Points, limits: Floats, working_mode: Floats
) -> Mechanism:
    """Return a 6-SPS: six telescopic struts between ball joints; drives are their lengths.

    Parameters
    ----------
    base_points, platform_points : shape (6, 3) each. [m]
    limits, working_mode : arrays, shapes (6, 2) and (6,). [m, -]
    """
    legs = [
        Leg(STRUT, base, platform, joints=STRUT_JOINTS)
        for base, platform in zip(base_points, platform_points, strict=True)
    ]
    return Mechanism(SPATIAL, gather(legs, limits, working_mode))


def hexa_linear(
    *,
    base_points: Points,
    rail_directions: Points,
    rod_length: float,
    platform_points: Points,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return a 6-PUS: rods of fixed length on carriages along rails.

    Parameters
    ----------
    base_points : shape (6, 3), where the carriages' joints stand at drive coordinate 0. [m]
    rail_directions : shape (6, 3), of any length but 0.
    rod_length : [m]
    platform_points : shape (6, 3). [m]
    limits, working_mode : arrays, shapes (6, 2) and (6,). [m, -]

    Raises
    ------
    GeometryError : a rail has no direction.

    References
    ----------
    Laryushkin et al., 2019, doi:10.1134/S0235711919030106, fig. 2.
    """
    legs = [
        Leg(
            RAIL,
            base,
            platform,
            axis=direction,
            rod_length=rod_length,
            joints=BALL_JOINTS,
            hinge=hinge_across(direction),
        )
        for base, direction, platform in zip(
            base_points, rail_directions, platform_points, strict=True
        )
    ]
    return Mechanism(SPATIAL, gather(legs, limits, working_mode))


def hexa_rotary(
    *,
    base_points: Points,
    crank_axes: Points,
    crank_zero_directions: Points,
    crank_length: float,
    rod_length: float,
    platform_points: Points,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return a 6-RUS: rods of fixed length on cranks.

    Parameters
    ----------
    base_points : shape (6, 3), on the crank axes. [m]
    crank_axes, crank_zero_directions : shape (6, 3), perpendicular to each other.
    crank_length, rod_length : [m]
    platform_points : shape (6, 3). [m]
    limits, working_mode : arrays, shapes (6, 2) and (6,). [rad, -]

    Raises
    ------
    GeometryError : an axis is zero, or not perpendicular to its zero direction.
    """
    legs = [
        Leg(
            CRANK,
            base,
            platform,
            axis=axis,
            zero_direction=zero,
            crank_length=crank_length,
            rod_length=rod_length,
            joints=BALL_JOINTS,
            hinge=axis,
        )
        for base, axis, zero, platform in zip(
            base_points, crank_axes, crank_zero_directions, platform_points, strict=True
        )
    ]
    return Mechanism(SPATIAL, gather(legs, limits, working_mode))


def hinge_across(direction: Sequence[float] | Floats) -> Floats:
    """Return the first axis of a carriage's universal joint: across the rail, level if it can be.

    Along z x direction; along x where the rail is upright.
    """
    across = np.cross((0.0, 0.0, 1.0), direction)
    size = float(np.linalg.norm(across))
    upright = size <= 1e-9 * float(np.linalg.norm(direction))
    return np.array([1.0, 0.0, 0.0]) if upright else across / size
