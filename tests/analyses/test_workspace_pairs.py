"""Conditions between two rods: every code names both, and is theirs."""

import json
import math
from typing import Any

import numpy as np
import numpy.typing as npt

import analyses
from schemas.analyses import parse_request
from schemas.workspace import WorkspaceRequest
from schemas.workspace_result import WorkspaceResult

LEAST = 0.2
DELTA: dict[str, Any] = {
    "kind": "delta_linear",
    "rail_radius": 0.2,
    "platform_radius": 0.12,
    "rod_length": 0.35,
    "carriage_arm": 0.0,
    "tool_offset": 0.0,
}
GRID = [
    {"coordinate": "x", "min": -0.2, "max": 0.2, "step": 0.05},
    {"coordinate": "y", "min": -0.2, "max": 0.2, "step": 0.04},
]


def request() -> WorkspaceRequest:
    body = {"analysis": "workspace", "class": "constructive", "type": "constant_orientation"}
    own = {"mechanism": DELTA, "grid": GRID, "fixed": {"z": 0.0}}
    bound = {"constructive": {"min_rod_distance": LEAST}}
    asked = parse_request(json.dumps({**body, **own, **bound}))
    assert isinstance(asked, WorkspaceRequest)
    analyses.check(asked, 10**6)
    return asked


def rod(leg: int, x: float, y: float) -> npt.NDArray[np.float64]:
    """Return 401 points of a rod, the platform's point at (x, y, 0)."""
    out = math.radians((90.0, 210.0, 330.0)[leg])
    outward = np.array([math.cos(out), math.sin(out), 0.0])
    low = np.array([x, y, 0.0]) + 0.12 * outward
    high = 0.2 * outward
    high[2] = math.sqrt(0.35**2 - np.sum((high - low)[:2] ** 2))
    return low + np.linspace(0.0, 1.0, 401)[:, None] * (high - low)


def test_a_pair_of_rods_is_named_and_too_near() -> None:
    asked = request()
    found = analyses.answer(asked)
    assert isinstance(found, WorkspaceResult)
    pairs = {e.code: (e.leg, e.other_leg) for e in found.excluded if e.reason == "rod_distance"}
    assert sorted(pairs.values()) == [(0, 1), (0, 2), (1, 2)]
    assert all(e.other_leg is None for e in found.excluded if e.reason != "rod_distance")
    tile = analyses.compute(asked, 0, found.nodes)
    codes = np.repeat(tile["codes"], tile["lengths"]).reshape(found.shape)
    assert set(pairs) <= set(np.unique(codes).tolist())
    for i, j in np.argwhere(np.isin(codes, list(pairs))):
        x, y = -0.2 + 0.05 * i, -0.2 + 0.04 * j
        one, other = pairs[int(codes[i, j])]
        assert one is not None
        assert other is not None
        apart = rod(one, x, y)[:, None] - rod(other, x, y)
        assert np.linalg.norm(apart, axis=2).min() < LEAST + 1e-3
