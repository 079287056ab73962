"""Velocity of every kind and motion: both ways, power, and loops closed by passive joints."""

import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.effort import signed_efforts
from mechanics.loads import Load
from mechanics.velocity import actuator_rates, passive_rates, platform_twists
from tests.oracles import legs
from tests.oracles.legs import Floats
from tests.properties.mechanisms import FEW, NAMES, Case, ask, numbers, well_held_cases

EVERY = pytest.mark.parametrize("name", NAMES)


def twist_of(case: Case, data: st.DataObject, size: float = 2.0) -> Floats:
    """Draw a twist that the platform can follow, shape (6, 1)."""
    rates = data.draw(st.lists(numbers(-size, size), min_size=len(case.pose), max_size=6))
    twist: Floats = (case.twists @ np.array(rates[: len(case.pose)]))[:, None]
    return twist


@EVERY
@FEW
@given(data=st.data())
def test_drive_rates_are_those_of_the_leg_equation(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    twist = twist_of(case, data)
    rows, levers = legs.leg_rows(case.machine, case.row, case.actuators)
    expected = rows @ (case.twists.T @ twist[:, 0]) / levers
    size = np.abs(rows).max() * np.abs(twist).max() / np.abs(levers)
    found = actuator_rates(case.block, twist)[:, 0]
    assert np.all(np.abs(found - expected) <= 1e-12 * size + 1e-300)


@EVERY
@FEW
@given(data=st.data())
def test_there_and_back(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    twist = twist_of(case, data)
    back = platform_twists(case.block, actuator_rates(case.block, twist))
    # The condition number is below 100, turns measured at the platform's size.
    scale = np.abs(twist).max() * max(case.machine.size, 1 / case.machine.size)
    np.testing.assert_allclose(back, twist, rtol=0, atol=1e-12 * scale + 1e-300)


@EVERY
@FEW
@given(data=st.data())
def test_both_ways_by_request(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    twist = twist_of(case, data)[:, 0]
    there = ask(case.request("velocity", platform_rates=[list(twist)]))
    back = ask(case.request("velocity", actuator_rates=there["actuator_rates"]))
    scale = np.abs(twist).max() * max(case.machine.size, 1 / case.machine.size)
    np.testing.assert_allclose(back["platform_rates"][0], twist, rtol=0, atol=1e-11 * scale)
    for forth, again in zip(there["passive_rates"][0], back["passive_rates"][0], strict=True):
        assert again == pytest.approx(forth, rel=1e-7, abs=1e-7)
    units = ["rad/s" if drive in ("crank", "arc") else "m/s" for drive in case.drives]
    assert there["units"] == back["units"] == units


@EVERY
@FEW
@given(data=st.data())
def test_drives_give_the_power_that_the_load_takes(name: str, data: st.DataObject) -> None:
    """T . psi' = -P . x'; an effort is known to cond * eps of all efforts, cond < 100."""
    case = well_held_cases(data, name)
    twist = twist_of(case, data)
    wrench = np.array(data.draw(st.lists(numbers(-50.0, 50.0), min_size=6, max_size=6)))
    efforts = signed_efforts(case.block, Load(known=wrench[:, None]))[:, 0]
    rates = actuator_rates(case.block, twist)[:, 0]
    taken = wrench @ twist[:, 0]
    _, levers = legs.leg_rows(case.machine, case.row, case.actuators)
    forces = float(np.linalg.norm(efforts / levers))
    speeds = float(np.linalg.norm(rates * levers))
    assert abs(efforts @ rates + taken) <= 1e-12 * max(forces * speeds, abs(float(taken))) + 1e-300


Rates = Floats


def _elbow(case: Case, leg: int) -> tuple[Floats, Floats, Floats, Floats]:
    """Return elbow, platform joint, rod direction and the hinge fixed in the driven link."""
    shape, psi = case.machine.legs[leg], float(case.actuators[leg])
    moved, _ = legs.driven(shape, psi)
    joint = legs.joints(case.machine, case.row)[leg]
    hinge = case.hinge(leg)
    if shape.drive == "crank":
        hinge = legs.about(shape.axis, psi) @ hinge
    return moved, joint, legs.unit(joint - moved), hinge


def _of_drive(case: Case, leg: int, rate: float) -> tuple[Floats, Floats]:
    """Return the angular velocity of the driven link, and the velocity of its end."""
    shape, psi = case.machine.legs[leg], float(case.actuators[leg])
    _, moving = legs.driven(shape, psi)
    turning = shape.axis * rate if shape.drive == "crank" else np.zeros(3)
    return turning, moving * rate


def _plane(case: Case, leg: int, rate: float, passive: Rates) -> tuple[Floats, Floats]:
    at_elbow, at_platform = passive
    moved, joint, direction, normal = _elbow(case, leg)
    turning, end = _of_drive(case, leg, rate)
    if case.drives[leg] == "strut":  # no elbow: B is the joint at the base
        end = rate * direction
    rod = turning + at_elbow * normal
    return end + np.cross(rod, joint - moved), rod + at_platform * normal


def _universal(case: Case, leg: int, rate: float, passive: Rates) -> tuple[Floats, Floats]:
    """Universal joint at the elbow, its second axis rod x first; then a ball."""
    first, second, *ball = passive
    moved, joint, direction, hinge = _elbow(case, leg)
    turning, end = _of_drive(case, leg, rate)
    rod = turning + first * hinge + second * legs.unit(np.cross(direction, hinge))
    return end + np.cross(rod, joint - moved), rod + np.array(ball)


def _parallelogram(case: Case, leg: int, rate: float, passive: Rates) -> tuple[Floats, Floats]:
    """The rods turn by BC, what joins them does not; CD is about the hinge again."""
    first, second, last = passive
    moved, joint, direction, hinge = _elbow(case, leg)
    turning, end = _of_drive(case, leg, rate)
    rod = turning + first * hinge + second * legs.unit(np.cross(direction, hinge))
    return end + np.cross(rod, joint - moved), turning + (first + last) * hinge


def _strut(case: Case, leg: int, rate: float, passive: Rates) -> tuple[Floats, Floats]:
    at_base, at_platform = passive[:3], passive[3:]
    moved, joint, direction, _ = _elbow(case, leg)
    return rate * direction + np.cross(at_base, joint - moved), at_base + at_platform


def _arcs(case: Case, leg: int, rate: float, passive: Rates) -> tuple[Floats, Floats]:
    at_elbow, at_platform = passive
    shape = case.machine.legs[leg]
    middle, _ = legs.driven(shape, float(case.actuators[leg]))
    outer = legs.joints(case.machine, case.row)[leg]
    return np.zeros(3), rate * shape.axis + at_elbow * middle + at_platform * outer


CHAINS: dict[tuple[str, ...], Callable[[Case, int, float, Rates], tuple[Floats, Floats]]] = {
    ("B", "C"): _plane,
    ("BA", "BC", "Cx", "Cy", "Cz"): _universal,
    ("BA", "BC", "CD"): _parallelogram,
    ("Ax", "Ay", "Az", "Cx", "Cy", "Cz"): _strut,
    ("W", "V"): _arcs,
}


@EVERY
@FEW
@given(data=st.data())
def test_passive_joints_close_every_loop(name: str, data: st.DataObject) -> None:
    """The rates along a leg, screw after screw, add up to the platform's own motion."""
    case = well_held_cases(data, name)
    twist = twist_of(case, data)[:, 0]
    answer = ask(case.request("velocity", platform_rates=[list(twist)]))
    arms = legs.arms(case.machine, case.row)
    for leg, names in enumerate(answer["passive_joints"]):
        rate, passive = answer["actuator_rates"][0][leg], answer["passive_rates"][0][leg]
        if passive is None:  # the second axis of a universal joint is lost along its first
            _, _, direction, hinge = _elbow(case, leg)
            assert np.linalg.norm(np.cross(hinge, direction)) < 1e-6
            continue
        end, turn = CHAINS[tuple(names)](case, leg, rate, np.array(passive))
        fastest = float(np.abs([rate, *passive]).max()) + float(np.abs(twist).max())
        np.testing.assert_allclose(turn, twist[3:], rtol=0, atol=1e-12 * fastest + 1e-300)
        if names != ["W", "V"]:
            expected = twist[:3] + np.cross(twist[3:], arms[leg])
            np.testing.assert_allclose(end, expected, rtol=0, atol=1e-11 * fastest + 1e-300)


@EVERY
@FEW
@given(data=st.data())
def test_rates_by_request_are_the_kernels(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    twist = twist_of(case, data)
    answer = ask(case.request("velocity", platform_rates=[list(twist[:, 0])]))
    drives = actuator_rates(case.block, twist)
    assert answer["actuator_rates"][0] == pytest.approx(list(drives[:, 0]), rel=1e-12, abs=1e-12)
    for found, made in zip(
        answer["passive_rates"][0], passive_rates(case.block, twist, drives), strict=True
    ):
        if found is not None:
            assert found == pytest.approx(list(made[:, 0]), rel=1e-9, abs=1e-9)


def test_an_upright_rail_with_a_parallelogram_by_hand() -> None:
    """One rod of a linear Delta at (0.3, 0, 0.4) from its carriage, tool driven along +z."""
    document = {
        "kind": "delta_linear",
        "rail_radius": 0.35,
        "platform_radius": 0.05,
        "carriage_arm": 0.0,
        "tool_offset": 0.0,
        "rod_length": 0.5,
    }
    case = Case(document, (0.0, 0.0, 0.0))
    answer = ask(case.request("velocity", platform_rates=[[0.0, 0.0, 1.0, 0.0, 0.0, 0.0]]))
    assert case.actuators == pytest.approx([0.4] * 3, rel=1e-14)
    assert answer["actuator_rates"][0] == pytest.approx([1.0] * 3, rel=1e-14)
    for passive in answer["passive_rates"][0]:
        assert passive == pytest.approx([0.0] * 3, abs=1e-15)
    along_y = ask(case.request("velocity", platform_rates=[[0.0, 1.0, 0.0, 0.0, 0.0, 0.0]]))
    # The rod of the leg at 90 degrees drops 0.4 over 0.3 inward: outward motion by 1 drives its
    # carriage up at 3/4, and the rod, 0.5 long, turns at hypot(1, 3/4) / 0.5.
    assert along_y["actuator_rates"][0][0] == pytest.approx(0.75, rel=1e-13)
    assert math.hypot(*along_y["passive_rates"][0][0][:2]) == pytest.approx(2.5, rel=1e-13)
