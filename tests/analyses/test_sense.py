"""Requests of the right shape that make no sense, and the field that is named."""

import json
import re
from typing import Any, get_args

import pytest

import analyses
from analyses.pictures import WorkspacePicture
from analyses.workspace import SECONDS_PER_LEG
from analyses.workspace_bounds import EFFECTIVE_BOUNDS
from schemas.workspace import Reason, WorkspaceRequest

BAR: dict[str, Any] = {
    "kind": "five_bar",
    "base_distance": 0.6,
    "crank_length": 0.5,
    "rod_length": 0.5,
}
TRIANGLE: dict[str, Any] = {
    "kind": "planar_3rrr",
    "base_side": 0.4,
    "platform_radius": 0.08,
    "crank_length": 0.18,
    "rod_length": 0.18,
}


def axis(coordinate: str, least: float = -0.3, step: float = 0.1) -> dict[str, Any]:
    return {"coordinate": coordinate, "min": least, "max": 0.3, "step": step}


def plane(**changes: object) -> dict[str, Any]:
    return {
        "analysis": "workspace",
        "mechanism": BAR,
        "class": "theoretical",
        "type": "constant_orientation",
        "grid": [axis("x"), axis("y")],
        **changes,
    }


def turning(**changes: object) -> dict[str, Any]:
    return plane(**{"mechanism": TRIANGLE, "fixed": {"phi": 0.0}, **changes})


def poses(analysis: str, rows: list[list[float]], **changes: object) -> dict[str, Any]:
    return {"analysis": analysis, "mechanism": BAR, "poses": rows, **changes}


def effort(**changes: object) -> dict[str, Any]:
    return poses("effort", [[0.0, 0.9], [0.0, 0.8]], **changes)


def check(document: dict[str, Any], node_limit: int = 10**6) -> None:
    analyses.check(analyses.parse(json.dumps(document)), node_limit)


def refused(document: dict[str, Any], node_limit: int = 10**6) -> dict[str, str]:
    """Return the complaints by pointer."""
    with pytest.raises(analyses.AnalysisError) as error:
        check(document, node_limit)
    return dict(error.value.errors)


SENSELESS: dict[str, tuple[dict[str, Any], str]] = {
    "unknown coordinate": (plane(grid=[axis("x"), axis("y"), axis("z")]), "/grid/2/coordinate"),
    "coordinate twice": (plane(grid=[axis("x"), axis("y"), axis("x")]), "/grid/2/coordinate"),
    "coordinate nowhere": (plane(grid=[axis("x")]), "/fixed/y"),
    "orientation nowhere": (turning(fixed={}), "/fixed/phi"),
    "fixed and on the grid": (plane(fixed={"x": 0.0}), "/fixed/x"),
    "fixed and unknown": (plane(fixed={"theta": 0.0}), "/fixed/theta"),
    "turn on the grid": (
        turning(grid=[axis("x"), axis("phi")], fixed={"y": 0.0}),
        "/grid/1/coordinate",
    ),
    "too many nodes": (plane(grid=[axis("x", step=1e-4), axis("y", step=1e-4)]), "/grid"),
    "too many efforts": (
        plane(
            **{"class": "effective"},
            effective={"load": {"force": 1.0}, "max_effort": [1.0, 2.0, 3.0]},
        ),
        "/effective/max_effort",
    ),
    "too few efforts": (
        plane(
            **{"class": "effective"},
            effective={"load": {"force": 1.0}, "max_effort": [1.0]},
        ),
        "/effective/max_effort",
    ),
    "effective without a bound": (
        plane(**{"class": "effective"}, effective={"load": {"force": 1.0}}),
        "/effective",
    ),
    "effort field without load": (plane(fields=["effort"]), "/effective/load"),
    "greatest effort field without load": (plane(fields=["effort_max"]), "/effective/load"),
    "mode of a workspace": (plane(working_mode=[1]), "/working_mode"),
    "rods that share no joint": (
        turning(**{"class": "constructive"}, constructive={"min_rod_rod_angle": 0.1}),
        "/constructive/min_rod_rod_angle",
    ),
    "greatest angle of rods that share no joint": (
        turning(**{"class": "constructive"}, constructive={"max_rod_rod_angle": 3.0}),
        "/constructive/max_rod_rod_angle",
    ),
    "wide pose of inverse kinematics": (
        poses("inverse_kinematics", [[0.0, 0.9], [0.0, 0.9, 0.1]]),
        "/poses/1",
    ),
    "narrow pose of effort": (
        poses("effort", [[0.0]], load={"force": 1.0}),
        "/poses/0",
    ),
    "mode of inverse kinematics": (
        poses("inverse_kinematics", [[0.0, 0.9]], working_mode=[1, 1, 1]),
        "/working_mode",
    ),
    "mode of effort": (effort(load={"force": 1.0}, working_mode=[1]), "/working_mode"),
    "too few known forces": (
        effort(known_load={"force": [[1.0, 0.0, 0.0]]}),
        "/known_load/force",
    ),
    "too many known moments": (
        effort(known_load={"moment": [[0.0, 0.0, 1.0]] * 3}),
        "/known_load/moment",
    ),
}


@pytest.mark.parametrize(("document", "pointer"), SENSELESS.values(), ids=SENSELESS.keys())
def test_the_senseless_field_is_named(document: dict[str, Any], pointer: str) -> None:
    assert list(refused(document)) == [pointer]


SENSIBLE: dict[str, dict[str, Any]] = {
    "plane": plane(),
    "turning": turning(),
    "one line": plane(grid=[axis("x")], fixed={"y": 0.5}),
    "one effort for all": plane(
        **{"class": "effective"}, effective={"load": {"force": 1.0}, "max_effort": 2.0}
    ),
    "one effort per leg": plane(
        **{"class": "effective"}, effective={"load": {"force": 1.0}, "max_effort": [2.0, 3.0]}
    ),
    **{
        f"effective by {name} alone": plane(
            **{"class": "effective"}, effective={name: 1.0, **partner}
        )
        for name, partner in {
            "max_pressure_angle": {},
            "min_abs_determinant": {},
            "max_condition_number": {},
            "max_actuator_speed": {"platform_speed": {"linear": 1.0}},
        }.items()
    },
    "cones with their axes": plane(
        **{"class": "constructive"},
        constructive={
            "max_base_joint_angle": 1.0,
            "base_joint_axes": [[1.0, 0.0, 0.0]] * 2,
            "max_platform_joint_angle": 1.0,
            "platform_joint_axes": [[0.0, 1e-6, 0.0], [0.0, 1e6, 0.0]],
        },
    ),
    "a distance of rods": turning(
        **{"class": "constructive"}, constructive={"min_rod_distance": 0.01}
    ),
    "bounds of a higher class": plane(constructive={"min_rod_rod_angle": 0.1}),
    "one known force": effort(known_load={"force": [1.0, 0.0, 0.0]}),
    "a known force per pose": effort(known_load={"force": [[1.0, 0.0, 0.0]] * 2}),
    "known and unknown": effort(load={"force": 1.0}, known_load={"moment": [0.0, 0.0, 1.0]}),
    "all modes": poses("inverse_kinematics", [[0.0, 0.9]], working_mode="all"),
}


@pytest.mark.parametrize("document", SENSIBLE.values(), ids=SENSIBLE.keys())
def test_the_sensible_is_accepted(document: dict[str, Any]) -> None:
    check(document)


@pytest.mark.parametrize(
    "bounds",
    [
        {"max_base_joint_angle": 0.5, "base_joint_axes": [[0.0, 0.0, 1.0]] * 3},
        {"max_platform_joint_angle": 0.5, "platform_joint_axes": [[0.0, 0.0, 1.0]] * 3},
        {"min_rod_distance": 0.01},
        {"min_crank_rod_angle": 0.1},
    ],
)
def test_arcs_have_no_rods(bounds: dict[str, Any]) -> None:
    arcs = dict.fromkeys(("proximal_arc", "distal_arc"), 1.5)
    cones = dict.fromkeys(("base_cone", "platform_cone"), 0.9)
    mechanism = {"kind": "spherical_3rrr", **arcs, **cones}
    assert f"/constructive/{next(iter(bounds))}" in refused(
        plane(mechanism=mechanism, constructive=bounds)
    )


def test_every_bound_of_the_effective_class_is_named() -> None:
    detail = refused(plane(**{"class": "effective"}, effective={}))["/effective"]
    assert all(name in detail for name in EFFECTIVE_BOUNDS)


def test_every_reason_has_a_price() -> None:
    # What home cannot reach is found from runs, not node by node.
    assert set(SECONDS_PER_LEG) == set(get_args(Reason)) - {"component"}


def test_conditions_of_all_legs_name_none() -> None:
    document = plane(
        **{"class": "effective"},
        effective={
            "max_pressure_angle": 1.0,
            "min_abs_determinant": 0.1,
            "max_condition_number": 9.0,
            "max_actuator_speed": 9.0,
            "platform_speed": {"linear": 1.0},
        },
    )
    answer = json.loads(analyses.answer(analyses.parse(json.dumps(document))).model_dump_json())
    assert [(entry["reason"], entry["leg"]) for entry in answer["excluded"]] == [
        ("reach", 0),
        ("reach", 1),
        ("pressure_angle", 0),
        ("pressure_angle", 1),
        ("determinant", None),
        ("condition_number", None),
        ("actuator_speed", 0),
        ("actuator_speed", 1),
    ]


@pytest.mark.parametrize(
    ("field", "bound", "unit"),
    [
        ("condition_number", {"max_condition_number": 1.5}, "-"),
        ("pressure_angle", {"max_pressure_angle": 1.0}, "rad"),
    ],
)
def test_figures_mark_the_bound_of_their_field(
    field: str, bound: dict[str, float], unit: str
) -> None:
    document = plane(**{"class": "effective"}, effective=bound, fields=[field])
    request = analyses.parse(json.dumps(document))
    assert isinstance(request, WorkspaceRequest)
    made = analyses.compute(request, 0, 49)
    picture = analyses.picture(request, lambda: iter([made]), field)
    assert isinstance(picture, WorkspacePicture)
    shown = picture.field
    assert shown is not None
    assert (shown.unit, shown.limit) == (unit, *bound.values())


def test_an_unknown_coordinate_is_told_what_is_allowed() -> None:
    detail = refused(plane(grid=[axis("x"), axis("y"), axis("z")]))["/grid/2/coordinate"]
    assert "'z'" in detail
    assert "x, y" in detail


def test_the_node_limit_is_named() -> None:
    document = plane(grid=[axis("x", step=1e-4), axis("y", step=1e-4)])
    assert "1000000" in refused(document)["/grid"]


def test_a_grid_at_the_limit_is_accepted() -> None:
    check(plane(), 49)


def test_a_grid_one_node_over_the_limit_is_not() -> None:
    assert list(refused(plane(), 48)) == ["/grid"]


@pytest.mark.timeout(5)
@pytest.mark.parametrize(
    ("first", "second", "limit"),
    [
        (1e-4, 1e-4, 10**6),
        (1e-3, 1e-5, 10**5),
        (1e-7, 0.2, 1000),
        (0.07, 0.013, 300),
        (0.1, 0.1, 48),
    ],
)
def test_the_step_that_would_fit_fits(first: float, second: float, limit: int) -> None:
    document = plane(grid=[axis("x", step=first), axis("y", step=second)])
    detail = refused(document, limit)["/grid"]
    x, y = (float(step) for step in re.findall(r"[xy]: ([0-9.e+-]*[0-9])", detail))
    check(plane(grid=[axis("x", step=x), axis("y", step=y)]), limit)


def test_the_step_that_would_fit_is_hardly_too_coarse() -> None:
    detail = refused(plane(grid=[axis("x", step=1e-4), axis("y", step=1e-4)]), 10**6)["/grid"]
    x, y = (float(step) for step in re.findall(r"[xy]: ([0-9.e+-]*[0-9])", detail))
    assert list(refused(plane(grid=[axis("x", step=0.99 * x), axis("y", step=0.99 * y)]))) == [
        "/grid"
    ]


@pytest.mark.timeout(5)
@pytest.mark.parametrize("step", [1e-6, 1e-12])
def test_a_grid_beyond_counting_is_refused_like_any_other(step: float) -> None:
    wide = {"coordinate": "x", "min": -1e12, "max": 1e12, "step": step}
    assert list(refused(plane(grid=[wide, axis("y")]))) == ["/grid"]
