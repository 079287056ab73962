"""`/v1/jobs`, as far as jobs go without a worker."""

import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from typing import Any

import httpx
import pytest

from tests.service.bodies import EFFORT, FIVE_BAR, INVERSE, PLANAR_3RRR, WORKSPACE
from tests.service.services import Service, assert_problem

FIELDS = {
    "id",
    "analysis",
    "mechanism",
    "state",
    "progress",
    "attempt",
    "created",
    "started",
    "finished",
    "error",
    "links",
}


def submit(api: Service, body: dict[str, Any] = INVERSE) -> dict[str, Any]:
    answer = api.post("/v1/jobs", body)
    assert answer.status_code == 201
    job: dict[str, Any] = answer.json()
    return job


def cancelled(api: Service) -> dict[str, Any]:
    answer = api.client.post(submit(api)["links"]["cancel"])
    job: dict[str, Any] = answer.json()
    return job


def test_a_job_is_created_at_its_location(api: Service) -> None:
    answer = api.post("/v1/jobs", WORKSPACE)
    assert answer.status_code == 201
    assert api.get(answer.headers["Location"]).json() == answer.json()


def test_a_new_job_says_all_of_itself(api: Service) -> None:
    job = submit(api, WORKSPACE)
    assert job.keys() == FIELDS
    assert job["analysis"] == "workspace"
    assert job["state"] == "accepted"
    assert job["progress"] == {"done": 0, "total": 15, "fraction": 0.0}
    assert job["attempt"] == 0
    assert (job["started"], job["finished"], job["error"]) == (None, None, None)


def test_times_name_their_zone(api: Service) -> None:
    created = datetime.fromisoformat(submit(api)["created"])
    assert created.utcoffset() is not None
    assert abs(created.timestamp() - time.time()) < 60


def test_a_workspace_links_to_grid_and_figure(api: Service) -> None:
    job = submit(api, WORKSPACE)
    here = f"/v1/jobs/{job['id']}"
    assert job["links"] == {
        "self": here,
        "events": f"{here}/events",
        "cancel": f"{here}/cancel",
        "result": f"{here}/result",
        "grid": f"{here}/grid",
        "figure": f"{here}/figure",
    }


def test_what_has_no_grid_links_to_none(api: Service) -> None:
    links = submit(api, INVERSE)["links"]
    assert (links["grid"], links["figure"]) == (None, None)


def test_a_job_names_the_mechanism_that_would_be_stored(api: Service) -> None:
    job = submit(api)
    assert job["mechanism"] == api.post("/v1/mechanisms", FIVE_BAR).json()["id"]


def test_two_jobs_of_one_body_are_two(api: Service) -> None:
    assert submit(api)["id"] != submit(api)["id"]


def test_a_job_survives_a_restart(start: Callable[..., Service], api: Service) -> None:
    job = submit(api)
    assert start().get(job["links"]["self"]).json() == job


def test_the_same_key_and_body_give_the_same_job(api: Service) -> None:
    first = api.post("/v1/jobs", INVERSE, Idempotency_Key="one")
    again = api.post("/v1/jobs", INVERSE, Idempotency_Key="one")
    assert (first.status_code, again.status_code) == (201, 200)
    assert again.json() == first.json()
    assert again.headers["Location"] == first.headers["Location"]
    assert api.rows()["jobs"] == 1


def test_the_same_key_and_meaning_give_the_same_job(api: Service) -> None:
    first = api.post("/v1/jobs", INVERSE, Idempotency_Key="one")
    body = dict(reversed(INVERSE.items())) | {"working_mode": None, "poses": [[0, 0.9]]}
    assert api.post("/v1/jobs", body, Idempotency_Key="one").json() == first.json()


def test_the_same_key_with_another_body_is_refused(api: Service) -> None:
    api.post("/v1/jobs", INVERSE, Idempotency_Key="one")
    before = api.rows()
    answer = api.post("/v1/jobs", EFFORT, Idempotency_Key="one")
    assert_problem(answer, 422, "header:idempotency-key")
    assert api.rows() == before


def test_another_key_gives_another_job(api: Service) -> None:
    first = api.post("/v1/jobs", INVERSE, Idempotency_Key="one")
    assert api.post("/v1/jobs", INVERSE, Idempotency_Key="two").json() != first.json()


def test_a_key_at_once_from_many_gives_one_job(api: Service) -> None:
    def post(_: int) -> httpx.Response:
        return api.post("/v1/jobs", INVERSE, Idempotency_Key="one")

    with ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(post, range(8)))
    assert sorted(answer.status_code for answer in answers) == [200] * 7 + [201]
    assert len({answer.json()["id"] for answer in answers}) == 1


def test_a_key_of_a_removed_job_is_free(api: Service) -> None:
    first = api.post("/v1/jobs", INVERSE, Idempotency_Key="one").json()
    api.client.post(first["links"]["cancel"])
    api.client.delete(first["links"]["self"])
    assert api.post("/v1/jobs", EFFORT, Idempotency_Key="one").status_code == 201


def test_an_empty_key_is_no_key_or_refused(api: Service) -> None:
    first, second = (api.post("/v1/jobs", body, Idempotency_Key="") for body in (INVERSE, EFFORT))
    assert first.status_code == second.status_code


def test_a_full_queue_refuses_for_now(start: Callable[..., Service]) -> None:
    api = start(queue_limit=2)
    submit(api)
    submit(api)
    before = api.rows()
    answer = api.post("/v1/jobs", INVERSE, Idempotency_Key="one")
    assert_problem(answer, 503)
    assert int(answer.headers["Retry-After"]) > 0
    assert api.rows() == before


def test_a_full_queue_refuses_what_an_analysis_would_put_there(
    start: Callable[..., Service],
) -> None:
    api = start(queue_limit=1)
    submit(api)
    answer = api.post("/v1/analyses", INVERSE, Prefer="respond-async")
    assert_problem(answer, 503)
    assert "Retry-After" in answer.headers


def test_a_full_queue_still_answers_a_repeated_key(start: Callable[..., Service]) -> None:
    api = start(queue_limit=1)
    first = api.post("/v1/jobs", INVERSE, Idempotency_Key="one")
    again = api.post("/v1/jobs", INVERSE, Idempotency_Key="one")
    assert again.json() == first.json()


def test_a_cancelled_job_makes_room(start: Callable[..., Service]) -> None:
    api = start(queue_limit=1)
    cancelled(api)
    submit(api)


def test_the_list_has_the_newest_first(api: Service) -> None:
    jobs = [submit(api) for _ in range(3)]
    assert api.get("/v1/jobs").json() == {"items": jobs[::-1], "next_page_token": None}


@pytest.mark.parametrize("size", [1, 2, 3, 5, 6])
def test_pages_have_every_job_once(api: Service, size: int) -> None:
    jobs = [submit(api) for _ in range(5)]
    found: list[dict[str, Any]] = []
    parameters: dict[str, Any] = {"page_size": size}
    while True:
        page = api.get("/v1/jobs", params=parameters).json()
        assert len(page["items"]) <= size
        found += page["items"]
        if page["next_page_token"] is None:
            break
        parameters["page_token"] = page["next_page_token"]
    assert found == jobs[::-1]


def test_a_list_is_filtered_by_state(api: Service) -> None:
    stopped, waiting = cancelled(api), submit(api)
    assert api.get("/v1/jobs?state=cancelled").json()["items"] == [stopped]
    assert api.get("/v1/jobs?state=accepted").json()["items"] == [waiting]
    assert api.get("/v1/jobs?state=failed").json()["items"] == []


def test_a_list_is_filtered_by_analysis(api: Service) -> None:
    inverse, effort = submit(api, INVERSE), submit(api, EFFORT)
    assert api.get("/v1/jobs?analysis=inverse_kinematics").json()["items"] == [inverse]
    assert api.get("/v1/jobs?analysis=effort").json()["items"] == [effort]
    assert api.get("/v1/jobs?analysis=workspace").json()["items"] == []


def test_a_list_is_filtered_by_mechanism(api: Service) -> None:
    five_bar = submit(api)
    other = {"mechanism": PLANAR_3RRR, "poses": [[0.0, 0.0, 0.0]]}
    planar = submit(api, INVERSE | other)
    for job in (five_bar, planar):
        found = api.get("/v1/jobs", params={"mechanism": job["mechanism"]}).json()["items"]
        assert found == [job]


def test_filters_hold_together(api: Service) -> None:
    cancelled(api)
    submit(api, EFFORT)
    wanted = submit(api)
    query = {"state": "accepted", "analysis": "inverse_kinematics"}
    assert api.get("/v1/jobs", params=query).json()["items"] == [wanted]


def test_pages_keep_the_filter(api: Service) -> None:
    efforts = [submit(api, body) for body in (EFFORT, INVERSE, EFFORT)][::2]
    query: dict[str, Any] = {"analysis": "effort", "page_size": 1}
    first = api.get("/v1/jobs", params=query).json()
    second = api.get("/v1/jobs", params=query | {"page_token": first["next_page_token"]}).json()
    assert first["items"] + second["items"] == efforts[::-1]
    assert second["next_page_token"] is None


def test_an_unknown_state_is_refused(refusing: Service) -> None:
    assert_problem(refusing.get("/v1/jobs?state=asleep"), 422, "?state")


@pytest.mark.parametrize("size", ["0", "-1", "501", "many", "1e400", "99999999999999999999"])
def test_a_page_size_out_of_bounds_is_refused(refusing: Service, size: str) -> None:
    assert_problem(refusing.get("/v1/jobs", params={"page_size": size}), 422, "?page_size")


def test_a_waiting_job_is_cancelled_at_once(api: Service) -> None:
    job = cancelled(api)
    assert job["state"] == "cancelled"
    assert job["finished"] is not None
    assert api.get(job["links"]["self"]).json() == job


def test_cancelling_twice_changes_nothing(api: Service) -> None:
    job = cancelled(api)
    again = api.client.post(job["links"]["cancel"])
    assert (again.status_code, again.json()) == (200, job)


def test_a_waiting_job_is_not_removed(api: Service) -> None:
    job = submit(api)
    assert_problem(api.client.delete(job["links"]["self"]), 409)
    assert api.get(job["links"]["self"]).json() == job


def test_an_ended_job_is_removed(api: Service) -> None:
    job = cancelled(api)
    removed = api.client.delete(job["links"]["self"])
    assert (removed.status_code, removed.content) == (204, b"")
    assert_problem(api.get(job["links"]["self"]), 404)
    assert api.rows()["jobs"] == api.rows()["requests"] == 0


@pytest.mark.parametrize("what", ["result", "grid", "figure"])
def test_what_is_not_ready_is_said_so(api: Service, what: str) -> None:
    answer = api.get(submit(api, WORKSPACE)["links"][what])
    assert_problem(answer, 404)
    assert answer.json()["type"].endswith("result-not-ready")


@pytest.mark.parametrize("what", ["result", "grid", "figure"])
def test_what_was_cancelled_has_no_result(api: Service, what: str) -> None:
    job = submit(api, WORKSPACE)
    api.client.post(job["links"]["cancel"])
    answer = api.get(job["links"][what])
    assert_problem(answer, 404)
    assert answer.json()["type"].endswith("job-cancelled")


def test_waiting_returns_in_time(api: Service) -> None:
    job = submit(api)
    begun = time.monotonic()
    waited = api.get(job["links"]["self"], params={"wait": 0.5}).json()
    assert 0.45 <= time.monotonic() - begun < 5.0
    assert waited == job


def test_waiting_ends_with_the_job(api: Service) -> None:
    job = submit(api)
    with ThreadPoolExecutor(1) as pool:
        waited = pool.submit(api.get, job["links"]["self"], params={"wait": 30})
        time.sleep(0.3)
        begun = time.monotonic()
        stopped = api.client.post(job["links"]["cancel"]).json()
        assert waited.result().json() == stopped
        assert time.monotonic() - begun < 5.0


def test_nobody_waits_for_an_ended_job(api: Service) -> None:
    job = cancelled(api)
    begun = time.monotonic()
    api.get(job["links"]["self"], params={"wait": 30})
    assert time.monotonic() - begun < 5.0


@pytest.mark.parametrize("wait", ["-1", "61", "nan", "inf", "1e400", "long"])
def test_a_wait_out_of_bounds_is_refused(api: Service, wait: str) -> None:
    answer = api.get(submit(api)["links"]["self"], params={"wait": wait})
    assert_problem(answer, 422, "?wait")


def test_the_events_of_an_ended_job_end(api: Service) -> None:
    job = cancelled(api)
    answer = api.get(job["links"]["events"])
    assert answer.status_code == 200
    assert answer.headers["content-type"].startswith("text/event-stream")
    assert answer.text.count("event: state") == 1
    assert '"cancelled"' in answer.text


def test_the_events_end_when_the_job_does(api: Service) -> None:
    job = submit(api)
    with ThreadPoolExecutor(1) as pool:
        stream = pool.submit(api.get, job["links"]["events"])
        time.sleep(0.3)
        api.client.post(job["links"]["cancel"])
        text = stream.result(10).text
    assert text.index('"accepted"') < text.index('"cancelled"')


def test_who_saw_the_last_event_gets_no_other(api: Service) -> None:
    job = cancelled(api)
    text = api.get(job["links"]["events"]).text
    (last,) = [line[4:] for line in text.splitlines() if line.startswith("id: ")]
    again = api.get(job["links"]["events"], headers={"Last-Event-ID": last})
    assert "event:" not in again.text


UNKNOWN = [
    ("GET", ""),
    ("DELETE", ""),
    ("POST", "/cancel"),
    ("GET", "/events"),
    ("GET", "/result"),
    ("GET", "/grid"),
    ("GET", "/figure"),
    ("GET", "?wait=30"),
]


@pytest.mark.parametrize(("method", "path"), UNKNOWN)
@pytest.mark.parametrize("identifier", ["0" * 32, "x", "%00", "%FF", "a" * 3000])
def test_an_unknown_job_is_not_found(
    refusing: Service, method: str, path: str, identifier: str
) -> None:
    assert_problem(refusing.client.request(method, f"/v1/jobs/{identifier}{path}"), 404)
