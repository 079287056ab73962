"""The docs page and the description it shows."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from service.openapi import document_text
from tests.service.bodies import close
from tests.service.services import Service

COMMITTED = Path(__file__).parents[2] / "openapi.json"
VERBS = {"get", "put", "post", "delete", "patch", "head", "options"}
ANALYSES = [
    "inverse_kinematics",
    "forward_kinematics",
    "velocity",
    "effort",
    "singularity",
    "workspace",
    "friction_torque",
]
WITH_ANALYSIS = ["/v1/analyses", "/v1/estimates", "/v1/jobs"]


def committed() -> dict[str, Any]:
    document: dict[str, Any] = json.loads(COMMITTED.read_text(encoding="utf-8"))
    return document


def operations(document: dict[str, Any]) -> list[dict[str, Any]]:
    return [
        operation
        for path in document["paths"].values()
        for verb, operation in path.items()
        if verb in VERBS
    ]


def examples(path: str) -> dict[str, Any]:
    body = committed()["paths"][path]["post"]["requestBody"]["content"]["application/json"]
    found: dict[str, Any] = body["examples"]
    return found


def test_the_page_names_no_address_outside(refusing: Service) -> None:
    page = refusing.get("/docs")
    assert page.status_code == 200
    assert not re.search(r"(?:https?:)?//[\w-]+\.", page.text)


def test_the_files_of_the_page_are_served(refusing: Service) -> None:
    page = refusing.get("/docs").text
    files = re.findall(r'(?:src|href)="([^"]+)"', page)
    assert len(files) >= 3
    assert {refusing.get(file).status_code for file in files} == {200}


def test_the_styles_of_the_page_load_nothing_from_outside(refusing: Service) -> None:
    page = refusing.get("/docs").text
    styles = re.findall(r'href="([^"]+\.css)"', page)
    assert styles
    for style in styles:
        assert not re.search(r"url\(['\"]?(?:https?:)?//|@import", refusing.get(style).text)


def test_the_page_shows_the_served_description(refusing: Service) -> None:
    page = refusing.get("/docs").text
    (url,) = re.findall(r"url: '([^']+)'", page)
    assert refusing.get(url).json() == committed()


def test_the_committed_description_is_the_applications() -> None:
    assert COMMITTED.read_text(encoding="utf-8") == document_text(), "make openapi"


def test_no_committed_property_is_gone_from_the_application() -> None:
    ours = json.loads(document_text())["components"]["schemas"]
    gone = [
        f"{name}.{field}"
        for name, schema in committed()["components"]["schemas"].items()
        for field in schema.get("properties", {})
        if field not in ours.get(name, {}).get("properties", {})
    ]
    assert gone == []


def test_every_operation_has_an_id_of_its_own() -> None:
    names = [operation["operationId"] for operation in operations(committed())]
    assert len(set(names)) == len(names)
    assert all(re.fullmatch(r"[a-z]+(_[a-z]+)*", name) for name in names)


def test_every_declared_error_is_a_problem() -> None:
    for operation in operations(committed()):
        for status, response in operation["responses"].items():
            if status.startswith(("4", "5")):
                said = operation["operationId"], status
                assert list(response.get("content", {})) == ["application/problem+json"], said


def without_nulls(value: Any) -> Any:  # noqa: ANN401
    """Return a JSON value without the members that are null."""
    if isinstance(value, dict):
        return {name: without_nulls(part) for name, part in value.items() if part is not None}
    return [without_nulls(part) for part in value] if isinstance(value, list) else value


@pytest.mark.parametrize("path", WITH_ANALYSIS)
def test_every_analysis_has_an_example(path: str) -> None:
    assert examples(path).keys() == set(ANALYSES)


@pytest.mark.parametrize("name", ANALYSES)
def test_an_example_of_the_docs_gives_the_answer_of_the_docs(refusing: Service, name: str) -> None:
    answers = committed()["paths"]["/v1/analyses"]["post"]["responses"]["200"]["content"]
    stated = answers["application/json"]["examples"][name]["value"]
    answer = refusing.post("/v1/analyses", examples("/v1/analyses")[name]["value"])
    # FastAPI leaves nulls out of what it documents.
    assert close(without_nulls(answer.json()), without_nulls(stated))


@pytest.mark.parametrize("path", WITH_ANALYSIS)
@pytest.mark.parametrize("name", ANALYSES)
def test_an_example_of_the_docs_is_accepted(api: Service, path: str, name: str) -> None:
    assert api.post(path, examples(path)[name]["value"]).status_code in (200, 201)
