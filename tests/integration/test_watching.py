"""A job from its submission to its end, as its client sees it."""

import json
import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import httpx

from tests.integration.servers import Server
from tests.integration.studies import PRINTER, SMALL, workspace

Event = tuple[str, str, dict[str, Any]]
LONGER = workspace(0.001)


def events(server: Server, job: dict[str, Any], **headers: str) -> list[Event]:
    """Return the events of a job until they end: kind, id and the job that each tells."""
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    with server.client.stream("GET", job["links"]["events"], headers=named) as stream:
        assert stream.headers["content-type"].startswith("text/event-stream")
        return list(_parsed(stream))


def _parsed(stream: httpx.Response) -> Any:  # noqa: ANN401
    event: dict[str, str] = {}
    for line in stream.iter_lines():
        name, _, value = line.partition(":")
        if name:
            event[name] = value.strip()
        elif "event" in event:
            yield event["event"], event["id"], json.loads(event["data"])
            event = {}


def test_a_job_succeeds(server: Server) -> None:
    job = server.done(SMALL)
    assert job["progress"] == {"done": 3321, "total": 3321, "fraction": 1.0}
    assert job["attempt"] == 1
    assert job["created"] <= job["started"] <= job["finished"]
    assert job["error"] is None


def test_waiting_returns_as_soon_as_the_job_ends(server: Server) -> None:
    begun = time.monotonic()
    job = server.look(server.submit(SMALL), wait=60)
    assert job["state"] == "successful"
    assert time.monotonic() - begun < 30


def test_the_events_lead_from_submission_to_success(server: Server) -> None:
    told = events(server, server.submit(LONGER))
    states = [job["state"] for kind, _, job in told if kind == "state"]
    assert states[-1] == "successful"
    assert states == sorted(states, key=["accepted", "running", "successful"].index)
    assert [kind for kind, _, _ in told].count("progress") > 0


def test_progress_only_grows(server: Server) -> None:
    done = [job["progress"]["done"] for _, _, job in events(server, server.submit(LONGER))]
    assert done == sorted(done)
    assert len(set(done)) > 2


def test_the_last_event_tells_what_the_job_says(server: Server) -> None:
    job = server.submit(SMALL)
    assert events(server, job)[-1][2] == server.look(job)


def test_events_have_ids_of_their_own(server: Server) -> None:
    ids = [identifier for _, identifier, _ in events(server, server.submit(LONGER))]
    assert len(set(ids)) == len(ids)


def test_who_resumes_after_the_last_event_misses_and_repeats_nothing(server: Server) -> None:
    job = server.submit(SMALL)
    told = events(server, job)
    assert events(server, job, Last_Event_ID=told[-1][1]) == []
    resumed = events(server, job, Last_Event_ID=told[0][1])
    assert [document for _, _, document in resumed] == [told[-1][2]]


def test_two_jobs_at_once_both_go_on(server: Server) -> None:
    first, second = server.submit(LONGER), server.submit(LONGER)
    ends = [server.wait_for_end(job) for job in (first, second)]
    assert [job["state"] for job in ends] == ["successful"] * 2
    assert ends[1]["started"] < ends[0]["finished"]


def test_a_small_job_does_not_wait_for_a_large_one(server: Server) -> None:
    large = server.submit(workspace(0.001))
    server.wait_for_progress(large)
    small = server.done(SMALL)
    end = server.wait_for_end(large)
    assert end["state"] == "successful"
    assert small["finished"] < end["finished"]


def test_many_at_once_each_get_their_own_answer(server: Server) -> None:
    requests = [
        workspace(0.01, effective={"load": {"force": f}, "max_effort": 9.0})
        for f in (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
    ]

    def greatest(request: dict[str, Any]) -> float:
        job = server.done(request)
        result = server.client.get(job["links"]["result"]).json()
        return float(result["fields"]["effort_max"]["max"])

    with ThreadPoolExecutor(6) as pool:
        found = list(pool.map(greatest, requests))
    assert found == sorted(found)
    assert len(set(found)) == 6


def test_a_direct_answer_is_the_jobs_result(server: Server) -> None:
    direct = server.client.post("/v1/analyses", json=SMALL)
    job = server.done(SMALL)
    assert server.client.get(job["links"]["result"]).content == direct.content


def test_poses_are_answered_by_a_job_as_directly(server: Server) -> None:
    request = {
        "analysis": "effort",
        "mechanism": PRINTER,
        "poses": [[0.001 * i, 0.2] for i in range(500)],
        "load": {"force": 1.0},
    }
    direct = server.client.post("/v1/analyses", json=request)
    job = server.done(request)
    assert server.client.get(job["links"]["result"]).content == direct.content
    assert server.client.get(job["links"]["self"] + "/grid").json()["type"].endswith("no-grid")


def test_what_passes_the_budget_ends_as_a_job(server: Server) -> None:
    answer = server.client.post("/v1/analyses", json=LONGER)
    assert answer.status_code == 202
    assert server.wait_for_end(answer.json())["state"] == "successful"


def test_a_stored_mechanism_is_found_again_by_its_jobs(server: Server) -> None:
    mechanism = PRINTER | {"name": "found again"}
    identifier = server.client.post("/v1/mechanisms", json=mechanism).json()["id"]
    job = server.done(SMALL | {"mechanism": {"kind": "stored", "id": identifier}})
    found = server.client.get("/v1/jobs", params={"mechanism": identifier}).json()["items"]
    assert [item["id"] for item in found] == [job["id"]]
