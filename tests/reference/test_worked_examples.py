"""The worked requests of the API docs give the worked answers."""

import pytest

import analyses
from schemas.analyses import Request
from schemas.examples import EXAMPLES, Example


def close(given: object, expected: object) -> bool:
    """Return whether two JSON documents agree, numbers to 1e-12."""
    if isinstance(expected, dict):
        return (
            isinstance(given, dict)
            and given.keys() == expected.keys()
            and all(close(given[key], expected[key]) for key in expected)
        )
    if isinstance(expected, list):
        return (
            isinstance(given, list)
            and len(given) == len(expected)
            and all(map(close, given, expected))
        )
    if isinstance(expected, float):
        return bool(given == pytest.approx(expected, rel=1e-12, abs=1e-12))
    return bool(given == expected)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.request.analysis)
def test_example(example: Example) -> None:
    answer = analyses.answer(example.request).model_dump(mode="json")
    assert close(answer, example.answer), answer


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.request.analysis)
def test_example_makes_sense(example: Example) -> None:
    analyses.check(example.request, 10**6)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.request.analysis)
def test_example_survives_the_wire(example: Example) -> None:
    returned: Request = analyses.parse(example.request.model_dump_json())
    assert returned == example.request


def test_every_analysis_has_an_example() -> None:
    assert {example.request.analysis for example in EXAMPLES} == set(analyses.desk.ANALYSES)
