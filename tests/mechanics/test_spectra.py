"""Condition numbers, against NumPy's singular values."""

import numpy as np
import pytest

from mechanics.arrays import Floats
from mechanics.kernels.spectra import LANES, condition_numbers

SIZES = pytest.mark.parametrize("size", [2, 3, 4, 6])


def found(matrices: Floats, scales: Floats | None = None) -> Floats:
    """Return the condition numbers of matrices, shape (n, n, poses)."""
    numbers = np.empty(matrices.shape[2])
    ones = np.ones(matrices.shape[0])
    condition_numbers(matrices, ones if scales is None else scales, numbers)
    return numbers


def made(size: int, count: int, least: float, seed: int) -> tuple[Floats, Floats]:
    """Return matrices of known singular values, from 1 down to at most `least`."""
    random = np.random.default_rng(seed)
    left, right = (np.linalg.qr(random.normal(size=(count, size, size)))[0] for _ in range(2))
    values = least ** np.sort(random.uniform(0.0, 1.0, (count, size)), axis=1)
    values[:, 0] = 1.0
    matrices = np.einsum("nij,nj,njk->ikn", left, values, right)
    return np.ascontiguousarray(matrices), 1.0 / values[:, -1]


@SIZES
def test_condition_numbers_are_those_of_singular_values(size: int) -> None:
    matrices = np.random.default_rng(size).normal(size=(size, size, 1000))
    values = np.linalg.svd(np.moveaxis(matrices, 2, 0), compute_uv=False)
    expected = values[:, 0] / values[:, -1]
    # A condition number is known to itself times the rounding of the matrix.
    assert np.all(np.abs(found(matrices) / expected - 1.0) < 1e-14 * expected + 1e-13)


@SIZES
@pytest.mark.parametrize("least", [0.5, 1e-3, 1e-6])
def test_known_condition_numbers(size: int, least: float) -> None:
    matrices, expected = made(size, 500, least, size)
    assert np.all(np.abs(found(matrices) / expected - 1.0) < 1e-14 * expected + 1e-13)


@SIZES
def test_columns_are_divided_by_their_scales(size: int) -> None:
    random = np.random.default_rng(size)
    matrices, scales = random.normal(size=(size, size, 100)), random.uniform(0.1, 10.0, size)
    expected = found(matrices / scales[None, :, None])
    np.testing.assert_allclose(found(matrices, scales), expected, rtol=1e-12)


@SIZES
def test_a_pose_is_answered_alike_in_any_company(size: int) -> None:
    matrices, _ = made(size, 3 * LANES + 7, 1e-9, 5)
    together = found(matrices)
    for k in (0, 1, LANES - 1, LANES, 2 * LANES + 3, 3 * LANES + 6):
        assert found(np.ascontiguousarray(matrices[..., k : k + 1]))[0] == together[k]


@SIZES
def test_orthogonal_matrices_are_perfect(size: int) -> None:
    matrices, _ = made(size, 200, 1.0, 3)
    np.testing.assert_allclose(found(matrices), 1.0, rtol=1e-14)


@SIZES
def test_singular_matrices_are_hopeless(size: int) -> None:
    matrices = np.random.default_rng(2).normal(size=(size, size, 4))
    matrices[:, 0, 0] = 0.0
    matrices[:, 0, 1] = matrices[:, 1, 1]
    matrices[0, :, 2] = 3.0 * matrices[1, :, 2]
    matrices[..., 3] = 0.0
    assert np.all(found(matrices) > 1e14)


@SIZES
@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf])
def test_no_numbers_no_condition_number(size: int, wrong: float) -> None:
    matrices = np.random.default_rng(2).normal(size=(size, size, 3))
    matrices[size - 1, 0, 1] = wrong
    assert np.isnan(found(matrices)).tolist() == [False, True, False]
