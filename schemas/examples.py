"""Worked requests and answers, one per analysis; shown in the API docs and run as tests.

All but the last are of one five-bar whose numbers can be checked by hand: base joints at (-0.3, 0)
and (0.3, 0), all links 0.5 m. At (0, 0.9) both cranks stand upright, the rods are the diagonals of
3-4-5 triangles, Jx = [[0.6, 0.8], [-0.6, 0.8]], Jpsi = diag(-0.3, 0.3), and the greatest torque
under 10 N is 10 * 0.3 / 0.96 = 3.125 N m, reached along the other rod's normal.

The last is of two wheels of 0.5 and 1 m whose line of action leans by a 3-4-5 triangle: base radii
0.4 and 0.8 m, tangent points 0.3 m before and 0.6 m after the pitch point. 0.1 m after it a normal
force of 100 N and 10 N of friction make 100 (0.4 + 0.1 * 0.4) = 44 N m at one centre and
100 (0.8 + 0.1 * 0.5) = 85 N m at the other; 10 N lose 6 W at a sliding speed of 0.6 m/s.
"""

import math
from typing import Any, NamedTuple

from schemas.analyses import Request
from schemas.effort import EffortRequest, LoadSize
from schemas.families import FiveBar
from schemas.forward_kinematics import ForwardKinematicsRequest
from schemas.friction_torque import FrictionTorqueRequest
from schemas.gears import ExplicitMesh
from schemas.inverse_kinematics import InverseKinematicsRequest
from schemas.singularity import SingularityRequest
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
        "measure": {"value": 1.5, "unit": "m²", "error_bound": 1.25, "rigorous": False},
        "bounds": _BOUNDS,
        "centroid": {"x": 0.0, "y": 0.25},
        "components": [
            {"nodes": 6, "measure": 1.5, "bounds": _BOUNDS, "centroid": {"x": 0.0, "y": 0.25}}
        ],
        "component_count": 1,
        "excluded": [
            {"code": 1, "reason": "reach", "leg": 0, "other_leg": None, "nodes": 7},
            {"code": 2, "reason": "reach", "leg": 1, "other_leg": None, "nodes": 2},
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

_WHOLE_TRAIN = {
    "input_torque": 44.0,
    "frictionless_input_torque": 42.5,
    "excess": 44.0 / 42.5 - 1.0,
    "ratio": 0.5,
    "efficiency": 42.5 / 44.0,
    "loss": 1.5 / 44.0,
    "power_loss": 6.0,
    "self_locking": False,
}
_FRICTION_TORQUE = Example(
    "One pair of teeth in recess, by points in its plane",
    FrictionTorqueRequest(
        analysis="friction_torque",
        train=[
            ExplicitMesh(
                kind="explicit",
                input_centre=[-0.5, 0.0],
                output_centre=[1.0, 0.0],
                pitch_point=[0.0, 0.0],
                contact=[0.06, 0.08],
                friction_coefficient=0.1,
            )
        ],
        output_torque=85.0,
        contact="explicit",
        output_speed=2.0,
    ),
    {
        "analysis": "friction_torque",
        "contact": "explicit",
        "sense": "driving",
        **_WHOLE_TRAIN,
        "stages": [
            {
                **_WHOLE_TRAIN,
                "output_torque": 85.0,
                "frictionless_output_torque": 85.0,
                "contact_position": 0.1,
                "input_arm": 0.44 / math.hypot(1.0, 0.1),
                "output_arm": 0.85 / math.hypot(1.0, 0.1),
                "sliding_speed": 0.6,
                "geometry": {
                    "pitch_radii": [0.5, 1.0],
                    "base_radii": [0.4, 0.8],
                    "pressure_angle": math.asin(0.6),
                    "tip_radii": None,
                    "tip_thickness": None,
                    "approach": 0.1,
                    "recess": 0.1,
                    "contact_ratio": None,
                },
                "curve": None,
            }
        ],
    },
)

EXAMPLES = (_INVERSE, _FORWARD, _VELOCITY, _EFFORT, _SINGULARITY, _WORKSPACE, _FRICTION_TORQUE)
