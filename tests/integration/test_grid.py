"""Grid and figure of a job."""

import csv
import io
import math
import struct
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import httpx
import numpy as np
import pytest
from numpy.typing import NDArray

from tests.integration.servers import Server
from tests.integration.studies import FIELDS, PRINTER, SMALL, arrays

SHAPE = (81, 41)
LEGS = 2
PNG = b"\x89PNG\r\n\x1a\n"


@pytest.fixture(scope="module")
def job(server: Server) -> dict[str, Any]:
    """Return a job that has succeeded."""
    return server.done(SMALL)


@pytest.fixture(scope="module")
def result(server: Server, job: dict[str, Any]) -> dict[str, Any]:
    """Return its result."""
    answer: dict[str, Any] = server.client.get(job["links"]["result"]).json()
    return answer


@pytest.fixture(scope="module")
def grid(
    server: Server, job: dict[str, Any], tmp_path_factory: pytest.TempPathFactory
) -> dict[str, NDArray[Any]]:
    """Return its arrays."""
    answer = server.client.get(job["links"]["grid"])
    assert answer.status_code == 200
    assert answer.headers["content-type"] == "application/x-npz"
    return arrays(answer, tmp_path_factory.mktemp("grid"))


def fetch(server: Server, job: dict[str, Any], what: str, **headers: str) -> httpx.Response:
    """Return the answer to a GET of `grid` or `figure`, a query behind it or not."""
    name, mark, query = what.partition("?")
    named = {key.replace("_", "-"): value for key, value in headers.items()}
    return server.client.get(job["links"][name] + mark + query, headers=named)


def test_the_job_had_several_tiles(server: Server, job: dict[str, Any]) -> None:
    ((tiles,),) = server.rows("SELECT count(*) FROM tiles WHERE job_id = ?", job["id"])
    assert tiles > 1


def test_the_arrays_have_their_names(grid: dict[str, NDArray[Any]]) -> None:
    assert grid.keys() == {"inside", "reason", "axis_x", "axis_y", *FIELDS}


def test_the_arrays_have_their_shapes(grid: dict[str, NDArray[Any]]) -> None:
    per_leg = {"effort", "actuators"}
    for name in ("inside", "reason", *FIELDS):
        assert grid[name].shape == ((*SHAPE, LEGS) if name in per_leg else SHAPE), name


def test_the_arrays_have_their_types(grid: dict[str, NDArray[Any]]) -> None:
    types = {name: array.dtype for name, array in grid.items()}
    assert types.pop("inside") == np.bool_
    assert types.pop("reason") == np.uint8
    assert set(types.values()) == {np.dtype(np.float64)}


def test_the_axes_are_the_nodes(grid: dict[str, NDArray[Any]]) -> None:
    assert np.array_equal(grid["axis_x"], -0.4 + 0.01 * np.arange(81))
    assert np.array_equal(grid["axis_y"], 0.0 + 0.01 * np.arange(41))


def test_as_many_are_inside_as_the_result_says(
    grid: dict[str, NDArray[Any]], result: dict[str, Any]
) -> None:
    assert np.count_nonzero(grid["inside"]) == result["inside"] > 0
    assert list(grid["inside"].shape) == result["shape"]


def test_what_is_inside_has_no_reason(grid: dict[str, NDArray[Any]]) -> None:
    assert np.array_equal(grid["inside"], grid["reason"] == 0)


def test_the_reasons_are_counted_as_excluded(
    grid: dict[str, NDArray[Any]], result: dict[str, Any]
) -> None:
    codes, counts = np.unique(grid["reason"][grid["reason"] > 0], return_counts=True)
    stated = {entry["code"]: entry["nodes"] for entry in result["excluded"] if entry["nodes"]}
    assert stated == dict(zip(codes.tolist(), counts.tolist(), strict=True))


def test_every_reason_occurs_in_the_order_of_conditions(result: dict[str, Any]) -> None:
    entries = result["excluded"]
    assert [entry["code"] for entry in entries] == list(range(1, len(entries) + 1))
    order = ["reach", "actuator_limits", "crank_rod_angle", "rod_rod_angle", "effort"]
    places = [order.index(entry["reason"]) for entry in entries]
    assert places == sorted(places)
    assert set(places) == set(range(5))


@pytest.mark.parametrize("name", FIELDS)
def test_a_field_has_no_number_exactly_outside(grid: dict[str, NDArray[Any]], name: str) -> None:
    missing = np.isnan(grid[name])
    outside = ~grid["inside"]
    per_node = missing.reshape(*SHAPE, -1)
    assert np.array_equal(per_node.any(axis=2), outside)
    assert np.array_equal(per_node.all(axis=2), outside)


def test_the_greatest_effort_is_that_of_the_legs(grid: dict[str, NDArray[Any]]) -> None:
    inside = grid["inside"]
    assert np.array_equal(grid["effort"][inside].max(axis=1), grid["effort_max"][inside])


@pytest.mark.parametrize("name", FIELDS)
def test_the_result_sums_the_fields_up(
    grid: dict[str, NDArray[Any]], result: dict[str, Any], name: str
) -> None:
    summary = result["fields"][name]
    assert summary["min"] == np.nanmin(grid[name])
    assert summary["max"] == np.nanmax(grid[name])


def test_an_effort_is_the_same_number_directly_and_in_the_grid(
    server: Server, grid: dict[str, NDArray[Any]]
) -> None:
    nodes = np.argwhere(grid["inside"])
    poses = np.stack([grid["axis_x"][nodes[:, 0]], grid["axis_y"][nodes[:, 1]]], axis=1)
    request = {
        "analysis": "effort",
        "mechanism": PRINTER,
        "poses": poses.tolist(),
        "load": {"force": 1.0},
    }
    direct = np.array(server.client.post("/v1/analyses", json=request).json()["effort"])
    assert direct.tobytes() == grid["effort"][grid["inside"]].tobytes()


def test_an_actuator_is_the_same_number_directly_and_in_the_grid(
    server: Server, grid: dict[str, NDArray[Any]]
) -> None:
    nodes = np.argwhere(grid["inside"])
    poses = np.stack([grid["axis_x"][nodes[:, 0]], grid["axis_y"][nodes[:, 1]]], axis=1)
    request = {"analysis": "inverse_kinematics", "mechanism": PRINTER, "poses": poses.tolist()}
    answer = server.client.post("/v1/analyses", json=request).json()
    assert all(answer["reachable"])
    assert np.array(answer["actuators"]).tobytes() == grid["actuators"][grid["inside"]].tobytes()


def test_the_csv_has_the_same_numbers(
    server: Server, job: dict[str, Any], grid: dict[str, NDArray[Any]]
) -> None:
    answer = fetch(server, job, "grid?format=csv")
    assert answer.headers["content-type"].startswith("text/csv")
    rows = list(csv.DictReader(io.StringIO(answer.text)))
    assert len(rows) == math.prod(SHAPE)
    columns = {
        "x": np.repeat(grid["axis_x"], SHAPE[1]),
        "y": np.tile(grid["axis_y"], SHAPE[0]),
        "inside": grid["inside"].ravel(),
        "reason": grid["reason"].ravel(),
        "effort_max": grid["effort_max"].ravel(),
        "effort_1": grid["effort"][..., 1].ravel(),
        "actuators_0": grid["actuators"][..., 0].ravel(),
    }
    for name, expected in columns.items():
        given = np.array([float(row[name] or "nan") for row in rows])
        assert np.array_equal(given, expected.astype(float), equal_nan=True), name


def test_the_format_is_taken_from_accept(server: Server, job: dict[str, Any]) -> None:
    answer = fetch(server, job, "grid", Accept="text/csv")
    assert answer.content == fetch(server, job, "grid?format=csv").content


def test_a_type_that_is_not_offered_is_refused(server: Server, job: dict[str, Any]) -> None:
    answer = fetch(server, job, "grid", Accept="application/pdf")
    assert answer.status_code == 406
    assert answer.headers["content-type"] == "application/problem+json"


def test_a_format_that_is_not_offered_is_refused(server: Server, job: dict[str, Any]) -> None:
    assert fetch(server, job, "grid?format=../../x").status_code == 422


@pytest.mark.parametrize("what", ["grid", "grid?format=csv", "figure", "figure?format=svg"])
def test_who_has_it_is_answered_304(server: Server, job: dict[str, Any], what: str) -> None:
    etag = fetch(server, job, what).headers["ETag"]
    again = fetch(server, job, what, If_None_Match=etag)
    assert (again.status_code, again.content) == (304, b"")
    assert again.headers["ETag"] == etag
    assert not etag.startswith("W/")


def test_every_format_has_an_etag_of_its_own(server: Server, job: dict[str, Any]) -> None:
    whats = ["grid", "grid?format=csv", "figure", "figure?format=svg", "figure?field=effort"]
    etags = [fetch(server, job, what).headers["ETag"] for what in whats]
    assert len(set(etags)) == len(etags)


def test_a_range_is_a_part_of_the_whole(server: Server, job: dict[str, Any]) -> None:
    whole = fetch(server, job, "grid").content
    part = fetch(server, job, "grid", Range="bytes=100-199")
    assert part.status_code == 206
    assert part.headers["content-range"] == f"bytes 100-199/{len(whole)}"
    assert part.content == whole[100:200]


def test_the_end_of_the_whole_is_a_range(server: Server, job: dict[str, Any]) -> None:
    whole = fetch(server, job, "grid").content
    assert fetch(server, job, "grid", Range="bytes=-50").content == whole[-50:]


def test_a_range_of_another_etag_is_answered_whole(server: Server, job: dict[str, Any]) -> None:
    answer = fetch(server, job, "grid", Range="bytes=0-9", If_Range='"other"')
    assert answer.status_code == 200


def test_a_range_of_this_etag_is_answered_in_part(server: Server, job: dict[str, Any]) -> None:
    etag = fetch(server, job, "grid").headers["ETag"]
    assert fetch(server, job, "grid", Range="bytes=0-9", If_Range=etag).status_code == 206


def test_a_range_beyond_the_end_is_a_problem(server: Server, job: dict[str, Any]) -> None:
    answer = fetch(server, job, "grid", Range="bytes=99999999-")
    assert answer.status_code == 416
    assert answer.headers["content-type"] == "application/problem+json"


def test_a_grid_asked_for_at_once_by_many_is_whole(server: Server) -> None:
    fresh = server.done(SMALL)
    with ThreadPoolExecutor(6) as pool:
        answers = list(pool.map(lambda _: fetch(server, fresh, "grid"), range(6)))
    assert {answer.status_code for answer in answers} == {200}
    assert len({answer.content for answer in answers}) == 1


def test_the_figure_is_a_png_of_some_size(server: Server, job: dict[str, Any]) -> None:
    answer = fetch(server, job, "figure")
    assert answer.headers["content-type"] == "image/png"
    assert answer.content.startswith(PNG)
    width, height = struct.unpack(">II", answer.content[16:24])
    assert width >= 1000
    assert height >= 600


def test_the_figure_is_an_svg_if_asked(server: Server, job: dict[str, Any]) -> None:
    answer = fetch(server, job, "figure?format=svg")
    assert answer.headers["content-type"] == "image/svg+xml"
    assert ElementTree.fromstring(answer.content).tag == "{http://www.w3.org/2000/svg}svg"


@pytest.mark.parametrize("field", [*FIELDS, "effort_0", "effort_1", "actuators_1"])
def test_a_figure_shows_a_kept_field(server: Server, job: dict[str, Any], field: str) -> None:
    assert fetch(server, job, f"figure?field={field}").content.startswith(PNG)


def test_another_field_gives_another_figure(server: Server, job: dict[str, Any]) -> None:
    whats = ["figure?field=effort_max", "figure?field=determinant", "figure?field=effort_0"]
    assert len({fetch(server, job, what).content for what in whats}) == 3


@pytest.mark.parametrize(
    "field", ["mass", "effort_2", "", "../../../etc/passwd", "..%2f..%2fx", "%00", "inside"]
)
def test_an_unknown_field_is_refused(server: Server, job: dict[str, Any], field: str) -> None:
    answer = fetch(server, job, f"figure?field={field}")
    assert answer.status_code == 422
    assert answer.headers["content-type"] == "application/problem+json"
    assert [fault["pointer"] for fault in answer.json()["errors"]] == ["?field"]


def test_removing_a_job_removes_its_files(server: Server) -> None:
    removed = server.done(SMALL)
    fetch(server, removed, "grid")
    fetch(server, removed, "figure")
    data = server.folder / "data"
    assert list(data.glob(f"**/{removed['id']}*"))
    assert server.client.delete(removed["links"]["self"]).status_code == 204
    assert list(data.glob(f"**/{removed['id']}*")) == []
    for table in ("tiles", "results", "requests"):
        assert server.rows(f"SELECT * FROM {table} WHERE job_id = ?", removed["id"]) == []


@pytest.mark.parametrize("what", ["grid", "figure", "result"])
def test_a_removed_job_has_nothing_to_fetch(server: Server, what: str) -> None:
    removed = server.done(SMALL)
    etag = fetch(server, removed, "grid").headers["ETag"]
    server.client.delete(removed["links"]["self"])
    answer = server.client.get(removed["links"][what], headers={"If-None-Match": etag})
    assert answer.status_code == 404


def test_nothing_but_the_files_of_jobs_is_left(server: Server) -> None:
    leftover = [path for path in (Path(server.folder) / "data").rglob("*") if "tmp" in path.name]
    assert leftover == []
