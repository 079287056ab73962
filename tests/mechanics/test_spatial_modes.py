"""All assembly modes of six rods of given lengths, against the poses that gave the lengths."""

import math
from functools import cache

import numpy as np
import pytest

from mechanics.assembly import starts
from mechanics.assembly.spatial import SpatialModes, spatial_modes
from mechanics.errors import GeometryError
from tests.oracles import rods
from tests.oracles.rods import Floats, Platform

KINDS = pytest.mark.parametrize("kind", list(rods.CLASSES))
PLATFORMS = 100
SEARCHED = 6


def modes_of(of: Platform) -> SpatialModes:
    return spatial_modes(of.base, of.platform, of.lengths)


def away(found: SpatialModes, position: Floats, rotation: Floats) -> Floats:
    """Return how far each mode is from a pose."""
    moved = np.abs(found.positions - position).max(axis=1)
    turned = np.abs(found.rotations - rotation).max(axis=(1, 2))
    farther: Floats = np.maximum(moved, turned)
    return farther


def errors(of: Platform, found: SpatialModes) -> Floats:
    """Return the relative error of the worst rod, and of the rotation, in each mode."""
    worst = []
    for position, rotation in zip(found.positions, found.rotations, strict=True):
        lengths = rods.lengths_at(of.base, of.platform, position, rotation)
        rod = np.abs(lengths - of.lengths).max() / of.lengths.max()
        worst.append(max(rod, np.abs(rotation @ rotation.T - np.eye(3)).max()))
    return np.array(worst)


@cache
def solved(kind: str) -> list[tuple[Platform, SpatialModes]]:
    """Return random platforms of a kind with their modes, for several tests to look at."""
    random = np.random.default_rng(1)
    drawn = [rods.draw(kind, random) for _ in range(PLATFORMS)]
    return [(of, modes_of(of)) for of in drawn]


@KINDS
def test_the_pose_that_gave_the_lengths_is_found(kind: str) -> None:
    for of, found in solved(kind):
        assert away(found, of.position, of.rotation).min() < 1e-9


@KINDS
def test_every_mode_has_rods_of_the_given_lengths(kind: str) -> None:
    assert max(errors(of, found).max() for of, found in solved(kind)) < 1e-12


@KINDS
def test_the_count_is_certified(kind: str) -> None:
    assert all(found.certified for _, found in solved(kind))


@KINDS
def test_simple_modes_come_in_pairs_each_once(kind: str) -> None:
    for _, found in solved(kind):
        pairs = zip(found.positions, found.rotations, strict=True)
        assert all(np.count_nonzero(away(found, *mode) < 1e-6) == 1 for mode in pairs)
        assert len(found.positions) % 2 == 0


@KINDS
def test_nothing_is_lost_that_newton_finds_from_random_poses(kind: str) -> None:
    random = np.random.default_rng(5)
    for _ in range(SEARCHED):
        of = rods.draw(kind, random)
        found = modes_of(of)
        for mode in rods.modes(of, random):
            assert away(found, mode[:3], mode[3:].reshape(3, 3)).min() < 1e-6


@pytest.mark.parametrize(("kind", "number"), [("6-3", 98), ("4-4", 85)])
def test_a_mode_beside_infinite_paths_is_not_lost(kind: str, number: int) -> None:
    """A path to it is easily taken for one of those that end where h = 0."""
    random = np.random.default_rng(11)
    of = [rods.draw(kind, random) for _ in range(number + 1)][-1]
    found = modes_of(of)
    assert found.certified
    for mode in rods.modes(of, random, starts=3000):
        assert away(found, mode[:3], mode[3:].reshape(3, 3)).min() < 1e-6


def test_dietmaiers_platform_has_forty_real_modes() -> None:
    # Dietmaier, 1998, The Stewart-Gough platform of general geometry can have 40 real postures.
    base = np.array(
        [
            [0, 0, 0],
            [1.107915, 0, 0],
            [0.549094, 0.756063, 0],
            [0.735077, -0.223935, 0.525991],
            [0.514188, -0.526063, -0.368418],
            [0.590473, 0.094733, -0.205018],
        ]
    )
    platform = np.array(
        [
            [0, 0, 0],
            [0.542805, 0, 0],
            [0.956919, -0.528915, 0],
            [0.665885, -0.353482, 1.402538],
            [0.478359, 1.158742, 0.107672],
            [-0.137087, -0.235121, 0.353913],
        ]
    )
    lengths = np.array([1, 0.645275, 1.086284, 1.503439, 1.281933, 0.771071])
    found = spatial_modes(base, platform, lengths)
    of = Platform(base, platform, lengths, np.zeros(3), np.eye(3))
    assert found.certified
    assert len(found.positions) == 40
    assert errors(of, found).max() < 1e-10
    pairs = zip(found.positions, found.rotations, strict=True)
    assert all(np.count_nonzero(away(found, *mode) < 1e-6) == 1 for mode in pairs)


def test_platforms_affinely_related_to_their_base_are_searched() -> None:
    random = np.random.default_rng(6)
    for _ in range(5):
        of = rods.draw("general", random)
        platform = of.base @ random.normal(0.0, 0.5, (3, 3)) + random.normal(size=3)
        lengths = rods.lengths_at(of.base, platform, of.position, of.rotation)
        of = of._replace(platform=platform, lengths=lengths)
        found = modes_of(of)
        assert (found.route, found.certified) == ("multistart", False)
        assert away(found, of.position, of.rotation).min() < 1e-9


# The smallest are searched from random poses, which takes seconds each.
@pytest.mark.parametrize(("size", "count"), [(0.1, 5), (0.01, 5), (0.001, 2)])
def test_small_platforms_keep_their_pose(size: float, count: int) -> None:
    random = np.random.default_rng(7)
    for _ in range(count):
        of = rods.draw("general", random)
        platform = size * of.platform
        lengths = rods.lengths_at(of.base, platform, of.position, of.rotation)
        of = of._replace(platform=platform, lengths=lengths)
        # A rod's rounding turns a small platform the more.
        assert away(modes_of(of), of.position, of.rotation).min() < 1e-10 / size


@pytest.mark.parametrize("kind", ["general", "planar", "semi-planar", "hexagons", "6-3"])
def test_a_double_mode_is_there_and_there_once(kind: str) -> None:
    random = np.random.default_rng(8)
    for _ in range(10):
        of = rods.at_singularity(kind, random)
        found = modes_of(of)
        # Two modes in one are known to half the digits.
        assert np.count_nonzero(away(found, of.position, of.rotation) < 1e-4) == 1
        assert away(found, of.position, of.rotation).min() < 1e-5
        assert errors(of, found).max() < 1e-12


@pytest.mark.parametrize("size", [1e-4, 1e4])
def test_the_unit_of_length_does_not_matter(size: float) -> None:
    of = rods.draw("general", np.random.default_rng(9))
    found = modes_of(of)
    scaled = spatial_modes(size * of.base, size * of.platform, size * of.lengths)
    assert len(scaled.positions) == len(found.positions)
    for position, rotation in zip(scaled.positions, scaled.rotations, strict=True):
        assert away(found, position / size, rotation).min() < 1e-9


def test_rods_out_of_reach_have_no_mode() -> None:
    of = rods.draw("general", np.random.default_rng(10))
    lengths = of.lengths.copy()
    lengths[0] = lengths[1:].max() + 100.0
    found = spatial_modes(of.base, of.platform, lengths)
    assert len(found.positions) == 0
    assert found.certified


@pytest.mark.parametrize("length", [0.0, -1.0, np.nan, np.inf])
def test_a_rod_without_length_is_refused(length: float) -> None:
    of = rods.draw("general", np.random.default_rng(11))
    lengths = of.lengths.copy()
    lengths[3] = length
    with pytest.raises(GeometryError, match="leg 3"):
        spatial_modes(of.base, of.platform, lengths)


def test_the_stored_start_has_these_forty_solutions() -> None:
    coefficients, stored = starts.read()[0]
    solved = starts.solve(coefficients, np.random.default_rng(12))
    cosines = np.abs(solved[:, :4].conj() @ stored[:, :4].T)
    partners = np.argmax(cosines, axis=1)
    assert sorted(partners) == list(range(starts.PATHS))
    phases = np.sum(solved[:, :4].conj() * stored[partners, :4], axis=1)[:, None]
    aligned = np.hstack([solved[:, :4] * phases, solved[:, 4:] * phases**2])
    np.testing.assert_allclose(aligned, stored[partners], atol=1e-6)


@pytest.mark.parametrize(
    "lengths", [[1e-6] * 6, [1.2] * 5 + [1e4], [0.36, 0.39, 5.5, 1.8, 2e3, 340.0]]
)
def test_rods_far_from_any_platform_are_given_up(lengths: list[float]) -> None:
    base = [[math.cos(a), math.sin(a), 0.0] for a in (0.0, 0.5, 2.1, 2.6, 4.2, 4.7)]
    platform = [
        [0.5 * math.cos(a), 0.5 * math.sin(a), 0.0] for a in (-0.4, 0.9, 1.7, 3.0, 3.8, 5.1)
    ]
    # Nothing is near these rods; what counts is that the search ends.
    assert spatial_modes(np.array(base), np.array(platform), np.array(lengths)).residuals.size == 0
