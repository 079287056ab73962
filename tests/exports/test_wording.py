"""Words and numbers as they are printed."""

import numpy as np
import pytest

from exports.drawing.wording import labelled, numbers, plain, wrapped


@pytest.mark.parametrize(
    ("values", "exponent", "texts"),
    [
        ([0.0, 0.5, 1.0], 0, ["0.0", "0.5", "1.0"]),
        ([0.25, 0.5, 0.75], 0, ["0.25", "0.50", "0.75"]),
        ([-2.0, 0.0, 2.0], 0, ["−2", "0", "2"]),
        ([-0.1, -1e-17, 0.1], 0, ["−0.1", "0.0", "0.1"]),
        ([2e5, 4e5], 3, ["200", "400"]),
        ([3.0], 0, ["3"]),
        ([], 0, []),
    ],
)
def test_numbers_have_the_digits_that_tell_them_apart(
    values: list[float], exponent: int, texts: list[str]
) -> None:
    assert numbers(np.array(values), exponent) == texts


@pytest.mark.parametrize(
    ("label", "unit", "exponent", "text"),
    [
        ("x", "m", 0, "$x$ (m)"),
        ("rz", "rad", 0, "rz (rad)"),
        ("Condition number", "", 0, "Condition number"),
        ("Condition number", "", 3, r"Condition number ($\times 10^{3}$)"),
        ("Torque", "N·m", -3, "Torque ($10^{-3}$ N·m)"),
        ("cost in $", "", 0, r"cost in \$"),
    ],
)
def test_a_label_carries_its_unit(label: str, unit: str, exponent: int, text: str) -> None:
    assert labelled(label, unit, exponent) == text


def test_plain_text_is_one_printable_line() -> None:
    assert plain(" a\n\tb\x00c\ud800 ") == "a b c"


def test_long_text_is_broken_and_cut() -> None:
    lines = wrapped("word " * 200, 300.0, 12.0).splitlines()
    assert len(lines) == 3
    assert lines[-1].endswith("…")


def test_an_equation_stays_on_one_line() -> None:
    lines = wrapped("section at y = 0", 70.0, 12.0).splitlines()
    assert lines[-1] == "y\u00a0=\u00a00"
