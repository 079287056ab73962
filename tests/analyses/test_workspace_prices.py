"""What workspaces are priced at before they are computed."""

import json
from typing import Any

import numpy as np
import pytest

import analyses
from schemas.analyses import Request, parse_request
from tests.oracles.draws import DRAWS

SYNCHRONOUS = 0.5
ONE_BY_ONE = 1e-4
"""Less than an orientation that is tried by itself takes, even of a single node. [s]"""


def at_one_node(step: float, **fields: Any) -> Request:  # noqa: ANN401
    """Return a request of one node at some of many orientations, with conditions to search."""
    draw = DRAWS["gough_stewart"](np.random.default_rng(0))
    turns = [{"coordinate": c, "min": -1.0, "max": 1.0, "step": step} for c in ("rx", "ry", "rz")]
    body = {
        "analysis": "workspace",
        "mechanism": draw.wire,
        "type": "inclusive_orientation",
        "class": "effective",
        "grid": [{"coordinate": "z", "min": 0.5, "max": 0.5, "step": 1.0}],
        "fixed": {"x": 0.0, "y": 0.0},
        "orientation_range": turns,
        "effective": {"max_condition_number": 1.5},
    }
    request = parse_request(json.dumps(body | fields))
    analyses.check(request, 10**9)
    return request


@pytest.mark.parametrize("step", [0.1, 0.05])
def test_orientations_tried_one_by_one_cost_however_few_the_nodes(step: float) -> None:
    count = round(2.0 / step + 1.0) ** 3
    price = analyses.estimate(at_one_node(step), SYNCHRONOUS)
    assert price.nodes == 1
    assert price.mode == "job"
    assert price.seconds > count * ONE_BY_ONE


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
    assert 0.1 * prices[1] < prices[0] < prices[1]
