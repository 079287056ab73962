"""The largest ball and box inside shapes whose own are known."""

import math

import numpy as np
import pytest

from mechanics.inscribed import Ball, Box, largest_ball, largest_box, offers_ball, offers_box
from mechanics.motions import PLANAR, SPATIAL, SPHERICAL, TRANSLATION
from tests.oracles.masks import ORIGIN, Mask, region_of


def round_(radius: float, rank: int, hollow: float = -1.0) -> Mask:
    """Return a ball of radius in steps about the middle of its grid, perhaps hollow."""
    middle = int(radius) + 1
    away = np.sqrt(((np.indices((2 * middle + 1,) * rank) - middle) ** 2).sum(axis=0))
    inside: Mask = (away <= radius) & (away > hollow)
    return inside


def ball_in(inside: Mask, *steps: float) -> Ball:
    ball = largest_ball(region_of(inside, steps), TRANSLATION)
    assert ball is not None
    return ball


def box_in(inside: Mask, *steps: float) -> Box:
    box = largest_box(region_of(inside, steps))
    assert box is not None
    return box


def test_a_disc_holds_its_square() -> None:
    box = box_in(round_(100.0, 2), 0.01, 0.01)
    np.testing.assert_allclose(box.maximum - box.minimum, math.sqrt(2.0), atol=0.03)


def test_a_ball_holds_its_cube() -> None:
    box = box_in(round_(50.0, 3), 0.02, 0.02, 0.02)
    np.testing.assert_allclose(box.maximum - box.minimum, 2.0 / math.sqrt(3.0), atol=0.06)


@pytest.mark.parametrize("rank", [1, 2, 3])
def test_a_ball_is_its_own_but_for_a_cell(rank: int) -> None:
    ball = ball_in(round_(50.0, rank), *(0.02,) * rank)
    assert 1.0 - 0.02 * math.sqrt(rank) <= ball.radius <= 1.0


@pytest.mark.parametrize("rank", [1, 2, 3])
def test_a_ball_is_about_its_centre(rank: int) -> None:
    ball = ball_in(round_(50.0, rank), *(0.02,) * rank)
    np.testing.assert_allclose(ball.centre, ORIGIN + 51 * 0.02, atol=1e-12)


def test_the_ball_in_a_hollow_one_lies_in_the_wall() -> None:
    ball = ball_in(round_(40.0, 3, hollow=20.0), 1.0, 1.0, 1.0)
    assert ball.radius == pytest.approx(10.0, abs=1.5 * math.sqrt(3.0))
    assert np.linalg.norm(ball.centre - ORIGIN - 41) == pytest.approx(30.0, abs=2.0)


def test_an_ellipse_holds_a_disc_of_its_shorter_half_axis() -> None:
    """Unequal steps make an ellipse of a disc of nodes."""
    ball = ball_in(round_(60.0, 2), 0.5, 2.0)
    assert 30.0 - 2.1 <= ball.radius <= 30.0


def test_a_whole_grid_is_its_own_box() -> None:
    box = box_in(np.ones((4, 6, 3), dtype=bool), 0.5, 2.0, 1.0)
    np.testing.assert_array_equal(box.minimum, [ORIGIN] * 3)
    np.testing.assert_array_equal(box.maximum, [ORIGIN + 1.5, ORIGIN + 10.0, ORIGIN + 2.0])


@pytest.mark.parametrize("first", range(11))
def test_a_box_is_found_whatever_planes_it_takes(first: int) -> None:
    for last in range(first + 1, 12):
        inside = np.zeros((12, 15, 15), dtype=bool)
        inside[first : last + 1, 2:9, 4:14] = True
        box = box_in(inside, 1.0, 1.0, 1.0)
        np.testing.assert_array_equal(box.minimum - ORIGIN, [first, 2, 4])
        np.testing.assert_array_equal(box.maximum - ORIGIN, [last, 8, 13])


def test_measures_are_those_of_solids() -> None:
    radius, at = 2.0, np.zeros(3)
    assert Ball(at[:1], radius).measure == 4.0
    assert Ball(at[:2], radius).measure == pytest.approx(4.0 * math.pi)
    assert Ball(at, radius).measure == pytest.approx(32.0 / 3.0 * math.pi)
    assert Box(at, np.array([1.0, 2.0, 3.0])).measure == 6.0


def test_a_plane_of_nodes_holds_no_box() -> None:
    thin = np.zeros((5, 5, 5), dtype=bool)
    thin[2] = True
    assert largest_box(region_of(thin, (1.0,) * 3)) is None


def test_two_planes_of_nodes_hold_no_ball() -> None:
    thin = np.zeros((5, 5, 5), dtype=bool)
    thin[2:4] = True
    assert largest_ball(region_of(thin, (1.0,) * 3), TRANSLATION) is None


def test_nothing_holds_nothing() -> None:
    empty = region_of(np.zeros((5, 5), dtype=bool), (1.0, 1.0))
    assert largest_box(empty) is None
    assert largest_ball(empty, TRANSLATION) is None


def test_lengths_and_angles_make_no_ball() -> None:
    mixed = region_of(np.ones((5, 5), dtype=bool), (1.0, 1.0), ("x", "phi"))
    assert not offers_ball(mixed.grid, PLANAR)
    assert largest_ball(mixed, PLANAR) is None
    assert largest_box(mixed) is not None


def test_angles_alone_make_a_ball() -> None:
    turns = region_of(np.ones((5, 5, 5), dtype=bool), (0.1,) * 3, ("rx", "ry", "rz"))
    ball = largest_ball(turns, SPHERICAL)
    assert ball is not None
    assert ball.radius == pytest.approx(0.2)


def test_four_axes_are_not_offered() -> None:
    names = ("x", "y", "z", "rx")
    region = region_of(np.ones((3, 3, 3, 3), dtype=bool), (1.0,) * 4, names)
    assert not offers_box(region.grid)
    assert largest_box(region) is None
    assert largest_ball(region, SPATIAL) is None


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1), (1, 2, 0), (2, 1, 0)])
def test_the_box_turns_with_its_region(order: tuple[int, int, int]) -> None:
    inside = np.zeros((7, 9, 12), dtype=bool)
    inside[1:4, 2:8, 3:11] = True
    inside[3:6, 4:6, 1:12] = True
    box = box_in(inside.transpose(order), 1.0, 1.0, 1.0)
    np.testing.assert_array_equal(box.minimum, ORIGIN + np.array([1, 2, 3])[list(order)])
    np.testing.assert_array_equal(box.maximum, ORIGIN + np.array([3, 7, 10])[list(order)])
