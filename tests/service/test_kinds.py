"""`/v1/kinds`."""

import jsonschema_rs
import pytest

from tests.service.services import Service, assert_problem

FIELDS = {
    "kind",
    "title",
    "motion",
    "coordinates",
    "coordinate_units",
    "drives",
    "analyses",
    "json_schema",
    "example",
    "presets",
}
KINDS = [
    "five_bar",
    "planar_3rrr",
    "translational_3rrrr",
    "delta_rotary",
    "delta_linear",
    "delta_linear_4dof",
    "hexa_linear",
    "gough_stewart",
    "hexa_rotary",
    "spherical_3rrr",
    "geared_decoupled",
    "custom",
]


def test_the_list_has_every_kind(refusing: Service) -> None:
    items = refusing.get("/v1/kinds").json()["items"]
    assert [item["kind"] for item in items] == KINDS


@pytest.mark.parametrize("kind", KINDS)
def test_one_kind_is_as_in_the_list(refusing: Service, kind: str) -> None:
    listed = {item["kind"]: item for item in refusing.get("/v1/kinds").json()["items"]}
    assert refusing.get(f"/v1/kinds/{kind}").json() == listed[kind]


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_has_every_field(refusing: Service, kind: str) -> None:
    assert refusing.get(f"/v1/kinds/{kind}").json().keys() == FIELDS


def test_a_five_bar_moves_in_x_and_y(refusing: Service) -> None:
    kind = refusing.get("/v1/kinds/five_bar").json()
    assert kind["coordinates"] == ["x", "y"]
    assert kind["coordinate_units"] == ["m", "m"]
    assert kind["drives"] == ["crank", "crank"]


def test_a_planar_3rrr_also_turns(refusing: Service) -> None:
    kind = refusing.get("/v1/kinds/planar_3rrr").json()
    assert kind["coordinates"] == ["x", "y", "phi"]
    assert kind["coordinate_units"] == ["m", "m", "rad"]
    assert kind["drives"] == ["crank"] * 3


@pytest.mark.parametrize("kind", KINDS)
def test_a_kind_offers_every_analysis(refusing: Service, kind: str) -> None:
    offered = refusing.get(f"/v1/kinds/{kind}").json()["analyses"]
    assert offered == [
        "inverse_kinematics",
        "forward_kinematics",
        "velocity",
        "effort",
        "singularity",
        "workspace",
        *(["friction_torque"] if kind == "geared_decoupled" else []),
    ]


@pytest.mark.parametrize("kind", KINDS)
def test_the_schema_accepts_the_example(refusing: Service, kind: str) -> None:
    document = refusing.get(f"/v1/kinds/{kind}").json()
    validator = jsonschema_rs.validator_for(document["json_schema"])
    assert validator.is_valid(document["example"])


@pytest.mark.parametrize("kind", KINDS)
def test_the_schema_refuses_an_unknown_field(refusing: Service, kind: str) -> None:
    document = refusing.get(f"/v1/kinds/{kind}").json()
    validator = jsonschema_rs.validator_for(document["json_schema"])
    assert not validator.is_valid(document["example"] | {"colour": "red"})


@pytest.mark.parametrize("kind", KINDS)
def test_the_example_can_be_stored(api: Service, kind: str) -> None:
    example = api.get(f"/v1/kinds/{kind}").json()["example"]
    assert api.post("/v1/mechanisms", example).status_code == 201


def test_the_papers_machines_are_presets(refusing: Service) -> None:
    items = refusing.get("/v1/kinds").json()["items"]
    names = {preset["name"] for item in items for preset in item["presets"]}
    assert names >= {"planar_3rrr_2016", "five_bar_printer_2017", "delta_linear_4dof_2019"}


@pytest.mark.parametrize("kind", KINDS)
def test_every_preset_names_its_source(refusing: Service, kind: str) -> None:
    presets = refusing.get(f"/v1/kinds/{kind}").json()["presets"]
    assert all(len(preset["source"]) > 20 for preset in presets)


@pytest.mark.parametrize("kind", KINDS)
def test_presets_are_of_their_kind_and_have_own_names(refusing: Service, kind: str) -> None:
    presets = refusing.get(f"/v1/kinds/{kind}").json()["presets"]
    assert all(preset["mechanism"]["kind"] == kind for preset in presets)
    assert len({preset["name"] for preset in presets}) == len(presets)


@pytest.mark.parametrize("kind", ["five_bar", "planar_3rrr"])
def test_every_preset_can_be_analysed(refusing: Service, kind: str) -> None:
    document = refusing.get(f"/v1/kinds/{kind}").json()
    pose = {"x": 0.0, "y": 0.2 if kind == "five_bar" else 0.0, "phi": 0.0}
    for preset in document["presets"]:
        request = {
            "analysis": "inverse_kinematics",
            "mechanism": preset["mechanism"],
            "poses": [[pose[coordinate] for coordinate in document["coordinates"]]],
        }
        assert refusing.post("/v1/analyses", request).json()["reachable"] == [True]


def test_an_unknown_kind_is_not_found(refusing: Service) -> None:
    assert_problem(refusing.get("/v1/kinds/hexapod"), 404)
