"""Assembly modes of platforms that do not turn: circles and spheres that meet, touch or miss."""

import numpy as np
import pytest

from mechanics.motions import PLANAR_TRANSLATION, TRANSLATION
from tests.mechanics.braced import gap, held, modes_of, on_struts

THIRDS = np.deg2rad([90.0, 210.0, 330.0])
AROUND = np.column_stack([np.cos(THIRDS), np.sin(THIRDS), np.zeros(3)])
BAR = on_struts(PLANAR_TRANSLATION, [[0.0, 0.0], [3.0, 0.0]], np.zeros((2, 2)))
TRIPOD = on_struts(TRANSLATION, AROUND, np.zeros((3, 3)))


def test_two_circles_meet_in_two_points() -> None:
    """A triangle of sides 3, 4 and 5."""
    found = modes_of(on_struts(PLANAR_TRANSLATION, [[0, 0], [3, 0]], np.zeros((2, 2))), [4, 5])
    low, high = sorted(found.modes, key=lambda mode: mode.pose[1])
    np.testing.assert_allclose([low.pose, high.pose], [[0.0, -4.0], [0.0, 4.0]], atol=1e-14)


def test_three_spheres_meet_in_two_points() -> None:
    found = modes_of(TRIPOD, [np.sqrt(2.0)] * 3)
    expected = [np.array([0.0, 0.0, z]) for z in (-1.0, 1.0)]
    for mode, pose in zip(sorted(found.modes, key=lambda m: m.pose[2]), expected, strict=True):
        np.testing.assert_allclose(mode.pose, pose, atol=1e-15)


@pytest.mark.parametrize("lengths", [(1.0, 2.0), (5.0, 2.0)])
def test_circles_that_touch_have_one_mode(lengths: tuple[float, float]) -> None:
    (mode,) = modes_of(BAR, lengths).modes
    np.testing.assert_allclose(mode.pose, [lengths[0], 0.0], atol=1e-7)
    assert abs(mode.determinant) < 1e-7


def test_spheres_that_touch_have_one_mode() -> None:
    (mode,) = modes_of(TRIPOD, [1.0] * 3).modes
    np.testing.assert_allclose(mode.pose, np.zeros(3), atol=1e-7)
    assert abs(mode.determinant) < 1e-7


@pytest.mark.parametrize("seed", range(20))
def test_rounding_does_not_lose_spheres_that_touch(seed: int) -> None:
    """They touch where the point lies in the plane of their centres, of any place and size."""
    random = np.random.default_rng(seed)
    size = 10.0 ** random.uniform(-3.0, 3.0)
    base, platform = random.uniform(-size, size, (2, 3, 3))
    shares = random.dirichlet(np.ones(3))
    mechanism = on_struts(TRANSLATION, base, platform)
    pose = shares @ (base - platform)
    (lengths,) = held(mechanism, pose)
    (mode,) = modes_of(mechanism, lengths).modes
    np.testing.assert_allclose(mode.pose, pose, atol=1e-6 * size)
    assert abs(mode.determinant) < 1e-6


@pytest.mark.parametrize("excess", [1e-5, -1e-5])
def test_a_hair_more_or_less_makes_two_modes_or_none(excess: float) -> None:
    assert len(modes_of(TRIPOD, [1.0 + excess] * 3).modes) == (2 if excess > 0.0 else 0)


@pytest.mark.parametrize("lengths", [(1.0, 1.0), (9.0, 2.0), (1.0, 5.0)])
def test_circles_that_miss_have_no_mode(lengths: tuple[float, float]) -> None:
    found = modes_of(BAR, lengths)
    assert (found.modes, found.certified) == ((), True)


@pytest.mark.parametrize("length", [0.0, -4.0, np.nan, np.inf])
def test_struts_cannot_have_such_a_length(length: float) -> None:
    assert modes_of(BAR, [length, 2.0]).modes == ()


def test_spheres_about_a_line_are_not_certified() -> None:
    """They meet in a circle: the point goes round while the struts stand still."""
    line = on_struts(TRANSLATION, [[-1, 0, 0], [0, 0, 0], [1, 0, 0]], np.zeros((3, 3)))
    assert not modes_of(line, [np.sqrt(2.0), 1.0, np.sqrt(2.0)]).certified


@pytest.mark.parametrize("sine", [1e-4, 1e-5, 1e-6])
@pytest.mark.parametrize("height", [1.0, 0.01])
def test_spheres_nearly_about_a_line_still_meet(sine: float, height: float) -> None:
    """The modes are known to rounding over the sine, and the pose that was held is one of them."""
    random = np.random.default_rng(0)
    for _ in range(50):
        base, aside = random.uniform(-1.0, 1.0, (3, 3)), random.normal(size=3)
        along = base[1] - base[0]
        base[2] = base[0] + random.uniform(0.2, 2.0) * along
        base[2] += sine * aside
        normal = np.cross(along, aside)
        pose = base[0] + 0.3 * along + 0.2 * random.normal() * aside
        pose += height * normal / np.linalg.norm(normal)
        mechanism = on_struts(TRANSLATION, base, np.zeros((3, 3)))
        found = modes_of(mechanism, held(mechanism, pose)[0])
        assert len(found.modes) == 2
        assert gap(mechanism, found.modes, pose) < 1e-11 / sine


def test_spheres_about_a_line_but_for_rounding_are_not_certified() -> None:
    base = [[-1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 1e-9, 0.0]]
    mechanism = on_struts(TRANSLATION, base, np.zeros((3, 3)))
    assert not modes_of(mechanism, held(mechanism, [0.1, 0.2, 1.0])[0]).certified


def test_modes_do_not_depend_on_where_the_platform_joints_are() -> None:
    offset = np.array([5.0, 6.0, 7.0])
    moved = on_struts(TRANSLATION, AROUND + offset, np.tile(offset, (3, 1)))
    found = modes_of(moved, [1.2, 1.3, 1.4]).modes
    expected = modes_of(TRIPOD, [1.2, 1.3, 1.4]).modes
    assert len(found) == len(expected) == 2
    assert all(gap(TRIPOD, expected, mode.pose) < 1e-13 for mode in found)


@pytest.mark.parametrize("height", [0.0, 1e6, 1e9])
def test_modes_close_to_each_other_are_two_however_far_they_are(height: float) -> None:
    far = on_struts(TRANSLATION, AROUND + np.array([0.0, 0.0, height]), np.zeros((3, 3)))
    found = modes_of(far, [np.hypot(1.0, 0.004)] * 3).modes
    heights = sorted(mode.pose[2] - height for mode in found)
    assert heights == pytest.approx([-0.004, 0.004], abs=1e-4)
