"""Unions over working modes, against every mode by itself."""

import json
from typing import Any

import numpy as np
import pytest

import analyses
from analyses.mechanisms import build
from schemas.analyses import parse_request
from schemas.mechanisms import parse_spec
from tests.oracles.draws import DRAWS

NAMES = ["five_bar", "planar_3rrr", "delta_rotary", "hexa_linear"]


def document(name: str) -> dict[str, Any]:
    draw = DRAWS[name](np.random.default_rng(4))
    mechanism = build(parse_spec(json.dumps(draw.wire, default=float)))
    names = mechanism.motion.coordinates
    axes = [
        {"coordinate": c, "min": low, "max": high, "step": (high - low) / 12.5}
        for c, low, high in zip(names[:2], draw.least, draw.most, strict=False)
    ]
    middle = 0.5 * (draw.least + draw.most)
    fixed = {c: float(middle[k]) for k, c in enumerate(names) if k > 1}
    effective = {"load": {"force": 1.0, "moment": 0.1}, "max_effort": [0.9] * mechanism.leg_count}
    limits = [{"min": -1.0, "max": 1.2}] * mechanism.leg_count
    return {
        "analysis": "workspace",
        "mechanism": draw.wire | {"actuator_limits": limits},
        "class": "effective",
        "type": "constant_orientation",
        "grid": axes,
        "fixed": fixed,
        "effective": effective,
        "fields": ["effort", "determinant"],
    }


def computed(body: dict[str, Any]) -> dict[str, Any]:
    request = parse_request(json.dumps(body, default=float))
    analyses.check(request, 10**6)
    return analyses.compute(request, 0, analyses.plan(request, 1.0).items)


@pytest.mark.parametrize("name", NAMES)
def test_any_mode_is_the_union_of_all(name: str) -> None:
    body = document(name)
    modes = build(parse_spec(json.dumps(body["mechanism"], default=float))).working_modes
    found = computed(body | {"working_mode": "any"})
    inside = np.repeat(found["codes"], found["lengths"]) == 0
    expected = np.zeros(inside.size, bool)
    efforts = np.full((inside.size, len(modes[0])), np.nan)
    for mode in modes:
        one = computed(body | {"working_mode": mode})
        own = np.repeat(one["codes"], one["lengths"]) == 0
        new = own & ~expected
        efforts[new] = one["field_effort"][new[own]]
        expected |= own
    assert 0 < inside.sum() < inside.size
    assert np.array_equal(inside, expected)
    assert np.array_equal(found["field_effort"], efforts[inside])


def test_types_of_many_orientations_have_their_union_too() -> None:
    body = document("planar_3rrr") | {"type": "maximal", "fixed": {}, "fields": []}
    modes = build(parse_spec(json.dumps(body["mechanism"], default=float))).working_modes
    codes = [computed(body | {"working_mode": mode}) for mode in [*modes, "any"]]
    inside = [np.repeat(one["codes"], one["lengths"]) == 0 for one in codes]
    assert np.array_equal(np.any(inside[:-1], axis=0), inside[-1])
    assert any(np.any(inside[-1] & ~one) for one in inside[:-1])


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"component": "home", "home": [0.0, 0.0, 0.0]}, "/working_mode"),
        ({"class": "theoretical", "method": "geometric"}, "/working_mode"),
    ],
)
def test_what_needs_one_mode_says_so(changes: dict[str, Any], place: str) -> None:
    body = document("planar_3rrr") | {"working_mode": "any", "fields": []} | changes
    with pytest.raises(analyses.AnalysisError) as error:
        computed(body)
    assert place in [pointer for pointer, _ in error.value.errors]


def test_the_result_tells_the_mode() -> None:
    request = parse_request(json.dumps(document("five_bar") | {"working_mode": "any"}))
    assert analyses.answer(request).model_dump()["working_mode"] == "any"
