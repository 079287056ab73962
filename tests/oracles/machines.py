"""Mechanisms as bodies and rods, worked out anew from the dimensions on the wire.

Nothing of the product is used here. A machine is a platform and driven links, tied by rods of
fixed length; a parallelogram may stand as its middle rod or as the two rods that it is made of.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Wire = Mapping[str, Any]

X, Y, Z = np.eye(3)
NOWHERE = np.zeros(3)
OUTWARD = [np.array([math.cos(a), math.sin(a), 0.0]) for a in np.deg2rad([90.0, 210.0, 330.0])]


class Rod(NamedTuple):
    """From a point of the driven link, in its frame, to one of the platform, in its own. [m]"""

    tip: Floats
    end: Floats
    length: float


@dataclass(frozen=True)
class Leg:
    """A driven link with its rods; a strut has no link and one rod, of the length of the drive.

    A crank turns about the last column of `frame` and a carriage slides along it.
    """

    drive: str
    base: Floats
    rods: tuple[Rod, ...]
    frame: Floats


@dataclass(frozen=True)
class Machine:
    """Legs under a platform with one of the six motions; `axis` is that of a single turn.

    `pairs` is half the width of parallelograms; 0: middle rods, and the missing motions locked.
    """

    motion: str
    legs: tuple[Leg, ...]
    axis: Floats
    pairs: float = 0.0


def unit(vector: Sequence[float] | Floats) -> Floats:
    direction: Floats = np.array(vector, dtype=float)
    return direction / math.sqrt(direction @ direction)


def frame_about(axis: Floats) -> Floats:
    """Return a right-handed frame, as columns, whose last axis is the given one."""
    aside = unit(np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))]))
    return np.column_stack([aside, np.cross(axis, aside), axis])


def crank(
    base: Floats,
    axis: Floats,
    zero: Floats,
    lengths: tuple[float, float],
    end: Floats,
    half: float = 0.0,
) -> Leg:
    """Return a leg of crank and rod, or of crank and two rods `half` to either side."""
    sides = (half, -half) if half else (0.0,)
    rods = tuple(Rod(lengths[0] * X + s * Z, end + s * axis, lengths[1]) for s in sides)
    return Leg("crank", base, rods, np.column_stack([zero, np.cross(axis, zero), axis]))


def rail(
    base: Floats,
    direction: Floats,
    length: float,
    end: Floats,
    aside: Floats = NOWHERE,
) -> Leg:
    """Return a leg of carriage and rod, or of carriage and two rods `aside` to either side."""
    frame = frame_about(direction)
    sides = (1.0, -1.0) if aside.any() else (0.0,)
    rods = tuple(Rod(s * aside @ frame, end + s * aside, length) for s in sides)
    return Leg("rail", base, rods, frame)


def strut(base: Floats, end: Floats) -> Leg:
    return Leg("strut", base, (Rod(NOWHERE, end, math.nan),), np.eye(3))


def _five_bar(wire: Wire, pairs: float) -> Machine:
    lengths = wire["crank_length"], wire["rod_length"]
    ends = (-0.5 * wire["base_distance"] * X, 0.5 * wire["base_distance"] * X)
    legs = tuple(crank(base, Z, X, lengths, NOWHERE) for base in ends)
    return Machine("planar_translation", legs, Z)


def _planar_3rrr(wire: Wire, pairs: float) -> Machine:
    lengths = wire["crank_length"], wire["rod_length"]
    radius = wire["base_side"] / math.sqrt(3.0)
    legs = tuple(
        crank(radius * out, Z, X, lengths, wire["platform_radius"] * out) for out in OUTWARD
    )
    return Machine("planar", legs, Z)


def _translational_3rrrr(wire: Wire, pairs: float) -> Machine:
    lengths = wire["link_length"], wire["link_length"]
    legs = tuple(
        crank(wire["base_radius"] * after, axis, after, lengths, NOWHERE, pairs)
        for axis, after in ((X, Y), (Y, Z), (Z, X))
    )
    return Machine("translation", legs, NOWHERE, pairs)


def _delta_rotary(wire: Wire, pairs: float) -> Machine:
    lengths = wire["crank_length"], wire["rod_length"]
    legs = tuple(
        crank(
            wire["base_radius"] * out,
            np.cross(out, Z),
            out,
            lengths,
            wire["platform_radius"] * out,
            pairs,
        )
        for out in OUTWARD
    )
    return Machine("translation", legs, NOWHERE, pairs)


def _delta_linear(wire: Wire, pairs: float) -> Machine:
    legs = tuple(
        rail(
            (wire["rail_radius"] - wire["carriage_arm"]) * out,
            Z,
            wire["rod_length"],
            wire["platform_radius"] * out + wire["tool_offset"] * Z,
            pairs * np.cross(Z, out),
        )
        for out in OUTWARD
    )
    return Machine("translation", legs, NOWHERE, pairs)


def _geared_decoupled(wire: Wire, pairs: float) -> Machine:
    """Return what the rails carry, about the wrist's centre; motors are not among the bodies."""
    return _delta_linear({**wire, "tool_offset": 0.0}, pairs)


def _delta_linear_4dof(wire: Wire, pairs: float) -> Machine:
    length, above = wire["rod_length"], wire["tool_offset"] * Z
    inward = wire["carriage_arm"]

    def parallelogram(side: float) -> Leg:
        base = side * (wire["rail_x"] - inward) * X
        return rail(base, Z, length, side * wire["platform_arm"] * X + above, pairs * Y)

    def rod(side: float) -> Leg:
        aside = 0.5 * side * wire["rod_spacing"] * X
        base = aside + (wire["rail_y"] - inward) * Y
        return rail(base, Z, length, aside + wire["rod_arm"] * Y + above)

    legs = (parallelogram(1.0), rod(1.0), rod(-1.0), parallelogram(-1.0))
    return Machine("schoenflies", legs, Y, pairs)


def _gough_stewart(wire: Wire, pairs: float) -> Machine:
    points = zip(wire["base_points"], wire["platform_points"], strict=True)
    legs = tuple(strut(np.array(base), np.array(end)) for base, end in points)
    return Machine("spatial", legs, NOWHERE)


def _hexa_linear(wire: Wire, pairs: float) -> Machine:
    columns = (wire["base_points"], wire["rail_directions"], wire["platform_points"])
    legs = tuple(
        rail(np.array(base), unit(direction), wire["rod_length"], np.array(end))
        for base, direction, end in zip(*columns, strict=True)
    )
    return Machine("spatial", legs, NOWHERE)


def _hexa_rotary(wire: Wire, pairs: float) -> Machine:
    lengths = wire["crank_length"], wire["rod_length"]
    legs = tuple(
        crank(np.array(base), unit(axis), unit(zero), lengths, np.array(end))
        for base, axis, zero, end in zip(
            wire["base_points"],
            wire["crank_axes"],
            wire["crank_zero_directions"],
            wire["platform_points"],
            strict=True,
        )
    )
    return Machine("spatial", legs, NOWHERE)


def _spherical_3rrr(wire: Wire, pairs: float) -> Machine:
    """Arcs end on the unit sphere; the distal one keeps its chord between two axes' points."""
    chord = 2.0 * math.sin(0.5 * wire["distal_arc"])
    base, platform = wire["base_cone"], wire["platform_cone"]
    tip = np.array([math.sin(wire["proximal_arc"]), 0.0, math.cos(wire["proximal_arc"])])

    def leg(out: Floats) -> Leg:
        axis = math.sin(base) * out + math.cos(base) * Z
        zero = math.cos(base) * out - math.sin(base) * Z
        end = math.sin(platform) * out + math.cos(platform) * Z
        frame = np.column_stack([zero, np.cross(axis, zero), axis])
        return Leg("crank", NOWHERE, (Rod(tip, end, chord),), frame)

    return Machine("spherical", tuple(leg(out) for out in OUTWARD), NOWHERE)


def _custom(wire: Wire, pairs: float) -> Machine:
    def leg(one: Wire) -> Leg:
        base, end = np.array(one["base_point"]), np.array(one["platform_point"])
        if one["drive"] == "strut":
            return strut(base, end)
        if one["drive"] == "rail":
            return rail(base, unit(one["direction"]), one["rod_length"], end)
        lengths = one["crank_length"], one["rod_length"]
        return crank(base, unit(one["axis"]), unit(one["zero_direction"]), lengths, end)

    axis = unit(wire["axis"]) if wire["motion"] == "schoenflies" else Z
    return Machine(wire["motion"], tuple(leg(one) for one in wire["legs"]), axis)


FAMILIES: Mapping[str, Callable[[Wire, float], Machine]] = MappingProxyType(
    {
        "five_bar": _five_bar,
        "planar_3rrr": _planar_3rrr,
        "translational_3rrrr": _translational_3rrrr,
        "delta_rotary": _delta_rotary,
        "delta_linear": _delta_linear,
        "geared_decoupled": _geared_decoupled,
        "delta_linear_4dof": _delta_linear_4dof,
        "gough_stewart": _gough_stewart,
        "hexa_linear": _hexa_linear,
        "hexa_rotary": _hexa_rotary,
        "spherical_3rrr": _spherical_3rrr,
        "custom": _custom,
    }
)


def machine(wire: Wire, pairs: float = 0.0) -> Machine:
    """Return the machine of a mechanism on the wire; see `Machine.pairs`."""
    return FAMILIES[wire["kind"]](wire, pairs)


def turn(axis: Floats, angle: float) -> Floats:
    """Return the rotation about a unit axis."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    rotation: Floats = np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    return rotation


def placement(motion: str, axis: Floats, pose: Sequence[float] | Floats) -> tuple[Floats, Floats]:
    """Return the platform's position and rotation at a pose. [m, -]"""
    position, rotation = np.zeros(3), np.eye(3)
    if motion in ("planar_translation", "planar"):
        position[:2] = pose[:2]
    elif motion != "spherical":
        position[:] = pose[:3]
    if motion in ("planar", "schoenflies"):
        rotation = turn(axis, pose[-1])
    elif motion in ("spherical", "spatial"):
        rx, ry, rz = pose[-3:]
        rotation = turn(Z, rz) @ turn(Y, ry) @ turn(X, rx)
    return position, rotation


def rod_screws(machine: Machine, pose: Sequence[float] | Floats, actuators: Floats) -> Floats:
    """Return unit screws (u, rho x u) of all rods, pointing to the platform, shape (rods, 6)."""
    position, rotation = placement(machine.motion, machine.axis, pose)
    rows = []
    for leg, drive in zip(machine.legs, actuators, strict=True):
        for rod in leg.rods:
            moved = turn(Z, drive) @ rod.tip if leg.drive == "crank" else rod.tip
            slid = drive * Z if leg.drive == "rail" else NOWHERE
            arm = rotation @ rod.end
            along = unit(position + arm - leg.base - leg.frame @ (moved + slid))
            rows.append(np.concatenate([along, np.cross(arm, along)]))
    return np.array(rows)
