"""`python -m benchmarks.assembly`: what all assembly modes of six rods cost, and which are missed.

Ten thousand random platforms of each kind, each held against the pose that it was drawn at and
against what Newton's method finds from random poses; the exit status says whether one was missed.
Other numbers of platforms and of random poses may be given as arguments.
"""

import sys
import time
from collections import Counter

import numpy as np

from benchmarks.measuring import REPEATS, seconds
from mechanics.arrays import Floats
from mechanics.assembly.rods import Rods, distinct, improve, random_poses
from mechanics.assembly.spatial import SpatialModes, spatial_modes
from mechanics.kernels import newton
from tests.oracles import rods as platforms
from tests.oracles.rods import Platform, Random

PLATFORMS = 10_000
STARTS = 128
EIGENVALUES = 20
"""One in so many platforms is timed beside NumPy's eigenvalues."""
POSES = 100_000


class Tally:
    """What came of the platforms of one kind."""

    def __init__(self, kind: str) -> None:
        self.kind = kind
        self.ours: list[float] = []
        self.theirs: list[float] = []
        self.routes: Counter[str] = Counter()
        self.modes = self.searched = self.lost = self.uncertain = 0

    def solve(self, of: Platform) -> SpatialModes:
        """Return all modes of a platform, timed."""
        start = time.process_time()
        found = spatial_modes(of.base, of.platform, of.lengths)
        self.ours.append(time.process_time() - start)
        return found

    def compare(self, of: Platform, found: SpatialModes, starts: int, random: Random) -> None:
        """Count which of the modes that Newton's method finds, and of the pose, are not ours."""
        six = Rods(of.base, of.platform, of.lengths)
        seen = distinct(six, improve(six, *random_poses(six, starts, random)))
        rows = np.hstack([seen.positions, seen.rotations.reshape(-1, 9)])
        self.lost += lost(found, np.vstack([rows, pose(of)]))
        self.modes, self.searched = self.modes + len(found.residuals), self.searched + len(rows)
        self.uncertain += not found.certified
        self.routes[found.route] += 1

    def report(self) -> None:
        """Print median and 99th percentile, and what was missed."""
        a, b, c = 1e6 * np.array([np.min(self.ours), *np.quantile(self.ours, [0.5, 0.99])])
        d, e = 1e6 * np.array([np.min(self.theirs), np.median(self.theirs)])
        print(
            f"{self.kind:16} least {a:5.0f}, median {b:5.0f}, p99 {c:5.0f} us;"
            f" eig 40 x 40 {d:5.0f}, {e:5.0f} us; {self.modes} modes,"
            f" Newton finds {self.searched}, lost {self.lost};"
            f" not certified {self.uncertain}; {dict(self.routes)}",
            flush=True,
        )


def tally(kind: str, count: int, starts: int) -> int:
    """Print the tally of random platforms of a kind; return how many modes were lost."""
    random = np.random.default_rng(0)
    of = Tally(kind)
    spatial_modes(*platforms.draw(kind, random)[:3])
    for k in range(count):
        drawn = platforms.draw(kind, random)
        of.compare(drawn, of.solve(drawn), starts, random)
        if k % EIGENVALUES == 0:
            matrix = random.normal(size=(40, 40))
            of.theirs.append(seconds(lambda matrix=matrix: np.linalg.eig(matrix)))  # type: ignore[misc]
    of.report()
    return of.lost


def pose(of: Platform) -> Floats:
    """Return a platform's own pose as a row."""
    row: Floats = np.r_[of.position, of.rotation.ravel()]
    return row


def lost(found: SpatialModes, poses: Floats) -> int:
    """Return how many of these poses, shape (n, 12), are not among the modes."""
    rows = np.hstack([found.positions, found.rotations.reshape(-1, 9)])
    away = np.abs(rows[None] - poses[:, None]).max(axis=2).min(axis=1, initial=np.inf)
    return int(np.count_nonzero(away > 1e-5))


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
    for _ in range(REPEATS):
        p = np.ascontiguousarray(np.broadcast_to(guess[0], (3, POSES)))
        R = np.repeat(of.rotation.reshape(9, 1), POSES, axis=1)  # noqa: N806
        given = (base, of.platform, lengths, p, R, 0.7, 20, iterations, residuals, converged)
        shortest = min(shortest, seconds(lambda given=given: newton.solve_rods(*given)))  # type: ignore[misc]
    print(
        f"Newton from a guess {1e6 * shortest / POSES:.3f} us a pose,"
        f" {iterations.mean():.1f} steps, {converged.mean():.2%} converged"
    )


def main() -> None:
    """Measure, compare, and fail if a mode was lost."""
    count, starts = (*map(int, sys.argv[1:]), *(PLATFORMS, STARTS)[len(sys.argv) - 1 :])
    batch()
    missed = sum(tally(kind, count, starts) for kind in platforms.CLASSES)
    sys.exit(f"{missed} modes lost" if missed else 0)


if __name__ == "__main__":
    main()
