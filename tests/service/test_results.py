"""What became of jobs, where this process plays the engine."""

from collections.abc import Callable
from typing import Any

import pytest

from storage import ErrorKind, Fault, JobError
from tests.service.bodies import INVERSE, WORKSPACE
from tests.service.services import Service, assert_problem, claimed

STATUS = {
    ErrorKind.USER: 422,
    ErrorKind.TIMEOUT: 504,
    ErrorKind.MEMORY: 507,
    ErrorKind.SYSTEM: 500,
    ErrorKind.LOST: 500,
}


def failed(api: Service, kind: ErrorKind) -> str:
    """Return the address of a job that failed."""
    queue, job = claimed(api, WORKSPACE)
    queue.fail(job, JobError(kind, "it went wrong", (Fault("/grid", "far too fine"),)))
    return f"/v1/jobs/{job.id}"


def test_a_job_that_is_run_says_so(api: Service) -> None:
    _, job = claimed(api, WORKSPACE)
    now = api.get(f"/v1/jobs/{job.id}").json()
    assert (now["state"], now["attempt"]) == ("running", 1)
    assert now["started"] is not None


def test_a_running_job_that_is_to_stop_still_runs(api: Service) -> None:
    _, job = claimed(api, WORKSPACE)
    answers = [api.client.post(f"/v1/jobs/{job.id}/cancel") for _ in range(2)]
    assert [answer.status_code for answer in answers] == [200, 200]
    assert answers[0].json() == answers[1].json()
    assert answers[0].json()["state"] == "running"


def test_a_running_job_is_not_removed(api: Service) -> None:
    _, job = claimed(api, WORKSPACE)
    assert_problem(api.client.delete(f"/v1/jobs/{job.id}"), 409)


def test_a_result_is_the_direct_answer(api: Service, run: Callable[..., dict[str, Any]]) -> None:
    job = run(WORKSPACE)
    direct = api.post("/v1/analyses", WORKSPACE)
    assert api.get(job["links"]["result"]).content == direct.content


@pytest.mark.parametrize("what", ["grid", "figure"])
def test_what_has_no_grid_and_no_figure_says_so(
    api: Service, run: Callable[..., dict[str, Any]], what: str
) -> None:
    answer = api.get(run(INVERSE)["links"]["self"] + f"/{what}")
    assert_problem(answer, 404)
    assert answer.json()["type"].endswith(f"no-{what}")


def test_one_axis_is_a_figure(api: Service, run: Callable[..., dict[str, Any]]) -> None:
    line = [WORKSPACE["grid"][0]]
    job = run(WORKSPACE | {"grid": line, "fixed": {"y": 0.3}})
    assert api.get(job["links"]["figure"]).status_code == 200


def test_a_file_is_not_made_for_an_unknown_field(
    api: Service, run: Callable[..., dict[str, Any]]
) -> None:
    job = run(WORKSPACE)
    answer = api.get(job["links"]["figure"], params={"field": "../../outside"})
    assert_problem(answer, 422, "?field")
    assert not any(api.settings.data.rglob("*outside*"))


@pytest.mark.parametrize("form", ["*", "W/{}", '"other", {}'])
def test_a_grid_that_is_known_is_not_sent_again(
    api: Service, run: Callable[..., dict[str, Any]], form: str
) -> None:
    grid = run(WORKSPACE)["links"]["grid"]
    known = form.format(api.get(grid).headers["ETag"])
    assert api.get(grid, headers={"If-None-Match": known}).status_code == 304


@pytest.mark.parametrize("kind", ErrorKind)
@pytest.mark.parametrize("what", ["result", "grid", "figure"])
def test_a_failed_job_answers_with_its_problem(api: Service, kind: ErrorKind, what: str) -> None:
    answer = api.get(f"{failed(api, kind)}/{what}")
    assert_problem(answer, STATUS[kind], "/grid")
    assert answer.json()["detail"] == "it went wrong"
    assert answer.json()["type"].endswith(f"job-{kind.value}")


@pytest.mark.parametrize("kind", ErrorKind)
def test_a_failed_job_says_why(api: Service, kind: ErrorKind) -> None:
    job = api.get(failed(api, kind)).json()
    assert job["state"] == "failed"
    assert job["error"] == {
        "kind": kind.value,
        "detail": "it went wrong",
        "errors": [{"pointer": "/grid", "detail": "far too fine"}],
    }


def test_a_failed_job_is_removed(api: Service) -> None:
    assert api.client.delete(failed(api, ErrorKind.SYSTEM)).status_code == 204


def test_an_ended_job_is_not_cancelled(api: Service) -> None:
    where = failed(api, ErrorKind.USER)
    before = api.get(where).json()
    assert api.client.post(f"{where}/cancel").json() == before
