"""Legs: the arrays of a mechanism's legs, one row a leg, which kernels take whole."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import GeometryError


class Legs(NamedTuple):
    """The legs of a mechanism. All arrays have one row a leg; lengths in m, angles in rad.

    A leg ties the platform point `c = p + R platform_point` by a rod of fixed length to the
    end of a crank, which turns about `axis` through `base_point` from `zero_direction`
    towards `quarter_direction` (= axis x zero_direction).
    """

    base_point: Floats
    axis: Floats
    zero_direction: Floats
    quarter_direction: Floats
    crank_length: Floats
    rod_length: Floats
    platform_point: Floats
    lower_limit: Floats
    upper_limit: Floats
    working_mode: Floats


def crank_legs(
    *,
    base_point: Floats,
    axis: Floats,
    zero_direction: Floats,
    crank_length: Floats,
    rod_length: Floats,
    platform_point: Floats,
    limits: Floats,
    working_mode: Floats,
) -> Legs:
    """Return legs whose drives are cranks.

    Parameters
    ----------
    base_point, axis, zero_direction, platform_point : arrays, shape (legs, 3); axes and zero
        directions are unit vectors, perpendicular to each other. [m, -]
    crank_length, rod_length : arrays, shape (legs,), or one number for all. [m]
    limits : array, shape (legs, 2), least and greatest crank angle; infinite where free. [rad]
    working_mode : array, shape (legs,), +1 or -1.

    Raises
    ------
    GeometryError : a length is not positive, or an axis is not perpendicular.
    """
    count = len(base_point)
    crank_length, rod_length = (
        np.array(np.broadcast_to(lengths, count), dtype=float)
        for lengths in (crank_length, rod_length)
    )
    for leg in range(count):
        _check_crank(leg, crank_length[leg], rod_length[leg], axis[leg], zero_direction[leg])
    return Legs(
        np.ascontiguousarray(base_point, dtype=float),
        np.ascontiguousarray(axis, dtype=float),
        np.ascontiguousarray(zero_direction, dtype=float),
        np.cross(axis, zero_direction),
        crank_length,
        rod_length,
        np.ascontiguousarray(platform_point, dtype=float),
        np.ascontiguousarray(limits[:, 0]),
        np.ascontiguousarray(limits[:, 1]),
        np.array(working_mode, dtype=float),
    )


def _check_crank(leg: int, crank: float, rod: float, axis: Floats, zero: Floats) -> None:
    if not (crank > 0.0 and rod > 0.0):
        raise GeometryError(f"leg {leg}: crank {crank} and rod {rod} must be above 0 m", leg=leg)
    for name, vector in (("axis", axis), ("zero direction", zero)):
        if abs(np.linalg.norm(vector) - 1.0) > 1e-12:
            raise GeometryError(f"leg {leg}: its {name} {vector} is no unit vector", leg=leg)
    if abs(axis @ zero) > 1e-12:
        raise GeometryError(
            f"leg {leg}: its zero direction is {axis @ zero} off perpendicular to its axis", leg=leg
        )
