"""Volumes common to spherical shells: closed forms, directions, grids, and the hexapod's legs."""

import math

import numpy as np
import pytest

from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.configuration import Configuration
from mechanics.errors import GeometryError, NotOfferedError
from mechanics.geometry.leg_regions import leg_shells
from mechanics.geometry.shells import Shell, ShellRegion, Volume, intersect
from mechanics.legs import STRUT, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import TRANSLATION
from tests.mechanics.platforms import TURNED, hexapod
from tests.oracles import legs


def region(*rows: tuple[float, float, float, float, float]) -> ShellRegion:
    return intersect([Shell(np.array(row[:3]), *row[3:]) for row in rows])


def turned(shells: tuple[Shell, ...], axis: list[float], angle: float) -> ShellRegion:
    rotation = legs.about(legs.unit(np.array(axis)), angle)
    return intersect([Shell(rotation @ s.centre, s.inner, s.outer) for s in shells])


def test_a_ball() -> None:
    assert region((1, 2, 3, 0, 2)).volume.value == pytest.approx(32 / 3 * math.pi, rel=1e-13)


def test_a_shell() -> None:
    found = region((1, 2, 3, 1, 2)).volume.value
    assert found == pytest.approx(28 / 3 * math.pi, rel=1e-13)


def test_a_shell_changes_its_section_at_the_poles_of_its_spheres() -> None:
    np.testing.assert_allclose(region((1, 2, 3, 1, 2)).volume.heights, [1, 2, 4, 5])


@pytest.mark.parametrize("centre", [(1, 0, 0), (0, 0, 1), (0.6, 0, 0.8), (0.36, 0.48, -0.8)])
def test_two_balls_in_any_direction(centre: tuple[float, float, float]) -> None:
    found = region((0, 0, 0, 0, 1), (*centre, 0, 1)).volume
    assert found.value == pytest.approx(5 / 12 * math.pi, rel=1e-12)


def test_balls_that_touch_have_no_volume() -> None:
    assert region((0, 0, 0, 0, 0.1), (0.3, 0, 0, 0, 0.2)).volume.value == 0.0


def test_a_ball_in_the_hole_of_a_shell_has_no_volume() -> None:
    found = region((0, 0, 0, 1, 2), (0.1, 0, 0, 0, 0.5)).volume
    assert (found.value, found.heights.size) == (0.0, 0)


def test_a_shell_without_width_has_no_volume() -> None:
    assert region((0, 0, 0, 1, 1), (0, 0, 1, 0, 1)).volume.value == 0.0


def test_a_ball_without_radius_has_no_volume() -> None:
    assert region((0, 0, 0, 0, 0), (0, 0, 0, 0, 1)).volume.value == 0.0


def test_equal_shells_are_one() -> None:
    rows = [(0.3, 0.1, 0.0, 0.5, 1.0)] * 6
    assert region(*rows).volume.value == pytest.approx(3.5 / 3 * math.pi, rel=1e-13)


def test_spheres_about_one_vertical_line() -> None:
    # The ball's lower part is cut off where both spheres meet, in a level circle.
    found = region((0, 0, 0, 0, 1), (0, 0, -1, 1, math.inf)).volume
    assert found.value == pytest.approx((4 / 3 - 5 / 12) * math.pi, rel=1e-12)


def test_a_section_is_an_annulus() -> None:
    expected = math.pi * (4 - 1)
    assert region((1, 2, 3, 1, 2)).section(3.5).area == pytest.approx(expected, rel=1e-14)


def test_a_section_beyond_the_region_is_empty() -> None:
    assert region((1, 2, 3, 1, 2)).section(5.1).is_empty


def test_what_has_no_end_is_refused() -> None:
    with pytest.raises(GeometryError, match="outer sphere"):
        region((0, 0, 0, 1, math.inf))


@pytest.mark.parametrize("radii", [(-0.1, 1), (1, 0.5), (math.nan, 1), (0, math.nan)])
def test_radii_that_make_no_shell_are_refused(radii: tuple[float, float]) -> None:
    with pytest.raises(GeometryError, match="radii"):
        Shell(np.zeros(3), *radii)


@pytest.fixture(scope="module")
def upright() -> Volume:
    return intersect(leg_shells(hexapod(), TURNED)).volume


@pytest.fixture(scope="module")
def slanted() -> Volume:
    return turned(leg_shells(hexapod(), TURNED), [1.0, 2.0, 3.0], 1.0).volume


def test_the_volume_is_the_same_along_any_direction(upright: Volume, slanted: Volume) -> None:
    assert slanted.value == pytest.approx(upright.value, rel=1e-10)


def test_the_error_covers_the_difference(upright: Volume, slanted: Volume) -> None:
    assert abs(upright.value - slanted.value) <= upright.error + slanted.error


def test_the_error_is_small(upright: Volume) -> None:
    assert upright.error < 1e-10 * upright.value


def test_a_level_hexapod() -> None:
    # Base and platform without turn: all centres at one height, so that heights fall together.
    shells = leg_shells(hexapod(), np.zeros(6))
    found, other = intersect(shells).volume, turned(shells, [1.0, 0.5, 0.2], 0.8).volume
    assert found.value == pytest.approx(other.value, rel=1e-10)


def test_the_shells_hold_what_the_limits_allow() -> None:
    mechanism = hexapod()
    places = np.random.default_rng(2).uniform([-0.6, -0.6, -1], [0.6, 0.6, 1], (3000, 3))
    poses = np.column_stack([places, np.tile(TURNED[3:], (3000, 1))])
    block = Configuration(mechanism, np.ascontiguousarray(poses.T))
    allowed = np.all(ActuatorLimits(mechanism).check(block) >= 0.0, axis=0)
    shells = leg_shells(mechanism, TURNED)
    inside = np.all([shell.contains(places) for shell in shells], axis=0)
    np.testing.assert_array_equal(inside, allowed)


def test_the_volume_is_what_random_places_say(upright: Volume) -> None:
    shells = leg_shells(hexapod(), TURNED)
    places = np.random.default_rng(3).uniform([-0.6, -0.6, -1], [0.6, 0.6, 1], (400_000, 3))
    share = np.mean(np.all([shell.contains(places) for shell in shells], axis=0))
    deviation = 2.88 * math.sqrt(share * (1 - share) / 400_000)
    assert upright.value == pytest.approx(2.88 * share, abs=4 * deviation)


def test_three_struts_without_turn() -> None:
    rows = [Leg(STRUT, tuple(2.0 * row), (0.0, 0.0, 0.0)) for row in np.eye(3)]
    limits = np.array([[0.5, 2.5]] * 3)
    shells = leg_shells(Mechanism(TRANSLATION, gather(rows, limits, np.ones(3))), np.zeros(3))
    np.testing.assert_array_equal([shell.centre for shell in shells], 2.0 * np.eye(3))


def test_legs_that_are_no_struts_are_not_offered() -> None:
    rail = Leg(1, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), axis=(1.0, 0.0, 0.0), rod_length=1.0)
    strut = Leg(STRUT, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    rows = gather([strut, strut, rail], np.array([[0.5, 2.5]] * 3), np.ones(3))
    with pytest.raises(NotOfferedError, match="leg 2"):
        leg_shells(Mechanism(TRANSLATION, rows), np.zeros(3))
