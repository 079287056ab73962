"""The largest ball and box inside regions, against every ball and every box there is."""

from itertools import product

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage

from mechanics.inscribed import largest_ball, largest_box
from mechanics.kernels.distances import counts, farthest
from mechanics.motions import TRANSLATION
from tests.oracles.masks import ORIGIN, Mask, region_of

MANY = settings(max_examples=60, deadline=None)
STEPS = (0.5, 0.25, 2.0)
SIDES = {1: 40, 2: 16, 3: 9}


@st.composite
def masks(draw: st.DrawFn) -> Mask:
    """Return what is left of a whole grid without some boxes and some single nodes."""
    rank = draw(st.integers(1, 3))
    shape = draw(st.lists(st.integers(1, SIDES[rank]), min_size=rank, max_size=rank))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    inside = random.random(shape) >= draw(st.sampled_from([0.0, 0.05, 0.2, 0.6]))
    for _ in range(draw(st.integers(0, 3))):
        ends = [sorted(random.integers(0, side + 1, 2)) for side in shape]
        inside[tuple(slice(*end) for end in ends)] = False
    return inside


def greatest_measure(inside: Mask) -> float:
    """Try all pairs of corners, counting what is outside between them by sums from the first."""
    sums = np.pad(~inside, [(1, 0)] * inside.ndim).astype(int)
    measures = np.ones(())
    for axis, step in enumerate(STEPS[: inside.ndim]):
        first, last = np.triu_indices(inside.shape[axis], 1)
        sums = np.cumsum(sums, axis=axis)
        sums = sums.take(last + 1, axis=axis) - sums.take(first, axis=axis)
        measures = np.multiply.outer(measures, (last - first) * step)
    return float(measures[sums == 0].max(initial=0.0))


def greatest_radius(inside: Mask) -> float:
    """Try all nodes against the box about every node outside, a step to each side."""
    steps = np.array(STEPS[: inside.ndim])
    around = np.pad(inside, 1)
    outside = np.argwhere(~around)
    best = 0.0
    for node in np.argwhere(around):
        gaps = np.maximum(np.abs(outside - node) - 1, 0) * steps
        best = max(best, float(np.sqrt((gaps**2).sum(axis=1).min())))
    return best


def ellipsoid(
    rank: int, centre: list[float], radii: list[float]
) -> tuple[Mask, npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Return an ellipsoid's mask, and its centre and half axes in the grid's coordinates."""
    side = {1: 60, 2: 41, 3: 21}[rank]
    middle = (side - 1) / 2 + np.array(centre[:rank])
    half = np.array(radii[:rank]) * (side / 2 - 2)
    nodes = np.indices((side,) * rank).reshape(rank, -1).T
    inside = (((nodes - middle) / half) ** 2).sum(axis=1) <= 1.0
    steps = np.array(STEPS[:rank])
    return inside.reshape((side,) * rank), ORIGIN + middle * steps, half * steps


@MANY
@given(masks())
def test_the_box_is_the_greatest_of_all(inside: Mask) -> None:
    box = largest_box(region_of(inside, STEPS))
    assert (box.measure if box else 0.0) == pytest.approx(greatest_measure(inside), rel=1e-12)


@MANY
@given(masks())
def test_all_nodes_of_the_box_are_inside(inside: Mask) -> None:
    box = largest_box(region_of(inside, STEPS))
    if box is not None:
        steps = np.array(STEPS[: inside.ndim])
        first = ((box.minimum - ORIGIN) / steps).round().astype(int)
        last = ((box.maximum - ORIGIN) / steps).round().astype(int)
        assert inside[tuple(slice(a, b + 1) for a, b in zip(first, last, strict=True))].all()


@MANY
@given(masks())
def test_the_ball_is_the_greatest_about_any_node(inside: Mask) -> None:
    ball = largest_ball(region_of(inside, STEPS), TRANSLATION)
    assert (ball.radius if ball else 0.0) == pytest.approx(greatest_radius(inside), rel=1e-12)


@MANY
@given(masks())
def test_every_node_of_the_ball_is_inside(inside: Mask) -> None:
    ball = largest_ball(region_of(inside, STEPS), TRANSLATION)
    if ball is not None:
        steps = np.array(STEPS[: inside.ndim])
        around = np.pad(inside, 1)
        places = ORIGIN + (np.argwhere(~around) - 1) * steps
        assert np.linalg.norm(places - ball.centre, axis=1).min() > ball.radius


@MANY
@given(st.integers(0, 2**32 - 1), st.sampled_from([0.02, 0.1, 0.3]), st.sampled_from([1.0, 3.0]))
def test_no_node_of_a_large_mask_is_overlooked(seed: int, outside: float, blur: float) -> None:
    """Blurred noise has deep places that differ by little, so that bounds come to be tried."""
    random = np.random.default_rng(seed)
    noise = ndimage.gaussian_filter(random.random(random.integers(8, 48, 3)), blur)
    mask = noise > np.quantile(noise, outside)
    mask[[0, -1]] = mask[:, [0, -1]] = mask[:, :, [0, -1]] = False
    steps = np.array(STEPS)
    square, node = farthest(counts(mask), steps)
    exact = ndimage.distance_transform_edt(mask, sampling=steps)
    assert np.sqrt(square) == pytest.approx(exact.max(), rel=1e-12)
    assert exact.ravel()[node] == pytest.approx(exact.max(), rel=1e-12)


CENTRES = st.lists(st.floats(-2.0, 2.0), min_size=3, max_size=3)
RADII = st.lists(st.floats(0.3, 1.0), min_size=3, max_size=3)


@MANY
@given(st.integers(1, 3), CENTRES, RADII)
def test_the_box_lies_in_a_convex_region_itself(
    rank: int, centre: list[float], radii: list[float]
) -> None:
    """All corners of the box do, between the nodes too."""
    inside, middle, half = ellipsoid(rank, centre, radii)
    box = largest_box(region_of(inside, STEPS))
    if box is not None:
        for corner in product(*zip(box.minimum, box.maximum, strict=True)):
            assert (((np.array(corner) - middle) / half) ** 2).sum() <= 1.0 + 1e-9


@MANY
@given(st.integers(1, 3), CENTRES, RADII)
def test_the_ball_lies_in_a_convex_region_itself(
    rank: int, centre: list[float], radii: list[float]
) -> None:
    """All its points do: a plane touches the region in every direction, and none cuts the ball."""
    inside, middle, half = ellipsoid(rank, centre, radii)
    ball = largest_ball(region_of(inside, STEPS), TRANSLATION)
    if ball is not None:
        directions = np.random.default_rng(0).normal(size=(2000, rank))
        directions /= np.linalg.norm(directions, axis=1)[:, None]
        support = np.linalg.norm(directions * half, axis=1)
        assert (directions @ (ball.centre - middle) + ball.radius <= support + 1e-9).all()


@MANY
@given(st.integers(1, 3), CENTRES, st.floats(0.3, 1.0))
def test_the_ball_of_a_ball_is_short_by_a_cell_and_a_half_at_most(
    rank: int, centre: list[float], radius: float
) -> None:
    steps = np.ones(rank)
    inside, _, half = ellipsoid(rank, centre, [radius] * 3)
    ball = largest_ball(region_of(inside, tuple(steps)), TRANSLATION)
    exact = half[0] / STEPS[0]
    found = ball.radius if ball else 0.0
    assert exact - 1.5 * np.sqrt(rank) <= found <= exact
