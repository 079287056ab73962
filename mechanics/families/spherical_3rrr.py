"""The spherical 3-RRR: three legs of two arcs each; all axes meet in one point."""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.families.circles import UP, outward
from mechanics.legs import ARC_JOINTS, CRANK, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import SPHERICAL


def spherical_3rrr(
    *,
    proximal_arc: float,
    distal_arc: float,
    base_cone: float,
    platform_cone: float,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return a spherical 3-RRR whose axes stand 120 degrees apart on cones about z.

    Base and platform axes lie at 90, 210 and 330 degrees, the platform's in its own frame. A
    crank of angle 0 leads its arc away from +z and turns about its axis.

    An arc is a crank on the unit sphere: its end w = u cos(a1) + sin(a1)(e cos psi + f sin psi)
    keeps the chord sqrt(2 - 2 cos(a2)) to the platform's axis v, which says w.v = cos(a2).

    Parameters
    ----------
    proximal_arc, distal_arc : a1, from base to intermediate, a2, on to platform axis. [rad]
    base_cone, platform_cone : half-angles of the cones of the axes. [rad]
    limits, working_mode : arrays, shapes (3, 2) and (3,). [rad, -]

    Raises
    ------
    GeometryError : an arc is 0.
    """
    legs = [
        Leg(
            CRANK,
            math.cos(proximal_arc) * _on_cone(base_cone, out),
            _on_cone(platform_cone, out),
            axis=_on_cone(base_cone, out),
            zero_direction=math.cos(base_cone) * out - math.sin(base_cone) * UP,
            crank_length=math.sin(proximal_arc),
            rod_length=math.sqrt(2.0 - 2.0 * math.cos(distal_arc)),
            joints=ARC_JOINTS,
            unit_rods=False,
        )
        for out in outward()
    ]
    return Mechanism(SPHERICAL, gather(legs, limits, working_mode))


def _on_cone(half_angle: float, out: Floats) -> Floats:
    axis: Floats = math.sin(half_angle) * out + math.cos(half_angle) * UP
    return axis / np.linalg.norm(axis)
