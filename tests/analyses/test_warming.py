"""What processes are ready for once they are warm."""

import json
import subprocess
import sys
from typing import Any

import pytest

from schemas.starters import STARTERS

ASKED = """
import json, sys
import analyses
from numba.core.registry import CPUDispatcher
from pydantic import TypeAdapter
from schemas.analyses import Request

def made():
    modules = [m for name, m in sys.modules.items() if name.startswith("mechanics.kernels.")]
    found = {k for m in modules for k in vars(m).values() if isinstance(k, CPUDispatcher)}
    return {f"{kernel.__module__}.{kernel.__name__}" for kernel in found if kernel.signatures}

analyses.warm()
before = made()
for body in json.load(sys.stdin):
    analyses.answer(TypeAdapter(Request).validate_python(body))
print(json.dumps(sorted(made() - before)))
"""

HEXAPOD = STARTERS["gough_stewart"].model_dump(exclude_none=True)
POSE = {"z": 0.65, "rx": 0.1, "ry": 0.0, "rz": -0.1}
ALL_TURNS = [{"coordinate": turn, "step": 1.5} for turn in ("rx", "ry", "rz")]
EFFECTIVE: dict[str, Any] = {
    "analysis": "workspace",
    "mechanism": HEXAPOD,
    "class": "effective",
    "type": "constant_orientation",
    "grid": [{"coordinate": "x", "min": -0.1, "max": 0.1, "step": 0.05}],
    "fixed": POSE | {"y": 0.0},
    "effective": {"load": {"force": 5.0}, "max_effort": 1e3, "max_pressure_angle": 1.5},
    "fields": ["effort_max", "pressure_angle"],
    "histograms": True,
}
WHOLE_TURN = {"type": "full", "fixed": {"y": 0.0, "z": 0.65}, "orientation_range": ALL_TURNS}
BODIES: list[dict[str, Any]] = [
    EFFECTIVE,
    EFFECTIVE | {"component": "home", "home": [0.0, 0.0, *POSE.values()]},
    EFFECTIVE
    | {
        "type": "full",
        "fixed": {"y": 0.0, "z": 0.65},
        "orientation_range": ALL_TURNS,
        "fields": [],
    },
    {
        "analysis": "forward_kinematics",
        "mechanism": HEXAPOD,
        "actuators": [[0.8] * 6],
        "guess": [0.0, 0.0, *POSE.values()],
    },
]


@pytest.mark.timeout(600)
def test_a_warm_process_compiles_nothing_for_a_hexapod() -> None:
    """Else the first answer takes seconds where the estimate says hundredths."""
    command = [sys.executable, "-c", ASKED]
    ended = subprocess.run(command, input=json.dumps(BODIES), capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    assert json.loads(ended.stdout) == []
