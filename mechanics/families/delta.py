"""The Delta family: parallelograms let the platform keep its orientation, or turn one way.

A parallelogram only takes turns away from the platform; it behaves as its middle rod.
"""

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import require_positive
from mechanics.families.circles import UP, outward
from mechanics.legs import BALL_JOINTS, CRANK, PARALLEL_JOINTS, RAIL, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import TRANSLATION, schoenflies


def translational_3rrrr(
    *, link_length: float, base_radius: float, limits: Floats, working_mode: Floats
) -> Mechanism:
    """Return a translational 3-RRRR: drive axes along x, y and z, all rods to one point.

    The axes pass through base_radius times (0, 1, 0), (0, 0, 1) and (1, 0, 0); a crank of
    angle 0 points along the axis after its own, x before y before z before x.

    Parameters
    ----------
    link_length : length of every crank and rod. [m]
    base_radius : distance of the drives from the origin. [m]
    limits, working_mode : arrays, shapes (3, 2) and (3,). [rad, -]

    References
    ----------
    Erastova, Laryushkin, 2017, doi:10.18698/0536-1044-2017-8-78-87, fig. 3.
    """
    require_positive(base_radius=base_radius)
    axes = np.eye(3)
    legs = [
        Leg(
            CRANK,
            base_radius * axes[(k + 1) % 3],
            np.zeros(3),
            axis=axes[k],
            zero_direction=axes[(k + 1) % 3],
            crank_length=link_length,
            rod_length=link_length,
            joints=PARALLEL_JOINTS,
            hinge=axes[k],
        )
        for k in range(3)
    ]
    return Mechanism(TRANSLATION, gather(legs, limits, working_mode))


def delta_rotary(
    *,
    base_radius: float,
    platform_radius: float,
    crank_length: float,
    rod_length: float,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return a Delta with cranks: base plane z = 0, legs at 90, 210 and 330 degrees.

    A crank of angle 0 points outward and turns upward; working mode +1 has the knees out.

    Parameters
    ----------
    base_radius, platform_radius : circles of the crank axes and of the platform's joints. [m]
    crank_length, rod_length : lengths of the links. [m]
    limits, working_mode : arrays, shapes (3, 2) and (3,). [rad, -]
    """
    require_positive(base_radius=base_radius, platform_radius=platform_radius)
    legs = [
        Leg(
            CRANK,
            base_radius * out,
            platform_radius * out,
            axis=np.cross(out, UP),
            zero_direction=out,
            crank_length=crank_length,
            rod_length=rod_length,
            joints=PARALLEL_JOINTS,
            hinge=np.cross(out, UP),
        )
        for out in outward()
    ]
    return Mechanism(TRANSLATION, gather(legs, limits, working_mode))


def delta_linear(
    *,
    rail_radius: float,
    platform_radius: float,
    rod_length: float,
    carriage_arm: float,
    tool_offset: float,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return a Delta with upright rails at 90, 210 and 330 degrees; drives are carriage heights.

    Parameters
    ----------
    rail_radius, platform_radius : circles of the rails and of the platform's joints. [m]
    rod_length : [m]
    carriage_arm : from a rail inward to the rod's joint on the carriage. [m]
    tool_offset : of the tool's point below the platform's joints. [m]
    limits, working_mode : arrays, shapes (3, 2) and (3,); +1: carriages above. [m, -]

    References
    ----------
    Laryushkin et al., 2019, doi:10.1134/S0235711919030106.
    """
    require_positive(rail_radius=rail_radius, platform_radius=platform_radius)
    legs = [
        _rail(
            (rail_radius - carriage_arm) * out,
            platform_radius * out + tool_offset * UP,
            rod_length,
            PARALLEL_JOINTS,
            np.cross(UP, out),
        )
        for out in outward()
    ]
    return Mechanism(TRANSLATION, gather(legs, limits, working_mode))


def delta_linear_4dof(
    *,
    rail_x: float,
    rail_y: float,
    carriage_arm: float,
    rod_length: float,
    platform_arm: float,
    rod_arm: float,
    rod_spacing: float,
    tool_offset: float,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return a Delta with two parallelograms and two rods, which also turns about y.

    Legs in order: parallelogram at (+rail_x, 0), rods at (+-rod_spacing/2, rail_y),
    parallelogram at (-rail_x, 0); all rails upright.

    Parameters
    ----------
    rail_x, rail_y : where the rails stand. [m]
    carriage_arm : from a rail inward to the rod's joint on the carriage. [m]
    rod_length : of parallelograms and rods. [m]
    platform_arm, rod_arm : from the tool's axis to the joints of parallelograms and rods. [m]
    rod_spacing : between the two rods. [m]
    tool_offset : of the tool's point below the platform's joints. [m]
    limits, working_mode : arrays, shapes (4, 2) and (4,). [m, -]

    References
    ----------
    Laryushkin et al., 2019, doi:10.1134/S0235711919030106, fig. 4.
    """
    require_positive(rail_x=rail_x, rail_y=rail_y, rod_spacing=rod_spacing)
    x, y = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    down = tool_offset * UP
    half = 0.5 * rod_spacing

    def parallelogram(side: float) -> Leg:
        base = side * (rail_x - carriage_arm) * x
        hinge = np.cross(UP, side * x)
        return _rail(base, side * platform_arm * x + down, rod_length, PARALLEL_JOINTS, hinge)

    def rod(side: float) -> Leg:
        base = side * half * x + (rail_y - carriage_arm) * y
        point = side * half * x + rod_arm * y + down
        return _rail(base, point, rod_length, BALL_JOINTS, np.cross(UP, y))

    legs = [parallelogram(1.0), rod(1.0), rod(-1.0), parallelogram(-1.0)]
    return Mechanism(schoenflies(y), gather(legs, limits, working_mode))


def _rail(base: Floats, platform: Floats, rod_length: float, joints: int, hinge: Floats) -> Leg:
    return Leg(RAIL, base, platform, axis=UP, rod_length=rod_length, joints=joints, hinge=hinge)
