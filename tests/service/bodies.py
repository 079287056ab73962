"""Bodies as callers write them, and what is expected of answers."""

from typing import Any

import pytest

FIVE_BAR: dict[str, Any] = {
    "kind": "five_bar",
    "base_distance": 0.6,
    "crank_length": 0.5,
    "rod_length": 0.5,
}
PLANAR_3RRR: dict[str, Any] = {
    "kind": "planar_3rrr",
    "base_side": 0.4,
    "platform_radius": 0.08,
    "crank_length": 0.18,
    "rod_length": 0.18,
}
INVERSE: dict[str, Any] = {
    "analysis": "inverse_kinematics",
    "mechanism": FIVE_BAR,
    "poses": [[0.0, 0.9]],
}
EFFORT: dict[str, Any] = {
    "analysis": "effort",
    "mechanism": FIVE_BAR,
    "poses": [[0.0, 0.9]],
    "load": {"force": 10.0},
}
WORKSPACE: dict[str, Any] = {
    "analysis": "workspace",
    "mechanism": FIVE_BAR,
    "class": "theoretical",
    "type": "constant_orientation",
    "grid": [
        {"coordinate": "x", "min": -1.0, "max": 1.0, "step": 0.5},
        {"coordinate": "y", "min": 0.0, "max": 1.0, "step": 0.5},
    ],
}


def grid(step: float, /, **second: Any) -> list[dict[str, Any]]:  # noqa: ANN401
    """Return a grid over x and y; `second` replaces values of the second axis."""
    return [
        {"coordinate": "x", "min": -1.0, "max": 1.0, "step": step},
        {"coordinate": "y", "min": -1.0, "max": 1.0, "step": step} | second,
    ]


def close(given: Any, expected: Any) -> bool:  # noqa: ANN401
    """Return whether two JSON documents agree, numbers to 1e-12."""
    if isinstance(expected, dict):
        return given.keys() == expected.keys() and all(
            close(given[key], expected[key]) for key in expected
        )
    if isinstance(expected, list):
        return len(given) == len(expected) and all(map(close, given, expected))
    if isinstance(expected, float):
        return bool(given == pytest.approx(expected, rel=1e-12, abs=1e-12))
    return bool(given == expected)
