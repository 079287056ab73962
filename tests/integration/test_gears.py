"""A train of gears as a job, which is about no mechanism."""

from typing import Any

import pytest

from tests.integration.servers import Server

TRAIN: dict[str, Any] = {
    "analysis": "friction_torque",
    "train": [
        {
            "kind": "design",
            "face": face,
            "module": 0.002,
            "input": {"teeth": 22},
            "output": {"teeth": 34},
            "friction_coefficient": 0.1,
        }
        for face in ("bevel", "spur", "spur")
    ],
    "output_torque": 50.0,
    "contact": "mean",
    "curve_points": 50,
}


@pytest.fixture(scope="module")
def job(server: Server) -> dict[str, Any]:
    """Return the ended job of a train that was asked to be one."""
    answer = server.client.post("/v1/analyses", json=TRAIN, headers={"Prefer": "respond-async"})
    assert answer.status_code == 202
    return server.look(answer.json(), wait=60)


def test_a_train_succeeds_mesh_by_mesh(job: dict[str, Any]) -> None:
    assert job["state"] == "successful"
    assert job["progress"] == {"done": 3, "total": 3, "fraction": 1.0}
    assert job["mechanism"] is None


def test_its_result_is_the_direct_answer(server: Server, job: dict[str, Any]) -> None:
    direct = server.client.post("/v1/analyses", json=TRAIN)
    assert server.client.get(job["links"]["result"]).content == direct.content


def test_it_has_a_figure(server: Server, job: dict[str, Any]) -> None:
    answer = server.client.get(job["links"]["figure"])
    assert answer.headers["content-type"] == "image/png"
    assert answer.content.startswith(b"\x89PNG")
