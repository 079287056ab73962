"""What is asked of the geared mechanism: limits of its motors, its workspaces, and nonsense."""

import json
import math
from itertools import product
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import analyses
from analyses.errors import AnalysisError
from analyses.workspace_setup import set_up
from mechanics.workspace import scan
from schemas.analyses import parse_request
from schemas.workspace import WorkspaceRequest

SIZES = {
    "rail_radius": 0.33,
    "platform_radius": 0.08,
    "rod_length": 0.37,
    "carriage_arm": 0.022,
}
WRIST = {"k1": 0.9, "k2": 1.0, "kp": 0.87, "k_gamma": 1.4}
TOOL = 0.05
GEARED = {"kind": "geared_decoupled", **SIZES, "tool_offset": TOOL, "wrist": WRIST}
DELTA = {"kind": "delta_linear", **SIZES, "tool_offset": 0.0}
RAILS = [{"min": 0.0, "max": 0.4}] * 3
LEVEL = {"rx": 0.0, "ry": 0.0, "rz": 0.0}
CONES = {
    "min_rod_distance": 0.09,
    "max_base_joint_angle": 0.9,
    "base_joint_axes": [[0.0, 0.0, -1.0]] * 3,
    "max_platform_joint_angle": 0.8,
    "platform_joint_axes": [[0.1, 0.0, -1.0]] * 3,
}


def parsed(body: dict[str, Any]) -> Any:  # noqa: ANN401
    request = parse_request(json.dumps(body, default=float))
    analyses.check(request, 10**7)
    return request


def answered(body: dict[str, Any]) -> dict[str, Any]:
    return analyses.answer(parsed(body)).model_dump(mode="json")


def refused(body: dict[str, Any]) -> str:
    with pytest.raises(AnalysisError) as caught:
        parsed(body)
    return str(caught.value.errors)


def workspace(mechanism: dict[str, Any], **fields: Any) -> dict[str, Any]:  # noqa: ANN401
    body = {"analysis": "workspace", "mechanism": mechanism, "class": "constructive"}
    return body | {"type": "constant_orientation"} | fields


def box(step: float, *centre: float) -> list[dict[str, Any]]:
    """Return a grid of positions about a point, level by level."""
    ends = zip("xyz", centre, (0.24, 0.24, 0.3), strict=True)
    return [{"coordinate": c, "min": m - h, "max": m + h, "step": step} for c, m, h in ends]


def codes(body: dict[str, Any]) -> npt.NDArray[np.uint8]:
    request = parsed(body)
    tile = analyses.compute(request, 0, analyses.plan(request, 1.0).items)
    return np.repeat(tile["codes"], tile["lengths"])


def test_motors_are_held_against_their_limits_turn_by_turn() -> None:
    """A motor is not a crank: a turn more is another place, and a limit may be turns away."""
    limits = [None, None, None, None, None, {"min": -7.0, "max": 1.0}]
    poses = [[TOOL, 0.0, 0.0, 0.0, 0.0, turned] for turned in (-1.0, 1.0, 2 * math.pi - 1.0, -8.0)]
    for pose in poses:
        pose[:2] = [TOOL * math.cos(pose[5]), TOOL * math.sin(pose[5])]
    found = answered(
        {
            "analysis": "inverse_kinematics",
            "mechanism": GEARED | {"actuator_limits": limits},
            "poses": poses,
        }
    )
    assert found["reachable"] == [True, True, False, False]
    assert found["actuators"][2][5] == pytest.approx(2 * math.pi - 1.0)
    assert [(o["pose"], o["leg"], o["reason"], o["limit"]) for o in found["obstacles"]] == [
        (2, 5, "actuator_limits", 1.0),
        (3, 5, "actuator_limits", -7.0),
    ]


def test_rails_out_of_reach_leave_the_motors_their_place() -> None:
    pose = [1.0, 0.0, 0.0, 0.3, 0.2, 0.1]
    found = answered({"analysis": "inverse_kinematics", "mechanism": GEARED, "poses": [pose]})
    assert None in found["actuators"][0][:3]
    assert found["actuators"][0][3:] == pytest.approx(
        [0.783 * 0.1 + 0.14, 0.783 * 0.5 + 0.14, 0.1], abs=1e-15
    )


@pytest.mark.parametrize("angle", [0.5 * math.pi, -0.5 * math.pi])
def test_aligned_axes_are_of_type_1(angle: float) -> None:
    """No rate of the motors then makes every turn, and the platform is held all the same."""
    pose = [0.0, 0.0, 0.0, 0.3, angle, 0.1]
    asked = {"mechanism": GEARED, "poses": [pose]}
    told = answered({"analysis": "singularity", **asked})
    assert told["type"] == [1]
    assert told["pressure_angles"][0][3:] == pytest.approx([0.5 * math.pi] * 3, abs=1e-7)
    load = {"force": [1.0, 2.0, 3.0], "moment": [1.0, 0.0, 0.5]}
    borne = answered({"analysis": "effort", **asked, "known_load": load})
    assert all(isinstance(effort, float) for effort in borne["effort"][0])
    moved = answered(
        {"analysis": "velocity", **asked, "platform_rates": [[0.0, 0.0, 0.0, 1.0, 0.0, 0.0]]}
    )
    assert moved["actuator_rates"][0][3:] == [None] * 3
    assert [entry["leg"] for entry in moved["obstacles"]] == [3, 4, 5]


def test_rods_in_one_plane_are_of_type_2() -> None:
    """Found by halving between two poses on either side: the rails lose hold, motors do not."""
    mixed = {"mechanism": GEARED, "working_mode": [1, 1, -1, 1, 1, 1]}

    def pose(share: float) -> list[float]:
        return [0.16 * share, 0.02, -0.1, 0.3, 0.2, 0.1]

    def determinant(share: float) -> float:
        asked = {"analysis": "singularity", **mixed, "poses": [pose(share)]}
        return float(answered(asked)["determinant"][0])

    low, high = 0.0, 1.0
    assert determinant(low) < 0.0 < determinant(high)
    while low < 0.5 * (low + high) < high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if determinant(middle) < 0.0 else (low, middle)
    told = answered({"analysis": "singularity", **mixed, "poses": [pose(low)]})
    assert told["type"] == [2]
    # Motors hold every turn, so what is left free is a translation.
    assert told["free_motion"][0][3:] == pytest.approx([0.0] * 3, abs=1e-9)


@pytest.mark.parametrize("bounds", [{}, CONES])
@pytest.mark.parametrize("angles", [(0.0, 0.0, 0.0), (0.4, -0.7, 2.1)])
def test_a_level_workspace_is_a_deltas_moved_by_the_tool(
    bounds: dict[str, Any], angles: tuple[float, ...]
) -> None:
    """What the rails carry does not turn, so rods and cones are as in a Delta, wherever it points.

    Grids are shifted by R OD, so that nodes meet the same wrist centres up to rounding.
    """
    _, ry, rz = angles
    ahead = [TOOL * math.cos(ry) * math.cos(rz), TOOL * math.cos(ry) * math.sin(rz)]
    ahead.append(-TOOL * math.sin(ry))
    step, limits = 0.0171, {"actuator_limits": [*RAILS, None, None, None]}
    turned = dict(zip(LEVEL, angles, strict=True))
    fields = {"constructive": bounds}
    own = workspace(GEARED | limits, grid=box(step, *ahead), fixed=turned, **fields)
    other = workspace(DELTA | {"actuator_limits": RAILS}, grid=box(step, 0.0, 0.0, 0.0), **fields)
    found, expected = codes(own) == 0, codes(other) == 0
    assert 100 < expected.sum() < 0.9 * expected.size
    assert np.array_equal(found, expected)


@pytest.mark.parametrize("shift", [-0.01, 0.01])
def test_a_motors_limit_is_all_or_nothing_at_one_orientation(shift: float) -> None:
    motor = {"min": -1.0, "max": 0.4 + shift}
    wire = GEARED | {"actuator_limits": [*RAILS, None, None, motor]}
    fixed = LEVEL | {"rz": 0.4}
    free = workspace(GEARED | {"actuator_limits": [*RAILS, *[None] * 3]}, fixed=fixed)
    grid = {"grid": box(0.02, 0.0, 0.0, 0.0)}
    found = answered(workspace(wire, fixed=fixed) | grid)
    inside = answered(free | grid)["inside"]
    assert inside > 100
    assert found["inside"] == (inside if shift > 0 else 0)
    stopped = {(e["reason"], e["leg"]): e["nodes"] for e in found["excluded"]}
    assert stopped["actuator_limits", 5] == inside - found["inside"]


def test_lines_decide_as_nodes_do() -> None:
    limits = [*RAILS, {"min": -0.5, "max": 0.5}, None, None]
    fixed = {"rx": 0.2, "ry": -0.3, "rz": 0.05}
    body = workspace(GEARED | {"actuator_limits": limits}, grid=box(0.013, 0, 0, 0), fixed=fixed)
    request = parsed(body)
    assert isinstance(request, WorkspaceRequest)
    s = set_up(request)
    both = [
        scan(s.mechanism, s.conditions, s.grid, {}, 0, s.grid.size, by_lines=by_lines)
        for by_lines in (True, False)
    ]
    by_lines, by_nodes = (np.repeat(one.codes, one.lengths) for one in both)
    assert np.array_equal(by_lines, by_nodes)


@pytest.mark.parametrize("every", [False, True])
def test_orientations_of_a_range_are_those_that_motors_allow(*, every: bool) -> None:
    """rz from -0.5 to 1 with D3 stopped at 0.3: some orientations hold, never all of them."""
    limits = [*RAILS, None, None, {"min": -10.0, "max": 0.3}]
    wire = GEARED | {"actuator_limits": limits, "tool_offset": 0.2}
    asked = {
        "type": "orientation_range" if every else "inclusive_orientation",
        "orientation_range": [{"coordinate": "rz", "min": -0.5, "max": 1.0}],
        "fixed": {"rx": 0.0, "ry": 0.1},
        "grid": box(0.04, 0.1, 0.0, 0.0),
    }
    found = codes(workspace(wire) | asked) == 0
    if every:
        assert not found.any()
        return
    each = [
        codes(
            workspace(wire, grid=asked["grid"], fixed={"rx": 0.0, "ry": 0.1, "rz": float(turned)})
        )
        == 0
        for turned in np.linspace(-0.5, 0.3, 161)
    ]
    expected = np.logical_or.reduce(each)
    assert 20 < expected.sum() < 0.9 * expected.size
    assert np.all(found[expected])
    # Sampled angles miss slivers; nothing may be added beyond half a step of turning.
    assert (found & ~expected).sum() <= 0.02 * expected.sum()


def test_the_maximal_workspace_is_the_tools_sphere_about_the_centres() -> None:
    """Motors without stops let the tool point anywhere, so a node is in where a centre is near."""
    wire = GEARED | {"actuator_limits": [*RAILS, *[None] * 3], "tool_offset": 0.1}
    nodes = [[0.02, 0.01, -0.1], [0.26, 0.0, -0.1], [0.0, 0.3, 0.0], [0.0, -0.2, 0.14]]
    random = np.random.default_rng(0)
    tips = random.normal(size=(4000, 3))
    tips *= 0.1 / np.linalg.norm(tips, axis=1, keepdims=True)
    for node in nodes:
        grid = [
            {"coordinate": c, "min": at, "max": at, "step": 1.0}
            for c, at in zip("xyz", node, strict=True)
        ]
        found = answered(workspace(wire, type="maximal", grid=grid, fixed={}))["inside"]
        centres = [[*c, 0.0, 0.0, 0.0] for c in (np.array(node) - tips)]
        inverse = {"analysis": "inverse_kinematics", "poses": centres}
        wire_at_centre = wire | {"tool_offset": 0.0}
        held = answered(inverse | {"mechanism": wire_at_centre})["reachable"]
        assert found == int(any(held))


@pytest.mark.parametrize("kind", ["maximal", "full"])
def test_a_turn_about_the_tools_line_is_tried_once(kind: str) -> None:
    """It changes nothing but motors, so without their limits one angle stands for all."""
    asked: dict[str, Any] = {"type": kind, "grid": box(0.1, 0.0, 0.0, 0.0), "fixed": {}}
    asked["orientation_range"] = [{"coordinate": c, "step": 0.8} for c in ("rx", "ry", "rz")]
    wide = {"min": -1e9, "max": 1e9}
    every = codes(workspace(GEARED | {"actuator_limits": [*RAILS, wide, None, None]}) | asked) == 0
    body = workspace(GEARED | {"actuator_limits": [*RAILS, None, None, None]}) | asked
    found = codes(body) == 0
    assert found.any()
    assert np.array_equal(found, every)
    told = {entry["coordinate"]: entry["count"] for entry in answered(body)["orientations"]}
    assert told == {"rx": 1, "ry": 5, "rz": None}


@pytest.mark.parametrize("cls", ["theoretical", "constructive"])
def test_upright_rails_have_no_geometry(cls: str) -> None:
    """Without stops the region has no end, with them it is cut along spheres; as of a Delta."""
    limits = {"actuator_limits": [*RAILS, *[None] * 3]}
    body = workspace(GEARED | limits, grid=box(0.02, 0, 0, 0), fixed=LEVEL, method="geometric")
    assert "/method" in refused(body | {"class": cls})


@pytest.mark.parametrize("bound", ["max_effort", "max_actuator_speed"])
def test_one_bound_cannot_be_that_of_rails_and_motors(bound: str) -> None:
    effective = {bound: 5.0, "load": {"force": 1.0}, "platform_speed": {"linear": 1.0}}
    body = workspace(GEARED, grid=box(0.02, 0, 0, 0), fixed=LEVEL)
    told = refused(body | {"class": "effective", "effective": effective})
    assert f"/effective/{bound}" in told
    assert "per drive" in told


def test_the_kind_tells_of_rails_and_motors() -> None:
    kind = analyses.offered_kind("geared_decoupled")
    assert kind.motion == "spatial"
    assert kind.coordinates == ["x", "y", "z", "rx", "ry", "rz"]
    assert kind.drives == ["rail"] * 3 + ["motor"] * 3


def test_a_motor_has_one_working_mode() -> None:
    told = refused(
        {
            "analysis": "inverse_kinematics",
            "mechanism": GEARED,
            "poses": [[0.0] * 6],
            "working_mode": [1, 1, 1, 1, 1, -1],
        }
    )
    assert "/working_mode" in told
    assert "motor" in told


def test_all_working_modes_are_those_of_the_rails() -> None:
    body = {"analysis": "inverse_kinematics", "mechanism": GEARED, "poses": [[0.0] * 6]}
    found = answered(body | {"working_mode": "all"})
    assert found["working_modes"] == [[*s, 1, 1, 1] for s in product((1, -1), repeat=3)]
    assert np.array(found["actuators"]).shape == (8, 1, 6)


def test_many_rows_of_drives_are_answered_at_once() -> None:
    """Motors cost no more than three spheres do: they have two modes, not forty."""
    body = {"analysis": "forward_kinematics", "mechanism": GEARED}
    assert analyses.estimate(parsed(body | {"actuators": [[0.2] * 6] * 1000}), 0.5).mode == "sync"


def test_parallel_rods_are_named() -> None:
    wire = GEARED | {"platform_radius": 0.33 - 0.022}
    told = refused({"analysis": "inverse_kinematics", "mechanism": wire, "poses": [[0.0] * 6]})
    assert "rail_radius less carriage_arm must differ from platform_radius" in told


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"actuator_limits": {"min": 0.0, "max": 1.0}}, "actuator_limits"),
        ({"actuator_limits": RAILS}, "actuator_limits"),
        ({"working_mode": [1, 1, 1]}, "working_mode"),
        ({"wrist": {**WRIST, "kp": 0.0}}, "kp"),
        ({"wrist": {"k1": 1.0, "k2": 1.0, "kp": 1.0}}, "k_gamma"),
    ],
)
def test_nonsense_is_named(change: dict[str, Any], place: str) -> None:
    body = {"analysis": "inverse_kinematics", "mechanism": GEARED | change, "poses": [[0.0] * 6]}
    with pytest.raises(ValueError, match=place):
        parse_request(json.dumps(body))
