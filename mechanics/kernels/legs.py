"""The leg equation |c - B|^2 = L^2, solved for the drive of every leg at every pose.

Arrays carry the poses on their last axis; vectors of a leg have shape (legs, 3, poses).
"""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import kernel
from mechanics.legs import Legs


@kernel
def attach(legs: Legs, positions: Floats, rotations: Floats) -> tuple[Floats, Floats]:
    """Return the arms rho = R c0 and the spans d = p + rho - A of every leg. [m]"""
    count = legs.rod_length.size
    poses = positions.shape[1]
    arms = np.empty((count, 3, poses))
    spans = np.empty((count, 3, poses))
    for k in range(count):
        for j in range(3):
            # One coordinate at a time: three plain streams, which the compiler vectorises.
            row = rotations[3 * j : 3 * j + 3]
            x, y, z = (
                legs.platform_point[k, 0],
                legs.platform_point[k, 1],
                legs.platform_point[k, 2],
            )
            base = legs.base_point[k, j]
            arm = arms[k, j]
            span = spans[k, j]
            for i in range(poses):
                arm[i] = row[0, i] * x + row[1, i] * y + row[2, i] * z
                span[i] = positions[j, i] + arm[i] - base
    return arms, spans


@kernel
def crank_equation(
    legs: Legs, k: int, x: float, y: float, z: float
) -> tuple[float, float, float, float]:
    """Return P, Q, S and the root of P^2 + Q^2 of P cos(psi) + Q sin(psi) = S. [m^2]"""
    e = legs.zero_direction[k]
    f = legs.quarter_direction[k]
    r = legs.crank_length[k]
    L = legs.rod_length[k]
    P = 2.0 * r * (x * e[0] + y * e[1] + z * e[2])
    Q = 2.0 * r * (x * f[0] + y * f[1] + z * f[2])
    S = x * x + y * y + z * z + r * r - L * L
    return P, Q, S, math.sqrt(P * P + Q * Q)


@kernel
def reach_margins(legs: Legs, spans: Floats) -> Floats:
    """Return, shape (legs, poses), by how much each leg equation is solvable; < 0: not. [m^2]"""
    count, _, poses = spans.shape
    margins = np.empty((count, poses))
    for k in range(count):
        for i in range(poses):
            _, _, S, root = crank_equation(legs, k, spans[k, 0, i], spans[k, 1, i], spans[k, 2, i])
            margins[k, i] = root - abs(S)
    return margins


@kernel
def needed_rods(legs: Legs, spans: Floats) -> Floats:
    """Return, shape (legs, poses), the rod nearest in length to the leg's that would reach. [m]"""
    count, _, poses = spans.shape
    rods = np.empty((count, poses))
    for k in range(count):
        a = legs.axis[k]
        r = legs.crank_length[k]
        for i in range(poses):
            x, y, z = spans[k, 0, i], spans[k, 1, i], spans[k, 2, i]
            height = x * a[0] + y * a[1] + z * a[2]
            radius = math.sqrt(max(x * x + y * y + z * z - height * height, 0.0))
            near = math.sqrt((radius - r) ** 2 + height * height)
            far = math.sqrt((radius + r) ** 2 + height * height)
            rods[k, i] = min(max(legs.rod_length[k], near), far)
    return rods


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
def cranks(legs: Legs, spans: Floats) -> tuple[Floats, Floats]:
    """Return cosines and sines, shape (legs, poses), of the crank angles; NaN: out of reach."""
    count, _, poses = spans.shape
    cosines = np.empty((count, poses))
    sines = np.empty((count, poses))
    for k in range(count):
        sign = legs.working_mode[k]
        for i in range(poses):
            P, Q, S, root = crank_equation(legs, k, spans[k, 0, i], spans[k, 1, i], spans[k, 2, i])
            cosines[k, i], sines[k, i] = crank_turn(P, Q, S, root, sign)
    return cosines, sines


@kernel
def angles(cosines: Floats, sines: Floats) -> Floats:
    """Return the angles of these cosines and sines, in (-pi, pi]. [rad]"""
    count, poses = cosines.shape
    turned = np.empty((count, poses))
    for k in range(count):
        for i in range(poses):
            angle = math.atan2(sines[k, i], cosines[k, i])
            turned[k, i] = math.pi if angle == -math.pi else angle
    return turned


@kernel
def rods(legs: Legs, spans: Floats, cosines: Floats, sines: Floats) -> tuple[Floats, Floats]:
    """Return the unit rod directions u = (c - B) / L, shape (legs, 3, poses), and Jpsi = u B'.

    Jpsi, shape (legs, poses), is in m for a crank.
    """
    count, _, poses = spans.shape
    directions = np.empty((count, 3, poses))
    drive_rates = np.empty((count, poses))
    for k in range(count):
        e = legs.zero_direction[k]
        f = legs.quarter_direction[k]
        r = legs.crank_length[k]
        L = legs.rod_length[k]
        for i in range(poses):
            c, s = cosines[k, i], sines[k, i]
            rate = 0.0
            for j in range(3):
                u = (spans[k, j, i] - r * (e[j] * c + f[j] * s)) / L
                directions[k, j, i] = u
                rate += u * r * (f[j] * c - e[j] * s)
            drive_rates[k, i] = rate
    return directions, drive_rates
