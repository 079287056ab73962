"""A ready example of each kind: plain dimensions that work, to start from."""

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

from schemas.custom import Custom, CustomLeg, StrutLeg
from schemas.families import (
    DeltaLinear,
    DeltaLinear4Dof,
    DeltaRotary,
    FiveBar,
    GoughStewart,
    HexaLinear,
    HexaRotary,
    Planar3RRR,
    Spherical3RRR,
    Translational3RRRR,
)
from schemas.geared import GearedDecoupled, WristGears
from schemas.gears import DesignMesh, Mesh, Wheel
from schemas.mechanisms import InlineMechanism


def _around(radius: float, spread: float) -> list[list[float]]:
    """Return six points in pairs, `spread` to either side of 90, 210 and 330 degrees. [deg]"""
    angles = [math.radians(a + s) for a in (90, 210, 330) for s in (-spread, spread)]
    return [[radius * math.cos(a), radius * math.sin(a), 0.0] for a in angles]


def _wrist_train() -> list[Mesh]:
    """Return the meshes behind a motor of the geared mechanism; their speed ratios make k."""
    pairs: list[tuple[Literal["bevel", "spur"], int, int]] = [
        ("bevel", 40, 36),
        ("bevel", 30, 30),
        ("spur", 25, 29),
        ("spur", 40, 30),
    ]
    return [
        DesignMesh(
            kind="design",
            face=face,
            module=0.0015,
            input=Wheel(teeth=towards_motor),
            output=Wheel(teeth=towards_platform),
            friction_coefficient=0.1,
        )
        for face, towards_motor, towards_platform in pairs
    ]


def _planar_3rpr() -> Custom:
    corners = [(0.0, 0.5), (-0.45, -0.25), (0.45, -0.25)]
    legs: list[CustomLeg] = [
        StrutLeg(drive="strut", base_point=[x, y, 0.0], platform_point=[0.25 * y, -0.25 * x, 0.0])
        for x, y in corners
    ]
    return Custom(kind="custom", name="Planar 3-RPR", motion="planar", legs=legs)


STARTERS: Mapping[str, InlineMechanism] = MappingProxyType(
    {
        "five_bar": FiveBar(kind="five_bar", base_distance=0.6, crank_length=0.5, rod_length=0.5),
        "planar_3rrr": Planar3RRR(
            kind="planar_3rrr",
            base_side=0.4,
            platform_radius=0.08,
            crank_length=0.18,
            rod_length=0.18,
        ),
        "translational_3rrrr": Translational3RRRR(
            kind="translational_3rrrr", link_length=0.3, base_radius=0.25
        ),
        "delta_rotary": DeltaRotary(
            kind="delta_rotary",
            base_radius=0.2,
            platform_radius=0.05,
            crank_length=0.3,
            rod_length=0.6,
        ),
        "delta_linear": DeltaLinear(
            kind="delta_linear",
            rail_radius=0.2,
            platform_radius=0.05,
            rod_length=0.35,
            carriage_arm=0.03,
            tool_offset=0.04,
        ),
        "delta_linear_4dof": DeltaLinear4Dof(
            kind="delta_linear_4dof",
            rail_x=0.2,
            rail_y=0.24,
            carriage_arm=0.05,
            rod_length=0.3,
            platform_arm=0.08,
            rod_arm=0.04,
            rod_spacing=0.08,
            tool_offset=0.05,
        ),
        "hexa_linear": HexaLinear(
            kind="hexa_linear",
            base_points=_around(0.4, 15.0),
            rail_directions=[[0.0, 0.0, 1.0]] * 6,
            rod_length=0.5,
            platform_points=_around(0.1, 45.0),
        ),
        "gough_stewart": GoughStewart(
            kind="gough_stewart",
            base_points=_around(0.5, 15.0),
            platform_points=_around(0.3, 45.0),
        ),
        "hexa_rotary": HexaRotary(
            kind="hexa_rotary",
            base_points=_around(0.3, 15.0),
            crank_axes=[[p[1], -p[0], 0.0] for p in _around(1.0, 15.0)],
            crank_zero_directions=_around(1.0, 15.0),
            crank_length=0.15,
            rod_length=0.4,
            platform_points=_around(0.12, 45.0),
        ),
        "spherical_3rrr": Spherical3RRR(
            kind="spherical_3rrr",
            proximal_arc=math.radians(80.0),
            distal_arc=math.radians(75.0),
            base_cone=math.radians(55.0),
            platform_cone=math.radians(120.0),
        ),
        "geared_decoupled": GearedDecoupled(
            kind="geared_decoupled",
            rail_radius=0.33,
            platform_radius=0.08,
            rod_length=0.37,
            carriage_arm=0.022,
            tool_offset=0.05,
            wrist=WristGears(k1=0.9, k2=1.0, kp=0.87, k_gamma=1.4),
            train=_wrist_train(),
        ),
        "custom": _planar_3rpr(),
    }
)
