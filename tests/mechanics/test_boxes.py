"""Volumes between proven bounds: closed forms, the tori of the 3-RRRR, shells by sections."""

import math

import numpy as np
import pytest

from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.errors import NotOfferedError
from mechanics.families.delta import translational_3rrrr
from mechanics.families.hexapods import hexa_linear
from mechanics.geometry.boxes import Reaches, bound_volume, reaches
from mechanics.geometry.leg_regions import leg_shells
from mechanics.geometry.shells import intersect
from mechanics.mechanism import Mechanism
from tests.mechanics.platforms import TURNED, hexagon, hexapod

FREE = (-math.inf, math.inf)


def rrrr(limits: tuple[float, float] = FREE) -> Mechanism:
    return translational_3rrrr(
        link_length=0.3,
        base_radius=0.2,
        limits=np.array([limits] * 3),
        working_mode=np.ones(3),
    )


def torus(crank: float, rod: float, axis: list[float]) -> Reaches:
    direction = np.array([axis]) / np.linalg.norm(axis)
    return Reaches(
        np.array([[0.1, 0.2, 0.3]]),
        direction,
        np.array([crank]),
        np.array([rod]),
        np.array([rod]),
        np.ones(1),
    )


@pytest.mark.parametrize("axis", [[0.0, 0.0, 1.0], [1.0, 2.0, 2.0]])
def test_a_torus_lies_between_its_bounds(axis: list[float]) -> None:
    found = bound_volume(torus(1.0, 0.4, axis), 3000)
    # A rod shorter than the crank reaches the tube of radius L around the crank's circle.
    assert found.lower <= 2 * math.pi**2 * 0.4**2 <= found.upper


def test_bounds_close_in() -> None:
    coarse, fine = (bound_volume(torus(1.0, 0.4, [0.0, 0.0, 1.0]), n) for n in (1000, 40_000))
    assert fine.upper - fine.lower < (coarse.upper - coarse.lower) / 3


def test_the_estimate_is_nearer_than_the_bounds() -> None:
    found = bound_volume(torus(1.0, 0.4, [0.0, 0.0, 1.0]), 3000)
    exact = 2 * math.pi**2 * 0.4**2
    assert abs(found.estimate - exact) < 0.1 * (found.upper - found.lower)


def test_the_tori_hold_what_the_3rrrr_reaches() -> None:
    mechanism = rrrr()
    places = np.random.default_rng(4).uniform(-0.9, 0.9, (4000, 3))
    block = Configuration(mechanism, np.ascontiguousarray(places.T))
    reached = np.all(Reach(mechanism).check(block) >= 0.0, axis=0)
    inside = reaches(mechanism, np.zeros(3), limited=False).contains(places)
    np.testing.assert_array_equal(inside, reached)


def test_the_volume_of_the_3rrrr_is_what_random_places_say() -> None:
    legs = reaches(rrrr(), np.zeros(3), limited=False)
    places = np.random.default_rng(5).uniform(-0.6, 0.8, (400_000, 3))
    share = legs.contains(places).mean()
    deviation = 1.4**3 * math.sqrt(share * (1 - share) / 400_000)
    found = bound_volume(legs, 12_000)
    assert found.lower - 4 * deviation <= 1.4**3 * share <= found.upper + 4 * deviation


def test_boxes_and_sections_agree_on_the_hexapod() -> None:
    exact = intersect(leg_shells(hexapod(), TURNED)).volume.value
    found = bound_volume(reaches(hexapod(), TURNED, limited=True), 12_000)
    assert found.lower <= exact <= found.upper


def test_legs_that_miss_each_other_leave_nothing() -> None:
    found = bound_volume(reaches(hexapod(0.01, 0.02), TURNED, limited=True))
    assert (found.lower, found.upper) == (0.0, 0.0)


def test_limited_cranks_are_not_offered() -> None:
    with pytest.raises(NotOfferedError, match="leg 0: the limits of its crank"):
        reaches(rrrr((-1.0, 1.0)), np.zeros(3), limited=True)


def rails(limits: tuple[float, float]) -> Mechanism:
    return hexa_linear(
        base_points=hexagon(0.5, 15.0),
        rail_directions=[[0.0, 0.0, 1.0]] * 6,
        rod_length=0.4,
        platform_points=hexagon(0.3, 45.0),
        limits=np.array([limits] * 6),
        working_mode=np.ones(6),
    )


def test_limited_rails_are_not_offered() -> None:
    with pytest.raises(NotOfferedError, match="leg 0: the limits of its rail"):
        reaches(rails((0.0, 1.0)), np.zeros(6), limited=True)


def test_rails_alone_bound_nothing() -> None:
    with pytest.raises(NotOfferedError, match="no leg bounds"):
        bound_volume(reaches(rails(FREE), np.zeros(6), limited=False))


def test_struts_without_limits_bound_nothing() -> None:
    mechanism = hexapod(*FREE)
    with pytest.raises(NotOfferedError, match="no leg bounds"):
        bound_volume(reaches(mechanism, np.zeros(6), limited=True))
