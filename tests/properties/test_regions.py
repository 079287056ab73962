"""Regions from runs: parts, extents, measure and its error, against dense masks."""

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from scipy import ndimage

from mechanics.grid import Axis, Grid
from mechanics.regions import Region
from tests.oracles import planar

MANY = settings(max_examples=80, deadline=None)
Codes = npt.NDArray[np.uint8]
STEPS = (0.5, 0.25, 2.0)


def runs(codes: Codes, cuts: set[int]) -> tuple[Codes, npt.NDArray[np.int64]]:
    """Return runs that end with every grid line, and wherever else a tile did."""
    flat = codes.ravel()
    line = codes.shape[-1]
    ends = {i for i in range(1, flat.size) if flat[i] != flat[i - 1] or i % line == 0}
    bounds = np.array([0, *sorted(ends | {cut for cut in cuts if 0 < cut < flat.size}), flat.size])
    return flat[bounds[:-1]], np.diff(bounds)


def region(codes: Codes, cuts: set[int] | None = None) -> Region:
    axes = tuple(
        Axis(name, -1.0, -1.0 + step * (count - 1), step)
        for name, step, count in zip(("x", "y", "phi"), STEPS, codes.shape, strict=False)
    )
    grid = Grid(axes, tuple(range(codes.ndim)), np.zeros(3))
    values, lengths = runs(codes, cuts or set())
    return Region(grid, values, lengths)


MASKS = st.integers(1, 3).flatmap(
    lambda rank: arrays.arrays(
        np.uint8,
        arrays.array_shapes(min_dims=rank, max_dims=rank, min_side=1, max_side=9),
        elements=st.integers(0, 2),
    )
)
CUTS = st.sets(st.integers(1, 700), max_size=8)


@MANY
@given(MASKS, CUTS)
def test_nodes_are_counted(codes: Codes, cuts: set[int]) -> None:
    assert region(codes, cuts).nodes == (codes == 0).sum()


@MANY
@given(MASKS, CUTS)
def test_nodes_are_counted_by_code(codes: Codes, cuts: set[int]) -> None:
    counted = region(codes, cuts).nodes_by_code()
    np.testing.assert_array_equal(counted, np.bincount(codes.ravel(), minlength=256))


@MANY
@given(MASKS, CUTS)
def test_parts_are_those_of_labelling(codes: Codes, cuts: set[int]) -> None:
    labels, count = ndimage.label(codes == 0)
    sizes = sorted(np.bincount(labels.ravel())[1:], reverse=True)
    assert len(sizes) == count
    assert [part.nodes for part in region(codes, cuts).components] == sizes


@MANY
@given(MASKS, CUTS)
def test_parts_lie_where_labelling_has_them(codes: Codes, cuts: set[int]) -> None:
    labels, count = ndimage.label(codes == 0)
    steps = np.array(STEPS[: codes.ndim])
    expected = []
    for label in range(1, count + 1):
        places = -1.0 + np.argwhere(labels == label) * steps
        rows = (places.min(axis=0), places.max(axis=0), places.mean(axis=0).round(9))
        expected.append((len(places), *map(tuple, rows)))
    given_ = [
        (part.nodes, tuple(part.minimum), tuple(part.maximum), tuple(part.centroid.round(9)))
        for part in region(codes, cuts).components
    ]
    assert sorted(given_) == sorted(expected)


@MANY
@given(MASKS)
def test_measure_is_a_cell_for_every_node(codes: Codes) -> None:
    cell = np.prod(STEPS[: codes.ndim])
    assert region(codes).measure == (codes == 0).sum() * cell


@MANY
@given(MASKS, CUTS)
def test_error_is_half_a_cell_for_every_face_of_the_border(codes: Codes, cuts: set[int]) -> None:
    """The border is that to nodes outside, and the grid's own ends."""
    inside = np.pad(codes == 0, 1)
    faces = sum(int(np.sum(np.diff(inside, axis=axis))) for axis in range(codes.ndim))
    cell = np.prod(STEPS[: codes.ndim])
    assert region(codes, cuts).measure_error == pytest.approx(faces * cell / 2, rel=1e-12)


@MANY
@given(st.floats(-0.4, 0.4), st.floats(-0.4, 0.4), st.floats(0.3, 1.3))
def test_a_disc_cut_by_the_grid_is_within_the_error(x: float, y: float, radius: float) -> None:
    """Whether the part within the outermost nodes is meant, or that within their cells."""
    count, step = 21, 0.05
    along = np.linspace(-0.5, 0.5, count)
    far = np.hypot(along[:, None] - x, along[None] - y) > radius
    axes = tuple(Axis(name, -0.5, 0.5, step) for name in "xy")
    cut = Region(Grid(axes, (0, 1), np.zeros(2)), *runs(far.astype(np.uint8), set()))
    for half in (0.5, 0.5 + 0.5 * step):
        fine = half * (np.arange(-200, 200) + 0.5) / 200.0
        within = np.hypot(fine[:, None] - x, fine[None] - y) <= radius
        exact = np.mean(within) * (2.0 * half) ** 2
        unsure = 2.0 * np.pi * radius * half / 200.0  # Of the sum by small squares.
        assert abs(cut.measure - exact) <= cut.measure_error + unsure


@MANY
@given(MASKS, CUTS)
def test_cuts_change_nothing(codes: Codes, cuts: set[int]) -> None:
    cut, uncut = region(codes, cuts), region(codes)
    assert cut.measure_error == uncut.measure_error
    assert len(cut.components) == len(uncut.components)


@MANY
@given(
    st.floats(1.5, 20.0),
    st.floats(0.0, 1.0),
    st.floats(0.0, 1.0),
    st.floats(0.3, 1.0),
)
def test_a_disc_is_within_the_error(radius: float, right: float, up: float, squeeze: float) -> None:
    """An ellipse of any place and size, its steps unequal."""
    wide, high = radius, radius / squeeze
    i, j = np.arange(-23, 24), np.arange(-70, 71)
    far = np.hypot((i[:, None] - right) / wide, (j[None] - up) / high) > 1
    disc = region(far.astype(np.uint8))
    exact = np.pi * wide * high * STEPS[0] * STEPS[1]
    assert abs(disc.measure - exact) <= disc.measure_error


def test_a_ring_is_one_part_and_its_hole_none() -> None:
    x, y = np.ogrid[-10:11, -10:11]
    away = np.hypot(x, y)
    ring = region(((away > 8) | (away < 4)).astype(np.uint8))
    assert len(ring.components) == 1


def test_cells_that_share_a_corner_alone_are_apart() -> None:
    assert len(region((np.eye(3)[::-1] == 0).astype(np.uint8)).components) == 3


def test_the_ends_of_lines_do_not_touch_the_next_line() -> None:
    codes = np.array([[1, 1, 0], [0, 1, 1]], dtype=np.uint8)
    assert len(region(codes).components) == 2


def test_an_empty_region_has_no_parts_and_no_measure() -> None:
    empty = region(np.ones((4, 5), dtype=np.uint8))
    assert (empty.nodes, empty.measure, len(empty.components)) == (0, 0.0, 0)


def test_the_oracle_finds_the_area_of_a_ring() -> None:
    exact = np.pi * (4.0 - 1.0)
    assert abs(planar.rings_area([(0.3, -0.2, 1.0, 2.0)]) - exact) < 1e-12
