"""Nodes of axes and grids."""

import numpy as np
import pytest

from mechanics.grid import Axis, Grid

PLANE = Grid(
    (Axis("y", 0.0, 2.0, 1.0), Axis("x", 10.0, 13.0, 1.0)), (1, 0), np.array([0.0, 0.0, 0.5])
)


@pytest.mark.parametrize(
    ("least", "greatest", "step", "count"),
    [
        (0.0, 1.0, 0.1, 11),
        (0.0, 0.3, 0.1, 4),  # 0.3 / 0.1 is just below 3
        (-0.3, 0.3, 0.001, 601),
        (-1.1, 1.0, 0.01, 211),
        (0.0, 1.05, 0.1, 11),
        (0.0, 0.0, 1.0, 1),
        (5.0, 5.5, 1.0, 1),
    ],
)
def test_nodes_while_not_above_the_maximum(
    least: float, greatest: float, step: float, count: int
) -> None:
    assert Axis("x", least, greatest, step).count == count


@pytest.mark.parametrize(("short", "count"), [(0.5e-9, 11), (2e-9, 10)])
def test_a_billionth_of_a_step_is_forgiven(short: float, count: int) -> None:
    assert Axis("x", 0.0, 10.0 - short, 1.0).count == count


def test_nodes_are_multiples_of_the_step_not_sums() -> None:
    np.testing.assert_array_equal(Axis("x", -0.3, 0.3, 0.001).nodes, -0.3 + np.arange(601) * 0.001)


def test_a_wild_axis_is_counted_without_being_made() -> None:
    assert Axis("x", -1e12, 1e12, 1e-12).intervals == pytest.approx(2e24)


def test_shape_follows_the_axes() -> None:
    assert PLANE.shape == (3, 4)


def test_size_is_all_nodes() -> None:
    assert PLANE.size == 12


def test_cell_is_the_product_of_the_steps() -> None:
    grid = Grid((Axis("x", 0.0, 1.0, 0.5), Axis("y", 0.0, 1.0, 0.25)), (0, 1), np.zeros(2))
    assert grid.cell == 0.125


def test_the_last_axis_is_fastest() -> None:
    np.testing.assert_array_equal(PLANE.poses(0, 12)[0], np.tile([10.0, 11.0, 12.0, 13.0], 3))


def test_the_first_axis_is_slowest() -> None:
    np.testing.assert_array_equal(PLANE.poses(0, 12)[1], np.repeat([0.0, 1.0, 2.0], 4))


def test_what_no_axis_drives_is_fixed() -> None:
    np.testing.assert_array_equal(PLANE.poses(0, 12)[2], np.full(12, 0.5))


def test_a_stretch_is_part_of_the_whole() -> None:
    np.testing.assert_array_equal(PLANE.poses(3, 7), PLANE.poses(0, 12)[:, 3:7])


def test_no_nodes_make_no_poses() -> None:
    assert PLANE.poses(5, 5).shape == (3, 0)
