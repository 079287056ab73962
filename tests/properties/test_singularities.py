"""Singularities of several kinds, made exactly; pressure angles and condition by definition."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.singularity import singularities
from tests.oracles import legs
from tests.oracles.legs import Floats
from tests.properties.mechanisms import (
    FEW,
    NAMES,
    Case,
    ask,
    numbers,
    well_held_cases,
)

EVERY = pytest.mark.parametrize("name", NAMES)


def hexagon(radius: float, spread: float) -> list[list[float]]:
    angles = [math.radians(a + s) for a in (90, 210, 330) for s in (-spread, spread)]
    return [[radius * math.cos(a), radius * math.sin(a), 0.0] for a in angles]


def bar(base: float, crank: float, rod: float, *pose: float, mode: tuple[int, int]) -> Case:
    document = {
        "kind": "five_bar",
        "base_distance": base,
        "crank_length": crank,
        "rod_length": rod,
        "working_mode": list(mode),
    }
    return Case(document, pose)


def triangle(sign: int) -> Case:
    """Rods along the spokes: elbows at (-3, 0) and so on, 5 from (0, 4), rods from 3 to 1."""
    document = {
        "kind": "planar_3rrr",
        "base_side": 4.0 * math.sqrt(3.0),
        "platform_radius": 1.0,
        "crank_length": 5.0,
        "rod_length": 2.0,
        "working_mode": [-sign] * 3,
    }
    return Case(document, (0.0, 0.0, sign * math.pi / 2))


def platform(yaw: float, height: float) -> Case:
    document = {
        "kind": "gough_stewart",
        "base_points": hexagon(0.5, 15.0),
        "platform_points": hexagon(0.3, 45.0),
    }
    return Case(document, (0.0, 0.0, height, 0.0, 0.0, yaw))


def upright_delta(crank: float = 0.3, rod: float = 0.7, *, platform_radius: float = 0.5) -> Case:
    """Cranks level and outward, so that knees stand above the platform's joints."""
    document = {
        "kind": "delta_rotary",
        "base_radius": 0.2,
        "platform_radius": platform_radius,
        "crank_length": crank,
        "rod_length": rod,
    }
    return Case(document, (0.0, 0.0, -rod))


TYPE_1 = {
    "five-bar stretched": bar(6.0, 2.0, 3.0, 1.0, 3.0, mode=(1, -1)),
    "five-bar folded": bar(6.0, 8.0, 3.0, -7.0, 3.0, mode=(1, -1)),
}
TYPE_2 = {
    "five-bar, rods in line": bar(6.0, 5.0, 6.0, 0.0, 4.0, mode=(1, -1)),
    "five-bar, rods together": bar(6.0, 3.0, 4.0, 0.0, 4.0, mode=(-1, 1)),
    "3-RRR, rods through one point": triangle(1),
    "3-RRR, mirrored": triangle(-1),
    "hexapod, 90 degrees": platform(math.pi / 2, 0.6),
    "hexapod, -90 degrees": platform(-math.pi / 2, 0.4),
    "delta, rods upright": upright_delta(),
}
TYPE_3 = {
    "five-bar, all in one line": bar(6.0, 2.0, 1.0, 0.0, 0.0, mode=(1, -1)),
}
SINGULAR = {**TYPE_1, **TYPE_2, **TYPE_3}
TYPES = {
    **{name: (case, 1) for name, case in TYPE_1.items()},
    **{name: (case, 2) for name, case in TYPE_2.items()},
    **{name: (case, 3) for name, case in TYPE_3.items()},
}
LOOSE = {**TYPE_2, **TYPE_3}


@pytest.mark.parametrize(("case", "number"), TYPES.values(), ids=TYPES)
def test_types_are_recognised(case: Case, number: int) -> None:
    assert ask(case.request("singularity"))["type"] == [number]


@pytest.mark.parametrize("case", LOOSE.values(), ids=LOOSE)
def test_free_motions_are_unit_null_twists(case: Case) -> None:
    answer = ask(case.request("singularity"))
    (free,) = answer["free_motion"]
    rows, _ = legs.leg_rows(case.machine, case.row, case.actuators)
    twist = np.array(free)
    moved = case.twists.T @ twist
    assert np.abs(rows @ moved).max() < 1e-9 * max(1.0, np.abs(moved).max())
    np.testing.assert_allclose(case.twists @ moved, twist, atol=1e-12)
    length = answer["characteristic_length"]
    size = math.hypot(*twist[:3], *(length * twist[3:]))
    assert size == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("case", LOOSE.values(), ids=LOOSE)
def test_no_condition_number_where_the_platform_is_loose(case: Case) -> None:
    assert ask(case.request("singularity"))["condition_number"] == [None]


@pytest.mark.parametrize("case", LOOSE.values(), ids=LOOSE)
def test_no_effort_where_the_platform_is_loose(case: Case) -> None:
    effort = ask(case.request("effort", load={"force": 1.0, "moment": 1.0}))
    assert effort["effort"] == [[None] * len(case.pose)]


@pytest.mark.parametrize("case", LOOSE.values(), ids=LOOSE)
def test_no_platform_rates_where_the_platform_is_loose(case: Case) -> None:
    rates = ask(case.request("velocity", actuator_rates=[[0.1] * len(case.pose)]))
    assert rates["platform_rates"] == [None]
    assert "singularity" in {obstacle["reason"] for obstacle in rates["obstacles"]}


@pytest.mark.parametrize("case", TYPE_2.values(), ids=TYPE_2)
def test_pressure_angles_are_right_where_the_platform_is_loose(case: Case) -> None:
    """Where the joint moves along with the free motion at all."""
    answer = ask(case.request("singularity"))
    twist = np.array(answer["free_motion"][0])
    pairs = zip(answer["pressure_angles"][0], legs.arms(case.machine, case.row), strict=True)
    for angle, arm in pairs:
        if np.linalg.norm(twist[:3] + np.cross(twist[3:], arm)) > 1e-6:
            assert angle == pytest.approx(math.pi / 2, abs=1e-7)


def test_free_motion_of_the_hexapod_is_a_screw_about_its_axis() -> None:
    (free,) = ask(platform(math.pi / 2, 0.6).request("singularity"))["free_motion"]
    assert free[0] == pytest.approx(0.0, abs=1e-12)
    assert [free[1], free[3], free[4]] == pytest.approx([0.0] * 3, abs=1e-12)
    assert abs(free[2]) > 0.01
    assert abs(free[5]) > 0.01


def test_the_hexapod_is_regular_before_it_has_turned() -> None:
    assert ask(platform(0.3, 0.6).request("singularity"))["type"] == [0]


def agile_eye(*pose: float) -> Case:
    cone = math.acos(1 / math.sqrt(3.0))
    document = {
        "kind": "spherical_3rrr",
        "proximal_arc": math.pi / 2,
        "distal_arc": math.pi / 2,
        "base_cone": cone,
        "platform_cone": cone,
    }
    return Case(document, pose)


@pytest.mark.parametrize("spin", [2 * math.pi / 3, -2 * math.pi / 3])
def test_the_agile_eye_is_isotropic_at_home(spin: float) -> None:
    answer = ask(agile_eye(0.0, 0.0, spin).request("singularity"))
    assert answer["type"] == [0]
    assert abs(answer["determinant"][0]) == pytest.approx(1.0, rel=1e-12)
    assert answer["condition_number"][0] == pytest.approx(1.0, rel=1e-12)
    assert answer["pressure_angles"][0] == pytest.approx([0.0] * 3, abs=1e-7)


@pytest.mark.parametrize("pose", [(0.0, 0.0, 0.0), (math.pi, 0.0, 0.0), (0.0, 0.0, math.pi)])
@pytest.mark.parametrize(
    ("analysis", "more"),
    [
        ("inverse_kinematics", {}),
        ("inverse_kinematics", {"working_mode": "all"}),
        ("singularity", {}),
        ("effort", {"load": {"force": 1.0, "moment": 1.0}}),
        ("velocity", {"platform_rates": [[0.0, 0.0, 0.0, 1.0, 2.0, 3.0]]}),
        ("velocity", {"actuator_rates": [[1.0, 2.0, 3.0]]}),
    ],
)
def test_the_agile_eye_answers_where_it_is_undetermined(
    pose: tuple[float, ...], analysis: str, more: dict[str, object]
) -> None:
    ask(agile_eye(*pose).request(analysis, **more))


def measured(case: Case) -> tuple[float, Floats]:
    """Return condition number and pressure angles by their definitions."""
    rows, _ = legs.leg_rows(case.machine, case.row, case.actuators)
    ends = legs.joints(case.machine, case.row)
    arms = legs.arms(case.machine, case.row)
    angles = []
    for number, leg in enumerate(case.machine.legs):
        braked = np.delete(legs.at_size(case.machine, rows), number, axis=0)
        move = np.linalg.svd(braked)[2][-1]
        move[len(move) - case.machine.turns :] /= case.machine.size
        twist = case.twists @ move
        speed = twist[:3] + np.cross(twist[3:], arms[number])
        force = legs.rod(leg, ends[number], float(case.actuators[number]))
        across = float(np.linalg.norm(np.cross(speed, force)))
        angles.append(math.atan2(across, abs(float(speed @ force))))
    return legs.spread(case.machine, case.row, case.actuators), np.array(angles)


@EVERY
@FEW
@given(data=st.data())
def test_closeness_is_as_defined(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    condition, angles = measured(case)
    found = singularities(case.block)
    assert found.type[0] == 0
    assert found.condition_number[0] == pytest.approx(condition, rel=1e-9)
    np.testing.assert_allclose(found.pressure_angles[:, 0], angles, atol=1e-7)
    assert np.isnan(found.free_motion).all()


@EVERY
@FEW
@given(data=st.data())
def test_the_wire_speaks_of_the_same_singularity(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    found, answer = singularities(case.block), ask(case.request("singularity"))
    assert answer["determinant"] == pytest.approx(list(found.determinant))
    assert answer["condition_number"] == pytest.approx(list(found.condition_number))
    assert answer["pressure_angles"][0] == pytest.approx(list(found.pressure_angles[:, 0]))
    if case.machine.turns:
        assert answer["characteristic_length"] == pytest.approx(case.machine.size, rel=1e-12)


FAR = [0.0, 1e-300, 1e-9, 1.0, -1e3, 1e12, -1e12]


@EVERY
@FEW
@given(data=st.data())
def test_whatever_the_pose_the_wire_carries_numbers_or_null(name: str, data: st.DataObject) -> None:
    """`ask` refuses NaN and inf; rows have their widths whatever happens in them."""
    case = well_held_cases(data, name)
    count = len(case.pose)
    turns = case.machine.turns
    rows = [
        [*data.draw(st.lists(st.sampled_from(FAR), min_size=count, max_size=count))]
        for _ in range(4)
    ]
    nearby = data.draw(st.lists(numbers(-1.5, 1.5), min_size=count, max_size=count))
    point = [float(n) for n in case.machine.legs[0].base][: count - turns] + [0.0] * turns
    poses = [*rows, nearby, point, list(case.pose), [0.0] * count, [1e12] * count]
    twist = [float(number) for number in case.twists.sum(axis=1)]
    requests: list[tuple[str, dict[str, object]]] = [
        ("inverse_kinematics", {"working_mode": "all"}),
        ("inverse_kinematics", {}),
        ("singularity", {}),
        ("effort", {"load": {"force": 1.0, "moment": 1.0}}),
        ("effort", {"known_load": {"force": [1.0, 2.0, 3.0]}, "platform": {"mass": 1.0}}),
        ("velocity", {"platform_rates": [twist] * len(poses)}),
        ("velocity", {"actuator_rates": [[1.0] * count] * len(poses)}),
    ]
    for analysis, more in requests:
        answer = ask({**case.request(analysis, **more), "poses": poses})
        for key in ("effort", "actuators", "pressure_angles", "actuator_rates"):
            if key in answer and more.get("working_mode") != "all":
                assert [len(row) for row in answer[key]] == [count] * len(poses)


@pytest.mark.parametrize("case", SINGULAR.values(), ids=SINGULAR)
def test_singular_poses_answer_everything(case: Case) -> None:
    count = len(case.pose)
    twist = [float(number) for number in case.twists.sum(axis=1)]
    for analysis, more in (
        ("inverse_kinematics", {"working_mode": "all"}),
        ("effort", {"load": {"force": 1.0}, "platform": {"mass": 3.0}}),
        ("velocity", {"platform_rates": [twist]}),
        ("velocity", {"actuator_rates": [[1.0] * count]}),
    ):
        ask(case.request(analysis, **more))


@pytest.mark.parametrize("case", TYPE_1.values(), ids=TYPE_1)
def test_a_stretched_or_folded_leg_asks_no_effort(case: Case) -> None:
    effort = ask(case.request("effort", load={"force": 10.0}))["effort"][0]
    assert effort[0] == pytest.approx(0.0, abs=1e-12)
    assert effort[1] > 0


@pytest.mark.parametrize("case", TYPE_1.values(), ids=TYPE_1)
def test_a_stretched_or_folded_leg_has_no_rate(case: Case) -> None:
    twist = [0.3, 0.7, 0.0, 0.0, 0.0, 0.0]
    answer = ask(case.request("velocity", platform_rates=[twist]))
    assert answer["actuator_rates"][0][0] is None
    assert [(o["pose"], o["leg"], o["reason"]) for o in answer["obstacles"]] == [
        (0, 0, "singularity")
    ]
