"""Nodes told box by box, against the same nodes told one by one."""

import math

import numpy as np
import pytest

from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.grid import Axis, Grid
from mechanics.kernels.codes import UNSEEN
from mechanics.motions import PLANAR, SPATIAL, SPHERICAL, Motion
from mechanics.octree import Reach, boxes_of, decide, foresee, window_about

SHAPES = [(17,), (9, 14), (1, 30), (7, 1, 12), (6, 5, 8), (3, 4, 5, 6), (2, 3, 2, 3, 2, 3)]
PLATFORM = np.array([[0.3, -0.2, 0.5], [-0.4, 0.1, 0.2]])
"""Platform points, whose sum of distances from a point makes the regions of these tests. [m]"""


def grid_of(motion: Motion, shape: tuple[int, ...]) -> Grid:
    """Return a grid with axes of unlike lengths, the motion's last coordinate first."""
    random = np.random.default_rng(3)
    columns = tuple(range(len(motion.coordinates)))[::-1][: len(shape)]
    wide = random.uniform(0.5, 2.5, len(shape))
    axes = tuple(
        Axis(motion.coordinates[column], -w, w, 2.0 * w / (count - 0.5))
        for column, count, w in zip(columns, shape, wide, strict=True)
    )
    return Grid(axes, columns, random.uniform(-0.3, 0.3, len(motion.coordinates)))


class Rings:
    """Three regions by how far platform points are from one point, and who was asked of them."""

    def __init__(self, motion: Motion, grid: Grid) -> None:
        self.motion, self.grid = motion, grid
        self.asked: list[Integers] = []
        self.limits = np.quantile(self.sizes(grid.poses(0, grid.size)), [0.4, 0.7])

    def sizes(self, poses: Floats) -> Floats:
        positions, rotations = self.motion.place(np.ascontiguousarray(poses))
        arms = np.einsum("ijk,lj->lik", rotations.reshape(3, 3, -1), PLATFORM)
        sizes: Floats = np.linalg.norm(positions + arms - 0.1, axis=1).sum(axis=0)
        return sizes

    def codes(self, sizes: Floats) -> Bytes:
        return np.searchsorted(self.limits, sizes).astype(np.uint8)

    def ask(self, nodes: Integers) -> Bytes:
        self.asked.append(nodes)
        return self.codes(self.sizes(self.grid.poses_at(nodes)))

    def judge(self, poses: Floats, reach: Reach) -> Bytes:
        far = np.linalg.norm(PLATFORM, axis=1)
        changes = far.size * reach.positions + far.sum() * reach.turns + 1e-12
        sizes = self.sizes(poses)
        low, high = self.codes(sizes - changes), self.codes(sizes + changes)
        return np.where(low == high, low, UNSEEN).astype(np.uint8)


def stretches(size: int) -> list[tuple[int, int]]:
    random = np.random.default_rng(size)
    drawn = np.sort(random.integers(0, size + 1, (8, 2)), axis=1)
    return [(0, size), (size, size), (size - 1, size), *map(tuple, drawn.tolist())]


@pytest.mark.parametrize(
    ("motion", "shape"),
    [
        (motion, shape)
        for motion in (PLANAR, SPHERICAL, SPATIAL)
        for shape in SHAPES
        if len(shape) <= len(motion.coordinates)
    ],
)
def test_boxes_say_what_nodes_say(motion: Motion, shape: tuple[int, ...]) -> None:
    grid = grid_of(motion, shape)
    expected = Rings(motion, grid).ask(np.arange(grid.size))
    for start, stop in stretches(grid.size):
        rings = Rings(motion, grid)
        found = decide(motion, grid, start, stop, rings.judge, rings.ask)
        assert np.array_equal(found, expected[start:stop])
        asked = np.concatenate([*rings.asked, np.empty(0, np.int64)])
        assert np.all(np.diff(asked) > 0)


def test_few_nodes_are_asked_where_boxes_tell() -> None:
    axes = (Axis("x", -1.0, 1.0, 2.0 / 511), Axis("y", -1.0, 1.0, 2.0 / 511))
    grid = Grid(axes, (0, 1), np.zeros(3))
    rings = Rings(PLANAR, grid)
    decide(PLANAR, grid, 0, grid.size, rings.judge, rings.ask)
    assert rings.asked[0].size < 0.05 * grid.size


@pytest.mark.parametrize(("motion", "counts"), [(PLANAR, (400, 500)), (SPATIAL, (40, 50, 60))])
def test_what_all_boxes_take_is_seen_from_the_large_ones(
    motion: Motion, counts: tuple[int, ...]
) -> None:
    columns = tuple(range(len(counts)))
    axes = tuple(Axis("xyz"[k], -1.0, 1.0, 2.0 / n) for k, n in enumerate(counts))
    grid = Grid(axes, columns, np.zeros(len(motion.coordinates)))
    rings, judged = Rings(motion, grid), 0

    def judge(poses: Floats, reach: Reach) -> Bytes:
        nonlocal judged
        judged += poses.shape[1]
        return rings.judge(poses, reach)

    for fewest in (9, 30):
        judged = 0
        rings.asked.clear()
        decide(motion, grid, 0, grid.size, judge, rings.ask, fewest=fewest)
        work = foresee(motion, grid, rings.judge, fewest)
        assert 0.5 < work.judged / judged < 2.0
        assert 0.5 < work.asked / rings.asked[0].size < 2.0


@pytest.mark.parametrize("share", [0.0, 0.01, 0.5, 1.0])
def test_only_nodes_among_others_are_asked(share: float) -> None:
    grid = grid_of(SPATIAL, (6, 9, 13))
    expected = Rings(SPATIAL, grid).ask(np.arange(grid.size))
    for start, stop in stretches(grid.size):
        among: Booleans = np.random.default_rng(start).random(stop - start) < share
        rings = Rings(SPATIAL, grid)
        found = decide(SPATIAL, grid, start, stop, rings.judge, rings.ask, among=among)
        assert np.array_equal(found[among], expected[start:stop][among])
        assert all(among[nodes - start].all() for nodes in rings.asked)


def test_one_pose_is_asked_by_itself() -> None:
    grid = Grid((), (), np.zeros(3))
    rings = Rings(PLANAR, grid)
    assert decide(PLANAR, grid, 0, 1, rings.judge, rings.ask).tolist() == [0]


@pytest.mark.parametrize("motion", [PLANAR, SPATIAL])
def test_nodes_are_within_reach_of_their_centres(motion: Motion) -> None:
    grid = grid_of(motion, (5, 6, 7))
    seen: list[tuple[Floats, Reach]] = []

    def judge(poses: Floats, reach: Reach) -> Bytes:
        seen.append((poses, reach))
        return np.full(poses.shape[1], 0, np.uint8)

    start, stop = 17, 160
    decide(motion, grid, start, stop, judge, lambda nodes: np.zeros(nodes.size, np.uint8))
    poses, reach = seen[0]
    boxes = boxes_of(grid.shape, start, stop)
    indices = np.array(np.unravel_index(np.arange(start, stop), grid.shape))
    for i in range(poses.shape[1]):
        first, last = (ends[:, i, None] for ends in boxes)
        own = np.all((first <= indices) & (indices <= last), axis=0)
        positions, rotations = motion.place(grid.poses_at(start + np.flatnonzero(own)))
        centre, rotation = motion.place(np.ascontiguousarray(poses[:, i : i + 1]))
        apart = np.linalg.norm(positions - centre, axis=0)
        assert np.all(apart <= reach.positions[i])
        assert np.max(apart) >= (1.0 - 1e-9) * reach.positions[i]
        traces = np.sum(rotations * rotation, axis=0)
        assert np.all(np.arccos(np.clip(0.5 * (traces - 1.0), -1.0, 1.0)) <= reach.turns[i] + 1e-7)


@pytest.mark.parametrize("shape", SHAPES)
def test_a_stretch_is_at_most_a_head_a_middle_and_a_tail_an_axis(shape: tuple[int, ...]) -> None:
    size = math.prod(shape)
    for start, stop in stretches(size):
        boxes = boxes_of(shape, start, stop)
        assert boxes.first.shape[1] <= 2 * len(shape) - 1
        indices = np.array(np.unravel_index(np.arange(size), shape))
        inside = (boxes.first[..., None] <= indices[:, None]) & (
            indices[:, None] <= boxes.last[..., None]
        )
        owners = np.all(inside, axis=0).sum(axis=0)
        assert owners[start:stop].tolist() == [1] * (stop - start)
        assert owners.sum() == stop - start


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("share", [0.02, 0.3, 1.0])
def test_a_window_is_the_smallest_about_its_nodes(shape: tuple[int, ...], share: float) -> None:
    grid = grid_of(SPATIAL, shape)
    nodes = np.flatnonzero(np.random.default_rng(9).random(grid.size) < share)
    nodes = np.append(nodes, grid.size // 2) if not nodes.size else nodes
    window, places = window_about(grid, nodes)
    indices = np.array(np.unravel_index(nodes, shape))
    assert window.first.tolist() == indices.min(axis=1).tolist()
    assert window.shape == tuple(np.ptp(indices, axis=1) + 1)
    inner = tuple(indices - window.first[:, None])
    assert np.array_equal(places, np.ravel_multi_index(inner, window.shape))
    assert np.array_equal(window.of(grid, places), nodes)
