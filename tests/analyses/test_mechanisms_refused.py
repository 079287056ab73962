"""Geometry and requests that make no sense: refused, with the reason and the leg."""

import json
import math
from typing import Any

import pytest
from pydantic import ValidationError

import analyses
from analyses.mechanisms import check_mechanism
from schemas.mechanisms import parse_spec

Document = dict[str, Any]


def hexagon(radius: float, spread: float) -> list[list[float]]:
    angles = [math.radians(a + s) for a in (90, 210, 330) for s in (-spread, spread)]
    return [[radius * math.cos(a), radius * math.sin(a), 0.0] for a in angles]


def strut(x: float, y: float, z: float = 0.0, scale: float = 0.4) -> Document:
    return {
        "drive": "strut",
        "base_point": [x, y, z],
        "platform_point": [scale * y, -scale * x, 0.1 * z],
    }


def crank(**changes: object) -> Document:
    return {
        "drive": "crank",
        "base_point": [0.3, 0.4, 0.0],
        "axis": [0.0, 0.0, 1.0],
        "zero_direction": [1.0, 0.0, 0.0],
        "crank_length": 0.5,
        "rod_length": 0.6,
        "platform_point": [0.1, 0.0, 0.0],
        **changes,
    }


def rail(**changes: object) -> Document:
    return {
        "drive": "rail",
        "base_point": [-0.6, 0.1, 0.0],
        "direction": [0.0, 1.0, 0.0],
        "rod_length": 0.6,
        "platform_point": [-0.1, 0.05, 0.0],
        **changes,
    }


def planar(*legs: Document, **more: object) -> Document:
    return {"kind": "custom", "motion": "planar", "legs": list(legs), **more}


SOUND = planar(crank(), rail(), strut(0.2, -0.7))
TRIANGLE = planar(strut(0.0, 0.5), strut(-0.4, -0.3), strut(0.5, -0.2))
HEXAPOD: Document = {
    "kind": "gough_stewart",
    "base_points": hexagon(0.5, 15.0),
    "platform_points": hexagon(0.3, 45.0),
}
ROTARY: Document = {
    "kind": "hexa_rotary",
    "base_points": hexagon(0.3, 15.0),
    "crank_axes": [[p[1], -p[0], 0.0] for p in hexagon(1.0, 15.0)],
    "crank_zero_directions": hexagon(1.0, 15.0),
    "crank_length": 0.15,
    "rod_length": 0.4,
    "platform_points": hexagon(0.12, 45.0),
}


def swap(document: Document, field: str, leg: int, value: object) -> Document:
    rows = list(document[field])
    rows[leg] = value
    return {**document, field: rows}


def reason(document: Document) -> str:
    """Return why a mechanism is refused."""
    with pytest.raises((analyses.AnalysisError, ValidationError)) as refused:
        check_mechanism(parse_spec(json.dumps(document)))
    error = refused.value
    if isinstance(error, analyses.AnalysisError):
        return "; ".join(f"{place} {detail}" for place, detail in error.errors)
    assert isinstance(error, ValidationError)
    return "; ".join(f"{e['loc']} {e['msg']}" for e in error.errors())


@pytest.mark.parametrize("document", [SOUND, TRIANGLE, HEXAPOD, ROTARY])
def test_sound_mechanisms_are_accepted(document: Document) -> None:
    check_mechanism(parse_spec(json.dumps(document)))


BAD: dict[str, tuple[Document, list[str]]] = {
    "coincident legs": (planar(crank(), strut(0.2, 0.3), strut(0.2, 0.3)), ["leg 2", "leg 1"]),
    "coincident struts of a hexapod": (
        swap(
            swap(HEXAPOD, "base_points", 4, HEXAPOD["base_points"][1]),
            "platform_points",
            4,
            HEXAPOD["platform_points"][1],
        ),
        ["leg 4", "leg 1"],
    ),
    "zero axis": (planar(rail(), crank(axis=[0.0] * 3), strut(0.2, 0.3)), ["axis", "leg"]),
    "zero direction of zero length": (
        planar(rail(), crank(zero_direction=[0.0] * 3), strut(0.2, 0.3)),
        ["zero", "leg"],
    ),
    "rail without direction": (
        planar(rail(direction=[0.0] * 3), crank(), strut(0.2, 0.3)),
        ["leg"],
    ),
    "axis of a hexapod's crank": (swap(ROTARY, "crank_axes", 3, [0.0] * 3), ["axis", "leg"]),
    "oblique axis": (
        planar(rail(), crank(zero_direction=[1.0, 0.0, 0.1]), strut(0.2, 0.3)),
        ["perpendicular", "leg"],
    ),
    "similar hexagons": (
        {**HEXAPOD, "platform_points": [[0.6 * n for n in p] for p in HEXAPOD["base_points"]]},
        ["singular"],
    ),
    "platform joints above one line": (
        {**HEXAPOD, "platform_points": [[0.1 * k, 0.0, 0.0] for k in range(6)]},
        ["singular"],
    ),
    "six legs in the plane": (
        planar(*[strut(0.1 * k, 0.3 - 0.2 * k) for k in range(6)]),
        ["3", "6"],
    ),
    "two legs in the plane": (planar(crank(), rail()), ["3", "2"]),
    "five legs in space": (
        {"kind": "custom", "motion": "spatial", "legs": [strut(0.1, k, 0.3 * k) for k in range(5)]},
        ["6", "5"],
    ),
    "schoenflies without axis": (
        {"kind": "custom", "motion": "schoenflies", "legs": [strut(k, k, 1.0) for k in range(4)]},
        ["axis"],
    ),
    "schoenflies about nothing": (
        {
            "kind": "custom",
            "motion": "schoenflies",
            "axis": [0.0] * 3,
            "legs": [strut(k, k * k, 1.0) for k in range(4)],
        },
        ["axis"],
    ),
    "axis of another motion": ({**SOUND, "axis": [0.0, 0.0, 1.0]}, ["axis"]),
    "minus sign of a strut": ({**SOUND, "working_mode": [1, 1, -1]}, ["strut"]),
    "minus signs of a hexapod": ({**HEXAPOD, "working_mode": [1, 1, 1, 1, 1, -1]}, ["strut"]),
    "rails above the platform's own joints": (
        {
            "kind": "delta_linear",
            "rail_radius": 0.25,
            "platform_radius": 0.25,
            "rod_length": 0.4,
            "carriage_arm": 0.0,
            "tool_offset": 0.0,
        },
        ["singular"],
    ),
}


@pytest.mark.parametrize(("document", "words"), BAD.values(), ids=BAD)
def test_bad_geometry_is_refused_with_the_reason(document: Document, words: list[str]) -> None:
    said = reason(document)
    for word in words:
        assert word in said


@pytest.mark.parametrize("lean", [0.5, 0.1, 1e-3])
def test_an_oblique_axis_is_told_by_how_much(lean: float) -> None:
    said = reason(planar(rail(), crank(zero_direction=[1.0, 0.0, math.tan(lean)]), strut(0.2, 0.3)))
    numbers = [
        float(part)
        for part in said.replace(",", " ").replace(";", " ").replace("(", " ").split()
        if part.replace(".", "", 1).replace("e-", "", 1).replace("-", "", 1).isdigit()
    ]
    degrees = math.degrees(lean)
    forms = [lean, math.sin(lean), degrees, 90 - degrees, 90 + degrees, math.pi / 2 - lean]
    assert any(math.isclose(n, f, rel_tol=0.02) for n in numbers for f in forms), said


@pytest.mark.parametrize("leg", [0, 1, 2])
def test_the_leg_is_named(leg: int) -> None:
    legs = [strut(0.0, 0.5), strut(-0.4, -0.3), strut(0.5, -0.2)]
    legs[leg] = crank(axis=[0.0] * 3)
    assert f"leg {leg}" in reason(planar(*legs))


def refused(document: Document) -> None:
    with pytest.raises((analyses.AnalysisError, ValidationError)):
        analyses.check(analyses.parse(json.dumps(document)), 10**6)


def poses(analysis: str, mechanism: Document = SOUND, **more: object) -> Document:
    rows = [[0.1, 0.1, 0.2], [0.0, 0.1, 0.1]]
    return {"analysis": analysis, "mechanism": mechanism, "poses": rows, **more}


STILL = [0.0] * 6
SENSELESS: dict[str, Document] = {
    "part that the motion lacks": poses(
        "velocity", platform_rates=[STILL, [0.0, 0.0, 0.0, 0.1, 0.0, 0.0]]
    ),
    "too few platform rates": poses("velocity", platform_rates=[STILL]),
    "too many platform rates": poses("velocity", platform_rates=[STILL] * 3),
    "too few drive rates": poses("velocity", actuator_rates=[[1.0, 1.0, 1.0]]),
    "narrow drive rates": poses("velocity", actuator_rates=[[1.0, 1.0]] * 2),
    "both rates": poses(
        "velocity", platform_rates=[STILL] * 2, actuator_rates=[[1.0, 1.0, 1.0]] * 2
    ),
    "no rates": poses("velocity"),
    "rates without a platform": poses("effort", load={"force": 1.0}, platform_rates=[STILL] * 2),
    "accelerations without a platform": poses(
        "effort", load={"force": 1.0}, platform_accelerations=[STILL] * 2
    ),
    "rows of the platform's rates": poses(
        "effort", platform={"mass": 1.0}, platform_rates=[STILL] * 3
    ),
    "rows of its accelerations": poses(
        "effort", platform={"mass": 1.0}, platform_accelerations=[STILL] * 3
    ),
    "negative mass": poses("effort", platform={"mass": -1.0}),
    "mode of a strut": poses("singularity", working_mode=[1, 1, -1]),
    "mode of a strut in inverse": poses("inverse_kinematics", working_mode=[1, 1, -1]),
    "narrow pose": {**poses("singularity"), "poses": [[0.1, 0.1]]},
    "one bound for newtons and newton metres": {
        "analysis": "workspace",
        "mechanism": SOUND,
        "class": "effective",
        "type": "constant_orientation",
        "grid": [
            {"coordinate": "x", "min": 0.0, "max": 0.2, "step": 0.1},
            {"coordinate": "y", "min": 0.0, "max": 0.2, "step": 0.1},
        ],
        "fixed": {"phi": 0.1},
        "effective": {"load": {"force": 1.0}, "max_effort": 5.0},
    },
}


@pytest.mark.parametrize("document", SENSELESS.values(), ids=SENSELESS)
def test_senseless_requests_are_refused(document: Document) -> None:
    refused(document)


def test_one_bound_per_drive_is_accepted() -> None:
    document = SENSELESS["one bound for newtons and newton metres"]
    effective = {"load": {"force": 1.0}, "max_effort": [5.0, 6.0, 7.0]}
    analyses.check(analyses.parse(json.dumps({**document, "effective": effective})), 10**6)
