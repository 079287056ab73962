"""Requests made up from the description itself: never a 5xx, and every 4xx a problem."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import hypothesis
import pytest
import schemathesis
from hypothesis import HealthCheck, Phase
from schemathesis import APIOperation, Case, GenerationMode
from schemathesis.core.result import Ok
from schemathesis.schemas import BaseSchema

from tests.service.bodies import FIVE_BAR, INVERSE
from tests.service.services import PROBLEM_FIELDS, Service, service

DESCRIPTION = json.loads((Path(__file__).parents[2] / "openapi.json").read_text())
OPERATIONS = {
    operation["operationId"]: operation
    for path in DESCRIPTION["paths"].values()
    for operation in path.values()
}
# What has neither body nor query cannot be asked wrongly but by its path.
REFUSABLE = [
    name
    for name, operation in OPERATIONS.items()
    if "requestBody" in operation
    or any(parameter["in"] == "query" for parameter in operation.get("parameters", []))
]
Operation = APIOperation[Any, Any, Any, Any]
MAY_BE_UNAVAILABLE = {"get_readiness"}
EXAMPLES = 15
SLOW_BUT_WELL = [
    HealthCheck.too_slow,
    HealthCheck.filter_too_much,
    HealthCheck.data_too_large,
    HealthCheck.large_base_example,
]


@pytest.fixture(scope="module")
def api(tmp_path_factory: pytest.TempPathFactory, migrated: Path) -> Iterator[Service]:
    """Return a service that keeps what these requests make it keep."""
    with service(tmp_path_factory.mktemp("any"), migrated) as kept:
        kept.post("/v1/mechanisms", FIVE_BAR)
        kept.post("/v1/jobs", INVERSE)
        yield kept


@pytest.fixture(scope="module")
def operations(api: Service) -> dict[str, Operation]:
    """Return the operations of the description that the service gives of itself."""
    schema: BaseSchema = schemathesis.openapi.from_asgi("/openapi.json", api.client.app)
    results = schema.get_all_operations()
    found = [result.ok() for result in results if isinstance(result, Ok)]
    return {operation.definition.raw["operationId"]: operation for operation in found}


def try_out(operation: Operation, mode: GenerationMode, *, may_be_unavailable: bool) -> None:
    """Send what the strategy makes up, always the same."""

    def answer_is_well_formed(case: Case[Any]) -> None:
        answer = case.call()
        status = answer.status_code
        assert status < 500 or (may_be_unavailable and status == 503), answer.text
        if status >= 400:
            assert answer.headers["content-type"] == ["application/problem+json"]
            assert answer.json().keys() == PROBLEM_FIELDS

    cases = operation.as_strategy(generation_mode=mode)
    test = hypothesis.given(case=cases)(answer_is_well_formed)
    test = hypothesis.settings(
        max_examples=EXAMPLES,
        deadline=None,
        database=None,
        derandomize=True,
        phases=[Phase.generate],
        suppress_health_check=SLOW_BUT_WELL,
    )(test)
    test()


@pytest.mark.parametrize("name", OPERATIONS)
def test_a_request_as_described_is_answered(operations: dict[str, Operation], name: str) -> None:
    unavailable = name in MAY_BE_UNAVAILABLE
    try_out(operations[name], GenerationMode.POSITIVE, may_be_unavailable=unavailable)


@pytest.mark.parametrize("name", REFUSABLE)
def test_a_request_unlike_the_description_is_answered(
    operations: dict[str, Operation], name: str
) -> None:
    try_out(operations[name], GenerationMode.NEGATIVE, may_be_unavailable=False)
