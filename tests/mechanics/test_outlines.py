"""Planar workspaces by the geometric method: known areas, bounds, and what it cannot do."""

import math

import numpy as np
import pytest

from mechanics.arrays import Floats
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.errors import NotOfferedError, PoseError
from mechanics.families.five_bar import five_bar
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.geometry.annuli import contains
from mechanics.geometry.arcs import Arc
from mechanics.geometry.leg_regions import leg_annuli, leg_annuli_at_any_turn
from mechanics.geometry.outlines import constant_orientation, maximal_bound
from mechanics.legs import CRANK, RAIL, STRUT, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import PLANAR, PLANAR_TRANSLATION, TRANSLATION

FREE = (-math.inf, math.inf)
POSE = np.zeros(2)


def triangle(crank: float = 0.18, rod: float = 0.18) -> Mechanism:
    return planar_3rrr(
        base_side=0.4,
        platform_radius=0.08,
        crank_length=crank,
        rod_length=rod,
        limits=np.array([FREE] * 3),
        working_mode=np.ones(3),
    )


def bar(limits: tuple[float, float] = FREE) -> Mechanism:
    return five_bar(
        base_distance=0.12,
        crank_length=0.16,
        rod_length=0.22,
        limits=np.array([limits] * 2),
        working_mode=np.array([1.0, -1.0]),
    )


def plane(*legs: Leg, limits: tuple[float, float] = FREE) -> Mechanism:
    """Return a mechanism without turn whose second leg reaches wherever the first one does."""
    pair = legs if len(legs) == 2 else legs * 2
    return Mechanism(PLANAR_TRANSLATION, gather(pair, np.array([limits] * 2), np.ones(2)))


def crank(**changes: object) -> Leg:
    settings = {
        "drive": CRANK,
        "base_point": (0.0, 0.0, 0.0),
        "platform_point": (0.0, 0.0, 0.0),
        "axis": (0.0, 0.0, -2.0),
        "zero_direction": (1.0, 0.0, 0.0),
        "crank_length": 0.4,
        "rod_length": 0.5,
    }
    return Leg(**{**settings, **changes})  # type: ignore[arg-type]


STRUT_LEG = Leg(STRUT, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
RAIL_LEG = Leg(RAIL, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), axis=(1.0, 0.0, 0.0), rod_length=0.5)


def along(arc: Arc) -> Floats:
    angles = np.linspace(arc.start, arc.end, 100)
    return np.array(arc.centre) + arc.radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def test_the_3rrr_reaches_what_its_nodes_say() -> None:
    region = constant_orientation(triangle(), np.zeros(3), limited=False).region
    # 160 725 nodes 1 mm apart, and a border of 1.6 m.
    assert region.area == pytest.approx(0.160725, abs=3e-5)


def test_the_3rrr_with_equal_links_has_no_holes() -> None:
    region = constant_orientation(triangle(), np.zeros(3), limited=False).region
    assert (region.components, region.holes) == (1, 0)


def test_the_3rrr_with_unequal_links_has_holes() -> None:
    region = constant_orientation(triangle(0.17, 0.19), np.zeros(3), limited=False).region
    assert region.holes == 3


def test_a_constant_orientation_is_no_bound() -> None:
    assert not constant_orientation(triangle(), np.zeros(3), limited=False).is_bound


@pytest.mark.parametrize("phi", [0.0, 0.7, -2.5])
def test_the_annuli_hold_what_the_legs_reach(phi: float) -> None:
    mechanism = triangle(0.15, 0.2)
    places = np.random.default_rng(1).uniform(-0.4, 0.4, (2000, 2))
    poses = np.column_stack([places, np.full(2000, phi)])
    block = Configuration(mechanism, np.ascontiguousarray(poses.T))
    reached = np.all(Reach(mechanism).check(block) >= 0.0, axis=0)
    annuli = leg_annuli(mechanism, np.array([9.0, 9.0, phi]), limited=False)
    np.testing.assert_array_equal(contains(annuli, places), reached)


def test_the_bound_of_the_3rrr() -> None:
    assert maximal_bound(triangle(), limited=False).region.area == pytest.approx(0.1683, abs=5e-5)


def test_the_bound_says_that_it_is_one() -> None:
    assert maximal_bound(triangle(), limited=False).is_bound


def test_the_bound_holds_a_place_that_no_turn_reaches() -> None:
    assert contains(leg_annuli_at_any_turn(triangle(), limited=False), np.array([0.0, 0.275]))


@pytest.mark.parametrize("phi", [0.0, 0.7, -2.5])
def test_the_bound_holds_every_orientation(phi: float) -> None:
    mechanism = triangle(0.1, 0.2)
    region = constant_orientation(mechanism, np.array([0.0, 0.0, phi]), limited=False).region
    points = np.concatenate([along(arc) for loop in region.loops for arc in loop.arcs])
    # A hair off the border, which both may share.
    points += 1e-9 * (np.array(region.centroid) - points)
    assert contains(leg_annuli_at_any_turn(mechanism, limited=False), points).all()


def test_a_platform_point_far_off_leaves_a_hole_about_the_base_joint() -> None:
    leg = crank(platform_point=(2.0, 0.0, 0.0))
    mechanism = Mechanism(PLANAR, gather([leg] * 3, np.array([FREE] * 3), np.ones(3)))
    widened = leg_annuli_at_any_turn(mechanism, limited=False)[0]
    assert (widened.inner, widened.outer) == pytest.approx((1.1, 2.9))


def test_without_a_turn_the_bound_is_the_workspace() -> None:
    outline = maximal_bound(bar(), limited=False)
    exact = constant_orientation(bar(), POSE, limited=False)
    assert (outline.is_bound, outline.region.area) == (False, exact.region.area)


def test_the_five_bar_has_two_holes() -> None:
    assert constant_orientation(bar(), POSE, limited=False).region.holes == 2


def test_the_five_bars_area() -> None:
    half = math.acos(0.06 / 0.38)
    lens = 0.38**2 * (2 * half - math.sin(2 * half))
    # Holes of radius |r - L| = 0.06 m whose centres are 0.12 m apart: they touch.
    expected = lens - 2 * math.pi * 0.06**2
    found = constant_orientation(bar(), POSE, limited=False).region.area
    assert found == pytest.approx(expected, rel=1e-13)


def test_a_rod_on_a_slant_counts_by_its_length_in_the_plane() -> None:
    leg = crank(base_point=(0.0, 0.0, 0.3))
    found = leg_annuli(plane(leg), POSE, limited=False)[0]
    assert (found.inner, found.outer) == pytest.approx((0.0, 0.8), abs=1e-15)


def test_a_rod_too_short_for_its_slant_reaches_nothing() -> None:
    leg = crank(base_point=(0.0, 0.0, 0.6))
    assert constant_orientation(plane(leg), POSE, limited=False).region.is_empty


def test_the_limits_of_struts_are_the_radii() -> None:
    found = leg_annuli(plane(STRUT_LEG, limits=(0.2, 0.5)), POSE, limited=True)[0]
    assert (found.inner, found.outer) == (0.2, 0.5)


def test_a_strut_shorter_than_nothing_has_no_hole() -> None:
    assert leg_annuli(plane(STRUT_LEG, limits=(-0.2, 0.5)), POSE, limited=True)[0].inner == 0.0


def test_a_strut_without_limits_leaves_the_other_leg_alone() -> None:
    found = constant_orientation(plane(STRUT_LEG, crank()), POSE, limited=False).region
    assert found.area == pytest.approx(math.pi * (0.81 - 0.01), rel=1e-14)


def test_cranks_that_may_turn_around_keep_their_annuli_within_limits() -> None:
    limited = constant_orientation(bar((-4.0, 4.0)), POSE, limited=True)
    free = constant_orientation(bar(), POSE, limited=True)
    assert limited.region.area == free.region.area


@pytest.mark.parametrize(
    ("mechanism", "limited", "reason"),
    [
        (plane(STRUT_LEG), False, "no leg bounds"),
        (plane(STRUT_LEG), True, "no leg bounds"),
        (plane(crank(), RAIL_LEG), False, "leg 1: .* strip"),
        (plane(crank(), limits=(-1.0, 2.0)), True, "leg 0: the limits of its crank"),
        (plane(crank(axis=(0.0, 1.0, 0.0))), False, "leg 0: .* normal"),
        (
            Mechanism(TRANSLATION, gather([crank()] * 3, np.array([FREE] * 3), np.ones(3))),
            False,
            "translation moves it along x, y, z",
        ),
    ],
)
def test_what_is_not_offered(mechanism: Mechanism, limited: bool, reason: str) -> None:
    pose = np.zeros(len(mechanism.motion.coordinates))
    with pytest.raises(NotOfferedError, match=reason):
        constant_orientation(mechanism, pose, limited=limited)


def test_a_pose_of_another_motion_is_refused() -> None:
    with pytest.raises(PoseError):
        constant_orientation(bar(), np.zeros(3), limited=False)
