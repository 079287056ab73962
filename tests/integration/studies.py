"""Requests that the servers are given."""

from typing import Any

import httpx
import numpy as np
from numpy.typing import NDArray

PRINTER: dict[str, Any] = {
    "kind": "five_bar",
    "base_distance": 0.12,
    "crank_length": 0.16,
    "rod_length": 0.22,
    "actuator_limits": [{"min": -2.3, "max": 3.8}, {"min": -0.7, "max": 5.4}],
}
FIELDS = ["actuators", "determinant", "effort", "effort_max"]


def workspace(step: float, **changes: Any) -> dict[str, Any]:  # noqa: ANN401
    """Return a request for the effective workspace of the printer, by default with all fields."""
    return {
        "analysis": "workspace",
        "mechanism": PRINTER,
        "class": "effective",
        "type": "constant_orientation",
        "grid": [
            {"coordinate": "x", "min": -0.4, "max": 0.4, "step": step},
            {"coordinate": "y", "min": 0.0, "max": 0.4, "step": step},
        ],
        "constructive": {"min_crank_rod_angle": 0.35, "min_rod_rod_angle": 0.1},
        "effective": {"load": {"force": 1.0}, "max_effort": 0.2},
        "fields": FIELDS,
    } | changes


SMALL = workspace(0.01)
ENDLESS = workspace(0.00005, fields=[])
"""Two minutes of computing and more."""


def arrays(answer: httpx.Response, folder: Any) -> dict[str, NDArray[Any]]:  # noqa: ANN401
    """Return the arrays of a grid that was fetched."""
    path = folder / "grid.npz"
    path.write_bytes(answer.content)
    with np.load(path, allow_pickle=False) as archive:
        return {name: archive[name] for name in archive.files}
