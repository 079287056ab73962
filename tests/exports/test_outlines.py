"""Boundaries of regions on a plane grid."""

import numpy as np
import pytest
from matplotlib.path import Path

from exports.drawing.outlines import boundary_length, outline_of

NODES = np.arange(41, dtype=float)


def disc(radius: float) -> np.ndarray[tuple[int, int], np.dtype[np.bool_]]:
    x, y = np.meshgrid(NODES - 20, NODES - 20, indexing="ij")
    inside: np.ndarray[tuple[int, int], np.dtype[np.bool_]] = np.hypot(x, y) < radius
    return inside


def ragged() -> np.ndarray[tuple[int, int], np.dtype[np.bool_]]:
    inside = np.zeros((41, 41), bool)
    inside[1:-1, 1:-1] = np.random.default_rng(1).random((39, 39)) < 0.6
    return inside


@pytest.mark.parametrize(
    "inside",
    [disc(15.5), disc(15.5) & ~disc(6.0), ragged()],
    ids=["disc", "ring", "ragged"],
)
def test_all_nodes_inside_and_no_others_are_enclosed(
    inside: np.ndarray[tuple[int, int], np.dtype[np.bool_]],
) -> None:
    outline = outline_of(NODES, NODES, inside)
    nodes = np.stack(np.meshgrid(NODES, NODES, indexing="ij"), axis=-1).reshape(-1, 2)
    loops = outline.to_polygons(closed_only=False)
    around = np.sum([Path(loop).contains_points(nodes) for loop in loops], axis=0)
    np.testing.assert_array_equal((around % 2 == 1).reshape(inside.shape), inside)


def test_a_single_node_keeps_its_area() -> None:
    inside = np.zeros((5, 5), bool)
    inside[2, 3] = True
    outline = outline_of(NODES[:5], NODES[:5], inside)
    np.testing.assert_allclose(outline.get_extents().bounds, (1.5, 2.5, 1.0, 1.0))


def test_boundary_length_counts_parted_neighbours() -> None:
    inside = np.zeros((5, 5), bool)
    inside[2, 2:4] = True
    assert boundary_length(inside) == 6
