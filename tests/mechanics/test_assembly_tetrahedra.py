"""Hexapods whose joints coincide as 3-2-1: seen by themselves, up to eight modes in closed form."""

import numpy as np
import pytest

from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.tetrahedra import structure, structure_of, three_two_one
from mechanics.families.hexapods import hexa_rotary
from mechanics.mechanism import Mechanism
from mechanics.motions import SPATIAL
from tests.mechanics.braced import gap, held, modes_of, on_struts, places
from tests.oracles.assembly import Rods, newton_from_everywhere
from tests.oracles.legs import Floats

ORDER = [0, 1, 2, 0, 1, 0]
"""The joint of each leg: three legs on joint 0, two on joint 1."""


def points(seed: int) -> tuple[Floats, Floats]:
    """Return six points as 3-2-1 and six that are all different."""
    random = np.random.default_rng(seed)
    return random.uniform(-0.5, 0.5, (3, 3))[ORDER], random.uniform(-1.0, 1.0, (6, 3))


def hexapod(seed: int, on_platform: bool) -> Mechanism:
    joined, apart = points(seed)
    return on_struts(SPATIAL, *((apart, joined) if on_platform else (joined, apart)))


def test_legs_are_told_by_the_joint_that_they_share() -> None:
    joints = three_two_one(points(0)[0])
    assert joints == ((0, 3, 5), (1, 4), 2)


def test_the_structure_is_found_on_either_side() -> None:
    joined, apart = points(0)
    on_platform, on_base = structure(apart, joined), structure(joined, apart)
    assert on_platform is not None
    assert on_base is not None
    assert (on_platform.on_platform, on_base.on_platform) == (True, False)
    assert on_platform.joints == on_base.joints


@pytest.mark.parametrize(
    "order", [[0, 1, 2, 3, 4, 5], [0, 0, 1, 1, 2, 2], [0, 0, 0, 1, 2, 3], [0, 0, 0, 1, 1, 1]]
)
def test_other_arrangements_are_no_tetrahedra(order: list[int]) -> None:
    assert three_two_one(points(0)[1][order]) is None


def test_a_joint_that_is_nearly_shared_is_not() -> None:
    joined = points(0)[0].copy()
    joined[5] += 1e-6
    assert three_two_one(joined) is None


def test_cranks_move_the_base_joints_apart() -> None:
    """Base points that coincide are no joint where cranks stand between."""
    joined, apart = (side.tolist() for side in points(0))
    for base, platform, expected in ((joined, apart, False), (apart, joined, True)):
        made = hexa_rotary(
            base_points=base,
            crank_axes=[[0.0, 0.0, 1.0]] * 6,
            crank_zero_directions=[[1.0, 0.0, 0.0]] * 6,
            crank_length=0.2,
            rod_length=1.0,
            platform_points=platform,
            limits=np.array([[-np.inf, np.inf]] * 6),
            working_mode=np.ones(6),
        )
        found = structure_of(BrakedLegs(made, np.zeros((6, 1))))
        assert (found is not None) == expected


@pytest.mark.parametrize("on_platform", [True, False])
@pytest.mark.parametrize("seed", range(4))
def test_modes_are_those_that_many_starts_lead_to(seed: int, on_platform: bool) -> None:
    random = np.random.default_rng(seed)
    mechanism = hexapod(seed, on_platform)
    (lengths,) = held(mechanism, random.uniform(-0.6, 0.6, 6))
    of = mechanism.legs
    rods = Rods(of.base_point, of.platform_point, lengths, SPATIAL.twists)
    seen = newton_from_everywhere(rods, random, 600)
    found = modes_of(mechanism, lengths)
    assert found.route == "tetrahedra"
    assert found.certified
    assert len(found.modes) == len(seen) > 0
    here = places(mechanism, np.array([mode.pose for mode in found.modes]))
    for place in seen:
        assert np.abs(here - place).max(axis=1).min() < 1e-6


def test_eight_modes_and_none() -> None:
    """Three tetrahedra, each to either side, or rods too short for the first one."""
    mechanism = hexapod(1, True)
    rows = held(mechanism, *np.random.default_rng(2).uniform(-0.6, 0.6, (100, 6)))
    counts = {len(modes_of(mechanism, row).modes) for row in rows}
    assert counts == {2, 4, 6, 8}
    assert modes_of(mechanism, 0.1 * rows[0]).modes == ()


@pytest.mark.parametrize("on_platform", [True, False])
def test_a_flat_tetrahedron_is_one_mode_of_determinant_0(on_platform: bool) -> None:
    """The joint of three in the plane of the other ends of its rods, at the unturned pose."""
    joined, apart = points(5)
    shift = np.array([0.1, -0.2, 0.8])
    side = 1.0 if on_platform else -1.0
    apart[0] = joined[0] + side * shift + 0.3 * (apart[3] - joined[0] - side * shift)
    apart[0] += 0.4 * (apart[5] - joined[0] - side * shift)
    mechanism = on_struts(SPATIAL, *((apart, joined) if on_platform else (joined, apart)))
    pose = [*shift, 0.0, 0.0, 0.0]
    found = modes_of(mechanism, held(mechanism, pose)[0])
    near = [mode for mode in found.modes if gap(mechanism, (mode,), pose) < 1e-3]
    assert len(near) == 1
    assert abs(near[0].determinant) < 1e-6
    assert found.certified


@pytest.mark.parametrize("on_platform", [True, False])
def test_three_joints_in_line_are_not_certified(on_platform: bool) -> None:
    """About their line the platform spins while the struts stand still."""
    joined, apart = points(5)
    line = np.outer([0.0, 1.0, 2.5], [0.3, -0.2, 0.4])
    joined = line[[0, 1, 0, 1, 0, 2]]
    mechanism = on_struts(SPATIAL, *((apart, joined) if on_platform else (joined, apart)))
    lengths = held(mechanism, [0.1, -0.2, 0.8, 0.3, 0.1, -0.4])[0]
    assert modes_of(mechanism, lengths).route == "tetrahedra"
    assert not modes_of(mechanism, lengths).certified
