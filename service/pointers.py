"""From the places that pydantic names to JSON pointers into what the caller sent."""

from collections.abc import Sequence
from typing import Any

MOST_REPORTED = 20
LONGEST_INPUT = 80


def field_errors(errors: Sequence[Any], body: Any) -> list[tuple[str, str]]:  # noqa: ANN401
    """Return pointer and detail of each invalid field, what one field may be gathered.

    Parameters
    ----------
    errors : pydantic's errors, their `loc` starting with body, query, path or header.
    body : the decoded request body.
    """
    messages: dict[str, list[str]] = {}
    given: dict[str, str] = {}
    for error in errors:
        pointer = _pointer(error, body)
        gathered = messages.setdefault(pointer, [])
        if (message := _message(error)) not in gathered:
            gathered.append(message)
        given[pointer] = _given(error)
    pairs = [(p, " or ".join(texts) + given[p]) for p, texts in _deepest(messages).items()]
    if len(pairs) > MOST_REPORTED:
        more = len(pairs) - MOST_REPORTED
        return [*pairs[:MOST_REPORTED], ("", f"{more} more fields are invalid")]
    return pairs


def _deepest(gathered: dict[str, list[str]]) -> dict[str, list[str]]:
    # A union complains at the field about every branch that did not fit, and inside the one
    # that was meant: the latter says more.
    return {
        pointer: details
        for pointer, details in gathered.items()
        if not any(other.startswith(pointer + "/") for other in gathered)
    }


def _pointer(error: Any, body: Any) -> str:  # noqa: ANN401
    place, *steps = error["loc"]
    if place != "body":
        return f"{'?' if place == 'query' else f'{place}:'}{'.'.join(map(str, steps))}"
    pointer = ""
    here = body
    for step in steps:
        if _leads_on(here, step):
            here = here[step]
        elif error["type"] not in ("missing", "extra_forbidden") or step is not steps[-1]:
            # The name of a union's branch, which the caller never wrote.
            continue
        pointer += "/" + str(step).replace("~", "~0").replace("/", "~1")
    return pointer


def _leads_on(here: Any, step: int | str) -> bool:  # noqa: ANN401
    if isinstance(here, dict):
        return step in here
    return isinstance(here, list) and isinstance(step, int) and step < len(here)


def _message(error: Any) -> str:  # noqa: ANN401
    return str(error["msg"]).removeprefix("Value error, ").removeprefix("Input ")


def _given(error: Any) -> str:  # noqa: ANN401
    if error["type"] in ("missing", "union_tag_not_found"):
        return ""
    text = repr(error.get("input"))
    return f"; given {text[:LONGEST_INPUT]}{'...' if len(text) > LONGEST_INPUT else ''}"
