"""What is refused by shape alone, and at which field."""

import json
import math
from typing import Any

import pytest
from pydantic import ValidationError

from schemas.analyses import parse_request

BAR: dict[str, Any] = {
    "kind": "five_bar",
    "base_distance": 6.0,
    "crank_length": 5.0,
    "rod_length": 4.0,
}
INVERSE: dict[str, Any] = {
    "analysis": "inverse_kinematics",
    "mechanism": BAR,
    "poses": [[0.0, 7.0]],
}
EFFORT: dict[str, Any] = {**INVERSE, "analysis": "effort", "load": {"force": 1.0}}
AXIS = {"coordinate": "x", "min": -1.0, "max": 1.0, "step": 0.5}
WORKSPACE: dict[str, Any] = {
    "analysis": "workspace",
    "mechanism": BAR,
    "class": "theoretical",
    "type": "constant_orientation",
    "grid": [AXIS, {**AXIS, "coordinate": "y"}],
}


def refusals(document: dict[str, Any]) -> set[tuple[int | str, ...]]:
    """Return where a request is refused; tags of unions left out."""
    with pytest.raises(ValidationError) as refused:
        parse_request(json.dumps(document))
    tags = {"inverse_kinematics", "effort", "workspace", "five_bar", "planar_3rrr", "stored"}
    return {
        tuple(part for part in error["loc"] if part not in tags) for error in refused.value.errors()
    }


def test_the_plain_requests_are_accepted() -> None:
    for document in (INVERSE, EFFORT, WORKSPACE):
        parse_request(json.dumps(document))


@pytest.mark.parametrize("field", ["base_distance", "crank_length", "rod_length"])
@pytest.mark.parametrize("length", [0, -1.0, math.nan, math.inf, -math.inf, 1e300, "long", None])
def test_lengths(field: str, length: object) -> None:
    document = {**INVERSE, "mechanism": {**BAR, field: length}}
    assert refusals(document) == {("mechanism", field)}


def test_a_length_left_out() -> None:
    short = {key: value for key, value in BAR.items() if key != "rod_length"}
    assert refusals({**INVERSE, "mechanism": short}) == {("mechanism", "rod_length")}


@pytest.mark.parametrize(
    ("mechanism", "field"),
    [
        ({"elbow": 1.0}, "elbow"),
        ({"working_mode": [1]}, "working_mode"),
        ({"working_mode": [1, 1, 1]}, "working_mode"),
        ({"actuator_limits": [None]}, "actuator_limits"),
        ({"actuator_limits": {"min": 1.0, "max": -1.0}}, "actuator_limits"),
        ({"actuator_limits": {"min": math.nan}}, "actuator_limits"),
    ],
)
def test_fields_of_a_mechanism(mechanism: dict[str, Any], field: str) -> None:
    found = refusals({**INVERSE, "mechanism": {**BAR, **mechanism}})
    assert {place[:2] for place in found} == {("mechanism", field)}


@pytest.mark.parametrize("sign", [0, 2, 1.5, "1"])
def test_signs_of_a_working_mode(sign: object) -> None:
    found = refusals({**INVERSE, "mechanism": {**BAR, "working_mode": [sign, 1]}})
    assert found == {("mechanism", "working_mode", 0)}


def test_an_unknown_kind() -> None:
    assert refusals({**INVERSE, "mechanism": {**BAR, "kind": "hexapod"}}) == {("mechanism",)}


def test_an_unknown_analysis() -> None:
    assert refusals({**INVERSE, "analysis": "horoscope"}) == {()}


@pytest.mark.parametrize("value", [math.nan, math.inf, 1e300, "left", None])
def test_numbers_of_a_pose(value: object) -> None:
    assert refusals({**INVERSE, "poses": [[0.0, value]]}) == {("poses", 0, 1)}


def test_no_poses() -> None:
    assert refusals({**INVERSE, "poses": []}) == {("poses",)}


@pytest.mark.parametrize("part", ["force", "moment"])
@pytest.mark.parametrize("size", [-1.0, math.nan, math.inf])
def test_sizes_of_a_load(part: str, size: float) -> None:
    assert refusals({**EFFORT, "load": {part: size}}) == {("load", part)}


def test_an_effort_without_any_load() -> None:
    document = {key: value for key, value in EFFORT.items() if key != "load"}
    assert refusals(document) == {()}


@pytest.mark.parametrize("vector", [[1.0, 2.0], [1.0, 2.0, 3.0, 4.0], [1.0, 2.0, math.nan], []])
def test_a_known_force_has_three_numbers(vector: list[float]) -> None:
    found = refusals({**EFFORT, "known_load": {"force": vector}})
    assert {place[:2] for place in found} == {("known_load", "force")}


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"step": 0}, "step"),
        ({"step": -0.1}, "step"),
        ({"step": math.nan}, "step"),
        ({"step": 1e-60}, "step"),
        ({"step": 5e-324}, "step"),
        ({"min": 2.0}, "max"),
        ({"max": math.inf}, "max"),
        ({"min": math.nan}, "min"),
        ({"start": 0.0}, "start"),
    ],
)
def test_axes(change: dict[str, Any], field: str) -> None:
    found = refusals({**WORKSPACE, "grid": [{**AXIS, **change}]})
    assert {place[:3] for place in found} == {("grid", 0, field)}


def test_a_grid_without_axes() -> None:
    assert refusals({**WORKSPACE, "grid": []}) == {("grid",)}


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"class": "practical"}, ("class",)),
        ({"type": "upside_down"}, ("type",)),
        ({"fields": ["colour"]}, ("fields", 0)),
        ({"fixed": {"phi": math.nan}}, ("fixed", "phi")),
        ({"colour": "red"}, ("colour",)),
        ({"constructive": {"min_crank_rod_angle": -0.1}}, ("constructive", "min_crank_rod_angle")),
        ({"constructive": {"max_rod_rod_angle": 3.2}}, ("constructive", "max_rod_rod_angle")),
        (
            {"constructive": {"min_crank_rod_angle": 1.0, "max_crank_rod_angle": 0.5}},
            ("constructive", "max_crank_rod_angle"),
        ),
        (
            {"constructive": {"min_rod_rod_angle": 1.0, "max_rod_rod_angle": 0.5}},
            ("constructive", "max_rod_rod_angle"),
        ),
        ({"effective": {"max_effort": 1.0}}, ("effective", "max_effort")),
        ({"effective": {"load": {"force": -1.0}}}, ("effective", "load", "force")),
    ],
)
def test_workspaces(change: dict[str, Any], place: tuple[str, ...]) -> None:
    assert {found[: len(place)] for found in refusals({**WORKSPACE, **change})} == {place}


def test_fields_asked_twice_are_kept_once() -> None:
    twice = {**WORKSPACE, "fields": ["determinant", "actuators", "determinant"]}
    assert parse_request(json.dumps(twice)).model_dump()["fields"] == ["actuators", "determinant"]
