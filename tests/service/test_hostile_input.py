"""What nobody sends by mistake is answered as a problem, soon, in little memory."""

import base64
import json
import time
import tracemalloc
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tests.service.bodies import EFFORT, FIVE_BAR, INVERSE, WORKSPACE, grid
from tests.service.services import Service, assert_problem

PATHS = ["/v1/mechanisms", "/v1/analyses", "/v1/estimates", "/v1/jobs"]
PLACE = '"HERE"'
SURROGATE = "\ud800"


def placed(body: dict[str, Any], literal: str) -> str:
    """Return the body as text with a literal of JSON in the marked place."""
    return json.dumps(body).replace(PLACE, literal)


def nested(depth: int) -> str:
    return '{"a":' * depth + "1" + "}" * depth


NUMBERS = ["NaN", "Infinity", "-Infinity", "1e400", "-1e400", "1" + 400 * "0", "true", '"1"']
PLACES: dict[str, dict[str, Any]] = {
    "/mechanism/rod_length": INVERSE | {"mechanism": FIVE_BAR | {"rod_length": "HERE"}},
    "/mechanism/actuator_limits/min": INVERSE
    | {"mechanism": FIVE_BAR | {"actuator_limits": {"min": "HERE"}}},
    "/poses/0/1": INVERSE | {"poses": [[0, "HERE"]]},
    "/load/force": EFFORT | {"load": {"force": "HERE"}},
    "/known_load/force/2": EFFORT | {"known_load": {"force": [0, 0, "HERE"]}},
    "/grid/1/min": WORKSPACE | {"grid": grid(0.5, min="HERE")},
    "/grid/1/max": WORKSPACE | {"grid": grid(0.5, max="HERE")},
    "/grid/1/step": WORKSPACE | {"grid": grid(0.5, step="HERE")},
    "/fixed/z": WORKSPACE | {"fixed": {"z": "HERE"}},
    "/constructive/min_crank_rod_angle": WORKSPACE
    | {"constructive": {"min_crank_rod_angle": "HERE"}},
    "/effective/max_effort": WORKSPACE
    | {"effective": {"load": {"force": 1}, "max_effort": "HERE"}},
}


@pytest.mark.parametrize("number", NUMBERS, ids=lambda number: number[:12])
@pytest.mark.parametrize("pointer", PLACES)
def test_what_is_no_number_of_this_world_is_refused(
    refusing: Service, pointer: str, number: str
) -> None:
    before = refusing.rows()
    assert_problem(refusing.post_text("/v1/jobs", placed(PLACES[pointer], number)), 422, pointer)
    assert refusing.rows() == before


NOT_JSON = {
    "nothing there": b"",
    "cut off": b'{"kind":"five_bar",',
    "a byte": b"\xff",
    "an integer of 5000 digits": b"1" * 5000,
    "nested 100 000 times": b"[" * 100_000,
    "objects nested 100 000 times": nested(100_000).encode(),
    "a null byte": b'{"kind":"five_bar"}\0',
    "single quotes": b"{'kind':'five_bar'}",
}


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("what", NOT_JSON)
def test_what_is_not_json_is_a_problem(refusing: Service, path: str, what: str) -> None:
    before = refusing.rows()
    answer = refusing.post_text(path, NOT_JSON[what])
    assert_problem(answer, 422 if what == "nothing there" else 400)
    assert refusing.rows() == before


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("body", ["null", "[]", "[1]", '"x"', "3", "true", nested(500), "{}"])
def test_what_is_no_request_is_a_problem(refusing: Service, path: str, body: str) -> None:
    assert_problem(refusing.post_text(path, body), 422)


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize(
    "declared",
    [None, "text/plain", "text/html", "application/x-www-form-urlencoded", "multipart/form-data"],
)
def test_a_body_must_be_declared_as_json(
    refusing: Service, path: str, declared: str | None
) -> None:
    headers = {} if declared is None else {"Content-Type": declared}
    answer = refusing.client.post(path, content=json.dumps(INVERSE), headers=headers)
    assert_problem(answer, 415)


LONELY: dict[str, dict[str, Any]] = {
    "in a name": INVERSE | {"mechanism": FIVE_BAR | {"name": SURROGATE}},
    "as a field of a mechanism": INVERSE | {"mechanism": FIVE_BAR | {SURROGATE: 1}},
    "as a field of a request": INVERSE | {SURROGATE: 1},
    "as a kind": INVERSE | {"mechanism": FIVE_BAR | {"kind": SURROGATE}},
    "as an analysis": INVERSE | {"analysis": SURROGATE},
    "as an axis": WORKSPACE | {"grid": grid(0.5, coordinate=SURROGATE)},
    "as a fixed coordinate": WORKSPACE | {"fixed": {SURROGATE: 0}},
    "as a fixed coordinate without a number": WORKSPACE | {"fixed": {SURROGATE: "x"}},
    "as a field to keep": WORKSPACE | {"fields": [SURROGATE]},
    "as a working mode": INVERSE | {"working_mode": SURROGATE},
}


@pytest.mark.parametrize("what", LONELY)
def test_a_lone_surrogate_is_a_problem(refusing: Service, what: str) -> None:
    assert_problem(refusing.post_text("/v1/jobs", json.dumps(LONELY[what])), 422)


@pytest.mark.parametrize("text", ['{"kind":"five_bar","kind":"planar_3rrr"}', '{"a":1,"a":2}'])
def test_a_key_twice_is_a_problem(refusing: Service, text: str) -> None:
    assert_problem(refusing.post_text("/v1/mechanisms", text), 422)


LONG = "x" * 1_000_000
LENGTHY: dict[str, dict[str, Any]] = {
    "a field": INVERSE | {LONG: 1},
    "an analysis": INVERSE | {"analysis": LONG},
    "a kind": INVERSE | {"mechanism": {"kind": LONG}},
    "a fixed coordinate": WORKSPACE | {"fixed": {LONG: 0}},
    "an axis": WORKSPACE | {"grid": grid(0.5, coordinate=LONG)},
    "a name": INVERSE | {"mechanism": FIVE_BAR | {"name": LONG}},
    "an id": INVERSE | {"mechanism": {"kind": "stored", "id": LONG}},
    "many fixed coordinates": WORKSPACE | {"fixed": {f"c{i}": 0 for i in range(50_000)}},
}


@pytest.mark.parametrize("what", LENGTHY)
def test_a_problem_is_short_however_long_the_request(refusing: Service, what: str) -> None:
    answer = refusing.post("/v1/jobs", LENGTHY[what])
    size = len(answer.content)
    assert answer.status_code == 422
    assert size < 20_000


MANY: dict[str, dict[str, Any]] = {
    "poses": INVERSE | {"poses": [["a", "b"]] * 5_000},
    "fields": INVERSE | {f"field{i}": 0 for i in range(5_000)},
    "fixed coordinates": WORKSPACE | {"fixed": {f"c{i}": "x" for i in range(5_000)}},
    "signs": INVERSE | {"working_mode": [0] * 5_000},
}


@pytest.mark.timeout(60)
@pytest.mark.parametrize("what", MANY)
def test_many_faults_are_found_in_little_time(refusing: Service, what: str) -> None:
    begun = time.monotonic()
    status = refusing.post("/v1/jobs", MANY[what]).status_code
    seconds = time.monotonic() - begun
    assert status == 422
    assert seconds < 3.0


def chunks(body: bytes) -> Iterator[bytes]:
    # A generator has no length to declare.
    yield body[:1000]
    yield body[1000:]


@pytest.mark.parametrize("path", PATHS)
def test_a_large_body_is_refused(start: Callable[..., Service], path: str) -> None:
    api = start(body_limit_bytes=2048)
    before = api.rows()
    answer = api.post_text(path, json.dumps(INVERSE) + " " * 2048)
    assert_problem(answer, 413)
    assert "2048" in answer.json()["detail"]
    assert api.rows() == before


@pytest.mark.parametrize("path", PATHS)
def test_a_large_body_of_undeclared_length_is_refused(
    start: Callable[..., Service], path: str
) -> None:
    api = start(body_limit_bytes=2048)
    before = api.rows()
    body = (json.dumps(INVERSE) + " " * 2048).encode()
    headers = {"Content-Type": "application/json"}
    answer = api.client.post(path, content=chunks(body), headers=headers)
    assert_problem(answer, 413)
    assert api.rows() == before


def test_a_body_of_just_the_limit_is_read(start: Callable[..., Service]) -> None:
    api = start(body_limit_bytes=2048)
    assert api.post_text("/v1/analyses", json.dumps(INVERSE).ljust(2048)).status_code == 200


def test_a_hundred_thousand_poses_are_read(refusing: Service) -> None:
    poses = [[1e-6 * i + 1e-16, 0.9 - 1e-6 * i] for i in range(100_000)]
    answer = refusing.post("/v1/analyses", INVERSE | {"poses": poses})
    assert answer.status_code == 200
    assert len(answer.json()["reachable"]) == 100_000


ABSURD: dict[str, list[dict[str, Any]]] = {
    "fine": grid(1e-12),
    "wide": grid(1e-3, min=-1e12, max=1e12),
    "wide and fine": grid(1e-12, min=-1e12, max=1e12),
    "all there is": [{"coordinate": c, "min": -1e12, "max": 1e12, "step": 1e-12} for c in "xyxyxy"],
}


@pytest.mark.timeout(30)
@pytest.mark.parametrize("path", PATHS[1:])
@pytest.mark.parametrize("what", ABSURD)
def test_an_absurd_grid_is_refused_before_anything_is_allocated(
    refusing: Service, path: str, what: str
) -> None:
    before = refusing.rows()
    tracemalloc.start()
    begun = time.monotonic()
    try:
        answer = refusing.post(path, WORKSPACE | {"grid": ABSURD[what]})
        seconds, peak = time.monotonic() - begun, tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert_problem(answer, 422)
    assert seconds < 1.0
    assert peak < 10 * 2**20
    assert refusing.rows() == before


TRAVERSALS = ["..", "%2e%2e", "..%2f..%2fetc%2fpasswd", "..%5c..", "%2fetc%2fpasswd", "~", "*"]


@pytest.mark.parametrize("identifier", TRAVERSALS)
@pytest.mark.parametrize("path", ["/v1/mechanisms/{}", "/v1/jobs/{}/grid", "/v1/kinds/{}"])
def test_an_id_leads_nowhere_else(refusing: Service, path: str, identifier: str) -> None:
    assert_problem(refusing.get(path.format(identifier)), 404)


@pytest.mark.parametrize(
    "path", ["/docs/files/..%2f..%2fpyproject.toml", "/docs/files/%2fetc%2fpasswd"]
)
def test_the_files_of_the_docs_are_all_that_is_served(refusing: Service, path: str) -> None:
    assert_problem(refusing.get(path), 404)


def token(text: str) -> str:
    return base64.urlsafe_b64encode(text.encode()).decode()


TOKENS = {
    "empty": "",
    "words": "next please",
    "no base64": "é" * 10,
    "a byte": base64.urlsafe_b64encode(b"\xff\xfe").decode(),
    "no list": token("{}"),
    "one entry": token("[1]"),
    "three entries": token('[1,"a","b"]'),
    "no number": token('["soon","a"]'),
    "a list for a number": token('[[],"a"]'),
    "not a number": token('[NaN,"a"]'),
    "infinite": token('[1e400,"a"]'),
    "a lone surrogate": token('[1,"\\ud800"]'),
    "no text": token("[1,{}]"),
    "huge": "a" * 10_000,
    "deep": token("[" * 290),
}


@pytest.mark.parametrize("path", ["/v1/jobs", "/v1/mechanisms"])
@pytest.mark.parametrize("what", TOKENS)
def test_a_token_that_no_page_gave_is_refused(refusing: Service, path: str, what: str) -> None:
    answer = refusing.get(path, params={"page_token": TOKENS[what]})
    assert_problem(answer, 422, "?page_token")


QUERIES = ["state=%00", "state=", "analysis=" + "x" * 5000, "page_size=%F0%9F%98%80"]


@pytest.mark.parametrize("query", QUERIES, ids=lambda query: query[:16])
def test_a_query_that_makes_no_sense_is_refused(refusing: Service, query: str) -> None:
    assert_problem(refusing.get(f"/v1/jobs?{query}"), 422)


@pytest.mark.parametrize("query", ["analysis=%00", "mechanism=' OR 1=1 --", "analysis=%25"])
def test_a_filter_finds_only_what_it_names(api: Service, query: str) -> None:
    api.post("/v1/jobs", INVERSE)
    assert api.get(f"/v1/jobs?{query}").json()["items"] == []


def test_a_key_that_is_too_long_is_refused(refusing: Service) -> None:
    answer = refusing.post("/v1/jobs", INVERSE, Idempotency_Key="k" * 201)
    assert_problem(answer, 422, "header:idempotency-key")


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("PUT", "/v1/jobs"),
        ("DELETE", "/v1/kinds"),
        ("PATCH", "/v1/jobs/x"),
        ("GET", "/v1/analyses"),
    ],
)
def test_another_method_is_a_problem(refusing: Service, method: str, path: str) -> None:
    answer = refusing.client.request(method, path)
    assert_problem(answer, 405)
    assert answer.headers["Allow"]


@pytest.mark.parametrize("path", ["/", "/v1", "/v2/jobs", "/v1/jobs/x/y/z", "/.env", "/v1/%00"])
def test_another_path_is_a_problem(refusing: Service, path: str) -> None:
    assert_problem(refusing.get(path), 404)


EXTREMES: dict[str, dict[str, Any]] = {
    "far": INVERSE | {"poses": [[1e12, -1e12]]},
    "on a base joint": INVERSE | {"poses": [[0.3, 0.0]]},
    "subnormal": INVERSE | {"poses": [[5e-324, 0.9]]},
    "long and short": INVERSE | {"mechanism": FIVE_BAR | {"base_distance": 1e-9}},
    "unequal": EFFORT | {"mechanism": FIVE_BAR | {"rod_length": 1e6, "crank_length": 1e-9}},
    "singular": EFFORT | {"poses": [[0.0, 0.0], [0.7, 0.3]]},
    "strong": EFFORT | {"load": {"force": 1e12, "moment": 1e12}},
    "one node": WORKSPACE | {"grid": grid(1e12, min=-1.0, max=-1.0)},
    "nodes closer than numbers": WORKSPACE
    | {"grid": grid(0.5, min=1e12, max=1e12, step=1e-12), "fields": ["actuators"]},
    "nothing inside": WORKSPACE
    | {"grid": grid(0.5, min=50, max=60), "fields": ["actuators", "determinant"]},
}


@pytest.mark.parametrize("what", EXTREMES)
def test_what_is_extreme_but_makes_sense_is_answered(refusing: Service, what: str) -> None:
    answer = refusing.post("/v1/analyses", EXTREMES[what])
    assert answer.status_code == 200
    json.loads(answer.text, parse_constant=pytest.fail)
