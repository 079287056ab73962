"""The angles at which trigonometric polynomials vanish, all of them at once."""

from math import comb

import numpy as np
import numpy.typing as npt

from mechanics.arrays import Floats

SAMPLES = 16
"""Values per turn by which a polynomial is given: more than twice any degree here."""

ANGLES: Floats = 2.0 * np.pi * np.arange(SAMPLES) / SAMPLES
"""Where the values are taken. [rad]"""

_ASIDE = 0.05
"""Roots within this of being real are proposed: a triple root splits into such. [rad]"""


def zeros(values: Floats, degree: int) -> Floats:
    """Return the angles near which real trigonometric polynomials vanish. [rad]

    With t = tan((phi - phi0) / 2) a polynomial of degree d in cos and sin is one of degree 2 d
    in t, whose roots are the eigenvalues of its companion matrix. Its leading coefficient is the
    value at phi0 + pi, which is chosen where that is greatest: nothing is lost at infinity.

    Parameters
    ----------
    values : array, shape (rows, SAMPLES), at `ANGLES`; no row all zero.
    degree : of the polynomials, at most.

    Returns
    -------
    array, shape (rows, 2 degree)
        NaN for roots that are far from real. A double root that rounding made a complex pair
        gives two angles, to either side.
    """
    largest = np.argmax(np.abs(values), axis=1)
    phi0 = ANGLES[largest] - np.pi
    roots = np.linalg.eigvals(_companions(_in_half_tangents(values, phi0, degree)))
    with np.errstate(divide="ignore", invalid="ignore"):
        turns = np.log((1.0 + 1j * roots) / (1.0 - 1j * roots))
    aside = -turns.real
    angles: Floats = phi0[:, None] + turns.imag + aside
    return np.where(np.abs(aside) <= _ASIDE, angles, np.nan)


def _in_half_tangents(values: Floats, phi0: Floats, degree: int) -> Floats:
    """Return coefficients of t^0 ... t^2d of (1 + t^2)^d times each polynomial."""
    orders = np.arange(degree + 1)
    waves = np.fft.rfft(values, axis=1)[:, : degree + 1] / values.shape[1]
    waves[:, 1:] *= 2.0
    shifted = waves * np.exp(1j * phi0[:, None] * orders)
    powers = np.array([_wave(degree, order) for order in range(degree + 1)])
    # Not a matrix product, whose rounding depends on how many rows there are.
    coefficients: Floats = np.sum(shifted[:, :, None] * powers, axis=1).real
    return coefficients


def _wave(degree: int, order: int) -> npt.NDArray[np.complex128]:
    """Return the coefficients in t of (1 + t^2)^d e^(i k phi) = (1 + i t)^(d+k) (1 - i t)^(d-k)."""
    ahead = np.array([comb(degree + order, j) * 1j**j for j in range(degree + order + 1)])
    behind = np.array([comb(degree - order, j) * (-1j) ** j for j in range(degree - order + 1)])
    return np.convolve(ahead, behind)


def _companions(coefficients: Floats) -> Floats:
    """Return companion matrices, shape (rows, n, n), of polynomials given from t^0 up to t^n."""
    rows, size = coefficients.shape[0], coefficients.shape[1] - 1
    matrices = np.zeros((rows, size, size))
    matrices[:, 0] = -coefficients[:, -2::-1] / coefficients[:, -1:]
    matrices[:, np.arange(1, size), np.arange(size - 1)] = 1.0
    return matrices
