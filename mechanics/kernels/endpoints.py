"""Where paths end, in one frame; what each end is, by how near it is to others and conjugates."""

import math

import numpy as np

from mechanics.arrays import Booleans, Complexes, Floats, Integers
from mechanics.kernels.compiling import kernel
from mechanics.kernels.path_steps import ARRIVED, AT_INFINITY, LOST, SINGULAR
from mechanics.kernels.quadrics import FIRST, FRAME_SIGNS, SECOND, SWAPPED, TWICE

INFINITE = 1e-7
"""A solution of this |h| / |e|^2 or less is no pose."""

TWIN_INFINITE = 1e-5
"""Ends that fell together are no pose if |h| / |e|^2 is not above this: those are multiple."""

NEARLY_REAL = 3e-3
"""How far from real an end may be that is tried as a real mode; Newton's method decides."""


@kernel
def write_off(points: Floats, outcomes: Integers) -> None:
    """Make lost paths of those whose ends are no numbers."""
    for k in range(outcomes.size):
        if not np.isfinite(points[k]).all():
            points[k], outcomes[k] = 0.0, LOST


@kernel
def from_frames(points: Floats, frames: Integers) -> Complexes:
    """Return solutions e, of length 1, S3 and D3, shape (paths, 6), of points in their frames.

    Parameters
    ----------
    points : array, shape (paths, 10): e1, e2, e3, S3, D3, e0 being 1.
    frames : array, shape (paths,).
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
            solutions[k, n ^ frame] = share * FRAME_SIGNS[frame, n] * x[n]
        for n in range(4, 6):
            solutions[k, 9 - n if SWAPPED[frame] else n] = share * share * x[n]
    return solutions


@kernel
def classify(
    solutions: Complexes, outcomes: Integers, tolerance: float, final: bool
) -> tuple[Booleans, Booleans, Booleans, Booleans]:
    """Return which ends are doubtful, which multiple, which real and which nearly real.

    See `mechanics.assembly.endpoints.Endpoints`.
    """
    found = np.empty((4, outcomes.size), np.bool_)
    doubtful, multiple, real, nearly_real = found[0], found[1], found[2], found[3]
    own, partner, twin = nearest(solutions, outcomes == ARRIVED, tolerance)
    for k in range(outcomes.size):
        outcome, size, simple = outcomes[k], abs(e_times_e(solutions[k])), outcomes[k] == ARRIVED
        together, alone = simple and twin[k] < tolerance, simple and partner[k] >= tolerance
        infinite = outcome == AT_INFINITY or size < INFINITE
        infinite = infinite or (final and together and size < TWIN_INFINITE)
        # Where h = 0, too, one of two may have jumped, and a real mode be without its path.
        doubt = (together and not final) or ((together or alone) and not infinite)
        doubtful[k] = outcome == LOST or doubt
        multiple[k] = outcome == SINGULAR and not infinite
        real[k] = simple and own[k] < tolerance and not infinite
        nearly_real[k] = outcome != LOST and own[k] < NEARLY_REAL and not infinite
    # Other solutions come in pairs, and so must these; else a path to one has ended elsewhere.
    if np.count_nonzero(real) % 2 == 1 and not np.any(multiple & nearly_real):
        doubtful |= ~real
    return doubtful, multiple, real, nearly_real


@kernel
def e_times_e(solution: Complexes) -> complex:
    """Return h = e.e of a solution."""
    h = 0.0j
    for n in range(4):
        h += solution[n] * solution[n]
    return h


@kernel
def real_parts(solutions: Complexes, chosen: Booleans) -> Floats:
    """Return chosen solutions, turned so that e is as real as can be, without the rest."""
    parts = np.empty((np.count_nonzero(chosen), 6))
    row = 0
    for k in range(chosen.size):
        if chosen[k]:
            h = e_times_e(solutions[k])
            phase = np.conj(np.sqrt(h / abs(h)))
            for n in range(6):
                parts[row, n] = (solutions[k, n] * (phase if n < 4 else phase * phase)).real
            row += 1
    return parts


@kernel
def nearest(solutions: Complexes, simple: Booleans, reach: float) -> tuple[Floats, Floats, Floats]:
    """Return how far each solution is from its conjugate, from others', and from others.

    Of others only the simple ones count, and those within reach; 2 where there is none. What is
    compared are the products of e and S3, D3, which share one factor, as lines: distances are
    those of unit vectors.
    """
    count = simple.size
    lines, marks = unit_lines(solutions)
    own, partner, twin = np.empty(count), np.full(count, 2.0), np.full(count, 2.0)
    for k in range(count):
        own[k] = apart(lines[k], lines[k], -1.0)
        if simple[k]:
            partner[k] = own[k]
        for j in range(count):
            # Marks differ by no more than twice what lines or conjugates do.
            if simple[j] and j != k and abs(marks[j] - marks[k]) <= 2.0 * reach:
                partner[k] = min(partner[k], apart(lines[k], lines[j], -1.0))
                twin[k] = min(twin[k], apart(lines[k], lines[j], 1.0))
    return own, partner, twin


@kernel
def apart(a: Complexes, b: Complexes, sign: float) -> float:
    """Return how far apart the lines of two unit vectors are, or with -1 a and b's conjugate."""
    real, imaginary = 0.0, 0.0
    for n in range(12):
        real += a[n].real * b[n].real + sign * a[n].imag * b[n].imag
        imaginary += a[n].real * b[n].imag - sign * a[n].imag * b[n].real
    return math.sqrt(max(2.0 - 2.0 * math.hypot(real, imaginary), 0.0))


@kernel
def unit_lines(solutions: Complexes) -> tuple[Complexes, Floats]:
    """Return what `nearest` compares, shape (solutions, 12), and a mark of each.

    A mark is an average of the squares, alike for all vectors of a line and for its conjugate.
    """
    lines, marks = np.empty((solutions.shape[0], 12), np.complex128), np.zeros(solutions.shape[0])
    for k in range(marks.size):
        for n in range(10):
            lines[k, n] = TWICE[n] * solutions[k, FIRST[n]] * solutions[k, SECOND[n]]
        lines[k, 10], lines[k, 11] = solutions[k, 4], solutions[k, 5]
        square = 0.0
        for n in range(12):
            own = lines[k, n].real ** 2 + lines[k, n].imag ** 2
            square += own
            marks[k] += n / 11.0 * own
        marks[k] /= square
        share = 1.0 / math.sqrt(square)
        for n in range(12):
            lines[k, n] *= share
    return lines, marks
