"""The papers' planar mechanisms: how they are asked for, and where their links are."""

import math

import httpx
import numpy as np

from examples.drawing import Floats
from examples.serving import Json, ask, preset

CORNERS = np.deg2rad([90.0, 210.0, 330.0])


def rrr(client: httpx.Client) -> Json:
    """Return the planar 3-RRR of 2016."""
    return preset(client, "planar_3rrr", "planar_3rrr_2016")


def base_joints(mechanism: Json) -> Floats:
    """Return the base joints of a planar 3-RRR, shape (3, 2). [m]"""
    radius = mechanism["base_side"] / math.sqrt(3.0)
    joints: Floats = radius * np.column_stack([np.cos(CORNERS), np.sin(CORNERS)])
    return joints


def leg_reach(mechanism: Json) -> float:
    """Return how far a leg reaches, stretched. [m]"""
    return float(mechanism["crank_length"] + mechanism["rod_length"])


def leg_points(foot: Floats, crank: float, angle: float, end: Floats) -> Floats:
    """Return base joint, elbow and platform joint of a leg, shape (3, 2). [m]"""
    return np.stack([foot, foot + crank * np.array([math.cos(angle), math.sin(angle)]), end])


def rrr_links(client: httpx.Client, mechanism: Json, pose: Floats) -> tuple[list[Floats], Floats]:
    """Return the legs and the corners of a planar 3-RRR in a pose. [m]"""
    request = {
        "analysis": "inverse_kinematics",
        "mechanism": mechanism,
        "poses": [pose.tolist()],
    }
    angles = ask(client, request)["actuators"][0]
    turned = CORNERS + pose[2]
    platform = pose[:2] + mechanism["platform_radius"] * np.column_stack(
        [np.cos(turned), np.sin(turned)]
    )
    crank = mechanism["crank_length"]
    feet = zip(base_joints(mechanism), angles, platform, strict=True)
    return [leg_points(foot, crank, angle, end) for foot, angle, end in feet], platform
