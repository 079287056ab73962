"""Skeletons: where the joints are, for drawing."""

from typing import NamedTuple

from mechanics.arrays import Floats
from mechanics.configuration import Configuration


class Joints(NamedTuple):
    """Points of every leg, shape (legs, 3, poses) each; NaN where a leg cannot reach. [m]"""

    base: Floats
    elbow: Floats
    platform: Floats


def joints(block: Configuration) -> Joints:
    """Return the joints of a block of poses: base joint A, elbow B and platform joint c."""
    legs = block.mechanism.legs
    spans = block.attachment[1]
    base = block.mechanism.base_joints[:, :, None] + 0.0 * spans
    platform = base + spans
    return Joints(base, platform - legs.rod_scale[:, None, None] * block.rods[0], platform)
