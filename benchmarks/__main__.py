"""`python -m benchmarks`: prints each figure as a ratio, both sides measured in this run."""

import time
from collections.abc import Callable

import numpy as np

from analyses.analysis import POSES_PER_BLOCK
from benchmarks import rivals
from mechanics import effort
from mechanics.arrays import Floats
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.families.hexapods import gough_stewart
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.grid import Axis, Grid
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.workspace import scan

REPEATS = 5
POSES = 1_000_000


def best(work: Callable[[], object]) -> float:
    """Return the shortest of several times. [s]"""
    work()
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def report(name: str, items: int, ours: float, theirs: float, rival: str) -> None:
    """Print one line; a ratio above 1 says how many times faster we are."""
    nanoseconds = 1e9 / items
    print(
        f"{name:42} {ours * nanoseconds:8.1f} ns  {rival:40} {theirs * nanoseconds:8.1f} ns  "
        f"ratio {theirs / ours:6.2f}"
    )


def free(legs: int) -> Floats:
    """Return limits of drives that have none."""
    return np.tile([-np.inf, np.inf], (legs, 1))


def planar() -> Mechanism:
    """Return the 3-RRR of Laryushkin, Glazunov and Erastova, 2016."""
    return planar_3rrr(
        base_side=0.4,
        platform_radius=0.08,
        crank_length=0.18,
        rod_length=0.18,
        limits=free(3),
        working_mode=np.ones(3),
    )


def hexapod() -> tuple[Mechanism, Floats]:
    """Return a 6-SPS and random poses, shape (poses, 6)."""
    base_angles = np.deg2rad([-10, 10, 110, 130, 230, 250])
    platform_angles = np.deg2rad([-50, 50, 70, 170, 190, 290])
    flat = np.zeros(6)
    mechanism = gough_stewart(
        base_points=np.c_[np.cos(base_angles), np.sin(base_angles), flat].tolist(),
        platform_points=(
            0.5 * np.c_[np.cos(platform_angles), np.sin(platform_angles), flat]
        ).tolist(),
        limits=free(6),
        working_mode=np.ones(6),
    )
    random = np.random.default_rng(0)
    poses = np.c_[
        random.uniform(-0.2, 0.2, (POSES, 2)),
        random.uniform(0.9, 1.2, POSES),
        random.uniform(-0.5, 0.5, (POSES, 3)),
    ]
    return mechanism, poses


def scan_of_reach() -> None:
    """Compare a scan of the theoretical workspace, a node, with NumPy over the whole grid."""
    mechanism = planar()
    axes = (Axis("x", -0.3, 0.3, 0.0005), Axis("y", -0.3, 0.3, 0.0005))
    grid = Grid(axes, (0, 1), np.zeros(3))
    base, platform = mechanism.legs.base_point[:, :2], mechanism.legs.platform_point[:, :2]
    x, y = (axis.nodes for axis in axes)
    ours = best(lambda: scan(mechanism, [Reach(mechanism)], grid, {}, 0, grid.size))
    theirs = best(lambda: rivals.reach_grid(base, platform, 0.0, 0.36, x, y))
    report("3-RRR reach by general legs, a node", grid.size, ours, theirs, "NumPy, annuli")


def inverse_of_struts() -> None:
    """Compare the inverse of a 6-SPS, a pose, with bare roots and with blocked NumPy."""
    mechanism, rows = hexapod()
    poses = np.ascontiguousarray(rows.T)
    roots = np.empty_like(poses)
    base, platform = mechanism.legs.base_point, mechanism.legs.platform_point
    ours = best(lambda: Configuration(mechanism, poses).actuators)
    floor = best(lambda: rivals.six_roots(poses, roots))
    numpy = best(lambda: rivals.strut_lengths(rows, base, platform))
    report("6-SPS inverse, a pose", POSES, ours, floor, "six bare square roots (the floor)")
    report("6-SPS inverse, a pose", POSES, ours, numpy, "NumPy, blocks of 4096")


def efforts(name: str, mechanism: Mechanism, rows: Floats) -> None:
    """Compare worst-direction efforts from poses with batched inversion of ready Jacobians."""
    poses = np.ascontiguousarray(rows.T)
    ready = Configuration(mechanism, poses)
    jacobians = ready.platform_jacobians / ready.rods[1][:, None, :]
    matrices = np.ascontiguousarray(np.moveaxis(jacobians, 2, 0))
    split = len(mechanism.motion.translations)
    load = Load(10.0, 2.0)
    theirs = best(lambda: rivals.worst_efforts(matrices, 10.0, 2.0, split))
    starts = range(0, len(rows), POSES_PER_BLOCK)
    blocks = [np.ascontiguousarray(poses[:, a : a + POSES_PER_BLOCK]) for a in starts]
    ours = best(
        lambda: [effort.worst_efforts(Configuration(mechanism, block), load) for block in blocks]
    )
    report(name, len(rows), ours, theirs, "numpy.linalg.inv + norms, J given")


if __name__ == "__main__":
    scan_of_reach()
    inverse_of_struts()
    random_poses = np.random.default_rng(0).uniform(-0.05, 0.05, (200_000, 3))
    efforts("3-RRR efforts from poses, a pose", planar(), random_poses)
    platform, platform_poses = hexapod()
    efforts("6-SPS efforts from poses, a pose", platform, platform_poses)
