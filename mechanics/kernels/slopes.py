"""How far worst efforts change near a pose: to the first order exactly, a bound on all the rest.

While d moves by dd, u moves by (I - q u^T) dd / L to the first order, q = B' / (u . B'), for a
strut u. With v_kj = v_k(t_j) and w_j the turning of t_j (see `neighbourhoods`) this makes
F_kj = g_kj . dp + (rho_k x (g_kj + u_k x w_j)) . dw, g_kj = (v_kj - u_k (v_kj . q_k)) / L_k. What
|du| is off is half of |u''| |dd|^2 at most, on a straight way of unit speed. There, c the least
cos t, |u'| <= 1 / (L c) and |psi'| <= 1 / (r c); u . B' psi'' = L |u'|^2 - u . B'' psi'^2, so
|psi''| <= k / (r c^3) and |u''| <= (k / c^3 + 1 / (r c^2)) / L, for a rail without the last. For a
strut |u''| <= (4/3)^(1/2) / L^2, L the least length. (I + F)^-1 - I is -F but for
(I - N)^-1 - I - N. A size is convex: it falls by no more than its slope says, and rises by no more
than half the square of what is added beside, |a + b| <= |a| + a . b / |a| + |b|^2 / (2 |a|).
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel
from mechanics.legs import CRANK, STRUT, Legs

LANES = 64
"""Poses worked on together, in scratch arrays that stay in the nearest cache."""
TINY = 1e-300
"""No size of a column that has any is so small."""
STRUT_CURL = 0.5775
"""No less than half the root of 4/3."""


@kernel
def curls(
    legs: Legs,
    spans: Floats,
    travel: Floats,
    directions: Floats,
    shifts: Floats,
    swerves: Floats,
    least_rates: Floats,
    ways: Floats,
    inverses: Floats,
    left: Floats,
) -> None:
    """Write q, shape (legs, 3, poses), 1 / L and what du is off its first order, (legs, poses).

    Parameters
    ----------
    swerves : array, shape (legs, poses): how far dd is off its first order. [m]
    least_rates : array, shape (legs, poses): |Jpsi| at least, anywhere near. [m or -]
    """
    for k in range(legs.drive.size):
        crank, a, e = legs.drive[k] == CRANK, legs.axis[k], legs.zero_direction[k]
        f, rod, lever = legs.quarter_direction[k], legs.rod_length[k], 1.0
        bend, turn = 1.0 / rod, 0.0
        if crank:
            lever = legs.crank_length[k]
            turn = 1.0 / lever
            bend += turn
        for i in range(shifts.shape[1]):
            u, v, w = directions[k, 0, i], directions[k, 1, i], directions[k, 2, i]
            shift = shifts[k, i]
            if legs.drive[k] == STRUT:
                x, y, z = spans[k, 0, i], spans[k, 1, i], spans[k, 2, i]
                length = math.sqrt(x * x + y * y + z * z)
                ways[k, 0, i], ways[k, 1, i], ways[k, 2, i] = u, v, w
                inverses[k, i] = 1.0 / length
                near = shift / max(length - shift, 0.0)
                left[k, i] = STRUT_CURL * near * near + swerves[k, i] / length
            else:
                x, y, z = a[0], a[1], a[2]
                if crank:
                    c, s = travel[k, 0, i], travel[k, 1, i]
                    x, y, z = f[0] * c - e[0] * s, f[1] * c - e[1] * s, f[2] * c - e[2] * s
                along = u * x + v * y + w * z
                ways[k, 0, i], ways[k, 1, i], ways[k, 2, i] = x / along, y / along, z / along
                inverses[k, i] = 1.0 / rod
                cosine = least_rates[k, i] / lever
                curl = 0.5 * shift * shift * (bend / cosine + turn) / (cosine * cosine * rod)
                left[k, i] = curl + swerves[k, i] / (rod * cosine)


@kernel
def slopes(
    twists: Floats,
    columns: Floats,
    arms: Floats,
    directions: Floats,
    ways: Floats,
    inverses: Floats,
    left: Floats,
    turned: Floats,
    arm_turns: Floats,
    reach: Floats,
    blurs: Floats,
    mixing: Floats,
    load: tuple[float, float],
    own: Floats,
    known: Floats,
    changes: Floats,
) -> None:
    """Write how far sizes F |a| + M |b| of the columns of Jx^-1 may fall and rise, known loads too.

    Parameters
    ----------
    reach : array, shape (2, poses): positions and turns. [m, rad]
    load : F and M. [N, N m]
    own, known : arrays, shape (drives, poses): sizes with the known load's share, and that alone.
    changes : array, shape (2, drives, poses): how far they fall and rise at most.
    """
    count, total = columns.shape[0], blurs.size
    t, norms, sums = np.empty((6, 6, LANES)), np.empty((2, 6, LANES)), np.empty((9, LANES))
    share = np.empty(LANES)
    for first in range(0, total, LANES):
        lanes = min(LANES, total - first)
        for j in range(count):
            _twist(twists, columns, j, first, lanes, t, norms)
        for j in range(count):
            for row in range(9):
                for i in range(LANES):
                    sums[row, i] = 0.0
            for k in range(count):
                _weigh(load, t, norms, j, k, lanes, share)
                _lean(arms, directions, ways, inverses, t, share, j, k, first, lanes, sums)
                _leave(
                    arms,
                    left,
                    turned,
                    arm_turns,
                    reach,
                    blurs,
                    mixing,
                    own,
                    known,
                    t,
                    norms,
                    j,
                    k,
                    first,
                    lanes,
                    sums,
                )
            _sum_up(reach, load, norms, sums, j, first, lanes, changes)


@inlined
def _twist(
    twists: Floats, columns: Floats, j: int, first: int, lanes: int, t: Floats, norms: Floats
) -> None:
    """Write a column of Jx^-1 as a twist, and the sizes of its velocity and of its turning."""
    for row in range(6):
        for i in range(lanes):
            t[j, row, i] = 0.0
        for c in range(twists.shape[1]):
            unit = twists[row, c]
            if unit != 0.0:
                for i in range(lanes):
                    t[j, row, i] += unit * columns[j, c, first + i]
    for part in range(2):
        for i in range(lanes):
            x, y, z = t[j, 3 * part, i], t[j, 3 * part + 1, i], t[j, 3 * part + 2, i]
            norms[part, j, i] = math.sqrt(x * x + y * y + z * z)


@inlined
def _weigh(
    load: tuple[float, float],
    t: Floats,
    norms: Floats,
    j: int,
    k: int,
    lanes: int,
    share: Floats,
) -> None:
    """Write how much of column k adds to the size of column j, to the first order."""
    for i in range(lanes):
        force = t[j, 0, i] * t[k, 0, i] + t[j, 1, i] * t[k, 1, i] + t[j, 2, i] * t[k, 2, i]
        moment = t[j, 3, i] * t[k, 3, i] + t[j, 4, i] * t[k, 4, i] + t[j, 5, i] * t[k, 5, i]
        share[i] = load[0] * force / max(norms[0, j, i], TINY)
        share[i] += load[1] * moment / max(norms[1, j, i], TINY)


@inlined
def _lean(
    arms: Floats,
    directions: Floats,
    ways: Floats,
    inverses: Floats,
    t: Floats,
    share: Floats,
    j: int,
    k: int,
    first: int,
    lanes: int,
    sums: Floats,
) -> None:
    """Add what column k brings in along with dp and dw, to the first order."""
    for i in range(lanes):
        at = first + i
        rx, ry, rz = arms[k, 0, at], arms[k, 1, at], arms[k, 2, at]
        ux, uy, uz = directions[k, 0, at], directions[k, 1, at], directions[k, 2, at]
        bx, by, bz = t[j, 3, i], t[j, 4, i], t[j, 5, i]
        x = t[j, 0, i] + by * rz - bz * ry
        y = t[j, 1, i] + bz * rx - bx * rz
        z = t[j, 2, i] + bx * ry - by * rx
        across = x * ways[k, 0, at] + y * ways[k, 1, at] + z * ways[k, 2, at]
        scale = inverses[k, at]
        x, y, z = scale * (x - ux * across), scale * (y - uy * across), scale * (z - uz * across)
        sums[0, i] += share[i] * x
        sums[1, i] += share[i] * y
        sums[2, i] += share[i] * z
        x, y, z = x + uy * bz - uz * by, y + uz * bx - ux * bz, z + ux * by - uy * bx
        sums[3, i] += share[i] * (ry * z - rz * y)
        sums[4, i] += share[i] * (rz * x - rx * z)
        sums[5, i] += share[i] * (rx * y - ry * x)


@inlined
def _leave(
    arms: Floats,
    left: Floats,
    turned: Floats,
    arm_turns: Floats,
    reach: Floats,
    blurs: Floats,
    mixing: Floats,
    own: Floats,
    known: Floats,
    t: Floats,
    norms: Floats,
    j: int,
    k: int,
    first: int,
    lanes: int,
    sums: Floats,
) -> None:
    """Add what column k brings in beyond the first order, and of known loads altogether."""
    along = 1.0 if k == j else 0.0
    for i in range(lanes):
        at = first + i
        rx, ry, rz = arms[k, 0, at], arms[k, 1, at], arms[k, 2, at]
        x = t[j, 0, i] + t[j, 4, i] * rz - t[j, 5, i] * ry
        y = t[j, 1, i] + t[j, 5, i] * rx - t[j, 3, i] * rz
        z = t[j, 2, i] + t[j, 3, i] * ry - t[j, 4, i] * rx
        square, angle = x * x + y * y + z * z, turned[k, at]
        turning = norms[1, j, i] * arm_turns[k, at]
        straight = angle * math.sqrt(max(square - along, 0.0)) + turning
        linear = straight + 0.5 * along * angle * angle
        beyond = left[k, at] * math.sqrt(square) + turning * (angle + 0.5 * reach[1, at])
        beyond += mixing[k, j, at] - linear + blurs[at] * linear
        sums[6, i] += own[k, at] * beyond + known[k, at] * linear
        sums[7, i] += norms[0, k, i] * straight
        sums[8, i] += norms[1, k, i] * straight


@inlined
def _sum_up(
    reach: Floats,
    load: tuple[float, float],
    norms: Floats,
    sums: Floats,
    j: int,
    first: int,
    lanes: int,
    changes: Floats,
) -> None:
    """Write how far column j's size falls and rises; it is convex: it rises by squares too."""
    for i in range(lanes):
        at = first + i
        x, y, z = sums[0, i], sums[1, i], sums[2, i]
        change = sums[6, i] + reach[0, at] * math.sqrt(x * x + y * y + z * z)
        x, y, z = sums[3, i], sums[4, i], sums[5, i]
        change += reach[1, at] * math.sqrt(x * x + y * y + z * z)
        force, moment = load[0] * sums[7, i] * sums[7, i], load[1] * sums[8, i] * sums[8, i]
        squares = force / max(norms[0, j, i], TINY) + moment / max(norms[1, j, i], TINY)
        changes[0, j, at] = change
        changes[1, j, at] = change + 0.5 * squares
