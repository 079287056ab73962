"""Distances between segments, against bounded least squares, samples and by hand."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import lsq_linear

from mechanics.arrays import Floats
from mechanics.kernels.segments import distances

MANY = settings(max_examples=150, deadline=None)
ORIGIN = (0.0, 0.0, 0.0)


def between(starts: Floats, ends: Floats) -> float:
    """Return the distance of two segments, shape (2, 3) each."""
    found = np.empty((1, 1))
    one, two = np.array([0]), np.array([1])
    distances(one, two, starts[..., None].copy(), ends[..., None].copy(), found)
    return float(found[0, 0])


def optimised(starts: Floats, ends: Floats) -> float:
    """Return the least |p + s d - q - t e| over 0 <= s, t <= 1, a convex problem."""
    along = ends - starts
    matrix = np.column_stack([along[0], -along[1]])
    solved = lsq_linear(matrix, starts[1] - starts[0], (0.0, 1.0), method="bvls", tol=1e-14)
    return float(np.linalg.norm(matrix @ solved.x - (starts[1] - starts[0])))


@st.composite
def pairs(draw: st.DrawFn) -> tuple[Floats, Floats]:
    """Draw two segments of whole numbers: many meet, are parallel, in line, or have no length."""
    numbers = st.lists(st.integers(-3, 3), min_size=12, max_size=12)
    points = np.array(draw(numbers), dtype=float).reshape(2, 2, 3)
    jitter = draw(st.sampled_from([0.0, 0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 0.3]))
    points += jitter * np.random.default_rng(draw(st.integers(0, 999))).normal(size=(2, 2, 3))
    return points[0], points[1]


@MANY
@given(pairs())
def test_distances_are_the_least(pair: tuple[Floats, Floats]) -> None:
    assert between(*pair) == pytest.approx(optimised(*pair), abs=1e-9)


@MANY
@given(pairs())
def test_no_sampled_points_are_nearer(pair: tuple[Floats, Floats]) -> None:
    starts, ends = pair
    shares = np.linspace(0.0, 1.0, 101)[:, None]
    one, two = (starts[k] + shares * (ends[k] - starts[k]) for k in (0, 1))
    sampled = np.linalg.norm(one[:, None] - two[None], axis=-1).min()
    found = between(starts, ends)
    spacing = np.linalg.norm(ends - starts, axis=1).max() / 100
    assert sampled - spacing - 1e-12 <= found <= sampled + 1e-12


@MANY
@given(pairs())
def test_neither_order_nor_direction_matters(pair: tuple[Floats, Floats]) -> None:
    starts, ends = pair
    found = between(starts, ends)
    assert between(starts[::-1], ends[::-1]) == pytest.approx(found, abs=1e-12)
    assert between(ends, starts) == pytest.approx(found, abs=1e-12)
    swapped = np.stack([starts[0], ends[1]]), np.stack([ends[0], starts[1]])
    assert between(*swapped) == pytest.approx(found, abs=1e-12)


@pytest.mark.parametrize("angle", [1e-3, 1e-5, 1e-7, 1e-8, 1e-9, 1e-12, 0.0])
def test_segments_that_cross_at_a_small_angle(angle: float) -> None:
    # Their middles are 0.5 apart and their ends farther, however little that is.
    turn = np.array([np.cos(angle), np.sin(angle), 0.0])
    middle = np.array([[0.3, 0.1, 0.0], [0.3, 0.1, 0.5]])
    half = np.array([[1.0, 0.0, 0.0], turn])
    assert between(middle - half, middle + half) == pytest.approx(0.5, abs=1e-15)


HAND = {
    "skew": ((ORIGIN, (2, 0, 0)), ((1, -1, 3), (1, 1, 3)), 3.0),
    "crossing": ((ORIGIN, (2, 2, 0)), ((0, 2, 0), (2, 0, 0)), 0.0),
    "end to inside": ((ORIGIN, (2, 0, 0)), ((1, 1, 0), (1, 5, 0)), 1.0),
    "end to end": ((ORIGIN, (1, 0, 0)), ((4, 4, 0), (9, 9, 0)), 5.0),
    "parallel, side by side": ((ORIGIN, (2, 0, 0)), ((1, 1, 0), (3, 1, 0)), 1.0),
    "parallel, far along": ((ORIGIN, (2, 0, 0)), ((5, 4, 0), (9, 4, 0)), 5.0),
    "in line, apart": ((ORIGIN, (1, 0, 0)), ((3, 0, 0), (4, 0, 0)), 2.0),
    "in line, one on the other": ((ORIGIN, (4, 0, 0)), ((1, 0, 0), (2, 0, 0)), 0.0),
    "a point beside a segment": ((ORIGIN, ORIGIN), ((-1, 2, 0), (1, 2, 0)), 2.0),
    "two points": ((ORIGIN, ORIGIN), ((0, 3, 4), (0, 3, 4)), 5.0),
}


@pytest.mark.parametrize(("one", "two", "distance"), HAND.values(), ids=HAND)
def test_by_hand(
    one: tuple[tuple[float, ...], ...], two: tuple[tuple[float, ...], ...], distance: float
) -> None:
    starts, ends = np.array([one[0], two[0]], dtype=float), np.array([one[1], two[1]], dtype=float)
    assert between(starts, ends) == distance


@pytest.mark.parametrize("place", range(4))
def test_no_number_no_distance(place: int) -> None:
    points = np.random.default_rng(1).normal(size=(2, 2, 3))
    points[place // 2, place % 2, 1] = np.nan
    assert np.isnan(between(points[0], points[1]))
