"""The user's own legs as a mechanism."""

from collections.abc import Callable, Sequence

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import GeometryError
from mechanics.families.hexapods import hinge_across
from mechanics.legs import (
    BALL_JOINTS,
    CRANK,
    PARALLEL_JOINTS,
    PLANE_JOINTS,
    RAIL,
    STRUT,
    STRUT_JOINTS,
    Leg,
    gather,
)
from mechanics.mechanism import Mechanism
from mechanics.motions import (
    PLANAR,
    PLANAR_TRANSLATION,
    SPATIAL,
    SPHERICAL,
    TRANSLATION,
    Motion,
    schoenflies,
)
from schemas.custom import CrankLeg, RailLeg, StrutLeg

MOTIONS = {
    motion.name: motion for motion in (PLANAR_TRANSLATION, PLANAR, TRANSLATION, SPHERICAL, SPATIAL)
}
_PLANE_NORMAL = (0.0, 0.0, 1.0)


def custom(
    *,
    motion: str,
    axis: Sequence[float] | None,
    legs: Sequence[CrankLeg | RailLeg | StrutLeg],
    limits: Floats,
    working_mode: Floats,
) -> Mechanism:
    """Return the mechanism of these legs.

    A leg's passive joints follow from the motion: revolutes about z in the plane, parallelograms
    where the platform only translates, universal joint and ball elsewhere, balls for struts.

    Raises
    ------
    GeometryError : an axis or a leg is degenerate, or the legs are not as many as coordinates.
    """
    chosen = schoenflies(np.array(axis)) if motion == "schoenflies" else MOTIONS[motion]
    if _joints(chosen) == PLANE_JOINTS:
        for number, leg in enumerate(legs):
            _check_in_plane(number, leg)
    gathered = gather([_leg(leg, chosen) for leg in legs], limits, working_mode)
    return Mechanism(chosen, gathered)


def _leg(leg: CrankLeg | RailLeg | StrutLeg, motion: Motion) -> Leg:
    makers: dict[str, Callable[..., Leg]] = {"crank": _crank, "rail": _rail, "strut": _strut}
    return makers[leg.drive](leg, motion)


def _joints(motion: Motion) -> int:
    if motion.name.startswith("planar"):
        return PLANE_JOINTS
    return PARALLEL_JOINTS if not motion.turns else BALL_JOINTS


def _check_in_plane(number: int, leg: CrankLeg | RailLeg | StrutLeg) -> None:
    """Raise GeometryError unless all joints of a leg can be revolutes about z."""
    if leg.base_point[2] != leg.platform_point[2]:
        raise GeometryError(
            f"a planar motion needs its base and platform point at the same z; given "
            f"{leg.base_point[2]} and {leg.platform_point[2]}",
            leg=number,
        )
    if isinstance(leg, CrankLeg) and any(leg.axis[:2]):
        detail = f"a planar motion needs its crank's axis along z; given {leg.axis}"
        raise GeometryError(detail, leg=number)
    if isinstance(leg, RailLeg) and leg.direction[2] != 0.0:
        detail = f"a planar motion needs its rail in the plane; given {leg.direction}"
        raise GeometryError(detail, leg=number)


def _crank(leg: CrankLeg, motion: Motion) -> Leg:
    return Leg(
        CRANK,
        leg.base_point,
        leg.platform_point,
        axis=leg.axis,
        zero_direction=leg.zero_direction,
        crank_length=leg.crank_length,
        rod_length=leg.rod_length,
        joints=_joints(motion),
        hinge=leg.axis,
    )


def _rail(leg: RailLeg, motion: Motion) -> Leg:
    planar = _joints(motion) == PLANE_JOINTS
    return Leg(
        RAIL,
        leg.base_point,
        leg.platform_point,
        axis=leg.direction,
        rod_length=leg.rod_length,
        joints=_joints(motion),
        hinge=_PLANE_NORMAL if planar else hinge_across(leg.direction),
    )


def _strut(leg: StrutLeg, motion: Motion) -> Leg:
    planar = _joints(motion) == PLANE_JOINTS
    return Leg(
        STRUT,
        leg.base_point,
        leg.platform_point,
        joints=PLANE_JOINTS if planar else STRUT_JOINTS,
        hinge=_PLANE_NORMAL,
    )
