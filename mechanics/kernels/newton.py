"""Newton's method for a platform on six rods of given lengths, a guess a pose, many at a time.

|p + R b - a|^2 = L^2 for each rod. With d = p + R b - a and rho = R b a small motion (v, omega)
changes half the square by d.v + (rho x d).omega; the rotation that follows omega is Cayley's,
exactly a rotation however large the step. Eight poses go together, each until it stands still, so
that none depends on its company. All numbers lie in one array of lanes: see `homotopy`.
"""

import math

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.kernels.compiling import fused, spliced
from mechanics.kernels.rows import Row, solve_six

LANES = 8

Vector = tuple[float, float, float]

# Rows of the array of lanes.
POSITION = 0
ROTATION = 3
BASE = 12
PLATFORM = 30
LENGTHS = 48
SCALE = 54
MOVING = 55
ITERATIONS = 56
RESIDUAL = 57
ROWS = 58

STILL = 1e-18
"""The square of a step, relative to the rods, after which the next would be rounding."""

ROUNDING = 4.0 * 2.0**-52
"""Rods this exact, relative to their size, are not improved."""

SOLVED = 1e-12
"""Rods are of their lengths if they are to this, relative to their size."""


@fused
def solve_rods(
    base: Floats,
    platform: Floats,
    lengths: Floats,
    positions: Floats,
    rotations: Floats,
    trust: float,
    limit: int,
    iterations: Integers,
    residuals: Floats,
    converged: Booleans,
) -> None:
    """Write over guesses the poses to which they lead, and how they got there.

    Parameters
    ----------
    base : array, shape (6, 3, poses) or (6, 3, 1): the rods' fixed ends. [m]
    platform : array, shape (6, 3): their ends on the platform. [m]
    lengths : array, shape (6, poses) or (6, 1). [m]
    positions, rotations : arrays, shapes (3, poses) and (9, poses), guesses and answers. [m, -]
    trust : no step turns by more, nor moves by more times the rods' size. [rad]
    limit : how many steps are made at most.
    iterations : array, shape (poses,).
    residuals : array, shape (poses,): by how much the worst rod misses its length. [m]
    converged : array, shape (poses,): whether all rods have their lengths; where not, positions
        and rotations mean nothing.
    """
    w = np.zeros((ROWS, LANES))
    for k in range(18):
        for i in range(LANES):
            w[PLATFORM + k, i] = platform[k // 3, k % 3]
    total = residuals.size
    for first in range(0, total, LANES):
        take(w, first, base, lengths, positions, rotations)
        for _ in range(limit):
            advance(w, trust)
            moving = 0.0
            for i in range(LANES):
                moving += w[MOVING, i]
            if moving == 0.0:
                break
        judge(w)
        for i in range(min(LANES, total - first)):
            for k in range(3):
                positions[k, first + i] = w[POSITION + k, i]
            for k in range(9):
                rotations[k, first + i] = w[ROTATION + k, i]
            iterations[first + i] = int(w[ITERATIONS, i])
            residuals[first + i] = w[RESIDUAL, i]
            converged[first + i] = w[RESIDUAL, i] <= SOLVED * w[SCALE, i]


@spliced
def take(
    w: Floats, first: int, base: Floats, lengths: Floats, positions: Floats, rotations: Floats
) -> None:
    """Fill the lanes with the poses from `first` on, the last of them again if they are too few."""
    last, last_given = positions.shape[1] - 1, lengths.shape[1] - 1
    for i in range(LANES):
        n = min(first + i, last)
        given = min(n, last_given)
        square = 0.0
        for k in range(3):
            w[POSITION + k, i] = positions[k, n]
        for k in range(9):
            w[ROTATION + k, i] = rotations[k, n]
        for k in range(6):
            for j in range(3):
                w[BASE + 3 * k + j, i] = base[k, j, given]
            w[LENGTHS + k, i] = lengths[k, given]
            square += lengths[k, given] * lengths[k, given]
        w[SCALE, i] = math.sqrt(square / 6.0)
        w[MOVING, i] = 1.0
        w[ITERATIONS, i] = 0.0


@spliced
def vector(w: Floats, row: int, i: int) -> Vector:
    """Return three numbers."""
    return w[row, i], w[row + 1, i], w[row + 2, i]


@spliced
def dot(a: Vector, b: Vector) -> float:
    """Return a.b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@spliced
def rod(w: Floats, k: int, i: int) -> tuple[Vector, Vector]:
    """Return rho = R b and d = p + rho - a of rod k."""
    b = vector(w, PLATFORM + 3 * k, i)
    rho = (
        dot(vector(w, ROTATION, i), b),
        dot(vector(w, ROTATION + 3, i), b),
        dot(vector(w, ROTATION + 6, i), b),
    )
    p, a = vector(w, POSITION, i), vector(w, BASE + 3 * k, i)
    return rho, (p[0] + rho[0] - a[0], p[1] + rho[1] - a[1], p[2] + rho[2] - a[2])


@spliced
def equation(w: Floats, k: int, i: int) -> Row[float]:
    """Return d, rho x d, and what half the square of rod k lacks of half its length's."""
    rho, d = rod(w, k, i)
    return (
        d[0],
        d[1],
        d[2],
        rho[1] * d[2] - rho[2] * d[1],
        rho[2] * d[0] - rho[0] * d[2],
        rho[0] * d[1] - rho[1] * d[0],
        0.5 * (w[LENGTHS + k, i] * w[LENGTHS + k, i] - dot(d, d)),
    )


@spliced
def crossed(g: Vector, a: Vector, b: Vector, c: Vector) -> tuple[Vector, Vector, Vector]:
    """Return the rows of g x M, M being the matrix of the rows a, b, c."""
    return (
        (g[1] * c[0] - g[2] * b[0], g[1] * c[1] - g[2] * b[1], g[1] * c[2] - g[2] * b[2]),
        (g[2] * a[0] - g[0] * c[0], g[2] * a[1] - g[0] * c[1], g[2] * a[2] - g[0] * c[2]),
        (g[0] * b[0] - g[1] * a[0], g[0] * b[1] - g[1] * a[1], g[0] * b[2] - g[1] * a[2]),
    )


@spliced
def part(share: float, x: float, y: float, z: float) -> Vector:
    """Return share (x, y, z), and of nothing nothing, whatever x, y and z are."""
    some = share != 0.0
    return share * x if some else 0.0, share * y if some else 0.0, share * z if some else 0.0


@spliced
def shift(w: Floats, row: int, i: int, v: Vector) -> None:
    """Add v to three numbers."""
    w[row, i] += v[0]
    w[row + 1, i] += v[1]
    w[row + 2, i] += v[2]


@spliced
def turn(w: Floats, i: int, g: Vector) -> None:
    """Turn a lane's platform by Cayley's rotation, 2 atan |g| about g."""
    a, b, c = vector(w, ROTATION, i), vector(w, ROTATION + 3, i), vector(w, ROTATION + 6, i)
    d, e, f = crossed(g, a, b, c)
    s, t, u = crossed(g, d, e, f)
    share = 2.0 / (1.0 + dot(g, g))
    shift(w, ROTATION, i, part(share, d[0] + s[0], d[1] + s[1], d[2] + s[2]))
    shift(w, ROTATION + 3, i, part(share, e[0] + t[0], e[1] + t[1], e[2] + t[2]))
    shift(w, ROTATION + 6, i, part(share, f[0] + u[0], f[1] + u[1], f[2] + u[2]))


@spliced
def advance(w: Floats, trust: float) -> None:
    """Make one step in each lane that still moves."""
    for i in range(LANES):
        r, s, t = equation(w, 0, i), equation(w, 1, i), equation(w, 2, i)
        u, v, x = equation(w, 3, i), equation(w, 4, i), equation(w, 5, i)
        worst = max(max(abs(r[6]), abs(s[6])), max(abs(t[6]), abs(u[6])))
        worst = max(worst, max(abs(v[6]), abs(x[6])))
        step = solve_six(r, s, t, u, v, x)
        scale = w[SCALE, i]
        moved = math.sqrt(step[0] ** 2 + step[1] ** 2 + step[2] ** 2) / scale
        turned = math.sqrt(step[3] ** 2 + step[4] ** 2 + step[5] ** 2)
        moving = w[MOVING, i] if worst > ROUNDING * scale * scale else 0.0
        # Bounded apart: a small platform's turns, hardly known at first, must not stop its motion.
        share, half = moving * trust / max(moved, trust), 0.5 * moving * trust / max(turned, trust)
        shift(w, POSITION, i, part(share, step[0], step[1], step[2]))
        turn(w, i, part(half, step[3], step[4], step[5]))
        w[ITERATIONS, i] += w[MOVING, i]
        moves = (moving > 0.0) & (moved * moved + turned * turned > STILL)
        w[MOVING, i] = 1.0 if moves else 0.0


@spliced
def judge(w: Floats) -> None:
    """Write by how much the worst rod of each lane misses its length."""
    for i in range(LANES):
        worst = 0.0
        for k in range(6):
            _, d = rod(w, k, i)
            worst = max(worst, abs(math.sqrt(dot(d, d)) - w[LENGTHS + k, i]))
        w[RESIDUAL, i] = worst
