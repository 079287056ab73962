"""Requests that need the kernels which take the longest to compile."""

from typing import Any

from schemas.analyses import Request
from schemas.forward_kinematics import ForwardKinematicsRequest
from schemas.starters import STARTERS
from schemas.workspace import GridAxis, WorkspaceRequest

_FEW_NODES = [
    GridAxis(coordinate="x", min=-0.05, max=0.05, step=0.025),
    GridAxis(coordinate="y", min=-0.05, max=0.05, step=0.025),
]
_LEVEL = {"z": 0.7, "rx": 0.0, "ry": 0.0, "rz": 0.1}
# With a pressure angle the platform's twists are there, and efforts come from them.
_BOUNDS = {"load": {"force": 1.0}, "max_effort": 100.0, "max_pressure_angle": 1.5}
_SLIGHTLY = {"min": -0.1, "max": 0.1, "step": 0.2}
_EFFECTIVE: tuple[dict[str, Any], ...] = (
    {
        "type": "constant_orientation",
        "fixed": _LEVEL,
        "component": "home",
        "home": [0.0, 0.0, *_LEVEL.values()],
        "fields": ["effort_max"],
        "histograms": True,
    },
    {
        "type": "orientation_range",
        "fixed": {"z": 0.7},
        "orientation_range": [{"coordinate": turn, **_SLIGHTLY} for turn in ("rx", "ry", "rz")],
    },
)
HEAVY: tuple[Request, ...] = (
    *(
        ForwardKinematicsRequest(
            analysis="forward_kinematics",
            mechanism=STARTERS["gough_stewart"],
            actuators=[[0.8, 0.81, 0.82, 0.83, 0.84, 0.85]],
            guess=guess,
        )
        for guess in (None, [0.0, 0.0, *_LEVEL.values()])
    ),
    *(
        WorkspaceRequest.model_validate(
            {
                "analysis": "workspace",
                "mechanism": STARTERS[kind],
                "class": "theoretical",
                "type": "maximal",
                "grid": _FEW_NODES,
                "fixed": fixed,
                "inscribed": True,
            }
        )
        for kind, fixed in (("planar_3rrr", {}), ("gough_stewart", {"z": 0.7}))
    ),
    *(
        WorkspaceRequest.model_validate(
            {
                "analysis": "workspace",
                "mechanism": STARTERS["gough_stewart"],
                "class": "effective",
                "grid": _FEW_NODES,
                "effective": _BOUNDS,
                **asked,
            }
        )
        for asked in _EFFECTIVE
    ),
)
"""Ask for what takes the longest to compile: all modes of six rods and one from a guess, all angles
of a turn, bounds on efforts, and what is inscribed in a workspace or reached from a home."""
