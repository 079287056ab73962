"""Newton's method from guesses, many poses of six rods at once."""

import numpy as np
import pytest

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.kernels.newton import LANES, solve_rods
from tests.oracles import rods
from tests.oracles.rods import Platform

Answer = tuple[Floats, Floats, Integers, Floats, Booleans]


def guesses(of: Platform, count: int, off: float) -> tuple[Floats, Floats, Floats, Floats]:
    """Return poses about the platform's, shapes (n, 3) and (n, 3, 3), and guesses `off` them."""
    random = np.random.default_rng(0)
    q = np.c_[np.ones(count), random.normal(0.0, 0.1, (count, 3))]
    rotation = rods.rotations(q / np.linalg.norm(q, axis=1, keepdims=True)) @ of.rotation
    position = of.position + random.normal(0.0, 0.1, (count, 3))
    q = np.c_[np.ones(count), random.normal(0.0, off, (count, 3))]
    turned = rods.rotations(q / np.linalg.norm(q, axis=1, keepdims=True)) @ rotation
    return position, rotation, position + random.normal(0.0, off, (count, 3)), turned


def solved(base: Floats, platform: Floats, lengths: Floats, p: Floats, turned: Floats) -> Answer:
    """Return what the kernel makes of guesses, shapes (n, 3) and (n, 3, 3)."""
    count = len(p)
    positions = np.ascontiguousarray(p.T)
    rotations = np.ascontiguousarray(turned.reshape(count, 9).T)
    iterations, residuals = np.zeros(count, dtype=np.int64), np.empty(count)
    converged = np.empty(count, dtype=bool)
    answer = (iterations, residuals, converged)
    solve_rods(base, platform, lengths, positions, rotations, 0.7, 40, *answer)
    return positions.T, rotations.T.reshape(count, 3, 3), *answer


def problem(count: int, off: float) -> tuple[Platform, Floats, Floats, Floats, Floats, Floats]:
    """Return a hexapod on a base that moves along, its poses and guesses."""
    of = rods.draw("hexagons", np.random.default_rng(1))
    poses = guesses(of, count, off)
    base = of.base + np.random.default_rng(2).normal(0.0, 0.05, (count, 6, 3))
    return of, base, *poses


def lengths(of: Platform, base: Floats, position: Floats, rotation: Floats) -> Floats:
    spans = position[:, None] + np.einsum("nij,kj->nki", rotation, of.platform) - base
    return np.ascontiguousarray(np.linalg.norm(spans, axis=2).T)


def columns(base: Floats) -> Floats:
    return np.ascontiguousarray(np.moveaxis(base, 0, 2))


@pytest.mark.parametrize("count", [1, LANES - 1, LANES, 1000])
def test_guesses_lead_to_the_poses_beside_them(count: int) -> None:
    of, base, position, rotation, p, near = problem(count, 0.003)
    rod = lengths(of, base, position, rotation)
    found = solved(columns(base), of.platform, rod, p, near)
    assert found[4].all()
    # Few poses are close to a singularity, where even a small error leads elsewhere.
    beside = np.abs(found[0] - position).max(axis=1) < 1e-9
    beside &= np.abs(found[1] - rotation).max(axis=(1, 2)) < 1e-9
    assert np.mean(beside) > 0.99


def test_answers_have_rods_of_the_given_lengths() -> None:
    of, base, position, rotation, p, near = problem(1000, 0.3)
    rod = lengths(of, base, position, rotation)
    found = solved(columns(base), of.platform, rod, p, near)
    errors = np.abs(lengths(of, base, found[0], found[1]) - rod).max(axis=0)
    assert errors[found[4]].max() < 1e-12
    np.testing.assert_allclose(found[3][found[4]], errors[found[4]], atol=1e-14)
    turned = found[1][found[4]]
    np.testing.assert_allclose(
        turned @ np.swapaxes(turned, 1, 2), np.broadcast_to(np.eye(3), turned.shape), atol=1e-14
    )


def test_convergence_is_quadratic() -> None:
    of, base, position, rotation, p, near = problem(1000, 1e-4)
    found = solved(columns(base), of.platform, lengths(of, base, position, rotation), p, near)
    assert np.median(found[2]) <= 3


def test_rods_that_cannot_meet_are_marked() -> None:
    of, base, position, rotation, p, near = problem(100, 0.01)
    rod = lengths(of, base, position, rotation)
    rod[0, ::2] += 100.0
    converged = solved(columns(base), of.platform, rod, p, near)[4]
    assert not converged[::2].any()
    assert converged[1::2].all()


def test_a_pose_is_answered_alike_in_any_company() -> None:
    of, base, position, rotation, p, near = problem(30, 0.3)
    rod = lengths(of, base, position, rotation)
    together = solved(columns(base), of.platform, rod, p, near)
    for k in range(30):
        one = slice(k, k + 1)
        alone = solved(
            columns(base[one]), of.platform, np.ascontiguousarray(rod[:, one]), p[one], near[one]
        )
        for mine, ours in zip(alone, together, strict=True):
            np.testing.assert_array_equal(mine[0], ours[k])
