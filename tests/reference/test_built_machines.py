"""Figures that the sources of built machines print beside their dimensions.

Williams R.L. II, The Delta Parallel Robot: Kinematics Solutions, 2016, its example computed in the
repository Pieces98/Deltarobot_Kinematics; Jeanmonod N., Stewart platform on ESP32, 2019, repository
NicHub/stewart-platform-esp32; repository knaufinator/6DOF-Rotary-Stewart-Motion-Simulator.
"""

import json
import math

import numpy as np
import pytest

import analyses
from schemas.inverse_kinematics import InverseKinematicsResult
from schemas.presets import PRESETS
from tests.oracles.legs import Floats

# Platform [mm] and cranks below level [deg]. The source's first leg points along -y: half a turn.
FLEXPICKER = [
    ((0.0, 0.0, -1064.4517), (0.0, 0.0, 0.0)),
    ((108.1354, -180.3484, -1243.5413), (10.0, 20.0, 30.0)),
    ((0.0, 0.0, -900.3195), (-20.5, -20.5, -20.5)),
    ((300.4598, 499.9385, -1099.8281), (47.5, -11.6, 21.4)),
]

# Above the servos when all arms are level. [m]
LEVEL = 0.132943591247488
COUNTS = (467 - 183) / math.pi
# Shift from level [mm], turns [deg] and servo pulses, from the list of 2023. The list rounds the
# turn about z, 43/3 degrees, to 14.3.
YAW = 43.0 / 3.0
SERVOS = [
    ((0.0, 0.0, 0.0, 0.0, 0.0, 0.0), (325, 325, 325, 325, 325, 325)),
    ((0.0, 0.0, 12.0, 0.0, 0.0, 0.0), (248, 402, 248, 402, 248, 402)),
    ((0.0, 0.0, -12.0, 0.0, 0.0, 0.0), (420, 230, 420, 230, 420, 230)),
    ((-8.0, -8.0, -4.0, -4.0, -4.0, -YAW), (373, 388, 352, 324, 384, 285)),
    ((-8.0, 8.0, 4.0, -4.0, 4.0, YAW), (273, 317, 262, 378, 271, 303)),
    ((8.0, -8.0, 4.0, 4.0, 4.0, -YAW), (312, 361, 355, 354, 288, 456)),
    ((8.0, 8.0, 4.0, 4.0, 4.0, YAW), (275, 288, 271, 340, 262, 367)),
]
OUT_OF_REACH = [
    (-8.0, -8.0, 4.0, -4.0, -4.0, -YAW),
    (-8.0, 8.0, 4.0, -4.0, 4.0, -YAW),
    (8.0, -8.0, 4.0, -4.0, 4.0, YAW),
    (8.0, 8.0, 4.0, -4.0, -4.0, YAW),
]


def inverse(name: str, pose: list[float]) -> InverseKinematicsResult:
    """Return what holds a preset at one pose, in its default working mode."""
    mechanism = next(preset.mechanism for preset in PRESETS if preset.name == name)
    body = {
        "analysis": "inverse_kinematics",
        "mechanism": mechanism.model_dump(mode="json"),
        "poses": [pose],
    }
    result = analyses.answer(analyses.parse(json.dumps(body)))
    assert isinstance(result, InverseKinematicsResult)
    return result


def drives(name: str, pose: list[float]) -> Floats:
    result = inverse(name, pose)
    assert result.reachable == [True]
    return np.array(result.actuators[0], dtype=float)


def shifted(move: tuple[float, ...]) -> list[float]:
    """Return the desktop platform's pose after a move from level."""
    x, y, z = (1e-3 * part for part in move[:3])
    return [x, y, z + LEVEL, *(math.radians(part) for part in move[3:])]


def pulses(angles: Floats) -> Floats:
    """Return servo pulses: even servos are mirrored, so that theirs fall as the arm rises."""
    turned = np.round(COUNTS * (angles + 0.5 * math.pi))
    return np.where(np.arange(6) % 2 == 0, 467 - turned, 183 + turned)


@pytest.mark.parametrize(("point", "cranks"), FLEXPICKER)
def test_the_flexpicker_has_the_published_crank_angles(
    point: tuple[float, ...], cranks: tuple[float, ...]
) -> None:
    x, y, z = (1e-3 * part for part in point)
    found = -np.degrees(drives("flexpicker", [-x, -y, z]))
    # Coordinates are printed to a tenth of a micrometre.
    assert found == pytest.approx(cranks, abs=2e-5)


def test_the_motion_simulator_is_level_at_its_published_height() -> None:
    found = drives("motion_simulator", [0.0, 0.0, 0.648134, 0.0, 0.0, 0.0])
    # The height is printed to a micrometre, on cranks of 0.184 m.
    assert found == pytest.approx(np.zeros(6), abs=3e-6)


@pytest.mark.parametrize(("move", "expected"), SERVOS)
def test_the_desktop_platform_has_the_published_pulses(
    move: tuple[float, ...], expected: tuple[int, ...]
) -> None:
    assert pulses(drives("stewart_platform_esp32", shifted(move))).tolist() == list(expected)


@pytest.mark.parametrize("move", OUT_OF_REACH)
def test_the_desktop_platform_cannot_where_its_firmware_cannot(move: tuple[float, ...]) -> None:
    assert inverse("stewart_platform_esp32", shifted(move)).reachable == [False]
