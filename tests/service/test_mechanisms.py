"""`/v1/mechanisms`."""

from typing import Any

import pytest

from tests.service.bodies import FIVE_BAR, INVERSE, PLANAR_3RRR
from tests.service.services import Service, assert_problem

UNKNOWN = "/v1/mechanisms/m_" + 32 * "0"

SPELLINGS: list[dict[str, Any]] = [
    FIVE_BAR,
    dict(reversed(FIVE_BAR.items())),
    FIVE_BAR | {"name": None},
    FIVE_BAR | {"working_mode": [1, -1]},
    FIVE_BAR | {"working_mode": None},
    FIVE_BAR | {"actuator_limits": None},
    FIVE_BAR | {"actuator_limits": {}},
    FIVE_BAR | {"actuator_limits": {"min": None, "max": None}},
    FIVE_BAR | {"actuator_limits": [None, None]},
    FIVE_BAR | {"actuator_limits": [{}, None]},
]


def location(api: Service, spec: dict[str, Any]) -> str:
    return api.post("/v1/mechanisms", spec).headers["Location"]


def test_a_new_mechanism_is_created(api: Service) -> None:
    assert api.post("/v1/mechanisms", FIVE_BAR).status_code == 201


def test_a_new_mechanism_is_found_at_its_location(api: Service) -> None:
    created = api.post("/v1/mechanisms", FIVE_BAR)
    found = api.get(created.headers["Location"])
    assert found.json() == created.json()
    assert created.headers["Location"] == f"/v1/mechanisms/{found.json()['id']}"


def test_a_mechanism_keeps_what_was_given(api: Service) -> None:
    limits = [{"min": -1.0, "max": 2.0}, None]
    given = FIVE_BAR | {"name": "Fünf-Gelenk 五", "actuator_limits": limits}
    kept = api.get(location(api, given)).json()["mechanism"]
    assert kept == given | {"working_mode": [1, -1]}


@pytest.mark.parametrize("spelling", SPELLINGS, ids=range(len(SPELLINGS)))
def test_the_same_mechanism_spelled_differently_is_the_same(
    api: Service, spelling: dict[str, Any]
) -> None:
    first = api.post("/v1/mechanisms", FIVE_BAR)
    again = api.post("/v1/mechanisms", spelling)
    assert again.status_code == 200
    assert again.json() == first.json()
    assert again.headers["Location"] == first.headers["Location"]


def test_numbers_are_compared_by_value(api: Service) -> None:
    text = '{"kind":"five_bar","base_distance":%s,"crank_length":1,"rod_length":1.0}'
    answers = [api.post_text("/v1/mechanisms", text % number) for number in ("2", "2.0", "20e-1")]
    assert [answer.status_code for answer in answers] == [201, 200, 200]
    assert len({answer.json()["id"] for answer in answers}) == 1


def test_limits_of_plus_and_minus_zero_are_the_same(api: Service) -> None:
    plus = FIVE_BAR | {"actuator_limits": {"min": 0.0}}
    minus = FIVE_BAR | {"actuator_limits": {"min": -0.0}}
    assert location(api, plus) == location(api, minus)


@pytest.mark.parametrize(
    "change", [{"rod_length": 0.5000000000000001}, {"name": "another"}, {"working_mode": [1, 1]}]
)
def test_another_mechanism_has_another_id(api: Service, change: dict[str, Any]) -> None:
    assert location(api, FIVE_BAR) != location(api, FIVE_BAR | change)


def test_the_same_mechanism_is_stored_once(api: Service) -> None:
    for _ in range(3):
        api.post("/v1/mechanisms", FIVE_BAR)
    assert api.rows()["mechanisms"] == 1


def test_the_list_has_the_newest_first(api: Service) -> None:
    given = [api.post("/v1/mechanisms", spec).json() for spec in (FIVE_BAR, PLANAR_3RRR)]
    assert api.get("/v1/mechanisms").json() == {"items": given[::-1], "next_page_token": None}


@pytest.mark.parametrize("size", [1, 2, 3, 5, 6])
def test_pages_have_every_mechanism_once(api: Service, size: int) -> None:
    given = [location(api, FIVE_BAR | {"name": str(number)})[-34:] for number in range(5)]
    found: list[str] = []
    parameters: dict[str, Any] = {"page_size": size}
    while True:
        page = api.get("/v1/mechanisms", params=parameters).json()
        assert len(page["items"]) <= size
        found += [item["id"] for item in page["items"]]
        if page["next_page_token"] is None:
            break
        parameters["page_token"] = page["next_page_token"]
    assert found == given[::-1]


def test_a_page_token_stays_good_when_a_mechanism_is_added(api: Service) -> None:
    given = [location(api, FIVE_BAR | {"name": str(number)})[-34:] for number in range(4)]
    first = api.get("/v1/mechanisms", params={"page_size": 2}).json()
    api.post("/v1/mechanisms", PLANAR_3RRR)
    token = {"page_token": first["next_page_token"]}
    assert [item["id"] for item in api.get("/v1/mechanisms", params=token).json()["items"]] == [
        given[1],
        given[0],
    ]


def test_a_known_etag_is_answered_304(api: Service) -> None:
    where = location(api, FIVE_BAR)
    etag = api.get(where).headers["ETag"]
    again = api.get(where, headers={"If-None-Match": etag})
    assert again.status_code == 304
    assert again.content == b""
    assert again.headers["ETag"] == etag


@pytest.mark.parametrize("form", ["*", "W/{}", '"other", {}', '{}, "other"'])
def test_every_form_of_if_none_match_is_understood(api: Service, form: str) -> None:
    where = location(api, FIVE_BAR)
    known = form.format(api.get(where).headers["ETag"])
    assert api.get(where, headers={"If-None-Match": known}).status_code == 304


def test_another_etag_is_answered_in_full(api: Service) -> None:
    where = location(api, FIVE_BAR)
    assert api.get(where, headers={"If-None-Match": '"other"'}).status_code == 200


def test_an_etag_of_a_removed_mechanism_is_not_found(api: Service) -> None:
    where = location(api, FIVE_BAR)
    etag = api.get(where).headers["ETag"]
    api.client.delete(where)
    assert_problem(api.get(where, headers={"If-None-Match": etag}), 404)


def test_a_mechanism_is_removed(api: Service) -> None:
    where = location(api, FIVE_BAR)
    removed = api.client.delete(where)
    assert (removed.status_code, removed.content) == (204, b"")
    assert_problem(api.get(where), 404)
    assert api.rows()["mechanisms"] == 0


def test_removing_twice_is_not_found(api: Service) -> None:
    where = location(api, FIVE_BAR)
    api.client.delete(where)
    assert_problem(api.client.delete(where), 404)


def test_a_removed_mechanism_can_be_stored_again(api: Service) -> None:
    where = location(api, FIVE_BAR)
    api.client.delete(where)
    assert api.post("/v1/mechanisms", FIVE_BAR).status_code == 201
    assert api.get(where).status_code == 200


def test_a_job_outlives_its_mechanism(api: Service) -> None:
    where = location(api, FIVE_BAR)
    stored = {"kind": "stored", "id": where.rpartition("/")[2]}
    job = api.post("/v1/jobs", INVERSE | {"mechanism": stored}).json()
    api.client.delete(where)
    assert api.get(job["links"]["self"]).json() == job


@pytest.mark.parametrize("method", ["GET", "DELETE"])
def test_an_unknown_mechanism_is_not_found(refusing: Service, method: str) -> None:
    assert_problem(refusing.client.request(method, UNKNOWN), 404)
