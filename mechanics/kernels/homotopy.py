"""Forty solutions followed from one platform, which has them all, to another.

The coefficients of the equations go from the start's to the target's, theta(t) = (1 - t) theta0 +
t theta1, and the solutions go along. The start is complex, so that no path meets another before
t = 1. Paths are followed eight at a time, one in each lane; a lane takes the next path as soon as
its own is through. Each lane scales its quaternions to e0 = 1 in a frame of its own, turned by one
of the units 1, i, j, k so that e0 is not small.

Everything lies in one array of eight lanes' rows, where the compiler sees that rows do not
overlap: it then makes of each loop over the lanes one pass of vector code.
"""

import math
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import fused, spliced
from mechanics.kernels.platform_equations import COEFFICIENTS, at, newton_step
from mechanics.kernels.rows import Five, square

LANES = 8

# Rows of the array. A complex number takes two rows, a point of five unknowns ten.
START = 0
TARGET = START + 2 * COEFFICIENTS
POINTS = TARGET + COEFFICIENTS
"""The last three points and their velocities: point, velocity, former, its velocity, ..."""
GUESS = POINTS + 60
VELOCITY = GUESS + 10
TIME = VELOCITY + 10
STEP = TIME + 1
FORMER = STEP + 1
"""How long before the last point the former one lay, and the one before it."""
ERRORS = FORMER + 2
"""Squares of the two Newton steps, the last one first."""
SIZE = ERRORS + 2
SPEED = SIZE + 1
NORM = SPEED + 1
COUNT = NORM + 1
POLISHED = COUNT + 1
OUTCOME = POLISHED + 1
WEIGHTS = OUTCOME + 1
ROWS = WEIGHTS + 6

RUNNING, ARRIVED, SINGULAR, AT_INFINITY, LOST = 0, 1, 2, 3, 4
"""What becomes of a path: it ends in a root, a multiple one, where h = 0, or nowhere."""

FAR_PAST = 1e15
"""So long before the first point that its velocity alone counts."""

EXACT = 1e-20
"""The square of a Newton step with which a path has arrived."""

FRAME_LIMIT = 6.0
"""|e|^2 / |e0|^2 above which a lane turns its frame."""


class Pace(NamedTuple):
    """How large the steps are; the first Newton step is what is steered.

    A step counts if its first Newton step stays below `widest` and the second below
    `contraction` times the first. The next one is to have a first Newton step of
    `aim` / (second / first^2), but at most `most`.
    """

    widest: float
    contraction: float
    aim: float
    most: float
    start: float
    longest: float
    growth: float
    least: float
    patience: float


SWIFT = Pace(0.08, 0.08, 0.015, 0.02, 0.1, 0.3, 2.0, 1e-9, 120.0)
CAREFUL = Pace(0.01, 0.01, 0.001, 0.001, 0.02, 0.1, 1.6, 1e-11, 300.0)


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
        for _ in range(2):
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
def predict(w: Floats) -> None:
    """Guess each lane's next point by the quintic through three points and velocities."""
    for i in range(LANES):
        h, a, b = w[STEP, i], w[FORMER, i], w[FORMER + 1, i]
        f, g, k = 1.0 / a, 1.0 / b, 1.0 / (b - a)
        # Lagrange's polynomials for the times 0, -a, -b, at h.
        p, q, r = (h + a) * (h + b) * f * g, -(h * (h + b)) * f * k, h * (h + a) * g * k
        w[WEIGHTS, i] = (1.0 - 2.0 * (f + g) * h) * p * p
        w[WEIGHTS + 1, i] = h * p * p
        w[WEIGHTS + 2, i] = (1.0 - 2.0 * (k - f) * (h + a)) * q * q
        w[WEIGHTS + 3, i] = (h + a) * q * q
        w[WEIGHTS + 4, i] = (1.0 + 2.0 * (g + k) * (h + b)) * r * r
        w[WEIGHTS + 5, i] = (h + b) * r * r
    for n in range(10):
        for i in range(LANES):
            total = 0.0
            for k in range(6):
                total += w[WEIGHTS + k, i] * w[POINTS + 10 * k + n, i]
            w[GUESS + n, i] = total


@spliced
def point(w: Floats, first: int, i: int) -> Five:
    """Return the five complex numbers from row `first` on."""
    return (
        at(w, first, i),
        at(w, first + 2, i),
        at(w, first + 4, i),
        at(w, first + 6, i),
        at(w, first + 8, i),
    )


@spliced
def put(w: Floats, row: int, i: int, z: complex) -> None:
    """Write one complex number."""
    w[row, i], w[row + 1, i] = z.real, z.imag


@spliced
def measure(d: Five, norm: float) -> float:
    """Return the square of a change of the point, e measured against |e| and S3, D3 |e|^2."""
    share = 1.0 / norm
    turn = square(d[0]) + square(d[1]) + square(d[2])
    return share * (turn + share * (square(d[3]) + square(d[4])))


@spliced
def correct(w: Floats) -> None:
    """Improve each lane's guess by one Newton step, and note the path's velocity there."""
    for i in range(LANES):
        x = point(w, GUESS, i)
        d, v = newton_step(w, START, TARGET, i, x, w[TIME, i] + w[STEP, i])
        norm = 1.0 + (square(x[0]) + square(x[1]) + square(x[2]))
        h = 1.0 + (x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
        put(w, GUESS, i, x[0] - d[0])
        put(w, GUESS + 2, i, x[1] - d[1])
        put(w, GUESS + 4, i, x[2] - d[2])
        put(w, GUESS + 6, i, x[3] - d[3])
        put(w, GUESS + 8, i, x[4] - d[4])
        put(w, VELOCITY, i, -v[0])
        put(w, VELOCITY + 2, i, -v[1])
        put(w, VELOCITY + 4, i, -v[2])
        put(w, VELOCITY + 6, i, -v[3])
        put(w, VELOCITY + 8, i, -v[4])
        w[ERRORS + 1, i] = w[ERRORS, i]
        w[ERRORS, i] = measure(d, norm) + 1e-34
        w[SPEED, i] = measure(v, norm)
        w[NORM, i] = norm
        w[SIZE, i] = square(h)


@spliced
def decide(w: Floats, pace: Pace) -> None:
    """Accept each lane's step or not, choose the next one, and say what became of the path."""
    for i in range(LANES):
        time, step = w[TIME, i], w[STEP, i]
        second, first = w[ERRORS, i], w[ERRORS + 1, i]
        resting, ending = step == 0.0, time == 1.0
        near = second < max(pace.contraction**2 * first, EXACT)
        near &= first < pace.widest**2
        good = resting | near
        # A step's error grows with its sixth power; what counts is left of it after Newton.
        aim = min(pace.aim * first / math.sqrt(second), pace.most)
        eighth = math.sqrt(math.sqrt(math.sqrt(aim / math.sqrt(first))))
        factor = min(max(eighth * math.sqrt(eighth), 0.4), pace.growth)
        next_step = pace.start / math.sqrt(w[SPEED, i]) if resting else step * factor
        next_step = min(next_step if good else 0.45 * step, pace.longest)
        time = time + step if good else time
        rest = 1.0 - time
        next_step = rest if 1.02 * next_step > rest else next_step
        over = rest <= 1e-10
        polished = w[POLISHED, i] + (1.0 if ending else 0.0)
        # At a real mode |h| is |e|^2: a path that comes so near h = 0 so late has none to reach.
        infinite = (rest < 0.01) & (w[SIZE, i] < 2.5e-3 * w[NORM, i] * w[NORM, i])
        stuck = (not good) & (next_step < pace.least)
        weary = infinite & (w[COUNT, i] > pace.patience)
        outcome = (AT_INFINITY if infinite else LOST) if stuck else RUNNING
        outcome = AT_INFINITY if weary else outcome
        outcome = SINGULAR if polished >= 6.0 else outcome
        outcome = ARRIVED if ending & (second < EXACT) else outcome
        moved = good & (not resting)
        w[FORMER + 1, i] = step + w[FORMER, i] if moved else w[FORMER + 1, i]
        w[FORMER, i] = step if moved else w[FORMER, i]
        w[TIME, i] = 1.0 if over else time
        w[STEP, i] = 0.0 if over else next_step
        w[POLISHED, i] = polished
        w[COUNT, i] += 1.0
        w[OUTCOME, i] = outcome
        w[WEIGHTS, i] = 1.0 if good else 0.0


@spliced
def remember(w: Floats) -> None:
    """Make the guess the last point of each lane whose step counts."""
    for n in range(10):
        for i in range(LANES):
            good = w[WEIGHTS, i] > 0.5
            for k in range(5, 1, -1):
                row = POINTS + 10 * k + n
                w[row, i] = w[row - 20, i] if good else w[row, i]
            w[POINTS + n, i] = w[GUESS + n, i] if good else w[POINTS + n, i]
            w[POINTS + 10 + n, i] = w[VELOCITY + n, i] if good else w[POINTS + 10 + n, i]


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
