"""One geometry, one canonical form, one id, however it is spelled."""

import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from schemas.mechanisms import canonical_json, mechanism_id, parse_spec

BAR: dict[str, Any] = {
    "kind": "five_bar",
    "base_distance": 6.0,
    "crank_length": 5.0,
    "rod_length": 4.0,
}
TRIANGLE: dict[str, Any] = {
    "kind": "planar_3rrr",
    "base_side": 0.4,
    "platform_radius": 0.08,
    "crank_length": 0.18,
    "rod_length": 0.18,
}
LIMIT = {"min": -1.0, "max": 2.0}


def identify(document: dict[str, Any]) -> str:
    return mechanism_id(parse_spec(json.dumps(document)))


SPELLINGS: dict[str, dict[str, Any]] = {
    "whole numbers": {"base_distance": 6, "crank_length": 5, "rod_length": 4},
    "default mode written out": {"working_mode": [1, -1]},
    "null mode": {"working_mode": None},
    "null limits": {"actuator_limits": None},
    "a null limit per leg": {"actuator_limits": [None, None]},
    "an empty limit": {"actuator_limits": {}},
    "unbounded limits": {"actuator_limits": [{"min": None, "max": None}, {}]},
    "null name": {"name": None},
}


@pytest.mark.parametrize("spelling", SPELLINGS.values(), ids=SPELLINGS.keys())
def test_another_spelling_has_the_same_id(spelling: dict[str, Any]) -> None:
    assert identify({**BAR, **spelling}) == identify(BAR)


def test_the_order_of_fields_does_not_matter() -> None:
    assert identify(dict(reversed(BAR.items()))) == identify(BAR)


def test_exponents_do_not_matter() -> None:
    text = json.dumps(BAR).replace("6.0", "60e-1")
    assert mechanism_id(parse_spec(text)) == identify(BAR)


def test_one_limit_for_all_is_one_for_each() -> None:
    each = identify({**BAR, "actuator_limits": [LIMIT, LIMIT]})
    assert identify({**BAR, "actuator_limits": LIMIT}) == each


def test_a_limit_of_minus_zero_is_one_of_zero() -> None:
    below = identify({**BAR, "actuator_limits": {"min": -0.0, "max": 1.0}})
    assert below == identify({**BAR, "actuator_limits": {"min": 0.0, "max": 1.0}})


DIFFERENCES: dict[str, dict[str, Any]] = {
    "base": {"base_distance": 6.000000000000001},
    "crank": {"crank_length": 5.000000000000001},
    "rod": {"rod_length": 4.000000000000001},
    "mode": {"working_mode": [-1, 1]},
    "limits": {"actuator_limits": LIMIT},
    "limit of one leg": {"actuator_limits": [LIMIT, None]},
    "limit of the other leg": {"actuator_limits": [None, LIMIT]},
    "one end of a limit": {"actuator_limits": {"min": -1.0}},
}


@pytest.mark.parametrize("difference", DIFFERENCES.values(), ids=DIFFERENCES.keys())
def test_another_geometry_has_another_id(difference: dict[str, Any]) -> None:
    assert identify({**BAR, **difference}) != identify(BAR)


def test_all_differences_differ_from_each_other() -> None:
    ids = {identify({**BAR, **difference}) for difference in DIFFERENCES.values()}
    assert len(ids) == len(DIFFERENCES)


def test_kinds_differ() -> None:
    assert identify(TRIANGLE) != identify(BAR)


def test_ids_match_the_pattern_of_a_stored_mechanism() -> None:
    name = identify(BAR)
    assert len(name) == 34
    assert name.startswith("m_")
    assert set(name[2:]) <= set("0123456789abcdef")


@pytest.mark.parametrize("document", [BAR, TRIANGLE], ids=["five_bar", "planar_3rrr"])
def test_the_canonical_form_is_its_own(document: dict[str, Any]) -> None:
    text = canonical_json(parse_spec(json.dumps(document)))
    assert canonical_json(parse_spec(text)) == text


def test_the_canonical_form_has_sorted_keys_and_no_spaces() -> None:
    text = canonical_json(parse_spec(json.dumps(BAR)))
    assert text == json.dumps(json.loads(text), sort_keys=True, separators=(",", ":"))


LENGTHS = st.floats(1e-9, 1e6)


@settings(max_examples=60, deadline=None)
@given(LENGTHS, LENGTHS, LENGTHS, st.sampled_from([[1, 1], [1, -1], [-1, 1], [-1, -1]]))
def test_the_canonical_form_keeps_every_bit(
    base: float, crank: float, rod: float, mode: list[int]
) -> None:
    lengths = {"base_distance": base, "crank_length": crank, "rod_length": rod}
    spec = parse_spec(json.dumps({"kind": "five_bar", **lengths, "working_mode": mode}))
    assert parse_spec(canonical_json(spec)) == spec
