"""`python -m benchmarks.assembly`: what all assembly modes of six rods cost, and which are missed.

With a number of platforms as its argument it becomes a campaign: that many random platforms of
each kind, 10 000 say, against modes that Newton's method finds from random poses.
"""

import sys
import time
from collections import Counter
from collections.abc import Callable

import numpy as np

from mechanics.arrays import Floats
from mechanics.assembly.rods import Rods, distinct, improve, random_poses
from mechanics.assembly.spatial import SpatialModes, spatial_modes
from mechanics.kernels import newton
from tests.oracles import rods as platforms
from tests.oracles.rods import Platform

PLATFORMS = 1000
STARTS = 2048
POSES = 100_000


def seconds(work: Callable[[], object]) -> float:
    """Return how long a piece of work keeps the processor, whatever else runs on the machine."""
    start = time.process_time()
    work()
    return time.process_time() - start


def times(kind: str, count: int) -> None:
    """Print median and 99th percentile over random platforms, beside NumPy's eigenvalues."""
    random = np.random.default_rng(0)
    routes: Counter[str] = Counter()
    ours, theirs, missed = np.empty(count), np.empty(count), 0
    spatial_modes(*platforms.draw(kind, random)[:3])
    for k in range(count):
        of, matrix = platforms.draw(kind, random), random.normal(size=(40, 40))
        start = time.process_time()
        found = spatial_modes(of.base, of.platform, of.lengths)
        ours[k] = time.process_time() - start
        theirs[k] = seconds(lambda matrix=matrix: np.linalg.eig(matrix))  # type: ignore[misc]
        routes[found.route] += 1
        missed += lost(found, pose(of)[None])
    a, b, c = 1e6 * np.array([np.min(ours), *np.quantile(ours, [0.5, 0.99])])
    d, e, f = 1e6 * np.array([np.min(theirs), *np.quantile(theirs, [0.5, 0.99])])
    print(
        f"{kind:16} least {a:6.0f}, median {b:6.0f}, p99 {c:6.0f} us;"
        f" eig 40 x 40 {d:6.0f}, {e:6.0f}, {f:6.0f} us; poses lost {missed}; {dict(routes)}"
    )


def pose(of: Platform) -> Floats:
    """Return a platform's own pose as a row."""
    row: Floats = np.r_[of.position, of.rotation.ravel()]
    return row


def lost(found: SpatialModes, poses: Floats) -> int:
    """Return how many of these poses, shape (n, 12), are not among the modes."""
    rows = np.hstack([found.positions, found.rotations.reshape(-1, 9)])
    away = np.abs(rows[None] - poses[:, None]).max(axis=2).min(axis=1, initial=np.inf)
    return int(np.count_nonzero(away > 1e-5))


def campaign(kind: str, count: int) -> None:
    """Print how many modes that Newton's method finds are not among ours."""
    random = np.random.default_rng(1)
    routes: Counter[str] = Counter()
    modes, missed, seen, uncertain = 0, 0, 0, 0
    for _ in range(count):
        of = platforms.draw(kind, random)
        six = Rods(of.base, of.platform, of.lengths)
        found = spatial_modes(of.base, of.platform, of.lengths)
        searched = distinct(six, improve(six, *random_poses(six, STARTS, random)))
        rows = np.hstack([searched.positions, searched.rotations.reshape(-1, 9)])
        missed += lost(found, np.vstack([rows, pose(of)]))
        modes, seen = modes + len(found.residuals), seen + len(rows)
        uncertain += not found.certified
        routes[found.route] += 1
    print(
        f"{kind:16} {count} platforms, {modes} modes, Newton finds {seen}, of which lost {missed};"
        f" not certified {uncertain}; {dict(routes)}"
    )


def batch() -> None:
    """Print what Newton's method costs, a pose of a hexapod, from guesses beside it."""
    random = np.random.default_rng(2)
    of = platforms.draw("hexagons", random)
    q = np.c_[np.ones(POSES), random.normal(0.0, 0.05, (POSES, 3))]
    turns = platforms.rotations(q / np.linalg.norm(q, axis=1, keepdims=True)) @ of.rotation
    places = of.position + random.normal(0.0, 0.05, (POSES, 3))
    spans = places[:, None] + np.einsum("nij,kj->nki", turns, of.platform) - of.base
    lengths = np.ascontiguousarray(np.linalg.norm(spans, axis=2).T)
    base = np.ascontiguousarray(np.broadcast_to(of.base[:, :, None], (6, 3, POSES)))
    guess = np.array([of.position, *of.rotation.T])[:, :, None]
    iterations, residuals = np.zeros(POSES, dtype=np.int64), np.empty(POSES)
    converged, shortest = np.empty(POSES, dtype=bool), np.inf
    for _ in range(9):
        p = np.ascontiguousarray(np.broadcast_to(guess[0], (3, POSES)))
        R = np.repeat(of.rotation.reshape(9, 1), POSES, axis=1)  # noqa: N806
        given = (base, of.platform, lengths, p, R, 0.7, 20, iterations, residuals, converged)
        shortest = min(shortest, seconds(lambda given=given: newton.solve_rods(*given)))  # type: ignore[misc]
    print(
        f"Newton from a guess {1e6 * shortest / POSES:.3f} us a pose,"
        f" {iterations.mean():.1f} steps, {converged.mean():.2%} converged"
    )


def main() -> None:
    """Measure, or with a number of platforms compare."""
    if len(sys.argv) > 1:
        for kind in platforms.CLASSES:
            campaign(kind, int(sys.argv[1]))
        return
    batch()
    for kind in platforms.CLASSES:
        times(kind, PLATFORMS)


if __name__ == "__main__":
    main()
