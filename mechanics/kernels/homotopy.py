"""Forty solutions followed from one platform, which has them all, to another.

The coefficients of the equations go from the start's to the target's, theta(t) = (1 - t) theta0 +
t theta1, and the solutions go along. The start is complex, so that no path meets another before
t = 1. Paths are followed eight at a time, as `path_steps` makes the steps; a lane takes the next
path as soon as its own is through. Each lane scales its quaternions to e0 = 1 in a frame of its
own, turned by one of the units 1, i, j, k so that e0 is not small.
"""

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import fused, spliced
from mechanics.kernels.path_steps import (
    FORMER,
    GUESS,
    LANES,
    NORM,
    OUTCOME,
    POINTS,
    ROWS,
    RUNNING,
    START,
    TARGET,
    Pace,
    correct,
    decide,
    predict,
    put,
    remember,
)
from mechanics.kernels.platform_equations import COEFFICIENTS, at
from mechanics.kernels.rows import square

FAR_PAST = 1e15
"""So long before the first point that its velocity alone counts."""

FRAME_LIMIT = 6.0
"""|e|^2 / |e0|^2 above which a lane turns its frame."""


@fused
def track(
    start: Floats,
    target: Floats,
    points: Floats,
    frames: Integers,
    chosen: Integers,
    pace: Pace,
    ends: Floats,
    end_frames: Integers,
    outcomes: Integers,
) -> int:
    """Follow the chosen paths and write where they end; return how many steps that took.

    Parameters
    ----------
    start : array, shape (4, 120), real and imaginary parts of the coefficients in each frame.
    target : array, shape (4, 60).
    points : array, shape (paths, 10), solutions of the start, each in its frame.
    frames : array, shape (paths,), 0 to 3.
    chosen : array, the paths to follow.
    ends, end_frames : arrays like `points` and `frames`, for the chosen ones.
    outcomes : array, shape (paths,), what became of each of them.
    """
    w = np.zeros((ROWS, LANES))
    path, frame = np.full(LANES, -1), np.zeros(LANES, np.int64)
    taken, busy, steps = 0, chosen.size, 0
    for lane in range(LANES):
        path[lane], frame[lane] = begin(w, lane, start, target, points, frames, chosen, taken)
        taken += 1
    while busy > 0:
        steps += 1
        predict(w)
        for _ in range(pace.corrections):
            correct(w)
        decide(w, pace)
        remember(w)
        for lane in range(LANES):
            k = path[lane]
            if w[OUTCOME, lane] != RUNNING:
                if k >= 0:
                    finish(w, lane, ends[k])
                    end_frames[k], outcomes[k] = frame[lane], int(w[OUTCOME, lane])
                    busy -= 1
                path[lane], frame[lane] = begin(
                    w, lane, start, target, points, frames, chosen, taken
                )
                taken += 1
            elif w[NORM, lane] > FRAME_LIMIT:
                turn = largest(w, lane)
                if turn != 0:
                    frame[lane] ^= turn
                    turn_points(w, lane, turn)
                    load(w, lane, start, target, frame[lane])
    return steps


@spliced
def load(w: Floats, lane: int, start: Floats, target: Floats, frame: int) -> None:
    """Give a lane the coefficients in a frame."""
    for n in range(2 * COEFFICIENTS):
        w[START + n, lane] = start[frame, n]
    for n in range(COEFFICIENTS):
        w[TARGET + n, lane] = target[frame, n]


@spliced
def begin(
    w: Floats,
    lane: int,
    start: Floats,
    target: Floats,
    points: Floats,
    frames: Integers,
    chosen: Integers,
    taken: int,
) -> tuple[int, int]:
    """Put a lane at the start of the next path; return which that is, and its frame.

    When none is left, -1: the lane runs along with the last one again, though nobody looks. Left
    where it ended, its imaginary parts would shrink to numbers that processors are slow with.
    """
    k = chosen[min(taken, chosen.size - 1)]
    load(w, lane, start, target, frames[k])
    for n in range(POINTS, ROWS):
        w[n, lane] = 0.0
    for n in range(10):
        w[POINTS + n, lane] = points[k, n]
    w[FORMER, lane] = FAR_PAST
    w[FORMER + 1, lane] = FAR_PAST * FAR_PAST
    return (k if taken < chosen.size else -1), frames[k]


@spliced
def finish(w: Floats, lane: int, end: Floats) -> None:
    """Write where a lane's path ended."""
    for n in range(10):
        end[n] = w[GUESS + n, lane]


@spliced
def largest(w: Floats, lane: int) -> int:
    """Return which number of a lane's quaternion is the largest."""
    k, most = 0, 1.0
    for n in range(3):
        size = square(at(w, POINTS + 2 * n, lane))
        if size > most:
            k, most = n + 1, size
    return k


@spliced
def turn_points(w: Floats, lane: int, turn: int) -> None:
    """Write a lane's points and velocities in the frame turned by a unit, i, j or k (1, 2, 3).

    e i = (-e1, e0, e3, -e2) and so on: number n goes to place n xor `turn`. Scaled to e0 = 1
    again, and S, D by its square. Turning about i flips two axes of Q, where S and D change
    places; about i and j that concerns S3 and D3.
    """
    for first in range(POINTS, POINTS + 60, 20):
        x, v = np.ones(6, np.complex128), np.zeros(6, np.complex128)
        for n in range(5):
            x[n + 1], v[n + 1] = at(w, first + 2 * n, lane), at(w, first + 10 + 2 * n, lane)
        pole, rate = 1.0 / x[turn], v[turn]
        for n in range(1, 4):
            m = n ^ turn
            sign = 1.0 if (n - turn) % 3 == 2 else -1.0
            put(w, first + 2 * n - 2, lane, sign * pole * x[m])
            put(w, first + 2 * n + 8, lane, sign * pole * (v[m] - x[m] * pole * rate))
        for n in range(4, 6):
            m = 9 - n if turn != 3 else n
            put(w, first + 2 * n - 2, lane, pole * pole * x[m])
            put(w, first + 2 * n + 8, lane, pole * pole * (v[m] - 2.0 * x[m] * pole * rate))
