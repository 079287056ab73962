"""Slices: positions and turns on one grid, against every orientation tried alone."""

import json
from itertools import product
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import analyses
from analyses.errors import AnalysisError
from schemas.analyses import parse_request
from schemas.starters import STARTERS
from schemas.workspace import WorkspaceRequest
from schemas.workspace_result import WorkspaceResult

HEXAPOD = {"x": 0.05, "y": -0.1, "z": 0.5, "rx": 0.1, "ry": -0.2, "rz": 0.3}
AXES = {
    "x": {"min": -0.3, "max": 0.3, "step": 0.07},
    "y": {"min": -0.3, "max": 0.3, "step": 0.11},
    "z": {"min": 0.3, "max": 0.8, "step": 0.06},
}
TURN = {"min": -1.2, "max": 1.5, "step": 0.5}
SLICES = [
    ("planar_3rrr", ["phi", "x", "y"], {"x": 0.0, "y": 0.0, "phi": 0.0}),
    ("planar_3rrr", ["x", "phi"], {"x": 0.0, "y": 0.05, "phi": 0.0}),
    ("gough_stewart", ["rx", "z"], HEXAPOD),
    ("gough_stewart", ["x", "rz", "z", "ry"], HEXAPOD),
    ("gough_stewart", ["rx", "ry", "x", "y"], HEXAPOD),
]


def request(name: str, cls: str, **fields: object) -> WorkspaceRequest:
    mechanism = STARTERS[name].model_dump(exclude_none=True)
    if name == "gough_stewart":
        mechanism["actuator_limits"] = {"min": 0.45, "max": 0.7}
    else:
        mechanism["actuator_limits"] = [
            {"min": -0.5, "max": 1.8},
            {"min": 1.0, "max": 4.0},
            {"min": 3.0, "max": 6.5},
        ]
    effective = {"load": {"force": 1.0, "moment": 0.1}, "max_effort": 2.0}
    body = {"analysis": "workspace", "mechanism": mechanism, "class": cls, **fields}
    asked = parse_request(json.dumps({**body, "effective": effective}))
    assert isinstance(asked, WorkspaceRequest)
    analyses.check(asked, 10**9)
    return asked


def axis(name: str) -> dict[str, Any]:
    return {"coordinate": name, **AXES.get(name, TURN)}


def codes(asked: WorkspaceRequest) -> npt.NDArray[np.uint8]:
    tile = analyses.compute(asked, 0, analyses.plan(asked, 1.0).items)
    return np.repeat(tile["codes"], tile["lengths"])


def nodes(name: str) -> list[float]:
    found = axis(name)
    count = int((found["max"] - found["min"]) / found["step"]) + 1
    return [found["min"] + i * found["step"] for i in range(count)]


@pytest.mark.parametrize("cls", ["constructive", "effective"])
@pytest.mark.parametrize(("name", "grid", "rest"), SLICES)
def test_a_slice_is_made_of_the_orientations_alone(
    name: str, grid: list[str], rest: dict[str, float], cls: str
) -> None:
    fixed = {c: value for c, value in rest.items() if c not in grid}
    axes = [axis(c) for c in grid]
    shape = [len(nodes(c)) for c in grid]
    whole = codes(request(name, cls, type="orientation", grid=axes, fixed=fixed)).reshape(shape)
    turns = [c for c in grid if c.startswith(("r", "phi"))]
    places = [c for c in grid if c not in turns]
    expected = np.empty_like(whole)
    for at in product(*(range(len(nodes(c))) for c in turns)):
        turned = {c: nodes(c)[i] for c, i in zip(turns, at, strict=True)}
        own = {"grid": [axis(c) for c in places], "fixed": {**fixed, **turned}}
        found = codes(request(name, cls, type="constant_orientation", **own))
        index = tuple(at[turns.index(c)] if c in turns else slice(None) for c in grid)
        expected[index] = found.reshape([len(nodes(c)) for c in places])
    assert 0 < np.count_nonzero(expected == 0) < expected.size
    np.testing.assert_array_equal(whole, expected)


def test_a_slice_tells_its_measure_in_metres_and_radians() -> None:
    grid = [axis("x"), axis("rz")]
    fixed = {c: value for c, value in HEXAPOD.items() if c not in ("x", "rz")}
    asked = request("gough_stewart", "constructive", type="orientation", grid=grid, fixed=fixed)
    found = analyses.answer(asked)
    assert isinstance(found, WorkspaceResult)
    cell = grid[0]["step"] * grid[1]["step"]
    assert found.measure.value == pytest.approx(np.sum(codes(asked) == 0) * cell, rel=1e-12)
    assert found.measure.unit == "m·rad"


def test_a_constant_orientation_has_no_turn_on_the_grid() -> None:
    grid = [axis("x"), axis("phi")]
    with pytest.raises(AnalysisError) as refused:
        request(
            "planar_3rrr", "theoretical", type="constant_orientation", grid=grid, fixed={"y": 0}
        )
    assert [place for place, _ in refused.value.errors] == ["/grid/1/coordinate"]


def test_positions_alone_are_no_orientations() -> None:
    grid, fixed = [axis("x")], {"y": 0.0, "phi": 0.0}
    with pytest.raises(AnalysisError) as refused:
        request("planar_3rrr", "theoretical", type="orientation", grid=grid, fixed=fixed)
    assert [place for place, _ in refused.value.errors] == ["/grid/0/coordinate"]
