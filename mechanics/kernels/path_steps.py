"""One step along eight paths of solutions, one in each lane.

Everything lies in one array of eight lanes' rows, where the compiler sees that rows do not
overlap: it then makes of each loop over the lanes one pass of vector code. A step guesses by the
quintic through the last three points and their velocities and corrects twice by Newton's method;
the second correction tells the velocity too, which at an uncorrected point would be too far off.
"""

import math
from typing import NamedTuple

from mechanics.arrays import Floats
from mechanics.kernels.compiling import spliced
from mechanics.kernels.platform_equations import COEFFICIENTS, at, newton_step
from mechanics.kernels.rows import Five, Six, square

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
GOOD = OUTCOME + 1
ROWS = GOOD + 1

MOST_STEPS = 3000.0
"""A path of more steps creeps, however good they are, and is lost; most need a tenth of it."""
RUNNING, ARRIVED, SINGULAR, AT_INFINITY, LOST = 0, 1, 2, 3, 4
"""What becomes of a path: it ends in a root, a multiple one, where h = 0, or nowhere."""

EXACT = 1e-20
"""The square of a Newton step with which a path has arrived."""

OVER = 1e-10
"""No step is so short; what is left of a path is then none."""

SMALL, NOTHING = 2.5e-3, 1e-10
"""Squares of |h| / |e|^2, which is 1 at real modes, before and at the end of a path to h = 0."""

ROUGH = 1e-18
"""The square of a Newton step that may be rounding: near a multiple root there is as much."""


class Pace(NamedTuple):
    """How large the steps are; the first Newton step is what is steered.

    A step counts if its first Newton step stays below `widest` and the second below
    `contraction` times the first. The next one is to have a first Newton step of
    `aim` / (second / first^2), but at most `most`. There are always two `corrections`, but the
    compiler need not know: written out twice they would not fit the cache of instructions.
    """

    widest: float
    contraction: float
    aim: float
    most: float
    start: float
    longest: float
    growth: float
    least: float
    corrections: int = 2


SWIFT = Pace(0.08, 0.08, 0.015, 0.02, 0.1, 0.3, 2.0, 1e-9)
CAREFUL = Pace(0.01, 0.01, 0.001, 0.001, 0.02, 0.1, 1.6, 1e-11)


@spliced
def predict(w: Floats) -> None:
    """Guess each lane's next point by the quintic through three points and velocities."""
    for i in range(LANES):
        h, a, b = w[STEP, i], w[FORMER, i], w[FORMER + 1, i]
        f, g, k = 1.0 / a, 1.0 / b, 1.0 / (b - a)
        # Lagrange's polynomials for the times 0, -a, -b, at h.
        p, q, r = (h + a) * (h + b) * f * g, -(h * (h + b)) * f * k, h * (h + a) * g * k
        weights = (
            (1.0 - 2.0 * (f + g) * h) * p * p,
            h * p * p,
            (1.0 - 2.0 * (k - f) * (h + a)) * q * q,
            (h + a) * q * q,
            (1.0 + 2.0 * (g + k) * (h + b)) * r * r,
            (h + b) * r * r,
        )
        for n in range(10):
            w[GUESS + n, i] = weighed(w, POINTS + n, i, weights)


@spliced
def weighed(w: Floats, row: int, i: int, weights: Six) -> float:
    """Return the weighed sum of every tenth row, six of them from `row` on."""
    total: float = (
        weights[0] * w[row, i]
        + weights[1] * w[row + 10, i]
        + weights[2] * w[row + 20, i]
        + weights[3] * w[row + 30, i]
        + weights[4] * w[row + 40, i]
        + weights[5] * w[row + 50, i]
    )
    return total


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
        near = second < max(pace.contraction**2 * first, ROUGH)
        near &= first < pace.widest**2
        good = resting | near
        first_step = pace.start / math.sqrt(w[SPEED, i])
        next_step = first_step if resting else step * growth(first, second, pace)
        next_step = min(next_step if good else 0.45 * step, pace.longest)
        time = time + step if good else time
        rest = 1.0 - time
        next_step = rest if 1.02 * next_step > rest else next_step
        over = rest <= OVER
        w[COUNT, i] += 1.0
        w[POLISHED, i] += 1.0 if ending else 0.0
        stuck = (not good) & (next_step < pace.least)
        outcome = LOST if stuck | (w[COUNT, i] > MOST_STEPS) else RUNNING
        outcome = AT_INFINITY if (not good) & at_infinity(w, i, rest, stuck) else outcome
        outcome = SINGULAR if w[POLISHED, i] >= 6.0 else outcome
        w[OUTCOME, i] = ARRIVED if ending & (second < EXACT) else outcome
        moved = good & (not resting)
        w[FORMER + 1, i] = step + w[FORMER, i] if moved else w[FORMER + 1, i]
        w[FORMER, i] = step if moved else w[FORMER, i]
        w[TIME, i] = 1.0 if over else time
        w[STEP, i] = 0.0 if over else next_step
        w[GOOD, i] = 1.0 if good else 0.0


@spliced
def growth(first: float, second: float, pace: Pace) -> float:
    """Return by what the next step is longer, from the squares of both Newton steps.

    A step's error grows with its sixth power; this takes the 16/3rd root, out of square roots.
    Where the second is rounding it tells nothing of the path, which is then as straight as can be.
    """
    aim = min(pace.aim * first / math.sqrt(second), pace.most)
    aim = pace.most if second < ROUGH else aim
    eighth = math.sqrt(math.sqrt(math.sqrt(aim / math.sqrt(first))))
    return min(max(eighth * math.sqrt(eighth), 0.4), pace.growth)


@spliced
def at_infinity(w: Floats, i: int, rest: float, stuck: bool) -> bool:
    """Return whether a lane's path, whose step was refused, ends where h = 0: that is no pose.

    Where joints coincide many end so, in multiple roots, to which they come no nearer than rounding
    lets them: the last step, onto the root, would be refused again and again.
    """
    x = point(w, POINTS, i)
    norm = 1.0 + (square(x[0]) + square(x[1]) + square(x[2]))
    before = square(1.0 + (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]))
    leads = (rest < 0.01) & (before < SMALL * norm * norm)
    onto = (rest - w[STEP, i] <= OVER) & (w[SIZE, i] < NOTHING * w[NORM, i] * w[NORM, i])
    ends: bool = leads & (onto | stuck)
    return ends


@spliced
def remember(w: Floats) -> None:
    """Make the guess the last point of each lane whose step counts."""
    for i in range(LANES):
        good = w[GOOD, i] > 0.5
        for n in range(10):
            for k in range(5, 1, -1):
                row = POINTS + 10 * k + n
                w[row, i] = w[row - 20, i] if good else w[row, i]
            w[POINTS + n, i] = w[GUESS + n, i] if good else w[POINTS + n, i]
            w[POINTS + 10 + n, i] = w[VELOCITY + n, i] if good else w[POINTS + 10 + n, i]
