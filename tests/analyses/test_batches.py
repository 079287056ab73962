"""A hundred thousand poses in one request."""

import json
from typing import Any

import numpy as np
import pytest

import analyses
from tests.analyses.test_mechanisms_refused import HEXAPOD

COUNT = 100_000
RANDOM = np.random.default_rng(7)
POSES = (
    RANDOM.uniform(-1, 1, (COUNT, 6)) * [0.1, 0.1, 0.1, 0.3, 0.3, 0.3] + [0, 0, 0.5, 0, 0, 0]
).tolist()


@pytest.mark.parametrize(
    ("analysis", "more", "columns"),
    [
        ("inverse_kinematics", {}, {"actuators": 6}),
        ("velocity", {"actuator_rates": [[0.1] * 6] * COUNT}, {"platform_rates": 6}),
        ("effort", {"load": {"force": 1.0, "moment": 0.1}}, {"effort": 6, "worst_force": 6}),
        ("singularity", {}, {"pressure_angles": 6}),
    ],
)
def test_many_poses_are_one_answer(
    analysis: str, more: dict[str, Any], columns: dict[str, int]
) -> None:
    body = {"analysis": analysis, "mechanism": HEXAPOD, "poses": POSES, **more}
    request = analyses.parse(json.dumps(body))
    analyses.check(request, 10**6)
    answer = analyses.answer(request)
    for name, width in columns.items():
        rows = getattr(answer, name)
        assert len(rows) == COUNT
        assert {len(row) for row in rows} == {width}


def test_a_pose_among_many_is_as_if_alone() -> None:
    body = {"analysis": "effort", "mechanism": HEXAPOD, "load": {"force": 1.0, "moment": 0.1}}
    many = analyses.answer(analyses.parse(json.dumps({**body, "poses": POSES[:1000]})))
    alone = analyses.answer(analyses.parse(json.dumps({**body, "poses": [POSES[333]]})))
    row = many.model_dump()["effort"][333]
    assert row == pytest.approx(alone.model_dump()["effort"][0], rel=1e-13)
