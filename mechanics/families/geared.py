"""The geared decoupled mechanism: three rails move a wrist, three motors turn the platform."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import GeometryError, require_positive
from mechanics.families.circles import UP, outward
from mechanics.legs import PARALLEL_JOINTS, RAIL, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import SPATIAL
from mechanics.wrists import Wrist

_RAILS = 3
_PARALLEL = 1e-9


def geared_decoupled(
    *,
    rail_radius: float,
    platform_radius: float,
    carriage_arm: float,
    rod_length: float,
    tool_offset: float,
    gain: float,
    shared_gain: float,
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return the geared decoupled mechanism: upright rails at 90, 210 and 330 degrees, a wrist.

    Two universal joints on every rod keep what the rails carry from turning, so it moves as that
    of a Delta. Motors turn by D1 = k (rx - ry) + g rz, D2 = k (rx + ry) + g rz and D3 = rz; the
    first two through trains of gears alike, the third turns the wrist itself.

    Parameters
    ----------
    rail_radius, platform_radius : circles of the rails, and of the joints around the wrist's
        centre, which lies in their plane. [m]
    carriage_arm : from a rail inward to the rod's joint on the carriage. [m]
    rod_length : [m]
    tool_offset : from the wrist's centre to the tool's point, along the platform's x. [m]
    gain, shared_gain : k and g, turns of the motors for a turn of the platform.
    limits, working_mode : arrays, shapes (6, 2) and (6,): rails before motors; +1 takes the
        upper of a rail's two roots. [m, rad, -]

    Raises
    ------
    GeometryError : a radius is not positive, or all rods would be parallel.

    References
    ----------
    Glazunov et al., 2022, doi:10.31857/S0235711922020043.
    """
    require_positive(rail_radius=rail_radius, platform_radius=platform_radius)
    if abs(rail_radius - carriage_arm - platform_radius) < _PARALLEL * rail_radius:
        raise GeometryError(
            "rail_radius less carriage_arm must differ from platform_radius, or all rods are "
            f"parallel; given {rail_radius:g}, {carriage_arm:g} and {platform_radius:g} m"
        )
    tool = np.array([tool_offset, 0.0, 0.0])
    joints = platform_radius * outward()
    bases = (rail_radius - carriage_arm) * outward()
    # Joints that do not turn about the centre are as good as one in it, with the rails moved.
    legs = [
        Leg(
            RAIL,
            base - joint,
            -tool,
            axis=UP,
            rod_length=rod_length,
            joints=PARALLEL_JOINTS,
            hinge=np.cross(UP, out),
        )
        for base, joint, out in zip(bases, joints, outward(), strict=True)
    ]
    wrist = Wrist(
        np.array([[gain, -gain, shared_gain], [gain, gain, shared_gain], [0.0, 0.0, 1.0]]),
        tool,
        joints,
        np.ascontiguousarray(limits[_RAILS:, 0]),
        np.ascontiguousarray(limits[_RAILS:, 1]),
        np.array([True, True, False]),
    )
    return Mechanism(SPATIAL, gather(legs, limits[:_RAILS], working_mode[:_RAILS]), wrist)
