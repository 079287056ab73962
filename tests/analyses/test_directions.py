"""Orientations told by two unit vectors, held against angles."""

import json
import math
from typing import Any

import numpy as np
import pytest

import analyses
from analyses.errors import AnalysisError
from schemas.analyses import parse_request
from schemas.starters import STARTERS
from tests.oracles.wrists import rotation

Document = dict[str, Any]
RIGHT_ANGLE = 0.5 * math.pi


def parsed(kind: str, **fields: Any) -> Any:  # noqa: ANN401
    mechanism = STARTERS[kind].model_dump(mode="json")
    body = {"analysis": "inverse_kinematics", "mechanism": mechanism, **fields}
    request = parse_request(json.dumps(body))
    analyses.check(request, 10**6)
    return request


def actuators(kind: str, **fields: Any) -> Any:  # noqa: ANN401
    found = analyses.answer(parsed(kind, **fields)).model_dump()["actuators"]
    return np.array(found, dtype=float)


def axes(pose: list[float]) -> list[list[float]]:
    """Return the platform's x and y axes."""
    columns: list[list[float]] = rotation(pose)[:, :2].T.tolist()
    return columns


@pytest.mark.parametrize("kind", ["geared_decoupled", "gough_stewart"])
def test_vectors_stand_for_angles(kind: str) -> None:
    random = np.random.default_rng(0)
    height = 0.5 if kind == "gough_stewart" else 0.0
    poses = random.uniform(-1.0, 1.0, (30, 6)) * [0.01, 0.01, 0.01, 3.0, 1.5, 3.0]
    poses[:, 2] += height
    expected = actuators(kind, poses=poses.tolist())
    points, pairs = poses[:, :3].tolist(), [axes(pose) for pose in poses.tolist()]
    found = actuators(kind, poses=points, directions=pairs)
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_a_spherical_platform_has_directions_alone() -> None:
    angles = [[0.2, -0.1, 1.9], [0.1, 0.3, 2.2]]
    pairs = [axes([0.0, 0.0, 0.0, *three]) for three in angles]
    expected = actuators("spherical_3rrr", poses=angles)
    found = actuators("spherical_3rrr", poses=[[], []], directions=pairs)
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_the_first_vector_says_where_the_tool_points() -> None:
    """As in the paper of 2022: rz is the angle of the tool's direction seen from above."""
    ahead = [0.48, 0.64, 0.6]
    level = [-0.8, 0.6, 0.0]
    found = actuators("geared_decoupled", poses=[[0.0] * 3], directions=[[ahead, level]])
    assert found[0][5] == pytest.approx(math.atan2(0.64, 0.48), abs=1e-15)


def test_upright_tools_have_an_orientation() -> None:
    """Where ry is a right angle only rx and rz together are told; the platform is the same."""
    pair = axes([0.0, 0.0, 0.0, 0.3, RIGHT_ANGLE, 0.5])
    found = actuators("geared_decoupled", poses=[[0.0] * 3], directions=[pair])
    k, both = 0.783, found[0][3:]
    ry = (both[1] - both[0]) / (2.0 * k)
    rx = (both[1] + both[0] - 2.8 * both[2]) / (2.0 * k)
    assert ry == pytest.approx(RIGHT_ANGLE, abs=1e-7)
    assert math.remainder(rx - both[2] - (0.3 - 0.5), 2.0 * math.pi) == pytest.approx(0, abs=1e-7)


@pytest.mark.parametrize(
    ("kind", "fields", "told"),
    [
        (
            "geared_decoupled",
            {"poses": [[0.0] * 3], "directions": [[[1.1, 0.0, 0.0], [0.0, 1.0, 0.0]]]},
            "/directions/0/0: must be a unit vector; its length is 1.1",
        ),
        (
            "geared_decoupled",
            {"poses": [[0.0] * 3], "directions": [[[1.0, 0.0, 0.0], [0.6, 0.8, 0.0]]]},
            "/directions/0/1: must be perpendicular to the other one; they are 53.1301 degrees",
        ),
        (
            "geared_decoupled",
            {"poses": [[0.0] * 3] * 2, "directions": [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]},
            "/directions: must have one pair per pose, that is 2; given 1",
        ),
        (
            "geared_decoupled",
            {"poses": [[0.0] * 6], "directions": [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]},
            "/poses/0: must have 3 numbers",
        ),
        (
            "planar_3rrr",
            {"poses": [[0.0] * 2], "directions": [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]},
            "/directions: the motion planar has no angles",
        ),
    ],
)
def test_what_is_no_orientation_is_named(kind: str, fields: Document, told: str) -> None:
    with pytest.raises(AnalysisError) as caught:
        parsed(kind, **fields)
    assert str(caught.value).startswith(told)
