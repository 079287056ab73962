"""The geared decoupled mechanism against its own geometry, differences and brute force."""

import json
import math
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import pytest

from tests.oracles import wrists
from tests.oracles.draws import WRISTED
from tests.oracles.legs import angles_of
from tests.oracles.machines import Floats
from tests.properties.mechanisms import ask

Document = dict[str, Any]
MECHANISMS, POSES = 5, 3


class Case(NamedTuple):
    """A mechanism on the wire and a pose that it reaches, clear of singularities."""

    wire: Document
    pose: Floats
    twist: Floats
    wrench: Floats

    def asked(self, analysis: str, **more: object) -> Document:
        body = {"analysis": analysis, "mechanism": self.wire, "poses": [self.pose.tolist()]}
        return ask(json.loads(json.dumps(body | more, default=np.ndarray.tolist)))

    @property
    def loaded(self) -> Document:
        return {"force": self.wrench[:3].tolist(), "moment": self.wrench[3:].tolist()}


@cache
def cases() -> list[Case]:
    random = np.random.default_rng(2022)
    found: list[Case] = []
    while len(found) < MECHANISMS * POSES:
        wire, least, most = WRISTED["geared_decoupled"](random)
        tried = random.uniform(least, most, (100, 6))
        rods = [
            wrists.rods(wire, pose, wire["working_mode"]) / wire["rod_length"] for pose in tried
        ]
        clear = [
            pose
            for pose, rod in zip(tried, rods, strict=True)
            if np.abs(rod[:, 2]).min() > 0.2 and np.linalg.cond(rod) < 30 and abs(pose[4]) < 1.4
        ]
        found += [Case(wire, pose, *random.normal(size=(2, 6))) for pose in clear[:POSES]]
    return found


EVERY = pytest.mark.parametrize("number", range(MECHANISMS * POSES))


@EVERY
def test_drives_are_heights_and_turns(number: int) -> None:
    case = cases()[number]
    found = case.asked("inverse_kinematics")
    expected = wrists.drives(case.wire, case.pose, case.wire["working_mode"])
    assert found["units"] == ["m", "m", "m", "rad", "rad", "rad"]
    np.testing.assert_allclose(found["actuators"][0], expected, atol=1e-13)


@EVERY
def test_the_modes_of_drives_hold_their_pose(number: int) -> None:
    case = cases()[number]
    drives = wrists.drives(case.wire, case.pose, case.wire["working_mode"])
    found = case.asked("inverse_kinematics")
    asked = {"analysis": "forward_kinematics", "mechanism": case.wire}
    modes = ask(asked | {"actuators": found["actuators"]})["assembly_modes"][0]
    assert len(modes) == 2
    own = min(modes, key=lambda mode: float(np.abs(np.array(mode["pose"]) - case.pose).max()))
    np.testing.assert_allclose(own["pose"], case.pose, atol=1e-9)
    assert own["working_mode"] == case.wire["working_mode"]
    for mode in modes:
        again = wrists.drives(case.wire, mode["pose"], mode["working_mode"])
        np.testing.assert_allclose(again, drives, atol=1e-9)
    assert modes[0]["determinant"] > 0 > modes[1]["determinant"]


@EVERY
def test_motors_that_stand_turns_on_hold_the_same_orientation(number: int) -> None:
    case = cases()[number]
    beyond = case.pose + 2 * math.pi * np.array([0, 0, 0, 1, 0, -2])
    # Past a right angle of ry the same orientation has other angles.
    flipped = np.array([*case.pose[:3], case.pose[3] + math.pi, 3.0, case.pose[5] - math.pi])
    for pose in (beyond, flipped):
        drives = wrists.drives(case.wire, pose, case.wire["working_mode"])
        if np.isnan(drives).any():
            continue
        asked = {"analysis": "forward_kinematics", "mechanism": case.wire}
        modes = ask(asked | {"actuators": [drives.tolist()]})["assembly_modes"][0]
        expected = angles_of(wrists.rotation(pose))
        for mode in modes:
            np.testing.assert_allclose(mode["pose"][3:], expected, atol=1e-12)
        off = [np.abs(np.array(mode["pose"][:3]) - pose[:3]).max() for mode in modes]
        assert min(off) < 1e-9


@EVERY
def test_a_guess_leads_to_the_mode_beside_it(number: int) -> None:
    case = cases()[number]
    drives = case.asked("inverse_kinematics")["actuators"]
    asked = {"analysis": "forward_kinematics", "mechanism": case.wire, "actuators": drives}
    near = (case.pose + 1e-3).tolist()
    found = ask(asked | {"guess": near})
    np.testing.assert_allclose(found["assembly_modes"][0][0]["pose"], case.pose, atol=1e-9)


@EVERY
def test_rates_are_those_of_differences(number: int) -> None:
    case = cases()[number]
    found = case.asked("velocity", platform_rates=[case.twist])
    expected = wrists.rates(case.wire, case.pose, case.twist)
    np.testing.assert_allclose(found["actuator_rates"][0], expected, rtol=1e-7, atol=1e-7)


@EVERY
def test_rates_lead_back_to_the_twist(number: int) -> None:
    case = cases()[number]
    rates = case.asked("velocity", platform_rates=[case.twist])["actuator_rates"]
    found = case.asked("velocity", actuator_rates=rates)
    np.testing.assert_allclose(found["platform_rates"][0], case.twist, rtol=1e-11, atol=1e-11)


@EVERY
def test_rods_swing_as_those_of_a_delta_in_the_wrists_centre(number: int) -> None:
    case = cases()[number]
    sizes = {k: v for k, v in case.wire.items() if k not in ("kind", "wrist", "working_mode")}
    delta = sizes | {"kind": "delta_linear", "tool_offset": 0.0}
    delta["working_mode"] = case.wire["working_mode"][:3]
    arm = case.wire["tool_offset"] * wrists.rotation(case.pose)[:, 0]
    twist = [*(case.twist[:3] - np.cross(case.twist[3:], arm)).tolist(), 0.0, 0.0, 0.0]
    body = {"analysis": "velocity", "mechanism": delta, "platform_rates": [twist]}
    expected = ask(body | {"poses": [wrists.centre(case.wire, case.pose).tolist()]})
    found = case.asked("velocity", platform_rates=[case.twist])
    assert found["passive_joints"] == expected["passive_joints"]
    np.testing.assert_allclose(found["passive_rates"], expected["passive_rates"], atol=1e-9)


@EVERY
def test_what_drives_do_is_what_the_load_does(number: int) -> None:
    case = cases()[number]
    efforts = np.array(case.asked("effort", known_load=case.loaded)["effort"][0])
    rates = np.array(case.asked("velocity", platform_rates=[case.twist])["actuator_rates"][0])
    powers = np.concatenate([efforts * rates, case.wrench * case.twist])
    assert abs(powers.sum()) <= 1e-12 * np.abs(powers).sum()


@EVERY
def test_no_direction_asks_more_than_the_worst(number: int) -> None:
    case = cases()[number]
    random = np.random.default_rng(number)
    found = case.asked("effort", load={"force": 7.0, "moment": 2.0}, known_load=case.loaded)
    directions = random.normal(size=(2, 300, 3))
    forces, moments = directions / np.linalg.norm(directions, axis=2, keepdims=True)
    tried = case.wrench + np.hstack([7.0 * forces, 2.0 * moments])
    body = {"analysis": "effort", "mechanism": case.wire, "poses": [case.pose.tolist()] * 300}
    known = {"force": tried[:, :3].tolist(), "moment": tried[:, 3:].tolist()}
    efforts = np.abs(np.array(ask(body | {"known_load": known})["effort"]))
    assert np.all(efforts <= np.array(found["effort"][0]) * (1 + 1e-12))


@EVERY
def test_the_worst_direction_asks_what_it_is_said_to(number: int) -> None:
    case = cases()[number]
    found = case.asked("effort", load={"force": 7.0, "moment": 2.0}, known_load=case.loaded)
    forces, moments = np.array(found["worst_force"][0]), np.array(found["worst_moment"][0])
    loads = case.wrench + np.hstack([forces, moments])
    body = {"analysis": "effort", "mechanism": case.wire, "poses": [case.pose.tolist()] * 6}
    known = {"force": loads[:, :3].tolist(), "moment": loads[:, 3:].tolist()}
    efforts = np.array(ask(body | {"known_load": known})["effort"])
    np.testing.assert_allclose(np.abs(np.diag(efforts)), found["effort"][0], rtol=1e-11)


@EVERY
def test_a_platforms_weight_is_a_known_load(number: int) -> None:
    case = cases()[number]
    offset = np.array([0.1, -0.2, 0.05])
    weight = np.array([0.0, 0.0, -2.0 * 9.80665])
    moment = np.cross(wrists.rotation(case.pose) @ offset, weight)
    platform = {"mass": 2.0, "centre_of_mass": offset.tolist()}
    found = case.asked("effort", platform=platform)
    known = {"force": weight.tolist(), "moment": moment.tolist()}
    expected = case.asked("effort", known_load=known)
    np.testing.assert_allclose(found["effort"], expected["effort"], rtol=1e-11, atol=1e-11)


@EVERY
def test_the_determinant_is_that_of_the_rods(number: int) -> None:
    case = cases()[number]
    found = case.asked("singularity")
    rods = wrists.rods(case.wire, case.pose, case.wire["working_mode"]) / case.wire["rod_length"]
    size = abs(case.wire["tool_offset"])
    assert found["type"] == [0]
    assert found["determinant_unit"] == "m³"
    assert found["characteristic_length"] == pytest.approx(size, rel=1e-13)
    assert found["determinant"][0] == pytest.approx(np.linalg.det(rods) * size**3, rel=1e-9)


@EVERY
def test_pressure_angles_are_between_motion_and_push(number: int) -> None:
    """Brake all drives but one: where the platform goes, against what that drive bears alone."""
    case = cases()[number]
    jacobian = np.array([wrists.rates(case.wire, case.pose, twist) for twist in np.eye(6)]).T
    motions = np.linalg.inv(jacobian)
    rods = wrists.rods(case.wire, case.pose, case.wire["working_mode"])
    lines = [
        *((motions[:3, k], rods[k]) for k in range(3)),
        *((motions[3:, k], jacobian[k, 3:]) for k in range(3, 6)),
    ]
    expected = [
        math.acos(min(1.0, abs(a @ b) / (float(np.linalg.norm(a)) * float(np.linalg.norm(b)))))
        for a, b in lines
    ]
    found = case.asked("singularity")["pressure_angles"][0]
    np.testing.assert_allclose(found, expected, atol=1e-5)


@EVERY
def test_speeds_bound_the_rates(number: int) -> None:
    """The greatest rates over all directions, on a grid of one node, against the rows of J."""
    case = cases()[number]
    jacobian = np.array([wrists.rates(case.wire, case.pose, twist) for twist in np.eye(6)]).T
    greatest = 0.3 * np.linalg.norm(jacobian[:, :3], axis=1)
    greatest += 2.0 * np.linalg.norm(jacobian[:, 3:], axis=1)
    x = float(case.pose[0])
    fixed = dict(zip(("y", "z", "rx", "ry", "rz"), case.pose[1:].tolist(), strict=True))
    asked: Document = {"analysis": "workspace", "mechanism": case.wire}
    asked |= {"type": "constant_orientation"}
    asked |= {"grid": [{"coordinate": "x", "min": x, "max": x, "step": 1.0}], "fixed": fixed}
    for share, inside in ((1 + 1e-6, 1), (1 - 1e-6, 0)):
        effective: Document = {"platform_speed": {"linear": 0.3, "angular": 2.0}}
        effective |= {"max_actuator_speed": (share * greatest).tolist()}
        found = ask(asked | {"class": "effective", "effective": effective})
        assert found["inside"] == inside
