"""A platform on six rods of given lengths: poses improved from guesses, and found from many."""

import math
from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.kernels import newton
from mechanics.kernels.crowding import crowded

TRUST = 0.7
"""No step turns by more, nor moves by more times the rods' size. [rad]"""

STEPS = 40
"""Newton's method makes no more."""

APART = 1e-5
"""Poses nearer than this, turns and positions over the rods' size, may be one."""

STARTS = 2048
"""Random poses that one round starts from."""

ROUNDS = 8
MOST_MODES = 40


@dataclass(frozen=True)
class Rods:
    """Six rods: their fixed ends and those on the platform, shape (6, 3), and lengths, (6,). [m]"""

    base: Floats
    platform: Floats
    lengths: Floats

    @property
    def size(self) -> float:
        """The rms length. [m]"""
        return math.sqrt(float(self.lengths @ self.lengths) / 6.0)

    def spans(self, positions: Floats, rotations: Floats) -> Floats:
        """Return from one end of each rod to the other at poses, shape (poses, 6, 3). [m]"""
        turned = np.einsum("nij,kj->nki", rotations, self.platform)
        spans: Floats = positions[:, None, :] + turned - self.base
        return spans

    def residuals(self, positions: Floats, rotations: Floats) -> Floats:
        """Return by how much the worst rod misses its length at poses, shape (poses,). [m]"""
        spans = np.linalg.norm(self.spans(positions, rotations), axis=2)
        worst: Floats = np.max(np.abs(spans - self.lengths), axis=1, initial=0.0)
        return worst


@dataclass(frozen=True)
class Poses:
    """Poses reached from guesses, and how.

    Parameters
    ----------
    positions, rotations : arrays, shapes (poses, 3) and (poses, 3, 3). [m, -]
    iterations : array, shape (poses,): Newton steps made.
    residuals : array, shape (poses,): by how much the worst rod misses its length. [m]
    converged : array, shape (poses,): whether every rod has its length, to 1e-12 of their size.
    """

    positions: Floats
    rotations: Floats
    iterations: Integers
    residuals: Floats
    converged: Booleans

    def take(self, chosen: Booleans | Integers) -> "Poses":
        """Return the chosen poses."""
        return Poses(
            self.positions[chosen],
            self.rotations[chosen],
            self.iterations[chosen],
            self.residuals[chosen],
            self.converged[chosen],
        )


def improve(rods: Rods, positions: Floats, rotations: Floats) -> Poses:
    """Return the poses to which Newton's method leads from these, shapes (3, n) and (9, n)."""
    count = positions.shape[1]
    iterations, residuals = np.zeros(count, dtype=np.int64), np.empty(count)
    converged = np.empty(count, dtype=bool)
    newton.solve_rods(
        rods.base[:, :, None],
        rods.platform,
        rods.lengths[:, None],
        positions,
        rotations,
        TRUST,
        STEPS,
        iterations,
        residuals,
        converged,
    )
    turned = np.ascontiguousarray(rotations.T).reshape(count, 3, 3)
    return Poses(np.ascontiguousarray(positions.T), turned, iterations, residuals, converged)


def distinct(rods: Rods, poses: Poses) -> Poses:
    """Return each pose that converged once.

    Two are one if they are close and the pose halfway, too, has rods of the right lengths: of a
    double root Newton's method knows only half the digits.
    """
    rest = poses if poses.converged.all() else poses.take(poses.converged)
    if len(rest.residuals) <= MOST_MODES and not crowded(
        rest.positions, rest.rotations, rods.size, APART
    ):
        return rest
    rest = rest.take(np.argsort(rest.residuals, kind="stable"))
    kept = rest.take(np.arange(0))
    while rest.residuals.size and len(kept.residuals) < MOST_MODES:
        first = rest.take(np.array([0]))
        kept = joined(kept, first)
        rest = rest.take(~_same(rods, first, rest))
    return kept


def _same(rods: Rods, first: Poses, others: Poses) -> Booleans:
    """Return which of the others are the first pose."""
    away = np.max(np.abs(others.positions - first.positions), axis=1) / rods.size
    turn = np.max(np.abs(others.rotations - first.rotations), axis=(1, 2))
    same: Booleans = np.maximum(away, turn) < APART
    halfway = 0.5 * (others.rotations[same] + first.rotations)
    gram = np.swapaxes(halfway, 1, 2) @ halfway
    halfway = halfway @ (1.5 * np.eye(3) - 0.5 * gram)
    middle = 0.5 * (others.positions[same] + first.positions)
    same[same] = rods.residuals(middle, halfway) <= newton.SOLVED * rods.size
    return same


def search(rods: Rods, random: np.random.Generator) -> Poses:
    """Return the poses found from random ones, round after round until one brings nothing new."""
    found = improve(rods, *random_poses(rods, STARTS, random))
    modes = distinct(rods, found)
    for _ in range(ROUNDS):
        more = improve(rods, *random_poses(rods, STARTS, random))
        together = distinct(rods, joined(modes, more))
        if len(together.residuals) == len(modes.residuals):
            break
        modes = together
    return modes


def joined(a: Poses, b: Poses) -> Poses:
    """Return the poses of both."""
    return Poses(
        np.concatenate([a.positions, b.positions]),
        np.concatenate([a.rotations, b.rotations]),
        np.concatenate([a.iterations, b.iterations]),
        np.concatenate([a.residuals, b.residuals]),
        np.concatenate([a.converged, b.converged]),
    )


def random_poses(rods: Rods, count: int, random: np.random.Generator) -> tuple[Floats, Floats]:
    """Return poses turned anyhow, the platform's joints within the rods' reach of the base's.

    Shapes (3, poses) and (9, poses), as `improve` takes them.
    """
    q = random.normal(size=(count, 4))
    w, x, y, z = (q / np.linalg.norm(q, axis=1, keepdims=True)).T
    columns = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    rotations = np.ascontiguousarray(np.moveaxis(np.array(columns), 2, 0))
    away = random.normal(size=(count, 3))
    radius = 1.2 * rods.lengths.max() * np.cbrt(random.random(count))
    away *= (radius / np.linalg.norm(away, axis=1))[:, None]
    centre = rods.base.mean(axis=0) - rotations @ rods.platform.mean(axis=0)
    return np.ascontiguousarray((centre + away).T), np.ascontiguousarray(
        np.array(columns).reshape(9, count)
    )
