"""The part of a region about home, against flood filling sign by sign."""

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from scipy import ndimage

from mechanics.errors import MechanicsError
from mechanics.parts import home_part, kept, signs_of
from tests.oracles.masks import dense, region_of

MANY = settings(max_examples=150, deadline=None)
OTHER = 7
STEPS = (0.5, 0.25, 2.0)
OUTSIDE = 9
Field = npt.NDArray[np.int8]


@st.composite
def fields(draw: st.DrawFn) -> Field:
    """Return the sign of each node of a grid of 1 to 3 axes, or that it is outside."""
    rank = draw(st.integers(1, 3))
    shape = draw(arrays.array_shapes(min_dims=rank, max_dims=rank, min_side=1, max_side=9))
    often = draw(st.sampled_from([(1, -1, OUTSIDE), (1, 1, 1, -1, 0, OUTSIDE), (1, 1, -1, 0)]))
    return draw(arrays.arrays(np.int8, shape, elements=st.sampled_from(often)))


def flood(field: Field, home: int) -> npt.NDArray[np.bool_]:
    """Return which nodes the fill from home reaches."""
    sign = field.ravel()[home]
    if sign == OUTSIDE:
        return np.zeros(field.shape, dtype=bool)
    labels, _ = ndimage.label(field == sign)
    reached: npt.NDArray[np.bool_] = labels == labels.ravel()[home]
    return reached


@MANY
@given(fields(), st.integers(0, 10**6))
def test_the_part_is_what_a_flood_reaches(field: Field, seed: int) -> None:
    home = seed % field.size
    inside = field != OUTSIDE
    region = region_of(inside, STEPS)
    part = home_part(region, field[inside], home, OTHER)
    expected = np.where(flood(field, home), 0, np.where(inside, OTHER, dense(region)))
    np.testing.assert_array_equal(dense(part), expected)


@MANY
@given(fields(), st.integers(0, 10**6))
def test_what_is_kept_is_told_in_node_order(field: Field, seed: int) -> None:
    home = seed % field.size
    inside = field != OUTSIDE
    part = home_part(region_of(inside, STEPS), field[inside], home, OTHER)
    np.testing.assert_array_equal(kept(part, OTHER), flood(field, home)[inside])


@MANY
@given(fields(), st.integers(0, 10**6))
def test_runs_end_with_their_lines(field: Field, seed: int) -> None:
    inside = field != OUTSIDE
    part = home_part(region_of(inside, STEPS), field[inside], seed % field.size, OTHER)
    line = field.shape[-1]
    stops = np.cumsum(part.lengths)
    assert part.lengths.min() > 0
    assert ((stops - 1) // line == (stops - part.lengths) // line).all()


@MANY
@given(fields(), st.integers(0, 10**6))
def test_the_part_is_one(field: Field, seed: int) -> None:
    home = seed % field.size
    inside = field != OUTSIDE
    part = home_part(region_of(inside, STEPS), field[inside], home, OTHER)
    assert len(part.components) == int(inside.ravel()[home])


def test_a_line_of_zeros_parts_two_of_one_sign() -> None:
    field = np.array([[1, 1, 0, 1], [1, 1, 0, 1]], dtype=np.int8)
    part = home_part(region_of(np.ones((2, 4), dtype=bool), STEPS), field.ravel(), 0, OTHER)
    np.testing.assert_array_equal(dense(part), [[0, 0, 7, 7]] * 2)


def test_a_home_beyond_the_grid_is_not_inside() -> None:
    region = region_of(np.ones((2, 3), dtype=bool), STEPS)
    for home in (-1, 6):
        assert home_part(region, np.ones(6, dtype=np.int8), home, OTHER).nodes == 0


def test_signs_that_are_not_one_a_node_are_refused() -> None:
    region = region_of(np.ones((2, 3), dtype=bool), STEPS)
    with pytest.raises(MechanicsError, match=r"shape \(6,\)"):
        home_part(region, np.ones(5, dtype=np.int8), 0, OTHER)


def test_signs_are_those_of_numbers_and_nan_has_none() -> None:
    values = np.array([3.0, -1e-300, 0.0, -0.0, np.nan, np.inf, -np.inf])
    np.testing.assert_array_equal(signs_of(values), [1, -1, 0, 0, 0, 1, -1])
