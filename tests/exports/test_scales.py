"""From which value to which a field is shown."""

import numpy as np
import pytest

from exports.drawing.scales import scale_of


def test_shows_all_values_of_an_even_field() -> None:
    scale = scale_of(np.linspace(2.0, 7.0, 100), None)
    assert scale is not None
    assert (scale.low, scale.high, scale.below, scale.above) == (2.0, 7.0, False, False)


def test_leaves_out_a_far_tail_and_says_so() -> None:
    scale = scale_of(np.append(np.linspace(2.0, 7.0, 1000), 1e6), None)
    assert scale is not None
    assert scale.high < 12.0
    assert (scale.below, scale.above) == (False, True)


def test_infinity_lies_beyond_the_end() -> None:
    scale = scale_of(np.array([1.0, 2.0, np.inf]), None)
    assert scale is not None
    assert (scale.high, scale.above) == (2.0, True)


@pytest.mark.parametrize("limit", [1.5, 2.0, 5.0, 7.0, 9.0])
def test_takes_in_a_near_limit_off_its_ends(limit: float) -> None:
    scale = scale_of(np.linspace(2.0, 7.0, 100), limit)
    assert scale is not None
    assert scale.low < limit < scale.high


def test_a_far_limit_does_not_squeeze_the_values() -> None:
    scale = scale_of(np.linspace(2.0, 7.0, 100), 100.0)
    assert scale is not None
    assert scale.high == 7.0
    assert not scale.holds(100.0)


def test_zero_stands_in_the_middle_where_the_sign_changes() -> None:
    scale = scale_of(np.linspace(-1.0, 4.0, 100), None)
    assert scale is not None
    assert (scale.signed, scale.low, scale.high) == (True, -4.0, 4.0)


@pytest.mark.parametrize("value", [0.0, -3.0, 1e-12, 1e12])
def test_a_constant_field_has_a_range(value: float) -> None:
    scale = scale_of(np.full(10, value), None)
    assert scale is not None
    assert scale.low < value < scale.high


def test_no_finite_value_gives_no_scale() -> None:
    assert scale_of(np.array([np.nan, np.inf]), 1.0) is None


@pytest.mark.parametrize(
    ("value", "exponent"), [(0.02, 0), (5.0, 0), (9999.0, 0), (0.004, -3), (2e5, 3), (3e-8, -9)]
)
def test_takes_powers_of_ten_out_of_awkward_numbers(value: float, exponent: int) -> None:
    scale = scale_of(np.array([0.0, value]), None)
    assert scale is not None
    assert scale.exponent == exponent


def test_orders_of_size_are_told_apart_where_a_positive_field_spans_many() -> None:
    scale = scale_of(np.geomspace(0.5, 5000.0, 1000), None)
    assert scale is not None
    assert scale.logarithmic
    assert scale.share(np.array(50.0)) == pytest.approx(0.5, abs=0.02)


def test_a_field_that_touches_zero_keeps_even_steps() -> None:
    scale = scale_of(np.append(np.geomspace(0.5, 5000.0, 1000), 0.0), None)
    assert scale is not None
    assert not scale.logarithmic


def test_a_limit_is_taken_into_a_logarithmic_range() -> None:
    scale = scale_of(np.geomspace(1.0, 1000.0, 1000), 2000.0)
    assert scale is not None
    assert scale.logarithmic
    assert scale.holds(2000.0)
