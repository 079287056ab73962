"""Intersections of annuli: closed forms, and circles that touch, coincide or miss each other."""

import math

import numpy as np
import pytest

from mechanics.arrays import Floats
from mechanics.errors import GeometryError
from mechanics.geometry.annuli import Annulus, contains, intersect
from mechanics.geometry.arcs import ArcRegion


def annulus(x: float, y: float, inner: float, outer: float) -> Annulus:
    return Annulus(np.array([x, y]), inner, outer)


def region(*rows: tuple[float, float, float, float]) -> ArcRegion:
    return intersect([annulus(*row) for row in rows])


def centroid(found: ArcRegion) -> Floats:
    assert found.centroid is not None
    return found.centroid


def parts(found: ArcRegion) -> tuple[int, int]:
    return found.components, found.holes


def unit_lens(apart: float) -> float:
    """Return the area common to two unit discs, by a series where they barely meet."""
    angle = 2 * math.atan2(math.sqrt((2 - apart) * (2 + apart)), apart)
    if angle > 0.5:
        return angle - math.sin(angle)
    return math.fsum(
        (-1.0) ** k * angle ** (2 * k + 3) / math.factorial(2 * k + 3) for k in range(8)
    )


def test_area_of_an_annulus() -> None:
    assert region((1, 2, 0.5, 1)).area == pytest.approx(0.75 * math.pi, rel=1e-14)


def test_centroid_of_an_annulus() -> None:
    np.testing.assert_allclose(centroid(region((1, 2, 0.5, 1))), [1, 2], atol=1e-15)


def test_an_annulus_is_one_part_with_one_hole() -> None:
    assert parts(region((1, 2, 0.5, 1))) == (1, 1)


def test_a_disc_has_no_hole() -> None:
    assert parts(region((1, 2, 0, 1))) == (1, 0)


def test_the_outside_runs_counterclockwise_and_the_hole_clockwise() -> None:
    (outside,), (hole,) = (loop.arcs for loop in region((1, 2, 0.5, 1)).loops)
    turns = [outside.end - outside.start, hole.end - hole.start]
    assert turns == pytest.approx([2 * math.pi, -2 * math.pi])


@pytest.mark.parametrize("apart", [1e-9, 1e-3, 0.3, 1.0, 1.9, 1.999, 1.999999])
def test_area_of_a_lens(apart: float) -> None:
    found = region((0, 0, 0, 1), (apart, 0, 0, 1)).area
    # Two ends that nearly meet are only as far apart as the difference of 2 and `apart` says.
    assert found == pytest.approx(unit_lens(apart), rel=1e-12 + 1e-15 / (2 - apart))


def test_centroid_of_a_lens_is_halfway() -> None:
    found = centroid(region((3, 1, 0, 1), (3, 2, 0, 1)))
    np.testing.assert_allclose(found, [3, 1.5], atol=1e-14)


def test_bounds_of_a_lens() -> None:
    bounds = region((3, 1, 0, 1), (3, 2, 0, 1)).bounds
    assert bounds is not None
    half = math.sqrt(0.75)
    np.testing.assert_allclose(bounds, [[3 - half, 1], [3 + half, 2]], atol=1e-15)


def test_a_lens_is_bounded_by_an_arc_of_each_circle() -> None:
    (loop,) = region((0, 0, 0, 1), (1, 0, 0, 1)).loops
    assert sorted(arc.centre for arc in loop.arcs) == [(0.0, 0.0), (1.0, 0.0)]


def test_area_of_a_reuleaux_triangle() -> None:
    corners = [(math.cos(a), math.sin(a), 0.0, math.sqrt(3)) for a in np.radians([90, 210, 330])]
    expected = 1.5 * (math.pi - math.sqrt(3))
    assert region(*corners).area == pytest.approx(expected, rel=1e-14)


def test_centroid_of_half_a_disc() -> None:
    # A disc so large and so far off that its border is a line, but for 1e-6 / 2.
    found = centroid(region((0, 0, 0, 1), (1e6, 0, 0, 1e6)))
    np.testing.assert_allclose(found, [4 / (3 * math.pi), 0], atol=1e-6)


def test_discs_apart_have_nothing_in_common() -> None:
    assert region((0, 0, 0, 1), (3, 0, 0, 1)).is_empty


def test_an_empty_region_has_neither_area_nor_parts() -> None:
    found = region((0, 0, 0, 1), (3, 0, 0, 1))
    assert (found.area, found.centroid, found.bounds, found.loops) == (0.0, None, None, ())


def test_discs_that_touch_have_no_area() -> None:
    assert region((0, 0, 0, 0.1), (0.3, 0, 0, 0.2)).is_empty


def test_a_disc_that_touches_another_from_inside_stays_whole() -> None:
    found = region((0, 0, 0, 0.3), (0.2, 0, 0, 0.1))
    assert found.area == pytest.approx(0.01 * math.pi, rel=1e-14)


def test_a_disc_in_the_hole_of_an_annulus_is_outside() -> None:
    assert region((0, 0, 1, 2), (0.1, 0, 0, 0.5)).is_empty


def test_a_disc_that_fills_the_hole_is_outside() -> None:
    assert region((0, 0, 1, 2), (0, 0, 0, 1)).is_empty


def test_equal_annuli_are_one() -> None:
    rows = [(0.3, 0.1, 0.5, 1.0)] * 4
    assert region(*rows).loops == region(rows[0]).loops


def test_equal_circles_of_different_annuli_are_one() -> None:
    found = region((0, 0, 0.5, 1), (0, 0, 0.2, 1), (0, 0, 0.5, 3))
    assert found.loops == region((0, 0, 0.5, 1)).loops


def test_circles_equal_but_for_rounding_are_one() -> None:
    found = region((0.1 + 0.2, 0, 0, 1), (0.3, 0, 0, 1))
    assert len(found.loops) == 1


def test_a_hole_of_rounding_is_none() -> None:
    assert parts(region((0, 0, 0.1 + 0.2 - 0.3, 1))) == (1, 0)


def test_an_annulus_without_width_has_no_area() -> None:
    assert region((0, 0, 1, 1), (0, 0.5, 0, 1)).is_empty


def test_a_disc_without_radius_has_no_area() -> None:
    assert region((0, 0, 0, 0), (0, 0.5, 0, 1)).is_empty


def test_three_discs_through_one_point_have_no_area() -> None:
    corners = [(math.cos(a), math.sin(a), 0.0, 1.0) for a in np.radians([90, 210, 330])]
    assert region(*corners).area == pytest.approx(0, abs=1e-28)


def test_holes_that_touch_stay_two() -> None:
    assert parts(region((-1, 0, 1, 5), (1, 0, 1, 5))) == (1, 2)


def test_area_around_holes_that_touch() -> None:
    lens = 25 * (2 * math.acos(0.2) - math.sin(2 * math.acos(0.2)))
    found = region((-1, 0, 1, 5), (1, 0, 1, 5)).area
    assert found == pytest.approx(lens - 2 * math.pi, rel=1e-14)


def test_a_hole_that_touches_the_outside_leaves_a_crescent() -> None:
    found = region((0, 0, 0, 1), (0.5, 0, 0.5, 9))
    assert found.area == pytest.approx(0.75 * math.pi, rel=1e-14)


def test_circles_that_meet_in_a_corner_of_the_region() -> None:
    # All four circles pass through (0, 0) and (0, 6), and the outermost two bound the lens.
    rows = [(x, 3, 0, math.hypot(x, 3)) for x in (-4.0, -1.25, 1.25, 4.0)]
    angle = 2 * math.atan2(3, 4)
    assert region(*rows).area == pytest.approx(25 * (angle - math.sin(angle)), rel=1e-12)


def test_rings_across_each_other_leave_two_parts() -> None:
    assert parts(region((-1, 0, 1.2, 1.6), (1, 0, 1.2, 1.6))) == (2, 0)


def test_parts_come_from_large_to_small_and_holes_last() -> None:
    loops = region((0, 0, 0.3, 3), (2.5, 0, 0.2, 3)).loops
    assert [round(math.copysign(1, loop.area)) for loop in loops] == [1, -1, -1]


def test_an_arc_ends_where_the_next_begins() -> None:
    (loop, *_) = region((0, 0, 0.4, 1), (0.7, 0.2, 0.3, 1), (0.1, 0.9, 0.2, 1.1)).loops
    first, last = (
        np.array([np.add(a.centre, a.radius * np.array([np.cos(t), np.sin(t)])) for a, t in pairs])
        for pairs in ([(a, a.start) for a in loop.arcs], [(a, a.end) for a in loop.arcs])
    )
    np.testing.assert_allclose(last, np.roll(first, -1, axis=0), atol=1e-14)


def test_an_annulus_without_an_outer_circle_takes_its_hole_out() -> None:
    found = region((0, 0, 0, 1), (0.2, 0, 0.5, math.inf))
    assert found.area == pytest.approx(0.75 * math.pi, rel=1e-14)


def test_what_has_no_end_is_refused() -> None:
    with pytest.raises(GeometryError, match="outer circle"):
        region((0, 0, 1, math.inf))


@pytest.mark.parametrize("radii", [(-0.1, 1), (1, 0.5), (math.nan, 1), (0, math.nan)])
def test_radii_that_make_no_annulus_are_refused(radii: tuple[float, float]) -> None:
    with pytest.raises(GeometryError, match="radii"):
        annulus(0, 0, *radii)


def test_borders_belong_to_annuli() -> None:
    points = np.array([[1.0, 0.0], [0.0, 0.5], [0.0, 0.4], [1.1, 0.0]])
    found = contains([annulus(0, 0, 0.5, 1)], points)
    np.testing.assert_array_equal(found, [True, True, False, False])
