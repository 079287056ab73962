"""Singular poses, made exactly: finite at type 1, none at type 2, no NaN or inf on the wire."""

import json
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import analyses
from tests.oracles import planar
from tests.properties.samples import MODEST, Sample, numbers, samples

# With r = 2, L = 3 and A1 = (-3, 0) the pose A1 + (4, 3) is r + L = 5 away: leg 0 is stretched.
STRETCHED = Sample(6.0, None, 2.0, 3.0, (1, -1), (1.0, 3.0))
# With r = 8, L = 3 the pose A1 + (-4, 3) is r - L away: leg 0 is folded.
FOLDED = Sample(6.0, None, 8.0, 3.0, (1, -1), (-7.0, 3.0))
# Elbows (-6, 4) and (6, 4), platform (0, 4): both rods, 6 long, lie in one line.
RODS_IN_LINE = Sample(6.0, None, 5.0, 6.0, (1, -1), (0.0, 4.0))
# Both elbows at (0, 0), cranks along the base line: the rods lie upon each other.
RODS_TOGETHER = Sample(6.0, None, 3.0, 4.0, (-1, 1), (0.0, 4.0))
# Both elbows at (0, 4) likewise, but sqrt(58) away from the base joints nothing is a fraction.
RODS_TOGETHER_WITH_ROOTS = Sample(6.0, None, 5.0, 3.0, (-1, 1), (0.0, 7.0))


def refuse(constant: str) -> None:
    raise AssertionError(f"{constant} on the wire")


def effort(sample: Sample, **more: object) -> dict[str, Any]:
    """Return the answer to an effort request, read back from strict JSON."""
    body = {
        "analysis": "effort",
        "mechanism": sample.wire,
        "poses": [list(sample.pose)],
        "load": {"force": 10.0, "moment": 1.0},
        **more,
    }
    request = analyses.parse(json.dumps(body))
    analyses.check(request, 10**6)
    text = analyses.answer(request).model_dump_json()
    answer: dict[str, Any] = json.loads(text, parse_constant=refuse)
    return answer


@pytest.mark.parametrize("sample", [STRETCHED, FOLDED], ids=["stretched", "folded"])
def test_a_leg_in_line_with_its_crank_asks_no_torque(sample: Sample) -> None:
    # The rod's force goes through the drive's axis, so it has no moment about it.
    assert effort(sample)["effort"][0][0] == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("sample", [STRETCHED, FOLDED], ids=["stretched", "folded"])
def test_the_other_leg_bears_its_share(sample: Sample) -> None:
    away = planar.joints(sample.oracle, sample.row)[0, 0] - sample.oracle.base[0]
    along = away / np.linalg.norm(away)
    second = planar.elbows(sample.oracle, sample.row)[0, 1]
    rod = (sample.row[0] - second) / sample.rod
    # Across the first rod only the second one can push.
    push = 10.0 / abs(planar.cross(along, rod))
    lever = abs(planar.cross(second - sample.oracle.base[1], rod))
    assert effort(sample)["effort"][0][1] == pytest.approx(push * lever, rel=1e-12)


@pytest.mark.parametrize("sample", [STRETCHED, FOLDED], ids=["stretched", "folded"])
def test_a_type_1_pose_is_reachable(sample: Sample) -> None:
    assert effort(sample)["obstacles"] == []


@pytest.mark.parametrize("sample", [RODS_IN_LINE, RODS_TOGETHER], ids=["in line", "together"])
def test_there_is_no_effort_at_type_2(sample: Sample) -> None:
    assert effort(sample)["effort"] == [[None, None]]


@pytest.mark.parametrize("sample", [RODS_IN_LINE, RODS_TOGETHER], ids=["in line", "together"])
def test_type_2_is_named(sample: Sample) -> None:
    obstacles = effort(sample)["obstacles"]
    assert [(o["pose"], o["leg"], o["reason"]) for o in obstacles] == [(0, None, "singularity")]


@pytest.mark.parametrize("sample", [RODS_IN_LINE, RODS_TOGETHER], ids=["in line", "together"])
def test_there_is_no_signed_effort_at_type_2(sample: Sample) -> None:
    answer = effort(sample, load=None, known_load={"force": [1.0, 2.0, 0.0]})
    assert answer["effort"] == [[None, None]]


def test_type_2_is_recognised_through_rounding() -> None:
    assert effort(RODS_TOGETHER_WITH_ROOTS)["effort"] == [[None, None]]


def test_there_is_no_effort_out_of_reach() -> None:
    out = Sample(6.0, None, 2.0, 3.0, (1, -1), (40.0, 0.0))
    answer = effort(out)
    assert answer["effort"] == [[None, None]]
    assert [o["leg"] for o in answer["obstacles"]] == [0, 1]


def test_one_leg_out_of_reach_leaves_no_effort_of_the_other() -> None:
    # A2 = (3, 0) is 4.5 away, A1 10.5.
    out = Sample(6.0, None, 2.0, 3.0, (1, -1), (7.5, 0.0))
    answer = effort(out)
    assert answer["effort"] == [[None, None]]
    assert [o["leg"] for o in answer["obstacles"]] == [0]


def test_only_the_cell_of_a_leg_out_of_reach_is_null() -> None:
    out = Sample(6.0, None, 2.0, 3.0, (1, -1), (7.5, 0.0))
    body = {"analysis": "inverse_kinematics", "mechanism": out.wire, "poses": [[7.5, 0.0]]}
    answer = analyses.answer(analyses.parse(json.dumps(body))).model_dump()
    first, second = answer["actuators"][0]
    assert first is None
    assert second == pytest.approx(float(planar.crank_angles(out.oracle, out.row)[0, 1]))


@MODEST
@given(
    samples(),
    st.lists(st.tuples(*[numbers(-3.0, 3.0)] * 3), min_size=1, max_size=5),
)
def test_whatever_the_pose_the_wire_carries_numbers_or_null(
    sample: Sample, poses: list[tuple[float, ...]]
) -> None:
    joints = [tuple(point) for point in sample.oracle.base]
    turn = (0.0,) if sample.radius is not None else ()
    rows = [list(pose[: len(sample.pose)]) for pose in poses] + [[*p, *turn] for p in joints]
    for row in effort(sample, poses=rows)["effort"]:
        assert all(value is None for value in row) or all(math.isfinite(v) for v in row)


@pytest.mark.parametrize("offset", [0.0, 1e-300, 1e-200, 1e-17, 1e-9])
def test_near_type_2_the_wire_carries_numbers_or_null(offset: float) -> None:
    x, y = RODS_IN_LINE.pose
    answer = effort(RODS_IN_LINE, poses=[[x, y + offset], [x + offset, y]])
    for row in answer["effort"]:
        assert all(value is None or math.isfinite(value) for value in row)


def test_a_platform_joint_on_its_base_joint_is_out_of_reach() -> None:
    on_base = Sample(6.0, None, 2.0, 3.0, (1, -1), (-3.0, 0.0))
    assert effort(on_base)["effort"] == [[None, None]]


def test_a_platform_joint_on_its_base_joint_with_equal_links_is_no_number() -> None:
    # P = Q = S = 0: every crank angle solves the leg equation, the leg is folded.
    on_base = Sample(6.0, None, 5.0, 5.0, (1, -1), (-3.0, 0.0))
    for value in effort(on_base)["effort"][0]:
        assert value is None or math.isfinite(value)
