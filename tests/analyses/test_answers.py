"""What answers say beyond their numbers: shapes, nulls, obstacles, tiles of poses."""

import json
import math
from typing import Any

import numpy as np
import pytest

import analyses
from schemas.workspace import WorkspaceRequest

BAR: dict[str, Any] = {
    "kind": "five_bar",
    "base_distance": 6.0,
    "crank_length": 5.0,
    "rod_length": 5.0,
}
# Reachable; leg 0 out of reach; both out of reach; reachable.
POSES = [[0.0, 9.0], [12.0, 0.0], [0.0, 20.0], [1.0, 8.0]]


def ask(**document: object) -> dict[str, Any]:
    request = analyses.parse(json.dumps({"mechanism": BAR, "poses": POSES, **document}))
    analyses.check(request, 10**6)
    answer: dict[str, Any] = json.loads(analyses.answer(request).model_dump_json())
    return answer


def test_reachable_says_which_poses() -> None:
    answer = ask(analysis="inverse_kinematics")
    assert answer["reachable"] == [True, False, False, True]


def test_obstacles_name_pose_and_leg() -> None:
    obstacles = ask(analysis="inverse_kinematics")["obstacles"]
    assert [(o["pose"], o["leg"], o["reason"]) for o in obstacles] == [
        (1, 0, "reach"),
        (2, 0, "reach"),
        (2, 1, "reach"),
    ]


def test_only_the_cell_of_the_leg_is_null() -> None:
    rows = ask(analysis="inverse_kinematics")["actuators"]
    assert [[value is None for value in row] for row in rows] == [
        [False, False],
        [True, False],
        [True, True],
        [False, False],
    ]


def test_what_needs_all_legs_is_a_null_row() -> None:
    rows = ask(analysis="effort", load={"force": 1.0})["effort"]
    assert [[value is None for value in row] for row in rows] == [
        [False, False],
        [True, True],
        [True, True],
        [False, False],
    ]


def test_a_breach_of_a_limit_keeps_its_value() -> None:
    limited = {**BAR, "actuator_limits": [{"min": 2.0, "max": 3.0}, None]}
    answer = ask(analysis="inverse_kinematics", mechanism=limited, poses=[[0.0, 9.0]])
    assert answer["actuators"][0][0] == pytest.approx(math.pi / 2)
    assert answer["reachable"] == [False]
    (obstacle,) = answer["obstacles"]
    assert (obstacle["leg"], obstacle["reason"]) == (0, "actuator_limits")
    assert (obstacle["value"], obstacle["limit"]) == pytest.approx((math.pi / 2, 2.0))


def test_a_limit_whole_turns_away_is_kept() -> None:
    turn = 6 * math.pi
    limited = {**BAR, "actuator_limits": [{"min": turn + 1.0, "max": turn + 2.0}, None]}
    answer = ask(analysis="inverse_kinematics", mechanism=limited, poses=[[0.0, 9.0]])
    assert answer["reachable"] == [True]


def test_a_known_load_alone_gives_signed_efforts() -> None:
    # Pushed to the left, the right-hand rod (-3, 4) / 5 and the left one share the load.
    answer = ask(analysis="effort", poses=[[0.0, 9.0]], known_load={"force": [-1.0, 0.0, 0.0]})
    # Rods push 5/6 and -5/6; levers of the upright cranks are -3 and 3.
    assert answer["effort"][0] == pytest.approx([-2.5, -2.5])
    assert answer["worst_force"] is None


def test_units_of_efforts() -> None:
    assert ask(analysis="effort", load={"force": 1.0})["units"] == ["N·m", "N·m"]


def test_the_request_chooses_the_working_mode() -> None:
    chosen = ask(analysis="effort", load={"force": 1.0}, working_mode=[-1, -1])
    stored = ask(
        analysis="effort", load={"force": 1.0}, mechanism={**BAR, "working_mode": [-1, -1]}
    )
    assert chosen == stored


@pytest.mark.parametrize(
    "question",
    [
        {"analysis": "inverse_kinematics"},
        {"analysis": "inverse_kinematics", "working_mode": "all"},
        {"analysis": "effort", "load": {"force": 2.0, "moment": 1.0}},
        {"analysis": "effort", "known_load": {"force": [[1.0, k, 0.0] for k in range(12)]}},
    ],
    ids=["inverse", "all modes", "worst", "known per pose"],
)
def test_tiles_of_poses_make_the_same_answer(question: dict[str, Any]) -> None:
    document = {"mechanism": BAR, "poses": POSES * 3, **question}
    request = analyses.parse(json.dumps(document))
    tiles = [analyses.compute(request, start, stop) for start, stop in ((0, 5), (5, 6), (6, 12))]
    assert analyses.assemble(request, lambda: tiles) == analyses.answer(request)


def workspace(**changes: object) -> WorkspaceRequest:
    document = {
        "analysis": "workspace",
        "mechanism": BAR,
        "class": "theoretical",
        "type": "constant_orientation",
        "grid": [
            {"coordinate": "y", "min": 0.0, "max": 11.0, "step": 1.0},
            {"coordinate": "x", "min": -12.0, "max": 12.0, "step": 0.5},
        ],
        "fields": ["actuators", "determinant"],
        **changes,
    }
    request = analyses.parse(json.dumps(document))
    assert isinstance(request, WorkspaceRequest)
    return request


def test_arrays_follow_the_axes_of_the_request() -> None:
    request = workspace()
    pieces = [analyses.compute(request, 0, 12 * 49)]
    grid = analyses.dense_grid(request, lambda: iter(pieces))
    shapes = {column.name: column.shape for column in grid.columns}
    assert list(grid.axes) == ["y", "x"]
    assert shapes["inside"] == shapes["reason"] == shapes["determinant"] == (12, 49)
    assert shapes["actuators"] == (12, 49, 2)


def test_reason_0_is_inside() -> None:
    request = workspace()
    pieces = [analyses.compute(request, 0, 12 * 49)]
    grid = analyses.dense_grid(request, lambda: iter(pieces))
    made = {column.name: np.concatenate(list(column.chunks())) for column in grid.columns}
    np.testing.assert_array_equal(made["inside"], made["reason"] == 0)


def test_chunks_start_anew_at_every_call() -> None:
    request = workspace()
    pieces = [analyses.compute(request, 0, 100), analyses.compute(request, 100, 12 * 49)]
    grid = analyses.dense_grid(request, lambda: iter(pieces))
    for column in grid.columns:
        first, second = (np.concatenate(list(column.chunks())) for _ in range(2))
        assert first.tobytes() == second.tobytes()


def test_a_workspace_is_that_of_its_working_mode() -> None:
    request = workspace(working_mode=[-1, 1])
    assert analyses.answer(request).model_dump()["working_mode"] == [-1, 1]


def test_nothing_inside_is_an_answer() -> None:
    far = [
        {"coordinate": "x", "min": 100.0, "max": 101.0, "step": 1.0},
        {"coordinate": "y", "min": 0.0, "max": 1.0, "step": 1.0},
    ]
    answer = json.loads(analyses.answer(workspace(grid=far)).model_dump_json())
    assert (answer["inside"], answer["measure"]["value"], answer["component_count"]) == (0, 0, 0)
    assert (answer["bounds"], answer["centroid"], answer["components"]) == ([], None, [])
    assert answer["fields"]["determinant"]["max"] is None
