"""Histograms from tiles, against all values at once."""

from collections.abc import Callable, Iterator

import numpy as np
import numpy.typing as npt
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from mechanics.histograms import histogram

MANY = settings(max_examples=150, deadline=None)
Floats = npt.NDArray[np.float64]

TAME = arrays.arrays(np.float64, st.integers(1, 300), elements=st.floats(-1e6, 1e6))
WILD = arrays.arrays(np.float64, st.integers(0, 60), elements=st.floats())
CUTS = st.lists(st.integers(0, 300), max_size=5)


def tiles(values: Floats, cuts: list[int]) -> Callable[[], Iterator[Floats]]:
    return lambda: iter(np.split(values, sorted(cuts)))


@MANY
@given(TAME, CUTS)
def test_counts_are_those_of_sorting_into_the_edges(values: Floats, cuts: list[int]) -> None:
    found = histogram(tiles(values, cuts))
    places = np.searchsorted(found.edges, values, side="right") - 1
    expected = np.bincount(np.minimum(places, 63), minlength=64)
    np.testing.assert_array_equal(found.counts, expected)


@MANY
@given(st.floats(-1e3, 1e3), st.floats(1e-3, 1e3))
def test_values_on_edges_and_beside_them_are_told_apart(low: float, width: float) -> None:
    edges = histogram(tiles(np.array([low, low + width]), [])).edges
    values = np.concatenate([edges, np.nextafter(edges, low), np.nextafter(edges, low + width)])
    places = np.searchsorted(edges, values, side="right") - 1
    expected = np.bincount(np.minimum(places, 63), minlength=64)
    np.testing.assert_array_equal(histogram(tiles(values, [])).counts, expected)


@MANY
@given(TAME, CUTS)
def test_the_ends_are_the_least_and_the_greatest(values: Floats, cuts: list[int]) -> None:
    edges = histogram(tiles(values, cuts)).edges
    assert (edges[0], edges[-1]) == (values.min(), values.max())


@MANY
@given(TAME, st.integers(1, 100))
def test_bins_are_equally_wide(values: Floats, bins: int) -> None:
    edges = histogram(tiles(values, []), bins).edges
    even = np.linspace(values.min(), values.max(), bins + 1)
    np.testing.assert_allclose(edges, even, rtol=0.0, atol=1e-15 * np.abs(values).max())


@MANY
@given(WILD, CUTS)
def test_every_value_is_counted_once(values: Floats, cuts: list[int]) -> None:
    """Not a number, infinite, or in a bin: however far apart the numbers are."""
    found = histogram(tiles(values, cuts))
    assert found.undefined == np.isnan(values).sum()
    assert found.infinite == np.isinf(values).sum()
    assert found.counts.sum() == np.isfinite(values).sum()
    assert (np.diff(found.edges) >= 0.0).all()


@MANY
@given(WILD, CUTS, st.integers(1, 3))
def test_tiles_change_nothing(values: Floats, cuts: list[int], rows: int) -> None:
    cut = histogram(tiles(np.repeat(values[:, None], rows, axis=1), cuts))
    whole = histogram(tiles(np.tile(values, rows), []))
    np.testing.assert_array_equal(cut.edges, whole.edges)
    np.testing.assert_array_equal(cut.counts, whole.counts)


def test_known_values_fall_into_known_bins() -> None:
    found = histogram(tiles(np.array([0.0, 1.0, 1.5, 2.0, 3.999, 4.0, np.nan]), [2]), 4)
    np.testing.assert_array_equal(found.edges, [0.0, 1.0, 2.0, 3.0, 4.0])
    np.testing.assert_array_equal(found.counts, [1, 2, 1, 2])
    assert found.undefined == 1


def test_one_value_fills_the_last_bin() -> None:
    found = histogram(tiles(np.full(5, 2.5), [3]))
    assert found.counts[-1] == 5
    assert set(found.edges) == {2.5}


def test_nothing_finite_has_no_bins() -> None:
    found = histogram(tiles(np.array([np.nan, np.inf, -np.inf, np.nan]), [1]))
    assert (found.edges.size, found.counts.size) == (0, 0)
    assert (found.undefined, found.infinite) == (2, 2)
