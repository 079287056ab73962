"""Which format an Accept header asks for."""

import pytest

from service.refusals import Refusal
from service.routers.results import _accepted

GRID = ("npz", "csv")


@pytest.mark.parametrize(
    ("accept", "format"),
    [
        (None, "npz"),
        ("*/*", "npz"),
        ("text/csv", "csv"),
        ("text/*", "csv"),
        ("application/x-npz", "npz"),
        ("application/octet-stream", "npz"),
        ("application/x-npz;q=0, text/csv", "csv"),
        ("text/csv;q=0.1, application/x-npz", "npz"),
        ("image/png, text/csv;q=0.5", "csv"),
    ],
)
def test_the_most_wanted_format_is_chosen(accept: str | None, format: str) -> None:
    assert _accepted(accept, GRID) == format


@pytest.mark.parametrize("accept", ["image/*", "text/html", "text/csv;q=0", "nonsense"])
def test_what_is_not_offered_is_not_acceptable(accept: str) -> None:
    with pytest.raises(Refusal) as refused:
        _accepted(accept, GRID)
    assert refused.value.status == 406
