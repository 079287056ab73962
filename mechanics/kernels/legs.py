"""The leg equation |c - B|^2 = L^2, solved for the drive of every leg at every pose.

Arrays carry the poses on their last axis; vectors of a leg have shape (legs, 3, poses). Every
kernel writes into arrays that it is given, so that a driver can run a batch through scratch
arrays that stay in cache.
"""

import math
from typing import NamedTuple

from mechanics.arrays import Floats
from mechanics.kernels.arithmetic import multiply_add
from mechanics.kernels.compiling import inlined, kernel
from mechanics.legs import CRANK, RAIL, Legs

Vector = tuple[float, float, float]


class Numbers(NamedTuple):
    """The numbers of one leg, free of arrays: what the formulas take (see `mechanics.legs`)."""

    axis: Vector
    zero_direction: Vector
    quarter_direction: Vector
    base_point: Vector
    platform_point: Vector
    crank_length: float
    rod_length: float
    rod_scale: float
    working_mode: float
    lower_limit: float
    upper_limit: float


ROUNDING = 4.0 * 2.0**-52
"""A sum of squares is taken as 0 below this share of its terms."""


@inlined
def numbers(legs: Legs, k: int) -> Numbers:
    """Return the numbers of leg k."""
    return Numbers(
        (legs.axis[k, 0], legs.axis[k, 1], legs.axis[k, 2]),
        (legs.zero_direction[k, 0], legs.zero_direction[k, 1], legs.zero_direction[k, 2]),
        (legs.quarter_direction[k, 0], legs.quarter_direction[k, 1], legs.quarter_direction[k, 2]),
        (legs.base_point[k, 0], legs.base_point[k, 1], legs.base_point[k, 2]),
        (legs.platform_point[k, 0], legs.platform_point[k, 1], legs.platform_point[k, 2]),
        legs.crank_length[k],
        legs.rod_length[k],
        legs.rod_scale[k],
        legs.working_mode[k],
        legs.lower_limit[k],
        legs.upper_limit[k],
    )


@inlined
def turned(a: float, b: float, c: float, vector: Vector) -> float:
    """Return one coordinate of a turned vector: a row (a, b, c) of the rotation times it."""
    total: float = multiply_add(a, vector[0], multiply_add(b, vector[1], c * vector[2]))
    return total


@inlined
def arm(leg: Numbers, rotations: Floats, i: int) -> Vector:
    """Return rho = R c0 of one leg at pose i. [m]"""
    return (
        turned(rotations[0, i], rotations[1, i], rotations[2, i], leg.platform_point),
        turned(rotations[3, i], rotations[4, i], rotations[5, i], leg.platform_point),
        turned(rotations[6, i], rotations[7, i], rotations[8, i], leg.platform_point),
    )


@inlined
def span(leg: Numbers, p: Vector, rho: Vector) -> Vector:
    """Return d = p + rho - A of one leg. [m]"""
    A = leg.base_point
    return p[0] + rho[0] - A[0], p[1] + rho[1] - A[1], p[2] + rho[2] - A[2]


@kernel
def attach(legs: Legs, positions: Floats, rotations: Floats, arms: Floats, spans: Floats) -> None:
    """Write the arms rho = R c0 and the spans d = p + rho - A of every leg. [m]"""
    for k in range(legs.drive.size):
        leg = numbers(legs, k)
        for j in range(3):
            # One coordinate at a time: three plain streams, which the compiler vectorises.
            a, b, c = rotations[3 * j], rotations[3 * j + 1], rotations[3 * j + 2]
            position, rho, d = positions[j], arms[k, j], spans[k, j]
            base = legs.base_point[k, j]
            for i in range(position.size):
                rho[i] = turned(a[i], b[i], c[i], leg.platform_point)
                d[i] = position[i] + rho[i] - base


@kernel
def crank_equation(leg: Numbers, x: float, y: float, z: float) -> tuple[float, float, float, float]:
    """Return P, Q, S and the root of P^2 + Q^2 of P cos(psi) + Q sin(psi) = S. [m^2]"""
    e = leg.zero_direction
    f = leg.quarter_direction
    r = leg.crank_length
    L = leg.rod_length
    P = 2.0 * r * (x * e[0] + y * e[1] + z * e[2])
    Q = 2.0 * r * (x * f[0] + y * f[1] + z * f[2])
    square = x * x + y * y + z * z
    S = square + r * r - L * L
    # Rounding must not make a leg unreachable whose rod's end lies on the crank's axis.
    if abs(S) <= ROUNDING * (square + r * r + L * L):
        S = 0.0
    return P, Q, S, math.sqrt(P * P + Q * Q)


@kernel
def crank_turn(P: float, Q: float, S: float, root: float, sign: float) -> tuple[float, float]:
    """Return cos and sin of the crank angle atan2(Q, P) + sign acos(S / root); NaN: no reach.

    Without a trigonometric call: the solution's cosine and sine are rational in the root of
    (root - S)(root + S), written so because root^2 - S^2 would cancel where the leg stretches.
    """
    if root == 0.0:
        # The rod's end lies on the crank's axis: every angle solves the equation, or none.
        return (0.0, sign) if S == 0.0 else (math.nan, math.nan)
    w = sign * math.sqrt((root - S) * (root + S))
    H = root * root
    return (P * S - Q * w) / H, (Q * S + P * w) / H


@kernel
def rail_equation(leg: Numbers, x: float, y: float, z: float) -> tuple[float, float]:
    """Return d.s and L^2 less the squared distance of c from the rail; < 0: no reach. [m, m^2]"""
    s = leg.axis
    L = leg.rod_length
    along = x * s[0] + y * s[1] + z * s[2]
    u = x - along * s[0]
    v = y - along * s[1]
    w = z - along * s[2]
    return along, L * L - (u * u + v * v + w * w)


@kernel
def rail_coordinate(leg: Numbers, x: float, y: float, z: float) -> float:
    """Return d.s +- the root of what is left of the rod; NaN: no reach. [m]"""
    along, square = rail_equation(leg, x, y, z)
    reached: float = along + leg.working_mode * math.sqrt(square)
    return reached


@kernel
def strut_length(x: float, y: float, z: float) -> float:
    """Return |d|. [m]"""
    return math.sqrt(x * x + y * y + z * z)


@kernel
def crank_angle(cosine: float, sine: float) -> float:
    """Return the angle of this cosine and sine, in (-pi, pi]. [rad]"""
    angle: float = math.atan2(sine, cosine)
    return math.pi if angle == -math.pi else angle


@kernel
def reach_margins(legs: Legs, spans: Floats, margins: Floats) -> None:
    """Write, shape (legs, poses), by how much each leg equation is solvable; < 0: not. [m^2]"""
    for k in range(legs.drive.size):
        leg = numbers(legs, k)
        x, y, z = spans[k, 0], spans[k, 1], spans[k, 2]
        margin = margins[k]
        if legs.drive[k] == CRANK:
            for i in range(x.size):
                _, _, S, root = crank_equation(leg, x[i], y[i], z[i])
                margin[i] = root - abs(S)
        elif legs.drive[k] == RAIL:
            for i in range(x.size):
                margin[i] = rail_equation(leg, x[i], y[i], z[i])[1]
        else:
            for i in range(x.size):
                square = x[i] * x[i] + y[i] * y[i] + z[i] * z[i]
                # A strut of no length has no direction.
                margin[i] = square if square > 0.0 else -math.inf


@kernel
def needed_rods(legs: Legs, spans: Floats, rods: Floats) -> None:
    """Write, shape (legs, poses), the rod nearest in length to the leg's that would reach. [m]"""
    for k in range(legs.drive.size):
        a = legs.axis[k]
        r = legs.crank_length[k]
        L = legs.rod_length[k]
        for i in range(spans.shape[2]):
            x, y, z = spans[k, 0, i], spans[k, 1, i], spans[k, 2, i]
            height = x * a[0] + y * a[1] + z * a[2]
            u = x - height * a[0]
            v = y - height * a[1]
            w = z - height * a[2]
            radius = math.sqrt(u * u + v * v + w * w)
            if legs.drive[k] == CRANK:
                near = math.sqrt((radius - r) ** 2 + height * height)
                far = math.sqrt((radius + r) ** 2 + height * height)
                rods[k, i] = min(max(L, near), far)
            elif legs.drive[k] == RAIL:
                rods[k, i] = max(L, radius)
            else:
                rods[k, i] = math.sqrt(x * x + y * y + z * z)


@kernel
def travels(legs: Legs, spans: Floats, travel: Floats) -> None:
    """Write how far the drives have moved, shape (legs, 2, poses); NaN: out of reach.

    Cosine and sine of a crank's angle; a rail's or strut's coordinate and nothing. [-, m]
    """
    for k in range(legs.drive.size):
        leg = numbers(legs, k)
        x, y, z = spans[k, 0], spans[k, 1], spans[k, 2]
        first, second = travel[k, 0], travel[k, 1]
        if legs.drive[k] == CRANK:
            for i in range(x.size):
                P, Q, S, root = crank_equation(leg, x[i], y[i], z[i])
                first[i], second[i] = crank_turn(P, Q, S, root, leg.working_mode)
        elif legs.drive[k] == RAIL:
            for i in range(x.size):
                first[i] = rail_coordinate(leg, x[i], y[i], z[i])
        else:
            for i in range(x.size):
                first[i] = strut_length(x[i], y[i], z[i])


@kernel
def coordinates(legs: Legs, travel: Floats, values: Floats) -> None:
    """Write the drive coordinates, shape (legs, poses); crank angles in (-pi, pi]. [rad or m]"""
    for k in range(legs.drive.size):
        first, second, value = travel[k, 0], travel[k, 1], values[k]
        if legs.drive[k] == CRANK:
            for i in range(first.size):
                value[i] = crank_angle(first[i], second[i])
        else:
            for i in range(first.size):
                value[i] = first[i]


@kernel
def crank_rod(
    leg: Numbers, d: Vector, cosine: float, sine: float
) -> tuple[float, float, float, float]:
    """Return u = (d - B) / L and Jpsi = u B' of a crank. [-, m]"""
    e, f = leg.zero_direction, leg.quarter_direction
    c, s = leg.crank_length * cosine, leg.crank_length * sine
    share = 1.0 / leg.rod_scale
    u = (d[0] - (e[0] * c + f[0] * s)) * share
    v = (d[1] - (e[1] * c + f[1] * s)) * share
    w = (d[2] - (e[2] * c + f[2] * s)) * share
    rate = u * (f[0] * c - e[0] * s) + v * (f[1] * c - e[1] * s) + w * (f[2] * c - e[2] * s)
    return u, v, w, rate


@kernel
def rail_rod(leg: Numbers, d: Vector, q: float) -> tuple[float, float, float, float]:
    """Return u = (d - q s) / L and Jpsi = u s of a rail. [-, -]"""
    s = leg.axis
    share = 1.0 / leg.rod_scale
    u = (d[0] - q * s[0]) * share
    v = (d[1] - q * s[1]) * share
    w = (d[2] - q * s[2]) * share
    return u, v, w, u * s[0] + v * s[1] + w * s[2]


@kernel
def strut_rod(d: Vector, length: float) -> tuple[float, float, float, float]:
    """Return u = d / |d| and Jpsi = 1 of a strut; NaN where it has no length. [-, -]"""
    share = 1.0 / length if length > 0.0 else math.nan
    return d[0] * share, d[1] * share, d[2] * share, 1.0


@kernel
def rods(
    legs: Legs, spans: Floats, travel: Floats, directions: Floats, drive_rates: Floats
) -> None:
    """Write rod directions u = (c - B) / L, shape (legs, 3, poses), and Jpsi = u B'. [-, m or -]

    Jpsi, shape (legs, poses), is in m for a crank and a number for rails and struts.
    """
    for k in range(legs.drive.size):
        leg = numbers(legs, k)
        x, y, z = spans[k, 0], spans[k, 1], spans[k, 2]
        first, second = travel[k, 0], travel[k, 1]
        u, v, w = directions[k, 0], directions[k, 1], directions[k, 2]
        rate = drive_rates[k]
        if legs.drive[k] == CRANK:
            for i in range(x.size):
                d = x[i], y[i], z[i]
                u[i], v[i], w[i], rate[i] = crank_rod(leg, d, first[i], second[i])
        elif legs.drive[k] == RAIL:
            for i in range(x.size):
                d = x[i], y[i], z[i]
                u[i], v[i], w[i], rate[i] = rail_rod(leg, d, first[i])
        else:
            for i in range(x.size):
                u[i], v[i], w[i], rate[i] = strut_rod((x[i], y[i], z[i]), first[i])
