"""Zeros of trigonometric polynomials, against polynomials made from their zeros."""

import numpy as np
import pytest

from mechanics.assembly.trigonometric import ANGLES, zeros
from tests.oracles.legs import Floats


def values(*angles: float) -> Floats:
    """Return the values at `ANGLES` of the product of sin((phi - angle) / 2), one a row."""
    made: Floats = np.prod(np.sin(0.5 * (ANGLES[:, None] - np.array(angles))), axis=1)[None]
    return made


def near(found: Floats, angle: float) -> float:
    return float(np.nanmin(np.abs(np.angle(np.exp(1j * (found - angle))))))


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("degree", [3, 4])
def test_all_zeros_of_a_product(degree: int, seed: int) -> None:
    angles = np.sort(np.random.default_rng(seed).uniform(-3.0, 3.0, 2 * degree))
    apart = np.diff(angles).min()
    found = zeros(values(*angles), degree)
    assert np.isfinite(found).sum() == 2 * degree
    assert max(near(found, angle) for angle in angles) < 1e-9 / apart**2


@pytest.mark.parametrize("scale", [1e-200, 1e200])
def test_zeros_do_not_depend_on_the_scale(scale: float) -> None:
    found = zeros(scale * values(-2.0, -1.0, 0.5, 2.5), 2)
    assert max(near(found, angle) for angle in (-2.0, -1.0, 0.5, 2.5)) < 1e-13


def test_a_lower_degree_than_promised_loses_nothing() -> None:
    found = zeros(values(-1.0, 2.0), 4)
    assert max(near(found, angle) for angle in (-1.0, 2.0)) < 1e-12


def test_zeros_far_from_real_are_left_out() -> None:
    assert np.isnan(zeros((2.0 + np.cos(ANGLES))[None], 1)).all()


def test_a_double_zero_is_proposed_to_either_side() -> None:
    found = zeros(values(0.7, 0.7, -1.0, 2.0), 2)
    assert np.sum(np.abs(found - 0.7) < 1e-6) == 2


def test_a_zero_at_half_a_turn_is_no_infinity() -> None:
    assert near(zeros(values(np.pi, 0.0, 1.0, -2.0), 2), np.pi) < 1e-13


def test_rows_do_not_depend_on_their_company() -> None:
    rows = np.vstack(
        [values(*angles) for angles in np.random.default_rng(0).uniform(-3, 3, (9, 6))]
    )
    together = zeros(rows, 3)
    for row, found in zip(rows, together, strict=True):
        np.testing.assert_array_equal(zeros(row[None], 3)[0], found)
