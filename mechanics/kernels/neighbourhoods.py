"""How far what is known of a pose may be off at all poses near it: bounds, not estimates.

A leg's platform joint moves by at most `shift`. While d moves by dd, the rod turns by
du = (I - B' u^T / u B') dd / L, so |du| <= |dd| / (L cos t) with t the tilt, the angle between the
rod and the way that B goes; a crank's angle changes by |dd| / (r cos t) at most, a rail's
coordinate by |dd| / cos t. The tilt itself obeys |d sin t| <= k |dd|, k = 1/L + 1/r for a crank
and 1/L for a rail. Along the straight way from the centre this integrates: sin t grows from m to
no more than m + k shift, and |dd| / cos t to no more than A / k in all, where
A = asin(m + k shift) - asin(m). As long as m + k shift < 1, cos t keeps its sign, and so the leg
its working mode. A strut turns by asin(shift / |d|) at most: the same with m = 0, k = 1 / |d|.

Columns of J^-1 are twists t_j with u_k . v_k(t_j) = 1 if k = j, else 0, where v_k is the velocity
of joint k. Elsewhere Jx is (I + F) Jx at the centre, F_kj = du_k . v_k(t_j) + u_k . (w_j x drho_k).
With |F| <= N number by number (I + F)^-1 = I + X, |X| <= (I - N)^-1 - I, if the spectral radius of
N is below 1, which is so if and only if Gauss' elimination of I - N meets positive pivots only.
As |tr F^m| <= tr N^m for all m, |det (I + F)| is between det (I - N) and its inverse.
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.legs import CRANK, STRUT, Legs

LANES = 64
"""Poses worked on together, in scratch arrays that stay in the nearest cache."""

STEEPEST = 1.0 - 1e-6
"""No bound is given on a leg that comes nearer than this sine to stretched, folded or no length."""


@kernel
def swings(
    legs: Legs,
    spans: Floats,
    travel: Floats,
    directions: Floats,
    shifts: Floats,
    turned: Floats,
    strokes: Floats,
    rates: Floats,
) -> None:
    """Write how far rods turn and drives move, shape (legs, poses) each, and |Jpsi| at its ends.

    Parameters
    ----------
    spans, directions : arrays, shape (legs, 3, poses): d and u. [m, -]
    travel : cosines and sines of cranks, shape (legs, 2, poses).
    shifts : array, shape (legs, poses): how far the platform joints move at most. [m]
    turned : angles between the rods' directions; infinite where there is no bound. [rad]
    strokes : changes of the drives' coordinates. [rad or m]
    rates : array, shape (2, legs, poses), at least and at most. [m or -]
    """
    for k in range(legs.drive.size):
        if legs.drive[k] == STRUT:
            for i in range(shifts.shape[1]):
                x, y, z = spans[k, 0, i], spans[k, 1, i], spans[k, 2, i]
                length = math.sqrt(x * x + y * y + z * z)
                turned[k, i], _ = grown_angle(0.0, shifts[k, i] / length)
                strokes[k, i] = shifts[k, i]
                rates[0, k, i], rates[1, k, i] = 1.0, 1.0
        else:
            rod, lever = legs.rod_length[k], 1.0
            bend = 1.0 / rod
            if legs.drive[k] == CRANK:
                lever = legs.crank_length[k]
                bend += 1.0 / lever
            for i in range(shifts.shape[1]):
                sine, change = _tilt(legs, k, travel, directions, i), bend * shifts[k, i]
                grown, cosine = grown_angle(sine, change)
                near = sine - change if sine > change else 0.0
                turned[k, i] = grown / (bend * rod)
                strokes[k, i] = grown / (bend * lever)
                rates[0, k, i] = lever * cosine
                rates[1, k, i] = lever * math.sqrt(1.0 - near * near)


@kernel
def grown_angle(sine: float, change: float) -> tuple[float, float]:
    """Return no less than asin(sine + change) - asin(sine), and the greater angle's cosine. [rad]

    The slope of the arc sine is convex, so the trapezoid bounds its integral from above.
    """
    top = sine + change
    cosine = math.sqrt((1.0 - top) * (1.0 + top)) if top < STEEPEST else 0.0
    return 0.5 * change * (1.0 / cosine + 1.0 / math.sqrt((1.0 - sine) * (1.0 + sine))), cosine


@inlined
def _tilt(legs: Legs, k: int, travel: Floats, directions: Floats, i: int) -> float:
    """Return the sine of the angle between a rod and the way that its moving point goes."""
    u, v, w = directions[k, 0, i], directions[k, 1, i], directions[k, 2, i]
    a, e, f = legs.axis[k], legs.zero_direction[k], legs.quarter_direction[k]
    if legs.drive[k] == CRANK:
        c, s = travel[k, 0, i], travel[k, 1, i]
        x, y, z = f[0] * c - e[0] * s, f[1] * c - e[1] * s, f[2] * c - e[2] * s
    else:
        x, y, z = a[0], a[1], a[2]
    p, q, r = v * z - w * y, w * x - u * z, u * y - v * x
    return math.sqrt(p * p + q * q + r * r)


@kernel
def add_others(own: Floats, mixing: Floats, others: Floats) -> None:
    """Write what other columns bring into each, shape (drives, poses), of numbers of their own."""
    for j in range(own.shape[0]):
        for i in range(own.shape[1]):
            others[j, i] = 0.0
        for k in range(own.shape[0]):
            for i in range(own.shape[1]):
                others[j, i] += own[k, i] * mixing[k, j, i]


@kernel
def mixings(
    twists: Floats,
    columns: Floats,
    arms: Floats,
    turned: Floats,
    turns: Floats,
    blurs: Floats,
    speeds: Floats,
    mixing: Floats,
    kept: Floats,
) -> None:
    """Write how the columns of J^-1 may mix, and what is left of |det Jx| at least, as a share.

    Parameters
    ----------
    columns : array, shape (drives, coordinates, poses): the columns of Jx^-1 at the centres.
    arms : array, shape (drives, 3, poses): rho. [m]
    turned : array, shape (drives, poses): how far the rods turn at most. [rad]
    turns : array, shape (drives, poses): how far the arms' ends turn at most. [m]
    blurs : array, shape (poses,): what rounding may have made of all this, as a share.
    speeds : array, shape (2, drives, poses): |v_k(t_k)| at the centres, and anywhere near at most.
    mixing : array, shape (drives, drives, poses): everywhere near, column j is that at the centre
        plus each column k times at most [k, j]; it means nothing where nothing is kept.
    kept : array, shape (poses,): 0 where there is no bound.
    """
    size, total = columns.shape[0], kept.size
    bounds, velocities = np.empty((6, 6, LANES)), np.empty((6, 6, LANES))
    spins, t = np.empty((6, LANES)), np.empty((6, LANES))
    factors, share = np.empty(LANES), np.empty(LANES)
    for first in range(0, total, LANES):
        lanes = min(LANES, total - first)
        for j in range(size):
            _twist(twists, columns, j, first, lanes, t, spins)
            for k in range(size):
                _velocity(arms, j, k, first, lanes, t, velocities)
                _change(turned, turns, blurs, j, k, first, lanes, velocities, spins, bounds)
        _invert(size, bounds, factors, share)
        for k in range(size):
            _fastest(size, turns, velocities, spins, bounds, k, first, lanes, speeds)
            for j in range(size):
                for i in range(lanes):
                    mixing[k, j, first + i] = bounds[k, j, i] - (1.0 if k == j else 0.0)
        for i in range(lanes):
            kept[first + i] = share[i]


@inlined
def _twist(
    twists: Floats, columns: Floats, j: int, first: int, lanes: int, t: Floats, spins: Floats
) -> None:
    """Write a column of J^-1 as a twist, shape (6, lanes), and the size of its turning."""
    for row in range(6):
        for i in range(LANES):
            t[row, i] = 0.0
        for c in range(twists.shape[1]):
            unit = twists[row, c]
            if unit != 0.0:
                for i in range(lanes):
                    t[row, i] += unit * columns[j, c, first + i]
    for i in range(LANES):
        spins[j, i] = math.sqrt(t[3, i] * t[3, i] + t[4, i] * t[4, i] + t[5, i] * t[5, i])


@inlined
def _velocity(
    arms: Floats, j: int, k: int, first: int, lanes: int, t: Floats, velocities: Floats
) -> None:
    """Write |v_k(t_j)|, of joint k where all drives but j are braked."""
    for i in range(lanes):
        rx, ry, rz = arms[k, 0, first + i], arms[k, 1, first + i], arms[k, 2, first + i]
        x = t[0, i] + t[4, i] * rz - t[5, i] * ry
        y = t[1, i] + t[5, i] * rx - t[3, i] * rz
        z = t[2, i] + t[3, i] * ry - t[4, i] * rx
        velocities[k, j, i] = math.sqrt(x * x + y * y + z * z)


@inlined
def _change(
    turned: Floats,
    turns: Floats,
    blurs: Floats,
    j: int,
    k: int,
    first: int,
    lanes: int,
    velocities: Floats,
    spins: Floats,
    bounds: Floats,
) -> None:
    """Write I - N, number by number.

    Of v_k(t_k) the part along the rod is 1, and meets 1 - cos of the angle that the rod turns;
    all of the other v_k(t_j) is across the rod, and meets the sine.
    """
    along = 1.0 if k == j else 0.0
    for i in range(lanes):
        angle, speed, blur = turned[k, first + i], velocities[k, j, i], blurs[first + i]
        change = angle * math.sqrt(max(speed * speed - along, 0.0))
        change += 0.5 * along * angle * angle + spins[j, i] * turns[k, first + i]
        bounds[k, j, i] = along - (change * (1.0 + blur) + blur)


@inlined
def _fastest(
    size: int,
    turns: Floats,
    velocities: Floats,
    spins: Floats,
    inverse: Floats,
    k: int,
    first: int,
    lanes: int,
    speeds: Floats,
) -> None:
    """Write |v_k(t_k)| at the centres, and what it may be anywhere near."""
    for i in range(lanes):
        speed, spin = 0.0, 0.0
        for j in range(size):
            speed += velocities[k, j, i] * inverse[j, k, i]
            spin += spins[j, i] * inverse[j, k, i]
        speeds[0, k, first + i] = velocities[k, k, i]
        speeds[1, k, first + i] = speed + spin * turns[k, first + i]


@inlined
def _invert(size: int, a: Floats, factors: Floats, share: Floats) -> None:
    """Invert matrices I - N in place, one a lane, after Gauss and Jordan; write det (I - N).

    Pivots that are positive need no exchange; where one is not, 0 is written.
    """
    for i in range(LANES):
        share[i] = 1.0
    for p in range(size):
        for i in range(LANES):
            pivot = a[p, p, i]
            share[i] = share[i] * pivot if pivot > 0.0 else 0.0
            factors[i] = 1.0 / pivot
            a[p, p, i] = 1.0
        for j in range(size):
            for i in range(LANES):
                a[p, j, i] *= factors[i]
        for r in range(size):
            if r != p:
                _eliminate(size, a, p, r, factors)


@inlined
def _eliminate(size: int, a: Floats, p: int, r: int, factors: Floats) -> None:
    """Take row p from row r so often that nothing is left in column p."""
    for i in range(LANES):
        factors[i] = a[r, p, i]
        a[r, p, i] = 0.0
    for j in range(size):
        for i in range(LANES):
            a[r, j, i] -= factors[i] * a[p, j, i]
