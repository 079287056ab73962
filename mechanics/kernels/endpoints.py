"""Where paths end, in one frame, and how near each end is to the others and their conjugates."""

import math

import numpy as np

from mechanics.arrays import Booleans, Complexes, Floats, Integers
from mechanics.kernels.compiling import kernel


@kernel
def from_frames(points: Floats, frames: Integers, signs: Floats) -> Complexes:
    """Return solutions e, of length 1, S3 and D3, shape (paths, 6), of points in their frames.

    Parameters
    ----------
    points : array, shape (paths, 10): e1, e2, e3, S3, D3, e0 being 1.
    frames : array, shape (paths,).
    signs : array, shape (4, 4): with e = e' i in frame 1, and so on, number n of e' is number
        n ^ 1 of e, with this sign.
    """
    solutions = np.empty((frames.size, 6), np.complex128)
    x = np.empty(6, np.complex128)
    for k in range(frames.size):
        x[0], square, frame = 1.0, 1.0, frames[k]
        for n in range(5):
            x[n + 1] = complex(points[k, 2 * n], points[k, 2 * n + 1])
        for n in range(6):
            square += points[k, n] * points[k, n]
        share = 1.0 / math.sqrt(square)
        for n in range(4):
            solutions[k, n ^ frame] = share * signs[frame, n] * x[n]
        swapped = frame == 1 or frame == 2
        for n in range(4, 6):
            solutions[k, 9 - n if swapped else n] = share * share * x[n]
    return solutions


@kernel
def nearest(solutions: Complexes, simple: Booleans) -> tuple[Floats, Floats, Floats]:
    """Return how far each solution is from its conjugate, from others', and from others.

    Of others only the simple ones count. What is compared are the products of e and S3, D3,
    which share one factor, as lines: distances are those of unit vectors.
    """
    count = simple.size
    real, imaginary = unit_lines(solutions)
    own, partner, twin = np.empty(count), np.full(count, 2.0), np.full(count, 2.0)
    sums = np.empty((4, count))
    for k in range(count):
        sums[:] = 0.0
        for n in range(12):
            a, b = real[n, k], imaginary[n, k]
            for j in range(count):
                sums[0, j] += a * real[n, j]
                sums[1, j] += b * imaginary[n, j]
                sums[2, j] += a * imaginary[n, j]
                sums[3, j] += b * real[n, j]
        for j in range(count):
            p, q, r, s = sums[0, j], sums[1, j], sums[2, j], sums[3, j]
            near = apart((p - q) ** 2 + (r + s) ** 2)
            if j == k:
                own[k] = near
            if simple[j]:
                partner[k] = min(partner[k], near)
                if j != k:
                    twin[k] = min(twin[k], apart((p + q) ** 2 + (r - s) ** 2))
    return own, partner, twin


@kernel
def apart(square: float) -> float:
    """Return how far apart two lines are, from the square of their unit vectors' product."""
    return math.sqrt(max(2.0 - 2.0 * math.sqrt(square), 0.0))


@kernel
def unit_lines(solutions: Complexes) -> tuple[Floats, Floats]:
    """Return real and imaginary parts, shape (12, solutions), of what `nearest` compares."""
    count = solutions.shape[0]
    real, imaginary = np.empty((12, count)), np.empty((12, count))
    line = np.empty(12, np.complex128)
    for k in range(count):
        n, square = 0, 0.0
        for i in range(4):
            for j in range(i, 4):
                factor = 1.0 if i == j else 2.0
                line[n] = factor * solutions[k, i] * solutions[k, j]
                n += 1
        line[10], line[11] = solutions[k, 4], solutions[k, 5]
        for n in range(12):
            square += line[n].real ** 2 + line[n].imag ** 2
        share = 1.0 / math.sqrt(square)
        for n in range(12):
            real[n, k], imaginary[n, k] = share * line[n].real, share * line[n].imag
    return real, imaginary
