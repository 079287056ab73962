"""Published velocities and positions of 2019 (Delta with linear drives) and 2022 (geared).

Laryushkin P.A., Erastova K.G., Filippov G.S., Kheilo S.V., 2019, doi:10.1134/S0235711919030106;
Glazunov V.A. et al., 2022, doi:10.31857/S0235711922020043; and the struts of Rashoyan's study of
l-coordinate mechanisms. Every misprint found is told in the test that works round it.
"""

import json
import math
from typing import Any

import numpy as np
import pytest

import analyses
from schemas.inverse_kinematics import InverseKinematicsResult
from schemas.presets import PRESETS
from schemas.singularity import SingularityResult
from schemas.velocity import VelocityResult
from tests.oracles.machines import Floats, X, Y, Z, machine, rod_screws, turn

DELTA = next(p.mechanism for p in PRESETS if p.name == "delta_linear_4dof_2019").model_dump()
POSE = [0.1, 0.1, 0.2, 0.0]
HEIGHTS = [0.5312, 0.5284, 0.5284, 0.4761]
PRINTED_RATES = [-0.043, -0.035, 0.019, 0.021]
PRINTED_SPEED = np.array([0.5, 0.5, -1.0])


def ask(analysis: str, mechanism: dict[str, Any], poses: Any, **fields: Any) -> Any:  # noqa: ANN401
    """Return the checked answer to a request."""
    body = {"analysis": analysis, "mechanism": mechanism, "poses": poses, **fields}
    request = analyses.parse(json.dumps(body))
    analyses.check(request, 10**9)
    return analyses.answer(request)


def velocity(twist: list[float]) -> VelocityResult:
    """Return the rates of the 4-DOF Delta at its printed pose."""
    result = ask("velocity", DELTA, [POSE], platform_rates=[twist])
    assert isinstance(result, VelocityResult)
    return result


def heights(poses: list[list[float]]) -> Floats:
    result = ask("inverse_kinematics", DELTA, poses)
    assert isinstance(result, InverseKinematicsResult)
    return np.array(result.actuators, dtype=float)


def leg_one_screws() -> Floats:
    """Return the screws of A, BA, BC sum and CD of the first parallelogram, as columns.

    The joints are reckoned from the printed dimensions alone; angular part first.
    """
    tool = np.array(POSE[:3])
    joint = tool + np.array([0.08, 0.0, 0.05])
    across = np.array([joint[0] - 0.15, joint[1]])
    knee = np.array([0.15, 0.0, joint[2] + math.sqrt(0.3**2 - across @ across)])
    rod = joint - knee
    second = np.cross(rod, Y)
    columns = [
        (np.zeros(3), Z),
        (Y, np.cross(knee - tool, Y)),
        (np.zeros(3), -np.cross(rod, second / np.linalg.norm(second))),
        (Y, np.cross(joint - tool, Y)),
    ]
    return np.array([np.concatenate(column) for column in columns]).T


def leg_one_rates(turning: Floats, moving: Floats) -> Floats:
    """Return the rates in leg 1 by its screws, its four equations out of six."""
    screws, twist = leg_one_screws(), np.concatenate([turning, moving])
    rates: Floats = np.linalg.lstsq(screws, twist, rcond=None)[0]
    np.testing.assert_allclose(screws @ rates, twist, atol=1e-12)
    return rates


def test_carriage_heights() -> None:
    """Order of legs: parallelogram at +x, rods at +0.04 and -0.04, parallelogram at -x."""
    assert heights([POSE])[0] == pytest.approx(HEIGHTS, abs=5e-5)


def test_the_printed_screws_of_leg_one() -> None:
    """The 2019 paper's matrix, columns A, BA, BC sum, CD, to its three decimals."""
    printed: list[list[float]] = [
        [0, 0, 0, 0],
        [0, 1, 0, 1],
        [0, 0, 0, 0],
        [0, -0.331, -0.011, -0.05],
        [0, 0, 0.283, 0],
        [1, 0.05, 0.099, 0.08],
    ]
    np.testing.assert_allclose(leg_one_screws(), printed, atol=5.1e-4)


def test_drive_rates_of_the_speed_that_is_meant() -> None:
    """For v = (0.5, 0.5, -1) and no turning, in place of the misprinted rates."""
    rates = velocity([*PRINTED_SPEED, 0.0, 0.0, 0.0]).actuator_rates[0]
    assert rates == pytest.approx([-1.2311, -1.0898, -1.0898, -1.5972], abs=5e-5)


def test_parallelograms_have_their_printed_rates() -> None:
    """Misprint: the paper's right-hand side (0.5, 0.5, -1, 0, 0, 0) puts the speed first.

    Its screws have the angular part first, so it is omega = (0.5, 0.5, -1) and v = 0 that were
    reckoned. Of this omega a parallelogram feels only the part about y, which the motion has.
    """
    rates = velocity([0.0, 0.0, 0.0, 0.0, 0.5, 0.0]).actuator_rates[0]
    assert [rates[0], rates[3]] == pytest.approx([PRINTED_RATES[0], PRINTED_RATES[3]], abs=5e-4)


def test_rods_have_their_printed_rates_of_a_turn_that_the_motion_lacks() -> None:
    """Same misprint: the printed rates of the rods come from the whole of omega.

    The motion has no turns about x and z, so only the legs' own equations answer this:
    psi' = (rho x u) . omega / u_z. All four printed rates together belong to no motion at all.
    """
    screws = rod_screws(machine(DELTA), POSE, heights([POSE])[0])
    felt = np.array([0.5 * Y, PRINTED_SPEED, PRINTED_SPEED, 0.5 * Y])
    rates = np.sum(screws[:, 3:] * felt, axis=1) / screws[:, 2]
    assert rates == pytest.approx(PRINTED_RATES, abs=5e-4)


def test_turns_that_the_motion_lacks_are_refused() -> None:
    with pytest.raises(analyses.AnalysisError):
        velocity([0.0, 0.0, 0.0, *PRINTED_SPEED])


def test_printed_passive_rates_of_leg_one() -> None:
    """Printed -0.043, -0.089, 0, 0.589 for A, BA, BC sum and CD: those of omega_y = 0.5.

    The printed right-hand side has two more entries, 0.5 and -1, in rows of zeros: it contradicts
    itself there.
    """
    result = velocity([0.0, 0.0, 0.0, 0.0, 0.5, 0.0])
    passive = result.passive_rates[0][0] or []
    rates = [result.actuator_rates[0][0], *passive]
    assert rates == pytest.approx([-0.043, -0.089, 0.0, 0.589], abs=5e-4)


def test_passive_rates_of_leg_one_at_the_speed_that_is_meant() -> None:
    result = velocity([*PRINTED_SPEED, 0.0, 0.0, 0.0])
    passive = result.passive_rates[0][0] or []
    rates = [result.actuator_rates[0][0], *passive]
    assert rates == pytest.approx([-1.2311, -1.8445, 1.7678, 1.8445], abs=5e-5)


@pytest.mark.parametrize("turning", [0.0, 0.5, -0.7])
def test_passive_rates_of_leg_one_are_those_of_its_screws(turning: float) -> None:
    result = velocity([*PRINTED_SPEED, 0.0, turning, 0.0])
    passive = result.passive_rates[0][0] or []
    expected = leg_one_rates(turning * Y, PRINTED_SPEED)
    rates = [result.actuator_rates[0][0], *passive]
    np.testing.assert_allclose(np.array(rates, dtype=float), expected, atol=1e-12)


def test_a_parallelogram_is_two_rods() -> None:
    """Both rods of a parallelogram 0.08 m wide ask for the same height, to the paper's 1e-9 m."""
    random = np.random.default_rng(2019)
    poses = random.uniform([-0.1, -0.1, 0.1, -0.6], [0.1, 0.1, 0.3, 0.6], (200, 4))
    found = heights(poses.tolist())
    for pose, rows in zip(poses, found, strict=True):
        rotation = turn(Y, pose[3])
        for leg, side in ((0, 1.0), (3, -1.0)):
            for half in (0.04, -0.04):
                end = pose[:3] + rotation @ np.array([0.08 * side, half, 0.05])
                across = end[:2] - np.array([0.15 * side, half])
                height = end[2] + math.sqrt(0.3**2 - across @ across)
                assert rows[leg] == pytest.approx(height, abs=1e-9)


# Rashoyan's struts, all 2 m long: joint on the platform, direction from base to platform.
P1, P2, P3 = Y, X, -X
STRUTS = [(P1, -Y), (P1, X), (P1, Z), (P2, Z), (P2, -X), (P3, Z)]
CHANGES = np.array([0.1, 0.1, 0.1, 0.0, 0.0, 0.1])
FEET = np.array([point - 2.0 * direction for point, direction in STRUTS])
ENDS = np.array([point for point, _ in STRUTS])
HEXAPOD = {
    "kind": "gough_stewart",
    "base_points": FEET.tolist(),
    "platform_points": ENDS.tolist(),
}


def strut_step() -> tuple[Floats, Floats]:
    """Return the linear and the angular part of the screw that lengthens the struts."""
    result = ask("velocity", HEXAPOD, [[0.0] * 6], actuator_rates=[CHANGES.tolist()])
    assert isinstance(result, VelocityResult)
    twist = np.array(result.platform_rates[0], dtype=float)
    return twist[:3], twist[3:]


def test_strut_matrix() -> None:
    """The printed rows (e, P x e), each found by moving the platform along one unit twist."""
    printed = [
        [0, -1, 0, 0, 0, 0],
        [1, 0, 0, 0, 0, -1],
        [0, 0, 1, 1, 0, 0],
        [0, 0, 1, 0, -1, 0],
        [-1, 0, 0, 0, 0, 0],
        [0, 0, 1, 0, 1, 0],
    ]
    result = ask("velocity", HEXAPOD, [[0.0] * 6] * 6, platform_rates=np.eye(6).tolist())
    np.testing.assert_allclose(np.array(result.actuator_rates).T, printed, atol=1e-15)


def test_strut_determinant() -> None:
    result = ask("singularity", HEXAPOD, [[0.0] * 6])
    assert isinstance(result, SingularityResult)
    assert result.determinant[0] == pytest.approx(-2.0, rel=1e-14)


def test_strut_lengths() -> None:
    result = ask("inverse_kinematics", HEXAPOD, [[0.0] * 6])
    assert result.actuators[0] == pytest.approx([2.0] * 6, rel=1e-15)


def test_strut_screw() -> None:
    moving, turning = strut_step()
    np.testing.assert_allclose(moving, [0.0, -0.1, 0.05], atol=1e-15)
    np.testing.assert_allclose(turning, [0.05, 0.05, -0.1], atol=1e-15)


def test_struts_after_one_step() -> None:
    """Misprint: P1 goes to (0.1, 0.9, +0.1), not -0.1; P2 and P3 as printed."""
    moving, turning = strut_step()
    moved = [p + moving + np.cross(turning, p) for p in (P1, P2, P3)]
    expected = [[0.1, 0.9, 0.1], [1.0, -0.2, 0.0], [-1.0, 0.0, 0.1]]
    np.testing.assert_allclose(moved, expected, atol=1e-15)


def test_strut_residuals_after_one_step() -> None:
    """Printed 0.00475 three times, 0.01 twice and 0, with the points moved by v + omega x P."""
    moving, turning = strut_step()
    ends = ENDS + moving + np.cross(turning, ENDS)
    residuals = np.linalg.norm(ends - FEET, axis=1) - 2.0 - CHANGES
    assert residuals == pytest.approx([0.00475] * 3 + [0.01] * 2 + [0.0], abs=5e-5)


OFFSET, ROD = 0.227856, 0.37
PRINTED_UPRIGHT_RATES = [1.272, 1.793, -0.063]


def upright_rails(turned: float) -> dict[str, Any]:
    """Return three upright rails about the z axis, the first at 330 degrees and `turned` on."""
    legs = [
        {
            "drive": "rail",
            "base_point": [OFFSET * math.cos(a + turned), OFFSET * math.sin(a + turned), 0.0],
            "direction": [0.0, 0.0, 1.0],
            "rod_length": ROD,
            "platform_point": [0.0, 0.0, 0.0],
        }
        for a in np.deg2rad([330.0, 90.0, 210.0])
    ]
    return {"kind": "custom", "motion": "translation", "legs": legs}


def upright_rates(mechanism: dict[str, Any]) -> Floats:
    twist = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]
    result = ask("velocity", mechanism, [[0.0, 0.0, 0.0]], platform_rates=[twist])
    return np.array(result.actuator_rates[0], dtype=float)


def test_the_rails_above_the_centre() -> None:
    """The height that goes with the offset, 0.2915 m: upper root of the 2022 paper's equation."""
    result = ask("inverse_kinematics", upright_rails(0.0), [[0.0, 0.0, 0.0]])
    assert result.actuators[0] == pytest.approx([0.2915] * 3, abs=1e-4)


def test_upright_rates() -> None:
    """Printed 1.272, 1.793 and -0.063 for v = (1, 1, 1); the geometry is not printed.

    In the centre of a symmetric triangle the rates add up to 3 (1 each for the rise); the printed
    ones add up to 3.002, so no such triangle comes closer than 2/3 of 1e-3. Size and turn of the
    triangle follow from the rates: offset 0.2279 m, second corner 0.79 degrees short of the y
    axis. Unturned the rates differ from the printed ones by up to 0.014.
    """
    rates = upright_rates(upright_rails(math.radians(-0.7906)))
    np.testing.assert_allclose(rates, PRINTED_UPRIGHT_RATES, atol=7e-4)


TOOL = 0.05
GEARED = {
    "kind": "geared_decoupled",
    "rail_radius": OFFSET + 0.1,
    "carriage_arm": 0.02,
    "platform_radius": 0.08,
    "rod_length": ROD,
    "tool_offset": TOOL,
    "wrist": {"k1": 0.9, "k2": 1.0, "kp": 0.87, "k_gamma": 1.4},
}
"""Rails in the same places, in the family's own order of legs, and k = 0.783."""

AHEAD = [TOOL, 0.0, 0.0, 0.0, 0.0, 0.0]
"""The wrist's centre in the origin, the platform not turned."""


def test_geared_decoupled_has_the_rates_of_its_rails() -> None:
    twist = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]
    result = ask("velocity", GEARED, [AHEAD], platform_rates=[twist])
    expected = upright_rates(upright_rails(0.0))[[1, 2, 0]]
    np.testing.assert_allclose(result.actuator_rates[0][:3], expected, atol=1e-12)
    assert result.actuator_rates[0][3:] == [0.0, 0.0, 0.0]


def test_the_wrists_rates() -> None:
    """Printed 1.4, 2.966 and 1 in size for 1 rad/s about each axis.

    The paper's minus signs are a leftover of its Jx x' = -Jq q'.
    """
    arm = np.cross([1.0, 1.0, 1.0], [TOOL, 0.0, 0.0])
    twist = [*arm.tolist(), 1.0, 1.0, 1.0]
    result = ask("velocity", GEARED, [AHEAD], platform_rates=[twist])
    assert result.actuator_rates[0] == pytest.approx([0.0, 0.0, 0.0, 1.4, 2.966, 1.0], abs=1e-14)


def test_the_wrists_motors() -> None:
    """D1 = k (rx - ry) + kg rz, D2 = k (rx + ry) + kg rz and D3 = rz; rails do not feel angles."""
    turned = np.array([0.3, -0.2, 0.5])
    tip = turn(Z, 0.5) @ turn(Y, -0.2) @ np.array([TOOL, 0.0, 0.0])
    result = ask("inverse_kinematics", GEARED, [[*tip.tolist(), *turned.tolist()], AHEAD])
    expected = [0.783 * 0.5 + 0.7, 0.783 * 0.1 + 0.7, 0.5]
    assert result.actuators[0][3:] == pytest.approx(expected, abs=1e-15)
    assert result.actuators[0][:3] == pytest.approx(result.actuators[1][:3], abs=1e-15)


def test_a_moment_through_the_wrist() -> None:
    """-J^-T M by hand: 50 N m about x over 2 k = 1.566 twice, and what D3 holds against both."""
    result = ask("effort", GEARED, [AHEAD], known_load={"moment": [50.0, 0.0, 0.0]})
    expected = [0.0, 0.0, 0.0, -31.93, -31.93, 89.40]
    assert result.effort[0] == pytest.approx(expected, abs=5e-3)
