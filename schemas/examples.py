"""Worked requests and answers, one per analysis; shown in the API docs and run as tests.

All are of one five-bar whose numbers can be checked by hand: base joints at (-0.3, 0) and
(0.3, 0), all links 0.5 m. At (0, 0.9) both cranks stand upright, the rods are the diagonals of
3-4-5 triangles, Jx = [[0.6, 0.8], [-0.6, 0.8]], Jpsi = diag(-0.3, 0.3), and the greatest torque
under 10 N is 10 * 0.3 / 0.96 = 3.125 N m, reached along the other rod's normal.
"""

import math
from typing import Any, NamedTuple

from schemas.analyses import Request
from schemas.effort import EffortRequest, LoadSize
from schemas.families import FiveBar
from schemas.forward_kinematics import ForwardKinematicsRequest
from schemas.inverse_kinematics import InverseKinematicsRequest
from schemas.singularity import SingularityRequest
from schemas.starters import STARTERS
from schemas.velocity import VelocityRequest
from schemas.workspace import GridAxis, WorkspaceRequest


class Example(NamedTuple):
    """A request as a caller writes it, and the answer it gets."""

    title: str
    request: Request
    answer: dict[str, Any]


_FIVE_BAR = FiveBar(kind="five_bar", base_distance=0.6, crank_length=0.5, rod_length=0.5)

_INVERSE = Example(
    "Both cranks upright; the second pose is out of reach",
    InverseKinematicsRequest(
        analysis="inverse_kinematics", mechanism=_FIVE_BAR, poses=[[0.0, 0.9], [0.0, 1.2]]
    ),
    {
        "analysis": "inverse_kinematics",
        "working_mode": [1, -1],
        "units": ["rad", "rad"],
        "reachable": [True, False],
        "actuators": [[math.pi / 2, math.pi / 2], [None, None]],
        "obstacles": [
            {
                "pose": 1,
                "leg": leg,
                "reason": "reach",
                "value": math.sqrt(0.09 + 1.44) - 0.5,
                "limit": 0.5,
            }
            for leg in (0, 1)
        ],
    },
)

_FORWARD = Example(
    "Both cranks upright: the rods meet above the elbows or below them",
    ForwardKinematicsRequest(
        analysis="forward_kinematics",
        mechanism=_FIVE_BAR,
        actuators=[[math.pi / 2, math.pi / 2]],
    ),
    {
        "analysis": "forward_kinematics",
        "determinant_unit": "-",
        "assembly_modes": [
            [
                {
                    "pose": [0.0, 0.5 + side * 0.4],
                    "working_mode": [1, -1],
                    "determinant": side * 0.96,
                    "side": side,
                    "residual": 0.0,
                }
                for side in (1, -1)
            ]
        ],
        "route": ["closed form"],
        "certified": [True],
        "obstacles": [],
    },
)

_VELOCITY = Example(
    "The platform moves along x: both rods only translate",
    VelocityRequest(
        analysis="velocity",
        mechanism=_FIVE_BAR,
        poses=[[0.0, 0.9]],
        platform_rates=[[0.3, 0.0, 0.0, 0.0, 0.0, 0.0]],
    ),
    {
        "analysis": "velocity",
        "working_mode": [1, -1],
        "units": ["rad/s", "rad/s"],
        "platform_rates": [[0.3, 0.0, 0.0, 0.0, 0.0, 0.0]],
        "actuator_rates": [[-0.6, -0.6]],
        "passive_joints": [["B", "C"], ["B", "C"]],
        "passive_rates": [[[0.6, 0.0], [0.6, 0.0]]],
        "obstacles": [],
    },
)

_EFFORT = Example(
    "Greatest torques under a force of 10 N in any direction",
    EffortRequest(
        analysis="effort", mechanism=_FIVE_BAR, poses=[[0.0, 0.9]], load=LoadSize(force=10.0)
    ),
    {
        "analysis": "effort",
        "working_mode": [1, -1],
        "units": ["N·m", "N·m"],
        "effort": [[3.125, 3.125]],
        "worst_force": [[[8.0, 6.0, 0.0], [8.0, -6.0, 0.0]]],
        "worst_moment": [[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]],
        "obstacles": [],
    },
)

_SINGULARITY = Example(
    "Far from singularities",
    SingularityRequest(analysis="singularity", mechanism=_FIVE_BAR, poses=[[0.0, 0.9]]),
    {
        "analysis": "singularity",
        "working_mode": [1, -1],
        "determinant": [0.96],
        "determinant_unit": "-",
        # The roots of the eigenvalues 0.72 and 1.28 of Jx^T Jx.
        "condition_number": [4.0 / 3.0],
        "characteristic_length": 1.0,
        "type": [0],
        "pressure_angles": [[math.acos(0.96), math.acos(0.96)]],
        "free_motion": [None],
        "obstacles": [],
    },
)

_BOUNDS = [
    {"coordinate": "x", "min": -0.5, "max": 0.5, "clipped": False},
    {"coordinate": "y", "min": 0.0, "max": 0.5, "clipped": True},
]
_WORKSPACE = Example(
    "Theoretical workspace on a coarse grid, clipped at y = 0",
    WorkspaceRequest.model_validate(
        {
            "analysis": "workspace",
            "mechanism": _FIVE_BAR,
            "class": "theoretical",
            "type": "constant_orientation",
            "grid": [
                GridAxis(coordinate="x", min=-1.0, max=1.0, step=0.5),
                GridAxis(coordinate="y", min=0.0, max=1.0, step=0.5),
            ],
            "fields": ["actuators"],
        }
    ),
    {
        "analysis": "workspace",
        "class": "theoretical",
        "type": "constant_orientation",
        "orientations": None,
        "working_mode": [1, -1],
        "shape": [5, 3],
        "nodes": 15,
        "inside": 6,
        "measure": {"value": 1.5, "unit": "m²", "error_bound": 0.875, "rigorous": False},
        "bounds": _BOUNDS,
        "centroid": {"x": 0.0, "y": 0.25},
        "components": [
            {"nodes": 6, "measure": 1.5, "bounds": _BOUNDS, "centroid": {"x": 0.0, "y": 0.25}}
        ],
        "component_count": 1,
        "excluded": [
            {"code": 1, "reason": "reach", "leg": 0, "nodes": 7},
            {"code": 2, "reason": "reach", "leg": 1, "nodes": 2},
        ],
        "inscribed": None,
        "outer_bound": False,
        "boundary": None,
        "fields": {
            "actuators": {
                # Of the left crank: least at (-0.5, 0), 0.2 m from its base joint.
                "min": math.acos(0.2) - math.pi,
                "max": math.atan2(0.5, -0.2) + math.acos(math.hypot(0.2, 0.5)),
                "at_max": {"x": -0.5, "y": 0.5},
                "unit": "rad",
                "histogram": None,
            }
        },
    },
)

EXAMPLES = (_INVERSE, _FORWARD, _VELOCITY, _EFFORT, _SINGULARITY, _WORKSPACE)

HEXAPOD_AT_REST = ForwardKinematicsRequest(
    analysis="forward_kinematics",
    mechanism=STARTERS["gough_stewart"],
    actuators=[[0.8, 0.81, 0.82, 0.83, 0.84, 0.85]],
)
"""Asks for what takes the longest to compile."""
