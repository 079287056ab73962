"""Random dimensions of every family, as the wire has them, and a box of poses to try."""

import math
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from tests.oracles.machines import OUTWARD, Floats, X, Y, Z, turn, unit

Random = np.random.Generator
Fields = dict[str, Any]


class Draw(NamedTuple):
    """A mechanism on the wire and the least and greatest pose to try."""

    wire: Fields
    least: Floats
    most: Floats


def box(*ranges: tuple[float, float]) -> tuple[Floats, Floats]:
    return np.array([r[0] for r in ranges]), np.array([r[1] for r in ranges])


def both(*sizes: float) -> tuple[Floats, Floats]:
    return box(*((-size, size) for size in sizes))


def lengths(random: Random, **sizes: float) -> Fields:
    """Return each length within a fifth of its usual size."""
    return {name: size * random.uniform(0.8, 1.2) for name, size in sizes.items()}


def signs(random: Random, drives: list[str]) -> list[int]:
    return [1 if d == "strut" else int(random.choice([-1, 1])) for d in drives]


def cranks(random: Random, kind: str, legs: int, **sizes: float) -> Fields:
    mode = signs(random, ["crank"] * legs)
    return {"kind": kind, "working_mode": mode, **lengths(random, **sizes)}


def five_bar(random: Random) -> Draw:
    wire = cranks(random, "five_bar", 2, base_distance=0.5, crank_length=0.45, rod_length=0.5)
    return Draw(wire, *both(0.5, 0.8))


def planar_3rrr(random: Random) -> Draw:
    links = {"crank_length": 0.18, "rod_length": 0.2}
    wire = cranks(random, "planar_3rrr", 3, base_side=0.4, platform_radius=0.08, **links)
    return Draw(wire, *both(0.15, 0.15, 1.0))


def translational_3rrrr(random: Random) -> Draw:
    wire = cranks(random, "translational_3rrrr", 3, link_length=0.3, base_radius=0.25)
    return Draw(wire, *both(0.2, 0.2, 0.2))


def delta_rotary(random: Random) -> Draw:
    links = {"crank_length": 0.3, "rod_length": 0.6}
    wire = cranks(random, "delta_rotary", 3, base_radius=0.2, platform_radius=0.05, **links)
    return Draw(wire, *box((-0.25, 0.25), (-0.25, 0.25), (-0.7, -0.3)))


def _upright(random: Random, kind: str) -> Draw:
    sizes = {"carriage_arm": 0.03, "tool_offset": 0.04, "rod_length": 0.35}
    wire = cranks(random, kind, 3, rail_radius=0.25, platform_radius=0.06, **sizes)
    return Draw(wire, *both(0.15, 0.15, 0.3))


def delta_linear(random: Random) -> Draw:
    return _upright(random, "delta_linear")


def geared_decoupled(random: Random) -> Draw:
    """Return three rails under a wrist; the tool's point is aside of its centre, either way."""
    wire = _upright(random, "geared_decoupled").wire
    wire["working_mode"] += [1, 1, 1]
    wire["tool_offset"] *= float(random.choice([-1.0, 1.0]))
    wire["wrist"] = lengths(random, k1=0.9, k2=1.1, kp=0.8, k_gamma=1.4)
    return Draw(wire, *both(0.15, 0.15, 0.3, 3.1, 1.5, 3.1))


def delta_linear_4dof(random: Random) -> Draw:
    platform = {"platform_arm": 0.08, "rod_arm": 0.04, "rod_spacing": 0.08, "tool_offset": 0.05}
    base = {"rail_x": 0.2, "rail_y": 0.24, "carriage_arm": 0.05, "rod_length": 0.3}
    wire = cranks(random, "delta_linear_4dof", 4, **base, **platform)
    return Draw(wire, *both(0.15, 0.15, 0.3, 0.6))


def hexagon(random: Random, radius: float, spread: float, jitter: float) -> list[list[float]]:
    """Return six points in pairs about 90, 210 and 330 degrees, each moved at random."""
    around = [turn(Z, side * spread) @ out for out in OUTWARD for side in (-1.0, 1.0)]
    return [(radius * p + random.uniform(-jitter, jitter, 3)).tolist() for p in around]


def gough_stewart(random: Random) -> Draw:
    base = hexagon(random, 0.5, 0.26, 0.1)
    wire = {"kind": "gough_stewart", "base_points": base}
    wire["platform_points"] = hexagon(random, 0.3, 0.79, 0.06)
    return Draw(wire, *box(*[(-0.15, 0.15)] * 2, (0.3, 0.7), *[(-0.5, 0.5)] * 3))


def hexa_linear(random: Random) -> Draw:
    wire = cranks(random, "hexa_linear", 6, rod_length=0.6)
    wire["base_points"] = hexagon(random, 0.4, 0.26, 0.08)
    # Of any length: the product makes them unit vectors.
    tilted = [Z + random.uniform(-0.4, 0.4, 3) for _ in range(6)]
    wire["rail_directions"] = [(t * random.uniform(0.5, 2.0)).tolist() for t in tilted]
    wire["platform_points"] = hexagon(random, 0.15, 0.79, 0.05)
    return Draw(wire, *both(0.15, 0.15, 0.2, 0.5, 0.5, 0.5))


def hexa_rotary(random: Random) -> Draw:
    wire = cranks(random, "hexa_rotary", 6, crank_length=0.15, rod_length=0.4)
    wire["base_points"] = hexagon(random, 0.3, 0.26, 0.06)
    axes = [np.cross(p, Z) + random.uniform(-0.1, 0.1, 3) for p in np.array(wire["base_points"])]
    zeros = [np.cross(axis, random.normal(size=3)) for axis in axes]
    wire["crank_axes"] = [axis.tolist() for axis in axes]
    wire["crank_zero_directions"] = [zero.tolist() for zero in zeros]
    wire["platform_points"] = hexagon(random, 0.15, 0.79, 0.05)
    return Draw(wire, *box(*[(-0.1, 0.1)] * 2, (0.2, 0.45), *[(-0.4, 0.4)] * 3))


def spherical_3rrr(random: Random) -> Draw:
    arcs = {"proximal_arc": math.radians(75.0), "distal_arc": math.radians(75.0)}
    cones = {"base_cone": math.radians(55.0), "platform_cone": math.radians(110.0)}
    wire = cranks(random, "spherical_3rrr", 3, **arcs, **cones)
    return Draw(wire, *both(0.6, 0.6, 1.5))


def _custom_leg(random: Random, drive: str, plane: bool) -> Fields:
    """Return a leg that holds the platform at the origin, unturned."""
    flat = np.array([1.0, 1.0, 0.0 if plane else 1.0])
    base = unit(random.normal(size=3) * flat) * random.uniform(0.5, 0.8)
    end = unit(random.normal(size=3) * flat) * random.uniform(0.1, 0.3)
    level = random.uniform(-0.2, 0.2) * Z if plane else np.zeros(3)
    leg: Fields = {"drive": drive, "base_point": (base + level).tolist()}
    leg["platform_point"] = (end + level).tolist()
    if drive == "crank":
        axis = Z if plane else unit(random.normal(size=3))
        zero = unit(np.cross(axis, random.normal(size=3)))
        length = random.uniform(0.15, 0.3)
        elbow = base + length * turn(axis, random.uniform(-3.1, 3.1)) @ zero
        leg |= {"axis": (1.7 * axis).tolist(), "zero_direction": (0.6 * zero).tolist()}
        leg |= {"crank_length": length, "rod_length": float(np.linalg.norm(end - elbow))}
    if drive == "rail":
        direction = unit(random.normal(size=3) * flat)
        carriage = base + random.uniform(-0.3, 0.3) * direction
        leg |= {"direction": (1.3 * direction).tolist()}
        leg |= {"rod_length": float(np.linalg.norm(end - carriage))}
    return leg


def _custom(random: Random, motion: str, drives: list[str], *sizes: float) -> Draw:
    plane = motion.startswith("planar")
    legs = [_custom_leg(random, drive, plane) for drive in drives]
    wire = {"kind": "custom", "motion": motion, "legs": legs}
    if motion == "schoenflies":
        wire["axis"] = (2.0 * (X + 0.7 * Y - 1.3 * Z) + random.uniform(-0.5, 0.5, 3)).tolist()
    return Draw(wire | {"working_mode": signs(random, drives)}, *both(*sizes))


def custom_planar(random: Random) -> Draw:
    return _custom(random, "planar", ["crank", "rail", "strut"], 0.1, 0.1, 0.5)


def custom_planar_translation(random: Random) -> Draw:
    return _custom(random, "planar_translation", ["rail", "strut"], 0.1, 0.1)


def custom_translation(random: Random) -> Draw:
    return _custom(random, "translation", ["strut", "crank", "rail"], 0.1, 0.1, 0.1)


def custom_schoenflies(random: Random) -> Draw:
    drives = ["crank", "rail", "strut", "crank"]
    return _custom(random, "schoenflies", drives, 0.1, 0.1, 0.1, 0.5)


def custom_spherical(random: Random) -> Draw:
    return _custom(random, "spherical", ["crank", "strut", "rail"], 0.4, 0.4, 0.4)


def custom_spatial(random: Random) -> Draw:
    drives = ["crank", "crank", "rail", "rail", "strut", "strut"]
    return _custom(random, "spatial", drives, 0.1, 0.1, 0.1, 0.4, 0.4, 0.4)


DRAWS: Mapping[str, Callable[[Random], Draw]] = MappingProxyType(
    {
        draw.__name__: draw
        for draw in (
            five_bar,
            planar_3rrr,
            translational_3rrrr,
            delta_rotary,
            delta_linear,
            delta_linear_4dof,
            hexa_linear,
            gough_stewart,
            hexa_rotary,
            spherical_3rrr,
            custom_planar,
            custom_planar_translation,
            custom_translation,
            custom_schoenflies,
            custom_spherical,
            custom_spatial,
        )
    }
)

WRISTED: Mapping[str, Callable[[Random], Draw]] = MappingProxyType(
    {"geared_decoupled": geared_decoupled}
)
"""Those whose platform is turned by motors, not by legs."""

EVERY: Mapping[str, Callable[[Random], Draw]] = MappingProxyType({**DRAWS, **WRISTED})
