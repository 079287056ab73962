"""What workspaces are priced at before they are computed."""

import itertools
import json
from typing import Any

import numpy as np
import pytest

import analyses
from schemas.analyses import Request, parse_request
from schemas.starters import STARTERS
from tests.oracles.draws import DRAWS

SYNCHRONOUS = 0.5
ONE_BY_ONE = 1e-4
"""Less than an orientation that is tried by itself takes, however few the nodes. [s]"""


def upright(nodes: int, step: float, **fields: Any) -> Request:  # noqa: ANN401
    """Return a request of nodes at some of many orientations, with conditions to search."""
    draw = DRAWS["gough_stewart"](np.random.default_rng(0))
    turns = [{"coordinate": c, "min": -1.0, "max": 1.0, "step": step} for c in ("rx", "ry", "rz")]
    body = {
        "analysis": "workspace",
        "mechanism": draw.wire,
        "type": "inclusive_orientation",
        "class": "effective",
        "grid": [{"coordinate": "z", "min": 0.5, "max": 0.5 + 1e-4 * (nodes - 1), "step": 1e-4}],
        "fixed": {"x": 0.0, "y": 0.0},
        "orientation_range": turns,
        "effective": {"max_condition_number": 1.5},
    }
    request = parse_request(json.dumps(body | fields))
    analyses.check(request, 10**9)
    return request


@pytest.mark.parametrize("step", [0.1, 0.05])
def test_few_nodes_do_not_pay_for_orientations_tried_one_by_one(step: float) -> None:
    count = round(2.0 / step + 1.0) ** 3
    one, many = (analyses.estimate(upright(n, step), SYNCHRONOUS) for n in (1, 1000))
    assert (one.nodes, many.nodes) == (1, 1000)
    assert many.mode == "job"
    assert many.seconds > count * ONE_BY_ONE > one.seconds


def test_shapes_that_are_looked_for_cost_more_than_a_scan_by_lines() -> None:
    step = 2.0 / 400
    grid = [{"coordinate": name, "min": -1.0, "max": 1.0, "step": step} for name in "xyz"]
    asked = {
        "analysis": "workspace",
        "mechanism": DRAWS["gough_stewart"](np.random.default_rng(0)).wire,
        "class": "theoretical",
        "type": "constant_orientation",
        "grid": grid,
        "fixed": {"rx": 0.0, "ry": 0.0, "rz": 0.0},
    }
    prices = [
        analyses.estimate(parse_request(json.dumps(asked | {"inscribed": sought})), SYNCHRONOUS)
        for sought in (False, True)
    ]
    # A pass over each node of 64 million, and more: a queue's work, whatever the scan costs.
    assert prices[1].seconds > prices[0].seconds + 0.1
    assert prices[1].mode == "job"


def price_of_all_angles(count: int) -> float:
    """Return the price of so many nodes a side at all angles of a turn. [s]"""
    wire = DRAWS["planar_3rrr"](np.random.default_rng(0)).wire
    axes = [{"coordinate": c, "min": -0.3, "max": 0.3, "step": 0.6 / count} for c in "xy"]
    body = {"analysis": "workspace", "mechanism": wire, "type": "maximal", "class": "theoretical"}
    request = parse_request(json.dumps(body | {"grid": axes}))
    analyses.check(request, 10**9)
    return analyses.estimate(request, SYNCHRONOUS).seconds


def test_the_price_of_all_angles_grows_less_than_the_nodes() -> None:
    coarse, fine = price_of_all_angles(500), price_of_all_angles(2000)
    assert 4.0 * coarse < fine < 0.7 * 16.0 * coarse


def test_many_short_lines_cost_more_than_few_long_ones() -> None:
    draw = DRAWS["delta_rotary"](np.random.default_rng(0))
    prices = []
    for counts in ((100, 10), (10, 100)):
        grid = [
            {"coordinate": c, "min": 0.0, "max": 1.0, "step": 1.0 / (count - 1)}
            for c, count in zip("xz", counts, strict=True)
        ]
        body = {
            "analysis": "workspace",
            "mechanism": draw.wire,
            "type": "constant_orientation",
            "class": "theoretical",
            "grid": grid,
            "fixed": {"y": 0.0},
        }
        prices.append(analyses.estimate(parse_request(json.dumps(body)), SYNCHRONOUS).seconds)
    assert prices[0] > 2.0 * prices[1]


def test_the_ends_of_arcs_are_sought_however_short_the_range() -> None:
    wire = DRAWS["planar_3rrr"](np.random.default_rng(0)).wire
    prices = []
    for wide in (0.02, 3.0):
        body = {
            "analysis": "workspace",
            "mechanism": wire,
            "type": "inclusive_orientation",
            "class": "effective",
            "grid": [{"coordinate": c, "min": -0.3, "max": 0.3, "step": 0.03} for c in "xy"],
            "orientation_range": [{"coordinate": "phi", "min": -wide, "max": wide}],
            "effective": {"max_pressure_angle": 1.0},
        }
        request = parse_request(json.dumps(body))
        analyses.check(request, 10**9)
        prices.append(analyses.estimate(request, SYNCHRONOUS).seconds)
    assert 0.1 * prices[1] < prices[0]


PLANE = {"x": (-0.3, 0.3), "y": (-0.3, 0.3)}
SPACE = {"x": (-0.6, 0.6), "y": (-0.6, 0.6), "z": (0.2, 1.2)}
LIMITS = {"min": 0.5, "max": 1.1}
STEEPEST = {"max_pressure_angle": 0.9}
SLIGHTLY = [{"coordinate": c, "min": -0.2, "max": 0.2, "step": 0.2} for c in ("rx", "ry", "rz")]
STILL = {"rx": 0.0, "ry": 0.0, "rz": 0.0}


def priced(kind: str, ranges: dict[str, tuple[float, float]], count: int, **asked: Any) -> float:  # noqa: ANN401
    """Return the price of a starter's workspace on so many nodes a side. [s]"""
    mechanism = STARTERS[kind].model_dump(mode="json", exclude_none=True)
    if kind == "gough_stewart":
        mechanism["actuator_limits"] = LIMITS
    grid = [
        {"coordinate": name, "min": low, "max": high, "step": (high - low) / (count - 1)}
        for name, (low, high) in ranges.items()
    ]
    body = {"analysis": "workspace", "mechanism": mechanism, "class": "theoretical", "grid": grid}
    request = parse_request(json.dumps(body | {"type": "constant_orientation"} | asked))
    analyses.check(request, 10**12)
    return analyses.estimate(request, SYNCHRONOUS).seconds


def in_plane(count: int, **asked: Any) -> float:  # noqa: ANN401
    return priced("planar_3rrr", PLANE, count, **asked)


def in_space(count: int, **asked: Any) -> float:  # noqa: ANN401
    return priced("gough_stewart", SPACE, count, **asked)


LEVEL: dict[str, Any] = {"fixed": {"phi": 0.0}}
EFFECTIVE: dict[str, Any] = {"class": "effective", "effective": STEEPEST}


@pytest.mark.parametrize(
    "asked",
    [
        LEVEL,
        LEVEL | EFFECTIVE,
        LEVEL | {"fields": ["condition_number"]},
        LEVEL | {"working_mode": "any"},
        {"type": "maximal"},
        {"type": "full"},
        {"type": "maximal"} | EFFECTIVE,
        {"type": "full"} | EFFECTIVE,
    ],
)
def test_finer_grids_in_the_plane_cost_more(asked: dict[str, Any]) -> None:
    prices = [in_plane(count, **asked) for count in (50, 200, 800, 3200)]
    assert all(2.0 * coarse < fine for coarse, fine in itertools.pairwise(prices))


@pytest.mark.parametrize(
    "asked",
    [
        {"fixed": STILL},
        {"fixed": STILL, "class": "constructive"},
        {"fixed": STILL} | EFFECTIVE,
        {"type": "inclusive_orientation", "class": "constructive", "orientation_range": SLIGHTLY},
        {"type": "inclusive_orientation", "orientation_range": SLIGHTLY} | EFFECTIVE,
        {"type": "orientation_range", "orientation_range": SLIGHTLY} | EFFECTIVE,
    ],
)
def test_finer_grids_in_space_cost_more(asked: dict[str, Any]) -> None:
    prices = [in_space(count, **asked) for count in (30, 60, 120)]
    assert all(2.0 * coarse < fine for coarse, fine in itertools.pairwise(prices))


def test_a_class_costs_at_least_what_those_below_it_do() -> None:
    prices = [
        in_space(100, fixed=STILL, effective=STEEPEST, **{"class": name})
        for name in ("theoretical", "constructive", "effective")
    ]
    assert prices == sorted(prices)


@pytest.mark.parametrize("type_", ["maximal", "inclusive_orientation"])
def test_what_is_searched_costs_more_than_closed_forms(type_: str) -> None:
    ranges = [{"coordinate": "phi", "min": -0.5, "max": 0.5}] if type_ != "maximal" else []
    asked = {"type": type_, "orientation_range": ranges}
    assert in_plane(100, **asked) < in_plane(100, **asked, **EFFECTIVE)


def test_fields_working_modes_and_shapes_cost_something() -> None:
    alone = in_plane(300, **LEVEL)
    more: list[dict[str, Any]] = [
        {"fields": ["determinant"]},
        {"working_mode": "any"},
        {"inscribed": True},
    ]
    assert all(in_plane(300, **LEVEL, **asked) > alone for asked in more)


def test_where_nothing_holds_all_round_nothing_is_searched() -> None:
    far = {"x": (0.1, 0.4), "y": (0.1, 0.4)}
    some, all_ = (priced("planar_3rrr", far, 120, type=t, **EFFECTIVE) for t in ("maximal", "full"))
    assert all_ < 0.2 * some


@pytest.mark.parametrize(
    "asked", [EFFECTIVE, {"fields": ["pressure_angle"]}, {"fields": ["condition_number"]}]
)
def test_nodes_out_of_reach_cost_little(asked: dict[str, Any]) -> None:
    far = {name: (high, 9.0 * high - 8.0 * low) for name, (low, high) in PLANE.items()}
    near, beyond = (priced("planar_3rrr", ranges, 300, **LEVEL, **asked) for ranges in (PLANE, far))
    assert beyond < 0.1 * near


@pytest.mark.parametrize("type_", ["inclusive_orientation", "orientation_range"])
def test_nodes_that_another_orientation_cannot_change_are_asked_no_more(type_: str) -> None:
    asked = EFFECTIVE | {"type": type_, "orientation_range": SLIGHTLY}
    asked["effective"] = {"max_pressure_angle": 1.4}
    assert in_space(40, **asked) < in_space(40, **asked, fields=["free_orientation"])


def test_lines_are_counted_not_their_nodes() -> None:
    prices = [
        priced("delta_linear", {"x": (-0.3, 0.3), "y": (-0.3, 0.3), "z": (-low, low)}, 200)
        for low in (0.3, 3.0)
    ]
    assert prices[1] == pytest.approx(prices[0])
