"""Small linear systems: regular ones solved, singular ones as far as they determine anything."""

import numpy as np
import pytest

from mechanics.kernels.elimination import solve_each
from tests.oracles.legs import Floats


def solved(matrices: Floats, rights: Floats) -> Floats:
    found = np.empty_like(rights)
    solve_each(np.ascontiguousarray(matrices), np.ascontiguousarray(rights), found)
    return found


@pytest.mark.parametrize("size", [2, 3, 4, 6])
def test_regular_systems(size: int) -> None:
    random = np.random.default_rng(size)
    matrices, expected = random.normal(size=(size, size, 200)), random.normal(size=(size, 200))
    rights = np.einsum("pqi,qi->pi", matrices, expected)
    spreads = np.linalg.cond(np.moveaxis(matrices, 2, 0))
    errors = np.abs(solved(matrices, rights) - expected).max(axis=0)
    assert np.all(errors <= 1e-14 * spreads)


@pytest.mark.parametrize("rank", [0, 1, 2])
def test_a_singular_system_is_solved_if_it_can_be(rank: int) -> None:
    random = np.random.default_rng(rank)
    matrix = random.normal(size=(3, rank)) @ random.normal(size=(rank, 3))
    right = matrix @ random.normal(size=3)
    found = solved(matrix[..., None], right[:, None])[:, 0]
    np.testing.assert_allclose(matrix @ found, right, atol=1e-13)
    assert np.count_nonzero(found) == rank


def test_one_singular_system_leaves_the_others_alone() -> None:
    matrices = np.stack([np.eye(2), np.ones((2, 2)), 2.0 * np.eye(2)], axis=-1)
    found = solved(matrices, np.ones((2, 3)))
    np.testing.assert_array_equal(found[:, [0, 2]], [[1.0, 0.5], [1.0, 0.5]])
