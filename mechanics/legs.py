"""Legs: how one is described, and the arrays of all legs which kernels take whole."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.errors import GeometryError

CRANK, RAIL, STRUT = 0, 1, 2
"""What drives a leg."""

PLANE_JOINTS, BALL_JOINTS, PARALLEL_JOINTS, STRUT_JOINTS, ARC_JOINTS = 0, 1, 2, 3, 4
"""The passive joints of a leg: two revolutes of a plane; universal at the elbow and ball at the
platform; universal at both, the rod one of a parallelogram; ball at both ends; revolutes of arcs.
"""

_NOTHING = (0.0, 0.0, 0.0)
_LEAST_LENGTH = 1e-12
_PERPENDICULAR = 1e-9
_ROUNDING = 1e-15


@dataclass(frozen=True)
class Leg:
    """One leg. Points and directions are three numbers each. [m]

    Parameters
    ----------
    drive : `CRANK`, `RAIL` or `STRUT`.
    base_point, platform_point : A, and c0 from the platform's reference point. [m]
    axis : a crank's axis or a rail's direction.
    zero_direction : where a crank of angle 0 points, perpendicular to its axis.
    crank_length, rod_length : of a crank's leg; a rail has the rod only, a strut neither. [m]
    joints : its passive joints, `*_JOINTS`.
    hinge : the first axis of the universal joint at the elbow, fixed in the driven link.
    unit_rods : whether rod directions are unit vectors; an arc's keep their length, so that
        its row is (w x v) of the intermediate and the platform axis.
    """

    drive: int
    base_point: Sequence[float] | Floats
    platform_point: Sequence[float] | Floats
    axis: Sequence[float] | Floats = _NOTHING
    zero_direction: Sequence[float] | Floats = _NOTHING
    crank_length: float = 0.0
    rod_length: float = 0.0
    joints: int = BALL_JOINTS
    hinge: Sequence[float] | Floats = _NOTHING
    unit_rods: bool = True


class Legs(NamedTuple):
    """The legs of a mechanism. All arrays have one row a leg; lengths in m, angles in rad.

    A leg ties the platform point `c = p + R platform_point` to `B` by a rod of fixed length,
    `B = base_point + crank_length (zero_direction cos psi + quarter_direction sin psi)` for a
    crank and `B = base_point + psi axis` for a rail; a strut is itself of length psi.
    """

    drive: Integers
    base_point: Floats
    axis: Floats
    zero_direction: Floats
    quarter_direction: Floats
    crank_length: Floats
    rod_length: Floats
    rod_scale: Floats
    platform_point: Floats
    joints: Integers
    hinge: Floats
    lower_limit: Floats
    upper_limit: Floats
    working_mode: Floats


def gather(legs: Sequence[Leg], limits: Floats, working_mode: Floats) -> Legs:
    """Return the arrays of these legs, axes and directions made unit vectors.

    Parameters
    ----------
    legs : the legs, in order.
    limits : array, shape (legs, 2), least and greatest drive coordinate. [rad or m]
    working_mode : array, shape (legs,), +1 or -1.

    Raises
    ------
    GeometryError : a length is not positive, an axis is zero or not perpendicular; with the leg.
    """
    for number, leg in enumerate(legs):
        _check(number, leg)
    axes = _units([leg.axis for leg in legs])
    zeros = _across(axes, _units([leg.zero_direction for leg in legs]))
    rods = np.array([leg.rod_length for leg in legs], dtype=float)
    return Legs(
        drive=np.array([leg.drive for leg in legs], dtype=np.int64),
        base_point=_rows([leg.base_point for leg in legs]),
        axis=axes,
        zero_direction=zeros,
        quarter_direction=np.cross(axes, zeros),
        crank_length=np.array([leg.crank_length for leg in legs], dtype=float),
        rod_length=rods,
        rod_scale=np.where([leg.unit_rods for leg in legs], rods, 1.0),
        platform_point=_rows([leg.platform_point for leg in legs]),
        joints=np.array([leg.joints for leg in legs], dtype=np.int64),
        hinge=_units([leg.hinge for leg in legs]),
        lower_limit=np.ascontiguousarray(limits[:, 0]),
        upper_limit=np.ascontiguousarray(limits[:, 1]),
        working_mode=np.array(working_mode, dtype=float),
    )


def _rows(vectors: Sequence[Sequence[float] | Floats]) -> Floats:
    return np.ascontiguousarray(np.array(vectors, dtype=float))


def _units(vectors: Sequence[Sequence[float] | Floats]) -> Floats:
    rows = _rows(vectors)
    lengths = np.linalg.norm(rows, axis=1, keepdims=True)
    # What is a unit vector already stays as it is, bit for bit.
    lengths[(lengths == 0.0) | (np.abs(lengths - 1.0) < 1e-15)] = 1.0
    return np.ascontiguousarray(rows / lengths)


def _across(axes: Floats, directions: Floats) -> Floats:
    """Return directions that are nearly so, shape (legs, 3), perpendicular to their axes."""
    off = np.sum(directions * axes, axis=1, keepdims=True)
    # What rounding alone has left stays as it is, bit for bit.
    return _units(list(np.where(np.abs(off) > _ROUNDING, directions - off * axes, directions)))


def _check(number: int, leg: Leg) -> None:
    if leg.drive != STRUT and not leg.rod_length > 0.0:
        raise GeometryError(f"its rod must be above 0 m; given {leg.rod_length}", leg=number)
    if leg.drive == STRUT:
        return
    name = "axis" if leg.drive == CRANK else "direction"
    if np.linalg.norm(leg.axis) < _LEAST_LENGTH:
        raise GeometryError(f"its {name} must not be zero", leg=number)
    if leg.drive == CRANK:
        _check_crank(number, leg)


def _check_crank(number: int, leg: Leg) -> None:
    if not leg.crank_length > 0.0:
        raise GeometryError(f"its crank must be above 0 m; given {leg.crank_length}", leg=number)
    axis, zero = _units([leg.axis, leg.zero_direction])
    if np.linalg.norm(leg.zero_direction) < _LEAST_LENGTH:
        raise GeometryError("its zero direction must not be zero", leg=number)
    if abs(axis @ zero) > _PERPENDICULAR:
        off = abs(90.0 - np.degrees(np.arccos(np.clip(axis @ zero, -1.0, 1.0))))
        raise GeometryError(
            f"its zero direction must be perpendicular to its axis; it is {off:.6g} degrees off",
            leg=number,
        )
