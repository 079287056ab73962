"""`friction_torque` over HTTP: trains of gears, of no mechanism."""

from collections.abc import Callable
from typing import Any

import pytest

from tests.service.bodies import FIVE_BAR, grid
from tests.service.services import Service, assert_problem

PAIR: dict[str, Any] = {
    "kind": "explicit",
    "input_centre": [-0.3, 0.0],
    "output_centre": [0.3, 0.0],
    "pitch_point": [0.0, 0.0],
    "contact": [0.024, 0.065],
    "friction_coefficient": 0.16,
}
SPUR: dict[str, Any] = {
    "kind": "design",
    "module": 0.002,
    "input": {"teeth": 20},
    "output": {"teeth": 40},
    "friction_coefficient": 0.08,
}
BEVEL = SPUR | {"face": "bevel"}


def train(*meshes: dict[str, Any], **changes: Any) -> dict[str, Any]:  # noqa: ANN401
    body = {"analysis": "friction_torque", "train": list(meshes), "output_torque": 50.0}
    return body | {"contact": "worst"} | changes


def wheel(teeth: int, shift: float = 0.0) -> dict[str, Any]:
    return {"teeth": teeth, "profile_shift": shift}


# The body, where the problem must point, and what it must say.
REFUSED: list[tuple[dict[str, Any], str, str]] = [
    (train(SPUR | {"input": wheel(12)}), "/train/0/input/profile_shift", "0.298133 below"),
    (train(PAIR, BEVEL | {"output": wheel(11)}), "/train/1/output/profile_shift", "undercut"),
    (train(SPUR | {"input": wheel(18, 2.0)}), "/train/0/input/profile_shift", "pointed"),
    (train(SPUR | {"addendum_coefficient": 0.3}), "/train/0", "contact ratio is 0.5"),
    (train(SPUR | {"centre_distance": 0.0595}), "/train/0/centre_distance", "by 0.0005 m"),
    (train(BEVEL | {"centre_distance": 0.06}), "/train/0/centre_distance", "bevel"),
    (train(SPUR | {"shaft_angle": 1.5}), "/train/0/shaft_angle", "spur"),
    (train(BEVEL | {"shaft_angle": 2.5}), "/train/0/shaft_angle", "half-angle"),
    (train(BEVEL | {"input": wheel(20, 0.2)}), "/train/0/output/profile_shift", "sum to 0"),
    (train(SPUR | {"contact_position": 0.009}), "/train/0/contact_position", "beyond"),
    (train(SPUR, contact="explicit"), "/train/0/contact_position", "must be given"),
    (train(SPUR | {"friction_coefficient": 2.8}), "/train/0/friction_coefficient", "2.747"),
    (train(SPUR | {"friction_coefficient": -0.1}), "/train/0/friction_coefficient", "-0.1"),
    (train(SPUR | {"input": wheel(2)}), "/train/0/input/teeth", "2"),
    (train(PAIR | {"pitch_point": [0, 0.01]}), "/train/0/pitch_point", "0.01 m off"),
    (train(PAIR | {"output_centre": [-0.3, 0]}), "/train/0/output_centre", "0 m apart"),
    (train(PAIR | {"contact": [0.048, 0.13]}), "/train/0/contact", "outside of the line"),
    (train(PAIR | {"contact": [0, 0]}), "/train/0/contact", "must differ"),
    (train(PAIR | {"opposite_contact": [0, -0.05]}), "/train/0/opposite_contact", "off"),
    (train(PAIR | {"base_pitch": 0.2}), "/train/0/base_pitch", "contact ratio is 0.69"),
    (train(SPUR, PAIR, contact="mean"), "/train/1/base_pitch", "must be given"),
    (train(PAIR, curve_points=50), "/train/0/base_pitch", "must be given"),
    (train(*[SPUR | {"input": wheel(20000)}] * 5), "/train", "1e13.5"),
    (train(), "/train", "at least 1"),
    (train(SPUR, contact="best"), "/contact", "best"),
    (train(SPUR, mechanism=FIVE_BAR), "", "either train"),
    (train(SPUR | {"kind": "worm"}), "/train/0/kind", "worm"),
]


@pytest.mark.parametrize("path", ["/v1/analyses", "/v1/estimates", "/v1/jobs"])
@pytest.mark.parametrize(("body", "pointer", "said"), REFUSED)
def test_wheels_that_do_not_mesh_are_refused(
    refusing: Service, path: str, body: dict[str, Any], pointer: str, said: str
) -> None:
    answer = refusing.post(path, body)
    assert_problem(answer, 422, pointer)
    assert said in answer.json()["detail"]


def test_a_pair_of_the_paper(refusing: Service) -> None:
    answer = refusing.post("/v1/analyses", train(PAIR, contact="explicit")).json()
    assert answer["input_torque"] == pytest.approx(53.863, abs=5e-4)
    assert answer["stages"][0]["output_arm"] == pytest.approx(0.28336, abs=5e-6)


def test_a_train_that_the_load_cannot_drive_back(refusing: Service) -> None:
    slippery, rough = PAIR, PAIR | {"friction_coefficient": 1.9}
    body = train(slippery, rough, slippery, contact="recess_end", sense="back_driving")
    answer = refusing.post("/v1/analyses", body).json()
    assert answer["self_locking"] is True
    assert (answer["input_torque"], answer["efficiency"], answer["loss"]) == (None, 0.0, 1.0)
    assert [stage["self_locking"] for stage in answer["stages"]] == [False, True, False]
    assert answer["stages"][1]["input_arm"] < 0.0
    assert refusing.post("/v1/analyses", body | {"sense": "driving"}).json()["input_torque"] > 0.0


def test_a_curve_is_answered_when_asked_for(refusing: Service) -> None:
    answer = refusing.post("/v1/analyses", train(SPUR, PAIR | {"base_pitch": 0.1}, curve_points=50))
    for stage in answer.json()["stages"]:
        curve = stage["curve"]
        assert (curve["phase"][0], curve["phase"][-1]) == (0.0, 1.0)
        assert set(curve["pairs"]) == {1, 2}
        assert {len(column) for column in curve.values()} == {len(curve["phase"])}


def test_an_estimate_counts_meshes(refusing: Service) -> None:
    answer = refusing.post("/v1/estimates", train(SPUR, SPUR, SPUR)).json()
    assert (answer["nodes"], answer["mode"]) == (3, "sync")


def test_no_family_offers_what_needs_no_mechanism(refusing: Service) -> None:
    offered = refusing.get("/v1/kinds/five_bar").json()["analyses"]
    assert "friction_torque" not in offered


def test_a_job_is_about_no_mechanism(api: Service, run: Callable[..., dict[str, Any]]) -> None:
    job = run(train(SPUR, BEVEL))
    assert job["mechanism"] is None
    assert job["progress"]["total"] == 2
    assert job["links"]["grid"] is None
    found = api.get("/v1/jobs", params={"analysis": "friction_torque"}).json()["items"]
    assert [one["id"] for one in found] == [job["id"]]


def test_a_job_answers_as_directly(api: Service, run: Callable[..., dict[str, Any]]) -> None:
    body = train(SPUR, BEVEL, PAIR | {"base_pitch": 0.1}, contact="mean", curve_points=20)
    direct = api.post("/v1/analyses", body)
    assert api.get(run(body)["links"]["result"]).content == direct.content


@pytest.mark.parametrize("field", [None, "loss", "input_torque"])
@pytest.mark.parametrize("form", ["png", "svg"])
def test_a_job_has_a_figure(
    api: Service, run: Callable[..., dict[str, Any]], form: str, field: str | None
) -> None:
    wanted = {"format": form} | ({} if field is None else {"field": field})
    answer = api.get(run(train(SPUR, PAIR))["links"]["figure"], params=wanted)
    assert answer.status_code == 200
    start = {"png": b"\x89PNG", "svg": b"<?xml"}[form]
    assert answer.content.startswith(start)


def test_a_figure_has_no_other_fields(api: Service, run: Callable[..., dict[str, Any]]) -> None:
    answer = api.get(run(train(SPUR))["links"]["figure"], params={"field": "../x"})
    assert_problem(answer, 422, "?field")


def test_a_figure_needs_a_cycle(api: Service, run: Callable[..., dict[str, Any]]) -> None:
    answer = api.get(run(train(PAIR))["links"]["figure"])
    assert_problem(answer, 422, "/train")
    assert "base_pitch" in answer.json()["detail"]


def test_a_train_has_no_grid(api: Service, run: Callable[..., dict[str, Any]]) -> None:
    answer = api.get(run(train(SPUR))["links"]["self"] + "/grid")
    assert_problem(answer, 404)
    assert answer.json()["type"].endswith("no-grid")


def test_a_workspace_is_still_of_a_mechanism(refusing: Service) -> None:
    body = {
        "analysis": "workspace",
        "class": "theoretical",
        "type": "constant_orientation",
        "grid": grid(0.5),
    }
    assert_problem(refusing.post("/v1/analyses", body), 422, "/mechanism")
