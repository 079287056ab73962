"""Requests that make sense although they look odd, and ones that do not although they look well."""

import json
from typing import Any

import pytest

import analyses
from analyses import AnalysisError
from analyses.mechanisms import check_mechanism
from schemas.mechanisms import parse_spec

ORIGIN = [0.0, 0.0, 0.0]
PLANE = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]


def crank(rod: float, **other: Any) -> dict[str, Any]:  # noqa: ANN401
    return {
        "drive": "crank",
        "base_point": ORIGIN,
        "axis": PLANE[2],
        "zero_direction": PLANE[0],
        "crank_length": 0.2,
        "rod_length": rod,
        "platform_point": ORIGIN,
        **other,
    }


def custom(*legs: dict[str, Any]) -> str:
    return json.dumps({"kind": "custom", "motion": "planar_translation", "legs": legs})


def test_two_cranks_on_one_axis_are_two_legs() -> None:
    check_mechanism(parse_spec(custom(crank(0.3), crank(0.4))))


def test_a_leg_twice_is_refused() -> None:
    with pytest.raises(AnalysisError, match="leg 1: its joints coincide with those of leg 0"):
        check_mechanism(parse_spec(custom(crank(0.3), crank(0.3))))


@pytest.mark.parametrize(
    "leg",
    [
        crank(0.3, axis=PLANE[0], zero_direction=PLANE[1]),
        crank(0.3, base_point=[0.1, 0.0, 0.3]),
        {"drive": "strut", "base_point": [0.1, 0.0, 0.3], "platform_point": ORIGIN},
        {
            "drive": "rail",
            "base_point": [0.1, 0.0, 0.0],
            "direction": [0.0, 1.0, 0.1],
            "rod_length": 0.3,
            "platform_point": ORIGIN,
        },
    ],
)
def test_a_planar_leg_out_of_the_plane_is_refused(leg: dict[str, Any]) -> None:
    with pytest.raises(AnalysisError) as refused:
        check_mechanism(parse_spec(custom(crank(0.4), leg)))
    assert refused.value.errors[0][0] == "/mechanism/legs/1"


def effort(**other: Any) -> dict[str, Any]:  # noqa: ANN401
    bar = {"kind": "five_bar", "base_distance": 0.6, "crank_length": 0.5, "rod_length": 0.5}
    body = {"mass": 1.0, **other.pop("platform", {})}
    asked = {"analysis": "effort", "mechanism": bar, "poses": [[0.0, 0.9]], "platform": body}
    return asked | other


def test_a_turn_that_the_platform_lacks_is_refused() -> None:
    request = analyses.parse(json.dumps(effort(platform_rates=[[0, 0, 0, 0, 5, 0]])))
    with pytest.raises(AnalysisError) as refused:
        analyses.check(request, 10)
    assert refused.value.errors[0][0] == "/platform_rates/0/4"


@pytest.mark.parametrize(
    "inertia",
    [
        [[-1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[1, 5, 0], [0, 1, 0], [0, 0, 1]],
        [[1, 0, 0], [0, 1, 0], [0, 0, 3]],
    ],
)
def test_what_no_body_can_have_is_no_inertia(inertia: list[list[float]]) -> None:
    with pytest.raises(ValueError, match="principal moments"):
        analyses.parse(json.dumps(effort(platform={"inertia": inertia})))


def test_an_angle_that_no_leg_has_is_refused() -> None:
    delta = {
        "kind": "delta_linear",
        "rail_radius": 0.2,
        "platform_radius": 0.05,
        "rod_length": 0.35,
        "carriage_arm": 0.03,
        "tool_offset": 0.04,
    }
    request = analyses.parse(
        json.dumps(
            {
                "analysis": "workspace",
                "mechanism": delta,
                "class": "constructive",
                "type": "constant_orientation",
                "grid": [{"coordinate": "x", "min": 0.0, "max": 0.1, "step": 0.01}],
                "fixed": {"y": 0.0, "z": 0.1},
                "constructive": {"min_crank_rod_angle": 0.1},
            }
        )
    )
    with pytest.raises(AnalysisError) as refused:
        analyses.check(request, 100)
    assert refused.value.errors[0][0] == "/constructive/min_crank_rod_angle"
