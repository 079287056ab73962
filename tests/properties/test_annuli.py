"""Random annuli: area, centroid, bounds and parts against dense grids and against each other."""

import math
from dataclasses import replace
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage

from mechanics.arrays import Floats
from mechanics.geometry.annuli import Annulus, contains, intersect

MANY = settings(max_examples=80, deadline=None)
FEW = settings(max_examples=25, deadline=None)
# The annuli of seed 3 have nothing in common.
SEEDS = (0, 1, 2, 4, 5, 6, 7, 8)
CLOSE = 1e-11

Annuli = list[Annulus]


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_subnormal=False)


# Sixteenths make circles touch, coincide and meet three in a point, exactly.
STEPS = st.integers(0, 32).map(lambda steps: steps / 16)
CENTRES = STEPS | numbers(0.0, 2.0)
WIDTHS = STEPS | numbers(0.0, 2.0)


@st.composite
def annuli(draw: st.DrawFn) -> Annulus:
    inner = draw(WIDTHS)
    return Annulus(np.array([draw(CENTRES), draw(CENTRES)]), inner, inner + draw(WIDTHS))


SOME = st.lists(annuli(), min_size=1, max_size=6)


def at_random(seed: int) -> Annuli:
    draws = np.random.default_rng(seed)
    return [
        Annulus(draws.normal(0, 0.4, 2), draws.uniform(0, 0.6), draws.uniform(0.8, 1.5))
        for _ in range(2 + seed % 4)
    ]


def grid(step: float) -> Floats:
    # Off the lines x = 0 and y = 0, so that nothing falls together.
    axis = np.arange(-2.0 + 0.37 * step, 2.0, step)
    return np.stack(np.meshgrid(axis, axis, indexing="ij"), axis=-1)


WIDE = 2.0 * grid(0.05).reshape(-1, 2)
HAIR = 1e-9


def moved(one: Annulus, turn: float, shift: Floats) -> Annulus:
    rotation = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    return replace(one, centre=rotation @ one.centre + shift)


@pytest.mark.parametrize("seed", SEEDS)
def test_area_is_what_ever_finer_grids_count(seed: int) -> None:
    rings = at_random(seed)
    exact = intersect(rings).area
    errors = [abs(contains(rings, grid(h)).sum() * h**2 - exact) for h in (0.02, 0.0025)]
    # Random nodes on a border of length s miss by about step^1.5 sqrt(s).
    assert errors[0] < 3 * 0.02**1.5
    assert errors[1] < 3 * 0.0025**1.5


@pytest.mark.parametrize("seed", SEEDS)
def test_centroid_is_that_of_a_fine_grid(seed: int) -> None:
    rings = at_random(seed)
    nodes = grid(0.0025)
    inside = nodes[contains(rings, nodes)]
    centroid = intersect(rings).centroid
    assert centroid is not None
    np.testing.assert_allclose(centroid, inside.mean(axis=0), atol=1e-3)


@pytest.mark.parametrize("seed", SEEDS)
def test_parts_and_holes_are_those_of_a_fine_grid(seed: int) -> None:
    rings = at_random(seed)
    inside = np.pad(contains(rings, grid(0.0025)), 1)
    found = intersect(rings)
    parts = ndimage.label(inside, np.ones((3, 3)))[1]
    assert (found.components, found.holes) == (parts, ndimage.label(~inside)[1] - 1)


@MANY
@given(SOME)
def test_no_node_inside_is_out_of_bounds(rings: Annuli) -> None:
    # Regions leave out points and lines without area, grids do not: the annuli are thinned.
    thin = [
        Annulus(r.centre, r.inner + HAIR, r.outer - HAIR)
        for r in rings
        if r.outer > r.inner + 3 * HAIR
    ]
    nodes = WIDE[contains(thin, WIDE)] if len(thin) == len(rings) else WIDE[:0]
    bounds = intersect(rings).bounds or (np.full(2, math.inf), np.full(2, -math.inf))
    assert np.all((nodes >= bounds[0] - CLOSE) & (nodes <= bounds[1] + CLOSE))


@MANY
@given(SOME, annuli())
def test_a_disc_and_what_is_outside_of_it_make_the_whole(rings: Annuli, other: Annulus) -> None:
    whole = intersect(rings).area
    inside = intersect([*rings, Annulus(other.centre, 0.0, other.outer)]).area
    outside = intersect([*rings, Annulus(other.centre, other.outer, math.inf)]).area
    assert inside + outside == pytest.approx(whole, abs=CLOSE)


@MANY
@given(SOME, numbers(-3.0, 3.0), numbers(-5.0, 5.0), numbers(-5.0, 5.0))
def test_area_stays_when_all_is_moved(rings: Annuli, turn: float, x: float, y: float) -> None:
    there = intersect([moved(one, turn, np.array([x, y])) for one in rings]).area
    assert there == pytest.approx(intersect(rings).area, abs=CLOSE)


@MANY
@given(SOME, numbers(1e-3, 1e3))
def test_area_grows_as_the_square_of_the_scale(rings: Annuli, scale: float) -> None:
    scaled = [Annulus(scale * r.centre, scale * r.inner, scale * r.outer) for r in rings]
    assert intersect(scaled).area == pytest.approx(
        scale**2 * intersect(rings).area, abs=CLOSE * scale**2
    )


@MANY
@given(SOME, st.randoms(use_true_random=False))
def test_the_order_does_not_count(rings: Annuli, shuffler: Random) -> None:
    other = [*rings, rings[0]]
    shuffler.shuffle(other)
    assert intersect(other).area == pytest.approx(intersect(rings).area, abs=CLOSE)


@MANY
@given(SOME)
def test_loops_enclose_the_area(rings: Annuli) -> None:
    found = intersect(rings)
    assert sum(loop.area for loop in found.loops) == pytest.approx(found.area, abs=CLOSE)


@FEW
@given(SOME)
def test_area_is_never_negative_nor_above_the_least_annulus(rings: Annuli) -> None:
    least = min(math.pi * (one.outer**2 - one.inner**2) for one in rings)
    assert -CLOSE <= intersect(rings).area <= least + CLOSE
