"""`python -m benchmarks`: prints each figure as a ratio, both sides measured in this run."""

import time
from collections.abc import Callable

import numpy as np

from benchmarks.rivals import reach_grid, worst_efforts
from mechanics import effort
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.grid import Axis, Grid
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.workspace import scan

REPEATS = 5


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
    """Print one line."""
    nanoseconds = 1e9 / items
    print(
        f"{name:44} {ours * nanoseconds:8.1f} ns  {rival:36} {theirs * nanoseconds:8.1f} ns  "
        f"ratio {theirs / ours:6.2f}"
    )


def machine() -> Mechanism:
    """Return the 3-RRR of Laryushkin, Glazunov and Erastova, 2016."""
    return planar_3rrr(
        base_side=0.4,
        platform_radius=0.08,
        crank_length=0.18,
        rod_length=0.18,
        limits=np.tile([-np.inf, np.inf], (3, 1)),
        working_mode=np.ones(3),
    )


def scan_of_reach(mechanism: Mechanism) -> None:
    """Compare a scan of the theoretical workspace, a node, with NumPy over the whole grid."""
    axes = (Axis("x", -0.3, 0.3, 0.0005), Axis("y", -0.3, 0.3, 0.0005))
    grid = Grid(axes, (0, 1), np.zeros(3))
    legs = mechanism.legs
    ours = best(lambda: scan(mechanism, [Reach(mechanism)], grid, {}, 0, grid.size))
    theirs = best(
        lambda: reach_grid(
            legs.base_point[:, :2],
            legs.platform_point[:, :2],
            0.0,
            0.36,
            axes[0].nodes,
            axes[1].nodes,
        )
    )
    report("3-RRR reach, general legs, a node", grid.size, ours, theirs, "NumPy, annuli at phi = 0")


def efforts_of_poses(mechanism: Mechanism) -> None:
    """Compare worst-direction efforts, a pose, with batched inversion of ready Jacobians."""
    random = np.random.default_rng(0)
    poses = np.ascontiguousarray(random.uniform(-0.05, 0.05, (200_000, 3)).T)
    load = Load(10.0)
    ready = Configuration(mechanism, poses)
    rates = ready.rods[1].T[:, :, None]
    jacobians = np.ascontiguousarray(np.moveaxis(ready.platform_jacobians, 2, 0) / rates)
    theirs = best(lambda: worst_efforts(jacobians, 10.0))
    ours = best(lambda: effort.worst_efforts(Configuration(mechanism, poses), load))
    name = "3-RRR efforts from poses"
    report(name, poses.shape[1], ours, theirs, "numpy.linalg.inv + norms, J given")


if __name__ == "__main__":
    scan_of_reach(machine())
    efforts_of_poses(machine())
