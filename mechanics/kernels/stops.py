"""The stops of drives: where they stand at one, and whether they stand within both."""

import numpy as np

from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import (
    Numbers,
    Vector,
    crank_angle,
    crank_equation,
    crank_turn,
    rail_coordinate,
    strut_length,
)
from mechanics.kernels.waves import TURN
from mechanics.legs import CRANK, RAIL


@inlined
def elbow(leg: Numbers, cosine: float, sine: float) -> Vector:
    """Return B - A of a crank that stands at this angle. [m]"""
    e, f = leg.zero_direction, leg.quarter_direction
    c, s = leg.crank_length * cosine, leg.crank_length * sine
    return e[0] * c + f[0] * s, e[1] * c + f[1] * s, e[2] * c + f[2] * s


@kernel
def within_stops(drive: int, leg: Numbers, d: Vector) -> bool:
    """Return whether a drive, a crank in some turn, stands within its stops; all else does not."""
    if drive == RAIL:
        q = rail_coordinate(leg, d[0], d[1], d[2])
    elif drive == CRANK:
        P, Q, S, root = crank_equation(leg, d[0], d[1], d[2])
        cosine, sine = crank_turn(P, Q, S, root, leg.working_mode)
        q = crank_angle(cosine, sine)
        # As `conditions.actuator_limits` does it, to the last bit.
        middle = 0.5 * (leg.lower_limit + leg.upper_limit)
        q += TURN * np.rint((middle - q) / TURN)
    else:
        q = strut_length(d[0], d[1], d[2])
    return bool(q >= leg.lower_limit and q <= leg.upper_limit)
