"""Bounds of constructive and effective workspaces on random mechanisms of every kind."""

import json
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.optimize import lsq_linear

import analyses
from analyses.workspace_bounds import EFFECTIVE_BOUNDS
from mechanics import fields
from mechanics.conditions.actuator_speed import ActuatorSpeed
from mechanics.conditions.base_joint_angle import BaseJointAngle
from mechanics.conditions.condition_number import ConditionNumber
from mechanics.conditions.determinant import Determinant
from mechanics.conditions.platform_joint_angle import PlatformJointAngle
from mechanics.conditions.pressure_angle import PressureAngle
from mechanics.conditions.rod_distance import RodDistance, separate_rods
from mechanics.effort import worst_efforts
from mechanics.loads import Load
from mechanics.singularity import singularities
from mechanics.velocity import Speed, actuator_rates
from schemas.workspace import WorkspaceRequest
from tests.oracles import legs
from tests.oracles.legs import Floats
from tests.properties.mechanisms import FEW, NAMES, Case, axes, numbers, well_held_cases

EVERY = pytest.mark.parametrize("name", NAMES)
RODS = pytest.mark.parametrize("name", [name for name in NAMES if name != "spherical_3rrr"])
# Grids of constant orientation have axes along translations only.
MOVING = [name for name in NAMES if "spherical" not in name]


def drawn_axes(data: st.DataObject, case: Case) -> Floats:
    return np.array([data.draw(axes()) for _ in case.pose])


def angle(one: Floats, two: Floats) -> float:
    """Return the angle of two vectors by the half-angle of their unit vectors."""
    a, b = legs.unit(one), legs.unit(two)
    return 2.0 * math.atan2(float(np.linalg.norm(a - b)), float(np.linalg.norm(a + b)))


def rods(case: Case) -> list[tuple[Floats, Floats]]:
    """Return both ends of every rod."""
    ends = legs.joints(case.machine, case.row)
    return [
        (legs.driven(leg, float(psi))[0], end)
        for leg, psi, end in zip(case.machine.legs, case.actuators, ends, strict=True)
    ]


@RODS
@FEW
@given(data=st.data())
def test_base_joints_rest_with_what_carries_them(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    rest = drawn_axes(data, case)
    found = BaseJointAngle(case.mechanism, rest, 1.0).check(case.block)[:, 0]
    for k, (leg, (start, end)) in enumerate(zip(case.machine.legs, rods(case), strict=True)):
        turned = rest[k]
        if leg.drive == "crank":
            turned = legs.about(leg.axis, float(case.actuators[k])) @ turned
        assert 1.0 - found[k] == pytest.approx(angle(end - start, turned), abs=1e-9)


@RODS
@FEW
@given(data=st.data())
def test_platform_joints_rest_with_the_platform(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    rest = drawn_axes(data, case)
    found = PlatformJointAngle(case.mechanism, rest, 1.0).check(case.block)[:, 0]
    _, rotation = legs.place(case.machine, case.row)
    for k, (start, end) in enumerate(rods(case)):
        assert 1.0 - found[k] == pytest.approx(angle(end - start, rotation @ rest[k]), abs=1e-9)


def nearest(one: tuple[Floats, Floats], two: tuple[Floats, Floats]) -> float:
    matrix = np.column_stack([one[1] - one[0], two[0] - two[1]])
    apart = two[0] - one[0]
    solved = lsq_linear(matrix, apart, (0.0, 1.0), method="bvls", tol=1e-14)
    return float(np.linalg.norm(matrix @ solved.x - apart))


@RODS
@FEW
@given(data=st.data())
def test_distances_are_those_of_the_rods(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    pairs = separate_rods(case.mechanism)
    condition = RodDistance(case.mechanism, 0.01)
    assert condition.legs == tuple(i for i, _ in pairs)
    found, ends = condition.check(case.block), rods(case)
    expected = [nearest(ends[i], ends[j]) - 0.01 for i, j in pairs]
    assert found[:, 0] == pytest.approx(expected, abs=1e-9)


@EVERY
@FEW
@given(data=st.data())
def test_pairs_are_all_but_those_that_share_a_joint(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    pairs = set()
    for i, one in enumerate(case.machine.legs):
        for j, two in enumerate(case.machine.legs[:i]):
            platform = np.allclose(one.point, two.point, rtol=0.0, atol=1e-12)
            struts = one.drive == two.drive == "strut"
            base = struts and np.allclose(one.base, two.base, rtol=0.0, atol=1e-12)
            if "arc" not in (one.drive, two.drive) and not platform and not base:
                pairs.add((j, i))
    assert set(separate_rods(case.mechanism)) == pairs


def directions(count: int) -> Floats:
    """Return unit vectors, shape (count, many), no farther apart than about 0.03."""
    if count < 2:
        return np.array([[1.0, -1.0]])[:count]
    turns = np.linspace(0.0, 2 * math.pi, 401)
    if count == 2:
        return np.array([np.cos(turns), np.sin(turns)])
    # A golden spiral on the sphere.
    heights = 1.0 - (2.0 * np.arange(8000) + 1.0) / 8000
    spins = math.pi * (3.0 - math.sqrt(5.0)) * np.arange(8000)
    radii = np.sqrt(1.0 - heights**2)
    return np.array([radii * np.cos(spins), radii * np.sin(spins), heights])


@EVERY
@FEW
@given(data=st.data())
def test_drive_speeds_are_never_exceeded_and_are_reached(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    linear, angular = data.draw(numbers(0.1, 5.0)), data.draw(numbers(0.1, 5.0))
    condition = ActuatorSpeed(case.mechanism, Speed(linear, angular), np.zeros(len(case.pose)))
    greatest = -condition.check(case.block)[:, 0]
    moves = len(case.pose) - case.machine.turns
    parts = [
        size * case.twists[:, chosen] @ directions(case.twists[:, chosen].shape[1])
        for size, chosen in ((linear, slice(moves)), (angular, slice(moves, None)))
    ]
    random = np.random.default_rng(7)
    both = sum(part[:, random.integers(0, part.shape[1], 3000)] for part in parts if part.shape[1])
    # The best of each part alone: rates are linear in twists.
    alone = [actuator_rates(case.at(*[case.row] * p.shape[1]), p) for p in parts if p.shape[1]]
    best = np.sum([np.max(rates, axis=1) for rates in alone], axis=0)
    rates = actuator_rates(case.at(*[case.row] * 3000), np.asarray(both))
    assert np.all(np.abs(rates) <= greatest[:, None] * (1 + 1e-12))
    assert np.all(best <= greatest * (1 + 1e-12))
    assert np.all(best >= greatest * (1 - 1e-3))


def differences(case: Case) -> Floats:
    """Return how the leg equations change with the twists, drives held, over what they weigh.

    A rod's length over the joint's move, of an arc w.v: rows of Jx but for their sign.
    """
    step = 1e-6
    point, rotation = legs.place(case.machine, case.row)

    def equations(twist: Floats) -> Floats:
        turn = np.linalg.norm(twist[3:])
        turned = legs.about(twist[3:] / turn, float(turn)) if turn else np.eye(3)
        values = []
        for leg, psi in zip(case.machine.legs, case.actuators, strict=True):
            moved, _ = legs.driven(leg, float(psi))
            joint = point + twist[:3] + turned @ rotation @ leg.point
            arc = leg.drive == "arc"
            values.append(moved @ joint if arc else np.linalg.norm(joint - moved))
        return np.array(values)

    columns = [
        (equations(step * twist) - equations(-step * twist)) / (2 * step) for twist in case.twists.T
    ]
    return np.column_stack(columns)


@EVERY
@FEW
@given(data=st.data())
def test_determinant_and_condition_are_of_the_differentiated_legs(
    name: str, data: st.DataObject
) -> None:
    case = well_held_cases(data, name)
    assume(case.reach > 0.05)
    matrix = differences(case)
    scaled = legs.at_size(case.machine, matrix)
    condition = 1.0 - ConditionNumber(1.0).check(case.block)[0, 0]
    assert condition == pytest.approx(np.linalg.cond(scaled), rel=1e-5)
    size = 1.0 + Determinant(1.0).check(case.block)[0, 0]
    assert size == pytest.approx(abs(np.linalg.det(matrix)), rel=1e-5, abs=1e-9)


@EVERY
@FEW
@given(data=st.data())
def test_fields_conditions_and_answers_agree(name: str, data: st.DataObject) -> None:
    block = well_held_cases(data, name).block
    answer = singularities(block)
    pressure = 9.0 - PressureAngle(block.mechanism, 9.0).check(block)
    np.testing.assert_allclose(pressure, answer.pressure_angles, atol=1e-14)
    assert fields.pressure_angle(block)[0] == answer.pressure_angles.max()
    assert fields.condition_number(block)[0] == answer.condition_number[0]


@dataclass(frozen=True)
class Study:
    """A case with bounds near what it has at its pose, and a small grid around that."""

    case: Case
    constructive: dict[str, Any]
    effective: dict[str, Any]
    grid: list[dict[str, Any]]

    def request(self, **changes: object) -> WorkspaceRequest:
        names = self.case.mechanism.motion.coordinates
        held = zip(names[len(self.grid) :], self.case.pose[len(self.grid) :], strict=True)
        document = {
            "analysis": "workspace",
            "mechanism": self.case.document,
            "class": "effective",
            "type": "constant_orientation",
            "grid": self.grid,
            "fixed": dict(held),
            "constructive": self.constructive,
            "effective": self.effective,
            "fields": ["condition_number", "pressure_angle", "determinant"],
            **changes,
        }
        request = analyses.parse(json.dumps(document))
        analyses.check(request, 10**6)
        assert isinstance(request, WorkspaceRequest)
        return request


def arrays(request: WorkspaceRequest) -> dict[str, npt.NDArray[Any]]:
    found = analyses.compute(request, 0, analyses.plan(request, 1.0).items)
    grid = analyses.dense_grid(request, lambda: iter([found]))
    return {
        column.name: np.concatenate(list(column.chunks())).reshape(column.shape)
        for column in grid.columns
    }


def studies(data: st.DataObject, name: str) -> Study:
    """Draw a case and every bound that it can have, held at the pose with a little to spare."""
    case = well_held_cases(data, name)
    block, mechanism, count = case.block, case.mechanism, len(case.pose)

    def above(value: float, greatest: float = 1e12) -> float:
        return min(greatest, float(value) * data.draw(numbers(1.02, 1.8)) + 1e-9)

    def below(value: float) -> float:
        return max(1e-9, float(value) * data.draw(numbers(0.2, 0.98)))

    rest = drawn_axes(data, case)
    cones = [
        (1.0 - kind(mechanism, rest, 1.0).check(block)).max()
        for kind in (BaseJointAngle, PlatformJointAngle)
    ]
    speeds = -ActuatorSpeed(mechanism, Speed(1.0, 1.0), np.zeros(count)).check(block)[:, 0]
    efforts = worst_efforts(block, Load(force=1.0, moment=1.0))[:, 0]
    constructive: dict[str, Any] = {
        "max_base_joint_angle": above(cones[0], math.pi),
        "base_joint_axes": rest.tolist(),
        "max_platform_joint_angle": above(cones[1], math.pi),
        "platform_joint_axes": rest.tolist(),
    }
    if separate_rods(mechanism):
        distance = RodDistance(mechanism, 0.0).check(block).min()
        constructive["min_rod_distance"] = below(distance)
    effective: dict[str, Any] = {
        "load": {"force": 1.0, "moment": 1.0},
        "max_effort": [above(effort) for effort in efforts],
        "max_pressure_angle": above(fields.pressure_angle(block)[0], math.pi),
        "min_abs_determinant": below(abs(block.determinants[0])),
        "max_condition_number": above(block.condition_numbers[0]),
        "platform_speed": {"linear": 1.0, "angular": 1.0},
        "max_actuator_speed": [above(speed) for speed in speeds],
    }
    step = 0.1 * case.reach
    grid = [
        {"coordinate": c, "min": x - 3 * step, "max": x + 3 * step, "step": step}
        for c, x in zip(mechanism.motion.translations[:2], case.pose, strict=False)
    ]
    return Study(case, constructive, effective, grid)


@pytest.mark.parametrize("name", MOVING)
@FEW
@given(data=st.data())
def test_classes_are_nested_node_by_node(name: str, data: st.DataObject) -> None:
    study = studies(data, name)
    effective, constructive, theoretical = (
        arrays(study.request(**{"class": rank}))["inside"]
        for rank in ("effective", "constructive", "theoretical")
    )
    assert np.all(constructive[effective])
    assert np.all(theoretical[constructive])


def loosened(bounds: dict[str, Any], name: str, share: float) -> dict[str, Any]:
    """Return the bounds with one of them asking less by a share, within what is allowed."""
    factor = 1.0 - 0.9 * share if name.startswith("min_") else 1.0 + share
    most = math.pi if name.endswith("_angle") else 1e12
    value = bounds[name]
    if isinstance(value, list):
        return {**bounds, name: [min(most, factor * entry) for entry in value]}
    return {**bounds, name: max(1e-9, min(most, factor * value))}


@pytest.mark.parametrize("name", MOVING)
@FEW
@given(data=st.data())
def test_a_looser_bound_never_loses_a_node(name: str, data: st.DataObject) -> None:
    study = studies(data, name)
    share = data.draw(numbers(0.0, 1.0))
    strict = arrays(study.request())["inside"]
    for block in ("constructive", "effective"):
        bounds = getattr(study, block)
        for bound in bounds:
            if bound.startswith(("min_", "max_")):
                looser = study.request(**{block: loosened(bounds, bound, share)})
                assert np.all(arrays(looser)["inside"][strict]), bound


@pytest.mark.parametrize("name", MOVING)
@FEW
@given(data=st.data())
def test_bounds_together_keep_what_each_alone_keeps(name: str, data: st.DataObject) -> None:
    study = studies(data, name)
    reached = arrays(study.request(**{"class": "constructive"}))["inside"]
    alone = np.ones_like(reached)
    partners = {"max_effort": ["load"], "max_actuator_speed": ["platform_speed"]}
    for bound in EFFECTIVE_BOUNDS:
        chosen = [bound, *partners.get(bound, [])]
        one = study.request(effective={key: study.effective[key] for key in chosen})
        alone &= arrays(one)["inside"]
    np.testing.assert_array_equal(arrays(study.request())["inside"], reached & alone)


@pytest.mark.parametrize("name", MOVING)
@FEW
@given(data=st.data())
def test_what_is_kept_inside_meets_its_bounds(name: str, data: st.DataObject) -> None:
    study = studies(data, name)
    made = arrays(study.request())
    inside = made["inside"]
    bounds = study.effective
    assert np.all(made["condition_number"][inside] <= bounds["max_condition_number"])
    assert np.all(made["pressure_angle"][inside] <= bounds["max_pressure_angle"])
    assert np.all(np.abs(made["determinant"][inside]) >= bounds["min_abs_determinant"])
    for field in ("condition_number", "pressure_angle"):
        np.testing.assert_array_equal(np.isnan(made[field]), ~inside)


@pytest.mark.parametrize("name", MOVING)
@FEW
@given(data=st.data())
def test_every_node_outside_has_a_reason_that_is_listed(name: str, data: st.DataObject) -> None:
    study = studies(data, name)
    request = study.request()
    answer = json.loads(analyses.answer(request).model_dump_json())
    counts = np.bincount(arrays(request)["reason"].ravel(), minlength=256)
    listed = {entry["code"]: entry["nodes"] for entry in answer["excluded"]}
    assert all(listed.get(code, 0) == counts[code] for code in range(1, 256))
    whole = {entry["reason"] for entry in answer["excluded"] if entry["leg"] is None}
    assert whole == {"determinant", "condition_number"}
