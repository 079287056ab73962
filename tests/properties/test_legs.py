"""Inverse kinematics of every kind and motion: constraint, working modes, limits, rates."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.configuration import Configuration
from schemas.mechanisms import KINDS
from tests.oracles import legs
from tests.oracles.draws import WRISTED
from tests.oracles.legs import Floats
from tests.properties.mechanisms import (
    FAMILIES,
    FEW,
    NAMES,
    Case,
    ask,
    cases,
    customs,
    numbers,
    well_held,
    well_held_cases,
)

EVERY = pytest.mark.parametrize("name", NAMES)


@EVERY
@FEW
@given(data=st.data())
def test_every_leg_keeps_its_equation(name: str, data: st.DataObject) -> None:
    case = cases(data, name)
    ends = legs.joints(case.machine, case.row)
    for leg, end, psi in zip(case.machine.legs, ends, case.actuators, strict=True):
        # A leg that is built stretched may fall a rounding short of the platform.
        assert math.isnan(psi) or abs(legs.residual(leg, end, psi)) <= 1e-12


@EVERY
@FEW
@given(data=st.data())
def test_a_sign_chooses_its_root(name: str, data: st.DataObject) -> None:
    """+1: a crank's or an arc's angle beyond atan2(Q, P), a rail's coordinate beyond d . s."""
    case = well_held_cases(data, name)
    ends = legs.joints(case.machine, case.row)
    mode = case.mechanism.legs.working_mode
    for leg, end, psi, sign in zip(case.machine.legs, ends, case.actuators, mode, strict=True):
        away = end - leg.base
        if leg.drive == "strut":
            assert psi > 0
        elif leg.drive == "rail":
            assert sign * (psi - away @ leg.axis) > 0
        else:
            middle = math.atan2(away @ leg.quarter, away @ leg.zero)
            assert sign * math.sin(psi - middle) > 0


@EVERY
@FEW
@given(data=st.data())
def test_working_modes_are_all_signs_of_legs_that_have_two(name: str, data: st.DataObject) -> None:
    case = cases(data, name)
    choices = [(1,) if drive == "strut" else (1, -1) for drive in case.drives]
    assert set(case.mechanism.working_modes) == set(itertools.product(*choices))
    assert len(case.mechanism.working_modes) == math.prod(map(len, choices))


@EVERY
@FEW
@given(data=st.data())
def test_all_modes_are_each_mode_alone(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    every = ask(case.request("inverse_kinematics", working_mode="all"))
    modes = [list(mode) for mode in case.mechanism.working_modes]
    assert every["working_modes"] == modes
    for index in {0, len(modes) // 2, len(modes) - 1}:
        alone = ask(case.request("inverse_kinematics", working_mode=modes[index]))
        assert every["actuators"][index] == alone["actuators"]
        assert every["reachable"][index] == alone["reachable"]


@EVERY
@FEW
@given(data=st.data())
def test_the_wire_carries_the_kernels_numbers(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    row = ask(case.request("inverse_kinematics"))["actuators"][0]
    assert [math.nan if value is None else value for value in row] == pytest.approx(
        list(case.actuators), rel=1e-13, abs=1e-13, nan_ok=True
    )


def limited(case: Case, leg: int, least: float, greatest: float) -> bool:
    """Return whether the pose counts as reachable with a limit on one leg."""
    limits: list[object] = [None] * len(case.pose)
    limits[leg] = {"min": least, "max": greatest}
    document = {**case.document, "actuator_limits": limits}
    answer = ask(case.request("inverse_kinematics", mechanism=document))
    assert answer["actuators"][0][leg] == pytest.approx(case.actuators[leg], abs=1e-13)
    assert bool(answer["obstacles"]) != answer["reachable"][0]
    for obstacle in answer["obstacles"]:
        assert (obstacle["leg"], obstacle["reason"]) == (leg, "actuator_limits")
    return bool(answer["reachable"][0])


@EVERY
@FEW
@given(data=st.data())
def test_only_angles_may_lie_whole_turns_away(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    leg = data.draw(st.integers(0, len(case.pose) - 1))
    turns = data.draw(st.sampled_from([-3, -1, 1, 2])) * 2 * math.pi
    psi = float(case.actuators[leg])
    assert limited(case, leg, psi - 0.1, psi + 0.1)
    turning = case.drives[leg] in ("crank", "arc")
    assert limited(case, leg, psi + turns - 0.1, psi + turns + 0.1) == turning


@EVERY
@FEW
@given(data=st.data())
def test_a_limit_beside_the_drive_is_broken(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    leg = data.draw(st.integers(0, len(case.pose) - 1))
    gap, width = data.draw(numbers(0.01, 1.0)), data.draw(numbers(0.01, 1.0))
    psi = float(case.actuators[leg])
    assert not limited(case, leg, psi + gap, psi + gap + width)
    assert not limited(case, leg, psi - gap - width, psi - gap)


@EVERY
@FEW
@given(data=st.data())
def test_jacobians_are_those_of_the_leg_equation(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    rows, levers = legs.leg_rows(case.machine, case.row, case.actuators)
    np.testing.assert_allclose(case.block.platform_jacobians[..., 0], rows, atol=1e-12)
    np.testing.assert_allclose(case.block.rods[1][:, 0], levers, atol=1e-12)
    assert case.block.determinants[0] == pytest.approx(np.linalg.det(rows), rel=1e-9, abs=1e-12)


def slopes(case: Case, column: int, step: float) -> Floats:
    """Return the rates of the drives along a coordinate, to fourth order in the step."""
    shift = np.zeros(len(case.pose))
    shift[column] = step
    block: Configuration = case.at(*[case.row + k * shift for k in (1, -1, 2, -2)])
    turning = np.array([drive in ("crank", "arc") for drive in case.drives])
    ends = block.actuators - case.actuators[:, None]
    ends = np.where(turning[:, None], np.angle(np.exp(1j * ends)), ends)
    near, far = ends[:, 0] - ends[:, 1], ends[:, 2] - ends[:, 3]
    made: Floats = (8 * near - far) / (12 * step)
    return made


@EVERY
@FEW
@given(data=st.data())
def test_jacobian_is_the_derivative_of_the_inverse(name: str, data: st.DataObject) -> None:
    """Steps of h = 1e-3 of the shortest span l, over the platform's arm where they turn.

    The fifth derivative of a drive with sine s of its elbow is about 5! / (l^5 s^9), so that
    with s > 0.3 the fourth-order truncation h^4 f^(5) / 30 is below 3e-7 of a unit rate 1 / l;
    the rounding is about 1e-16 / 1e-3. Rates of angles become angular velocities by
    `rate_matrix`.
    """
    case = well_held(cases(data, name), 1e3, 0.3)
    rows, _ = legs.leg_rows(case.machine, case.row, case.actuators)
    np.testing.assert_allclose(case.block.platform_jacobians[..., 0], rows, atol=1e-12)
    jacobian = (case.block.platform_jacobians / case.block.rods[1][:, None])[..., 0]
    expected = jacobian @ legs.rate_matrix(case.machine, case.row)
    farthest = max(float(np.linalg.norm(arm)) for arm in legs.arms(case.machine, case.row))
    for column in range(len(case.pose)):
        turning = column >= len(case.pose) - case.machine.turns
        arm = max(farthest, case.reach) if turning else 1.0
        found = slopes(case, column, 1e-3 * case.reach / arm)
        unit = np.array([1.0 if d in ("rail", "strut") else 1 / case.reach for d in case.drives])
        assert np.abs((found - expected[:, column]) / (unit * arm)).max() < 1e-6


@pytest.mark.parametrize("motion", legs.COORDINATES)
@FEW
@given(data=st.data())
def test_struts_measure_the_distance(motion: str, data: st.DataObject) -> None:
    case = data.draw(customs(motion, ("strut",) * legs.COORDINATES[motion]))
    ends = legs.joints(case.machine, case.row)
    lengths = [
        np.linalg.norm(end - leg.base) for leg, end in zip(case.machine.legs, ends, strict=True)
    ]
    np.testing.assert_allclose(case.actuators, lengths, rtol=1e-13)


def test_every_kind_of_the_wire_is_drawn() -> None:
    """A platform that motors turn is no matter of legs alone: see `test_wrists`."""
    assert {*FAMILIES, *WRISTED, "custom"} == set(KINDS)
