"""`/v1/analyses` and `/v1/estimates`."""

from collections.abc import Callable
from typing import Any

import pytest

from schemas.examples import EXAMPLES, Example
from tests.service.bodies import EFFORT, FIVE_BAR, INVERSE, PLANAR_3RRR, WORKSPACE, close, grid
from tests.service.services import Service, assert_problem

BODIES = [INVERSE, EFFORT, WORKSPACE]


def name(body: dict[str, Any] | Example) -> str:
    return str(body["analysis"] if isinstance(body, dict) else body.request.analysis)


@pytest.fixture
def stored(api: Service) -> dict[str, str]:
    """Return a reference to a stored five-bar."""
    identifier = api.post("/v1/mechanisms", FIVE_BAR).json()["id"]
    return {"kind": "stored", "id": identifier}


@pytest.mark.parametrize("example", EXAMPLES, ids=name)
def test_a_worked_example_gives_the_stated_answer(refusing: Service, example: Example) -> None:
    body = example.request.model_dump(mode="json", exclude_defaults=True)
    answer = refusing.post("/v1/analyses", body)
    assert answer.status_code == 200
    assert close(answer.json(), example.answer), answer.json()


@pytest.mark.parametrize("body", BODIES, ids=name)
def test_an_answer_at_once_stores_nothing(refusing: Service, body: dict[str, Any]) -> None:
    before = refusing.rows()
    assert refusing.post("/v1/analyses", body).status_code == 200
    assert refusing.rows() == before


@pytest.mark.parametrize("body", BODIES, ids=name)
def test_a_stored_mechanism_answers_as_an_inline_one(
    api: Service, stored: dict[str, str], body: dict[str, Any]
) -> None:
    inline = api.post("/v1/analyses", body)
    assert api.post("/v1/analyses", body | {"mechanism": stored}).content == inline.content


def test_all_working_modes_are_answered_on_a_leading_axis(refusing: Service) -> None:
    answer = refusing.post("/v1/analyses", INVERSE | {"working_mode": "all"}).json()
    one_by_one = [
        refusing.post("/v1/analyses", INVERSE | {"working_mode": mode}).json()
        for mode in answer["working_modes"]
    ]
    assert sorted(answer["working_modes"]) == [[-1, -1], [-1, 1], [1, -1], [1, 1]]
    assert answer["actuators"] == [one["actuators"] for one in one_by_one]
    assert answer["reachable"] == [one["reachable"] for one in one_by_one]


def test_only_the_unreachable_legs_cell_is_null(refusing: Service) -> None:
    body = INVERSE | {"poses": [[0.9, 0.0]]}
    answer = refusing.post("/v1/analyses", body).json()
    (row,) = answer["actuators"]
    assert row[0] is None
    assert row[1] is not None
    assert [(o["pose"], o["leg"], o["reason"]) for o in answer["obstacles"]] == [(0, 0, "reach")]


def test_a_drive_beyond_its_limit_keeps_its_value(refusing: Service) -> None:
    limited = FIVE_BAR | {"actuator_limits": [{"min": 0.0, "max": 1.0}, None]}
    free = refusing.post("/v1/analyses", INVERSE).json()
    answer = refusing.post("/v1/analyses", INVERSE | {"mechanism": limited}).json()
    assert answer["actuators"] == free["actuators"]
    assert answer["reachable"] == [False]
    (obstacle,) = answer["obstacles"]
    assert (obstacle["leg"], obstacle["reason"]) == (0, "actuator_limits")
    assert (obstacle["value"], obstacle["limit"]) == (answer["actuators"][0][0], 1.0)


def test_an_effort_out_of_reach_is_a_null_row(refusing: Service) -> None:
    answer = refusing.post("/v1/analyses", EFFORT | {"poses": [[0.0, 0.9], [0.9, 0.0]]}).json()
    assert None not in answer["effort"][0]
    assert answer["effort"][1] == [None, None]


def test_a_known_load_alone_gives_signed_efforts(refusing: Service) -> None:
    body = {key: value for key, value in EFFORT.items() if key != "load"}
    body |= {"poses": [[0.0, 0.9]] * 2, "known_load": {"force": [[0, 1, 0], [0, -1, 0]]}}
    up, down = refusing.post("/v1/analyses", body).json()["effort"]
    assert up == [-effort for effort in down]
    assert all(up)


@pytest.mark.parametrize("body", BODIES, ids=name)
def test_a_caller_who_prefers_a_job_gets_one(api: Service, body: dict[str, Any]) -> None:
    answer = api.post("/v1/analyses", body, Prefer="respond-async")
    assert answer.status_code == 202
    assert answer.headers["Preference-Applied"] == "respond-async"
    assert answer.json() == api.get(answer.headers["Location"]).json()
    assert answer.json()["state"] == "accepted"


def test_a_preference_among_others_is_heard(api: Service) -> None:
    answer = api.post("/v1/analyses", INVERSE, Prefer="wait=10, Respond-Async")
    assert answer.status_code == 202


def test_another_preference_changes_nothing(refusing: Service) -> None:
    assert refusing.post("/v1/analyses", INVERSE, Prefer="wait=10").status_code == 200


@pytest.mark.parametrize("body", BODIES, ids=name)
def test_what_passes_the_budget_becomes_a_job(
    start: Callable[..., Service], body: dict[str, Any]
) -> None:
    api = start(synchronous_seconds=0.0)
    answer = api.post("/v1/analyses", body)
    assert answer.status_code == 202
    assert api.get(answer.headers["Location"]).json()["analysis"] == body["analysis"]


def test_a_job_from_an_analysis_honours_the_idempotency_key(api: Service) -> None:
    headers = {"Prefer": "respond-async", "Idempotency_Key": "one"}
    first, again = (api.post("/v1/analyses", INVERSE, **headers) for _ in range(2))
    assert first.headers["Location"] == again.headers["Location"]
    assert api.rows()["jobs"] == 1


@pytest.mark.parametrize("body", BODIES, ids=name)
def test_a_light_request_is_estimated_as_sync(refusing: Service, body: dict[str, Any]) -> None:
    answer = refusing.post("/v1/estimates", body)
    estimate = answer.json()
    assert answer.status_code == 200
    assert estimate.keys() == {"nodes", "seconds", "bytes", "mode"}
    assert estimate["mode"] == "sync"
    assert estimate["seconds"] > 0
    assert estimate["bytes"] > 0


def test_the_mode_follows_the_budget(start: Callable[..., Service]) -> None:
    assert start(synchronous_seconds=0.0).post("/v1/estimates", INVERSE).json()["mode"] == "job"


def test_a_heavy_request_is_estimated_as_job(refusing: Service) -> None:
    body = WORKSPACE | {"grid": grid(0.0001), "fields": ["condition_number"]}
    estimate = refusing.post("/v1/estimates", body).json()
    assert (estimate["nodes"], estimate["mode"]) == (20001 * 20001, "job")


def test_poses_are_counted(refusing: Service) -> None:
    body = INVERSE | {"poses": [[0.0, 0.9]] * 7}
    assert refusing.post("/v1/estimates", body).json()["nodes"] == 7


def test_an_estimate_stores_nothing(refusing: Service) -> None:
    before = refusing.rows()
    refusing.post("/v1/estimates", WORKSPACE | {"grid": grid(0.0001)})
    assert refusing.rows() == before


def test_an_estimate_takes_a_stored_mechanism(api: Service, stored: dict[str, str]) -> None:
    inline = api.post("/v1/estimates", EFFORT).json()
    assert api.post("/v1/estimates", EFFORT | {"mechanism": stored}).json() == inline


@pytest.mark.parametrize("path", ["/v1/analyses", "/v1/estimates", "/v1/jobs"])
def test_a_removed_mechanism_is_named(api: Service, stored: dict[str, str], path: str) -> None:
    api.client.delete(f"/v1/mechanisms/{stored['id']}")
    answer = api.post(path, INVERSE | {"mechanism": stored})
    assert_problem(answer, 422, "/mechanism/id")
    assert stored["id"] in answer.json()["detail"]


def test_a_workspace_with_fixed_orientation_is_answered(refusing: Service) -> None:
    body = WORKSPACE | {"mechanism": PLANAR_3RRR, "fixed": {"phi": 0.0}}
    answer = refusing.post("/v1/analyses", body)
    assert answer.status_code == 200
    assert sum(entry["nodes"] for entry in answer.json()["excluded"]) == (
        answer.json()["nodes"] - answer.json()["inside"]
    )


def test_blocks_of_a_higher_class_are_not_applied(refusing: Service) -> None:
    more = {"constructive": {"min_crank_rod_angle": 3.0}, "effective": {"load": {"force": 1}}}
    plain = refusing.post("/v1/analyses", WORKSPACE)
    assert refusing.post("/v1/analyses", WORKSPACE | more).content == plain.content
