"""From the places that pydantic names to JSON pointers into what the caller sent."""

import reprlib
from collections.abc import Sequence
from typing import Any

import analyses

MOST_READ = 200
"""Errors of the validator that are looked at; there may be one for every number of a list."""

_SHORT = reprlib.Repr()
_SHORT.maxstring = _SHORT.maxother = 80


def field_errors(errors: Sequence[Any], body: Any) -> list[tuple[str, str]]:  # noqa: ANN401
    """Return pointer and detail of the first invalid fields, what one field may be gathered.

    Parameters
    ----------
    errors : pydantic's errors, their `loc` starting with body, query, path or header.
    body : the decoded request body.
    """
    messages: dict[str, list[str]] = {}
    given: dict[str, str] = {}
    for error in errors[:MOST_READ]:
        pointer = _pointer(error, body)
        gathered = messages.setdefault(pointer, [])
        if (message := _message(error)) not in gathered:
            gathered.append(message)
        given[pointer] = _given(error)
    return [(p, " or ".join(texts) + given[p]) for p, texts in _deepest(messages).items()]


def _deepest(messages: dict[str, list[str]]) -> dict[str, list[str]]:
    # A union complains at the field about every branch that did not fit, and inside the one
    # that was meant: the latter says more.
    above = {pointer[:cut] for pointer in messages for cut in _cuts(pointer)}
    return {pointer: texts for pointer, texts in messages.items() if pointer not in above}


def _cuts(pointer: str) -> list[int]:
    return [place for place, sign in enumerate(pointer) if sign == "/"]


def _pointer(error: Any, body: Any) -> str:  # noqa: ANN401
    place, *steps = error["loc"]
    if place != "body":
        return f"{'?' if place == 'query' else f'{place}:'}{'.'.join(map(str, steps))}"
    path = []
    here = body
    for step in steps:
        if _leads_on(here, step):
            here = here[step]
        elif error["type"] not in ("missing", "extra_forbidden") or step is not steps[-1]:
            # The name of a union's branch, which the caller never wrote.
            continue
        path.append(step)
    if error["type"].startswith("union_tag") and isinstance(here, dict):
        path.append(error["ctx"]["discriminator"].strip("'"))
    return analyses.pointer(*path)


def _leads_on(here: Any, step: int | str) -> bool:  # noqa: ANN401
    if isinstance(here, dict):
        return step in here
    return isinstance(here, list) and isinstance(step, int) and step < len(here)


def _message(error: Any) -> str:  # noqa: ANN401
    return str(error["msg"]).removeprefix("Value error, ").removeprefix("Input ")


def _given(error: Any) -> str:  # noqa: ANN401
    if error["type"] in ("missing", "union_tag_not_found"):
        return ""
    return f"; given {_SHORT.repr(error.get('input'))}"
