"""Hexapods that were built and whose dimensions are published."""

import math
from collections.abc import Sequence

from schemas.families import GoughStewart, HexaLinear, HexaRotary
from schemas.kinds import Preset
from schemas.legged import ActuatorLimit

Points = list[list[float]]


def _pairs(radius: float, spread: float) -> Points:
    """Return six points in pairs, `spread` to either side of 30, -90 and 150 degrees. [deg]"""
    angles = [math.radians(axis + side * spread) for axis in (30, -90, 150) for side in (1, -1)]
    return [[radius * math.cos(angle), radius * math.sin(angle), 0.0] for angle in angles]


def _crank_axes(level: Sequence[float]) -> tuple[Points, Points]:
    """Return axes and zero directions of cranks that are level at 0 and then turn upward.

    `level` has the angles about z at which they point when level. [deg]
    """
    zeros = [[math.cos(math.radians(a)), math.sin(math.radians(a)), 0.0] for a in level]
    return [[y, -x, 0.0] for x, y, _ in zeros], zeros


def _motion_simulator() -> HexaRotary:
    axes, zeros = _crank_axes((150.0, -90.0, 30.0, 150.0, -90.0, 30.0))
    return HexaRotary(
        kind="hexa_rotary",
        name="6DOF Rotary Stewart Motion Simulator",
        # The firmware's kinematics put RD and theta_r on the platform, PD and theta_p on the base,
        # against their names; only so does its home height come out.
        base_points=_pairs(0.4064, 30.0),
        platform_points=_pairs(0.40005, 10.0),
        crank_axes=axes,
        crank_zero_directions=zeros,
        crank_length=0.18415,
        rod_length=0.7239,
        working_mode=[-1] * 6,
        actuator_limits=ActuatorLimit(min=-math.pi / 3.0, max=math.pi / 3.0),
    )


def _desktop_platform() -> HexaRotary:
    axes, zeros = _crank_axes((-60.0, 120.0, 180.0, 0.0, 60.0, -120.0))
    return HexaRotary(
        kind="hexa_rotary",
        name="Stewart platform on ESP32",
        base_points=_pairs(0.5 * 0.15399, 22.9492),
        platform_points=_pairs(0.5 * 0.09961, 48.4099),
        crank_axes=axes,
        crank_zero_directions=zeros,
        crank_length=0.015,
        rod_length=0.14,
        working_mode=[-1] * 6,
        # The servos' range of half a turn.
        actuator_limits=ActuatorLimit(min=-0.5 * math.pi, max=0.5 * math.pi),
    )


HEXAPODS = (
    Preset(
        name="hexapod_machine_tool_2009",
        title="Hexapod machine tool of a calibration study",
        source="Nategh M.J., Agheli M.M. A total solution to kinematic calibration of hexapod "
        "machine tools with a minimum number of measurement configurations and superior "
        "accuracies. 2009. Nominal joints of tables 1 and 2 as given in the repository "
        "tabathaviso/hexapod-parallel-manipulator: circles of 650 and 250 mm in diameter.",
        mechanism=GoughStewart(
            kind="gough_stewart",
            name="Hexapod machine tool of Nategh and Agheli, 2009",
            base_points=[
                [0.3054001, 0.1111565, 0.0],
                [-0.0564357, 0.3200625, 0.0],
                [-0.2489644, 0.208906, 0.0],
                [-0.2489644, -0.208906, 0.0],
                [-0.0564357, -0.3200625, 0.0],
                [0.3054001, -0.1111565, 0.0],
            ],
            platform_points=[
                [0.0921597, 0.0844488, 0.0],
                [0.027055, 0.122037, 0.0],
                [-0.1192146, 0.0375882, 0.0],
                [-0.1192146, -0.0375882, 0.0],
                [0.027055, -0.122037, 0.0],
                [0.0921597, -0.0844488, 0.0],
            ],
        ),
    ),
    Preset(
        name="walking_machine_tool_2022",
        title="6-PSU manipulator of a six-legged walking machine tool",
        source="Liu J., Chen Z., Gao F. Kinematic Calibration of a Six-Legged Walking Machine "
        "Tool. Chinese Journal of Mechanical Engineering, 2022, vol. 35, 34, "
        "doi:10.1186/s10033-022-00688-2. Nominal values of table 2.",
        mechanism=HexaLinear(
            kind="hexa_linear",
            name="Manipulator of Liu, Chen and Gao, 2022",
            base_points=[
                [0.188527, 0.173511, -0.178076],
                [-0.188527, 0.173511, -0.178076],
                [-0.244529, 0.076514, -0.178076],
                [-0.056002, -0.250025, -0.178076],
                [0.056002, -0.250025, -0.178076],
                [0.244529, 0.076514, -0.178076],
            ],
            rail_directions=[[0.0, 0.0, 1.0]] * 6,
            rod_length=0.26,
            platform_points=[
                [0.024465, 0.078789, 0.0],
                [-0.024465, 0.078789, 0.0],
                [-0.080466, -0.018208, 0.0],
                [-0.056001, -0.060582, 0.0],
                [0.056001, -0.060582, 0.0],
                [0.080466, -0.018208, 0.0],
            ],
            working_mode=[-1] * 6,
        ),
    ),
    Preset(
        name="motion_simulator",
        title="Motion simulator on six geared servo motors",
        source="Repository knaufinator/6DOF-Rotary-Stewart-Motion-Simulator, "
        "initDefaultStewartConfig: radii 16 and 15.75 in, cranks 7.25 in, rods 28.5 in; cranks "
        "within 60 degrees of level.",
        mechanism=_motion_simulator(),
    ),
    Preset(
        name="stewart_platform_esp32",
        title="Desktop Stewart platform on six hobby servos",
        source="Jeanmonod N. Stewart platform on ESP32, 2019, repository "
        "NicHub/stewart-platform-esp32, Hexapod_Config_1: base and platform circles of 153.99 and "
        "99.61 mm in diameter, arms 15 mm, rods 140 mm.",
        mechanism=_desktop_platform(),
    ),
)
