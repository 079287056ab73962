"""Where the families put their joints, and the dimensions that they refuse."""

import math

import numpy as np
import pytest

from mechanics.configuration import Configuration
from mechanics.errors import GeometryError, MechanicsError, PoseError
from mechanics.families.five_bar import five_bar
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.mechanism import Mechanism
from tests.oracles.drives import actuators

BAD_LENGTHS = [0.0, -1.0, math.nan]


def bar(base: float = 6.0, crank: float = 5.0, rod: float = 5.0) -> Mechanism:
    return five_bar(
        base_distance=base,
        crank_length=crank,
        rod_length=rod,
        limits=np.array([[-np.inf, np.inf]] * 2),
        working_mode=np.array([1.0, -1.0]),
    )


def triangle(
    side: float = 0.4, radius: float = 0.08, crank: float = 0.18, rod: float = 0.18
) -> Mechanism:
    return planar_3rrr(
        base_side=side,
        platform_radius=radius,
        crank_length=crank,
        rod_length=rod,
        limits=np.array([[-np.inf, np.inf]] * 3),
        working_mode=np.ones(3),
    )


def test_base_joints_of_the_five_bar() -> None:
    np.testing.assert_array_equal(bar().legs.base_point, [[-3.0, 0.0, 0.0], [3.0, 0.0, 0.0]])


def test_the_rods_of_the_five_bar_share_a_joint() -> None:
    np.testing.assert_array_equal(bar().legs.platform_point, np.zeros((2, 3)))


def test_base_joints_of_the_3rrr() -> None:
    height = 0.4 / math.sqrt(3)
    expected = [[0.0, height, 0.0], [-0.2, -height / 2, 0.0], [0.2, -height / 2, 0.0]]
    np.testing.assert_allclose(triangle().legs.base_point, expected, atol=1e-16)


def test_platform_joints_of_the_3rrr() -> None:
    wide = 0.04 * math.sqrt(3)
    expected = [[0.0, 0.08, 0.0], [-wide, -0.04, 0.0], [wide, -0.04, 0.0]]
    np.testing.assert_allclose(triangle().legs.platform_point, expected, atol=1e-16)


@pytest.mark.parametrize("length", BAD_LENGTHS)
@pytest.mark.parametrize("name", ["base", "crank", "rod"])
def test_a_five_bar_that_cannot_be_built(name: str, length: float) -> None:
    with pytest.raises(GeometryError):
        bar(**{name: length})


@pytest.mark.parametrize("length", BAD_LENGTHS)
@pytest.mark.parametrize("name", ["side", "radius", "crank", "rod"])
def test_a_3rrr_that_cannot_be_built(name: str, length: float) -> None:
    with pytest.raises(GeometryError):
        triangle(**{name: length})


def test_poses_of_another_width_are_refused() -> None:
    with pytest.raises(PoseError) as refused:
        actuators(bar(), np.zeros((2, 3)))
    assert refused.value.given == (2, 3)
    assert refused.value.coordinates == ("x", "y")


def test_errors_share_one_parent() -> None:
    assert issubclass(GeometryError, MechanicsError)
    assert issubclass(PoseError, MechanicsError)


def test_working_modes_list_plus_before_minus() -> None:
    assert bar().working_modes == [(1, 1), (1, -1), (-1, 1), (-1, -1)]


def test_cranks_upright() -> None:
    mechanism = bar()  # 3-4-5 triangles over the upright cranks
    np.testing.assert_allclose(
        actuators(mechanism, np.array([[0.0, 9.0]])), [[math.pi / 2] * 2], rtol=1e-15
    )


def test_a_leg_out_of_reach_is_nan_alone() -> None:
    angles = actuators(bar(), np.array([[12.0, 0.0]]))
    np.testing.assert_array_equal(np.isnan(angles), [[True, False]])


def test_determinant_by_hand() -> None:
    # At (0, 9) the rods point along (3, 4) / 5 and (-3, 4) / 5.
    block = Configuration(bar(), np.array([[0.0], [9.0]]))
    assert block.determinants[0] == pytest.approx(0.96, rel=1e-14)


def test_taking_poses_keeps_what_was_computed() -> None:
    poses = np.ascontiguousarray(np.array([[0.0, 9.0], [1.0, 8.0], [0.5, 7.0]]).T)
    block = Configuration(bar(), poses)
    before = block.effort_rows
    chosen = np.array([True, False, True])
    np.testing.assert_array_equal(block.take(chosen).effort_rows, before[..., chosen])


def test_taking_poses_is_as_if_they_were_alone() -> None:
    poses = np.ascontiguousarray(np.array([[0.0, 9.0], [1.0, 8.0], [0.5, 7.0]]).T)
    chosen = np.array([False, True, True])
    alone = Configuration(bar(), np.ascontiguousarray(poses[:, chosen]))
    taken = Configuration(bar(), poses).take(chosen)
    np.testing.assert_array_equal(taken.effort_rows, alone.effort_rows)
