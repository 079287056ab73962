"""The geared decoupled mechanism, worked out anew from the dimensions on the wire, pose by pose.

Nothing of the product is used here.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from tests.oracles.machines import OUTWARD, Floats, X, Y, Z, turn

Wire = Mapping[str, Any]


def rotation(pose: Sequence[float] | Floats) -> Floats:
    rx, ry, rz = pose[3:]
    turned: Floats = turn(Z, rz) @ turn(Y, ry) @ turn(X, rx)
    return turned


def centre(wire: Wire, pose: Sequence[float] | Floats) -> Floats:
    """Return the wrist's centre O = p - R OD. [m]"""
    arm: Floats = wire["tool_offset"] * rotation(pose)[:, 0]
    return np.array(pose[:3]) - arm


def rods(wire: Wire, pose: Sequence[float] | Floats, signs: Sequence[int]) -> Floats:
    """Return the rods from the carriages to what they carry, shape (3, 3); NaN: no reach. [m]"""
    found = []
    for out, sign in zip(OUTWARD, signs, strict=False):
        end = centre(wire, pose) + wire["platform_radius"] * out
        aside = end - (wire["rail_radius"] - wire["carriage_arm"]) * out
        square = wire["rod_length"] ** 2 - aside[0] ** 2 - aside[1] ** 2
        height = math.sqrt(square) if square >= 0.0 else math.nan
        found.append([aside[0], aside[1], -sign * height])
    return np.array(found)


def gains(wire: Wire) -> Floats:
    """Return the turns of D1, D2 and D3, one a row, for those of the platform."""
    wrist = wire["wrist"]
    k, g = wrist["k1"] * wrist["k2"] * wrist["kp"], wrist["k_gamma"]
    return np.array([[k, -k, g], [k, k, g], [0.0, 0.0, 1.0]])


def drives(wire: Wire, pose: Sequence[float] | Floats, signs: Sequence[int]) -> Floats:
    """Return the carriages' heights and the motors' turns. [m, rad]"""
    heights = centre(wire, pose)[2] - rods(wire, pose, signs)[:, 2]
    motors: Floats = gains(wire) @ np.array(pose[3:])
    return np.concatenate([heights, motors])


def moved(pose: Sequence[float] | Floats, twist: Floats, time: float) -> Floats:
    """Return the pose after a short time of a twist (v, omega), in the turn it started from."""
    speed = float(np.linalg.norm(twist[3:]))
    spun = np.eye(3) if speed == 0.0 else turn(twist[3:] / speed, speed * time)
    r = spun @ rotation(pose)
    angles = np.array(
        [
            math.atan2(r[2, 1], r[2, 2]),
            math.atan2(-r[2, 0], math.hypot(r[0, 0], r[1, 0])),
            math.atan2(r[1, 0], r[0, 0]),
        ]
    )
    angles += 2 * math.pi * np.round((np.array(pose[3:]) - angles) / (2 * math.pi))
    return np.concatenate([np.array(pose[:3]) + time * twist[:3], angles])


def rates(wire: Wire, pose: Sequence[float] | Floats, twist: Floats) -> Floats:
    """Return the drives' rates under a twist, by differences of fourth order; free of Jacobians."""
    signs, step = wire["working_mode"], 5e-5

    def at(time: float) -> Floats:
        return drives(wire, moved(pose, twist, time), signs)

    slopes: Floats = (8 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12 * step)
    return slopes
