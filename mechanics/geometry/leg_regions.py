"""Where the legs let the platform's reference point go, one leg at a time."""

from math import hypot, inf, isfinite, sqrt

import numpy as np

from mechanics.arrays import Floats
from mechanics.errors import NotOfferedError
from mechanics.geometry.annuli import Annulus
from mechanics.geometry.arcs import TURN
from mechanics.geometry.shells import Shell
from mechanics.legs import CRANK, RAIL, STRUT, Legs
from mechanics.mechanism import Mechanism

PLANE, SPACE = ("x", "y"), ("x", "y", "z")
"""The translations of the motions that have regions in the plane and in space."""

_PARALLEL = 1e-12


def leg_annuli(mechanism: Mechanism, pose: Floats, *, limited: bool) -> tuple[Annulus, ...]:
    """Return where each leg lets the reference point go in the plane, at one orientation.

    A crank and its rod reach |r - L| to r + L from A - R c0; a strut what its limits say. Where
    a leg's joints stand at different heights, the rod counts by its length in the plane.

    Parameters
    ----------
    mechanism : of a motion in the plane.
    pose : array, shape (coordinates,); only the platform's turn counts. [m, rad]
    limited : whether actuator limits hold (class constructive) or not (theoretical). Without
        them a strut reaches everywhere.

    Raises
    ------
    NotOfferedError : the motion leaves the plane, or a leg's region is no annulus: a rail, a
        crank about an axis in the plane, a crank with limits that hold.
    PoseError : `pose` has another number of coordinates than the motion.

    References
    ----------
    Erastova, Laryushkin, 2017, doi:10.18698/0536-1044-2017-8-78-87 (without the holes).
    """
    require_translations(mechanism, PLANE)
    centres = leg_centres(mechanism, pose)
    radii = [
        _radii(mechanism.legs, leg, abs(float(centres[leg, 2])), limited)
        for leg in range(mechanism.leg_count)
    ]
    return tuple(
        Annulus(centre[:2], inner, outer)
        for centre, (inner, outer) in zip(centres, radii, strict=True)
    )


def leg_annuli_at_any_turn(mechanism: Mechanism, *, limited: bool) -> tuple[Annulus, ...]:
    """Return where each leg lets the reference point go in the plane if it alone chose the turn.

    The annulus of the platform point about A, widened by the point's distance |c0| from the
    reference point. What all legs have in common is only a bound of the maximal workspace: each
    may want another turn.

    Parameters
    ----------
    mechanism, limited : as for `leg_annuli`.

    Raises
    ------
    NotOfferedError : as for `leg_annuli`.
    """
    pose = np.zeros(len(mechanism.motion.coordinates))
    about_points = mechanism.legs._replace(platform_point=_only_heights(mechanism.legs))
    spread = np.hypot(*mechanism.legs.platform_point[:, :2].T)
    if not mechanism.motion.turns:
        return leg_annuli(mechanism, pose, limited=limited)
    narrow = leg_annuli(Mechanism(mechanism.motion, about_points), pose, limited=limited)
    return tuple(
        Annulus(one.centre, max(0.0, one.inner - off, off - one.outer), one.outer + off)
        for one, off in zip(narrow, spread.tolist(), strict=True)
    )


def leg_shells(mechanism: Mechanism, pose: Floats) -> tuple[Shell, ...]:
    """Return where each strut's limits let the reference point go in space, at one orientation.

    Parameters
    ----------
    mechanism : of a motion with all three translations, all legs struts.
    pose : array, shape (coordinates,); only the platform's turns count. [m, rad]

    Raises
    ------
    NotOfferedError : the motion lacks a translation, or a leg is no strut.
    PoseError : `pose` has another number of coordinates than the motion.
    """
    require_translations(mechanism, SPACE)
    legs = mechanism.legs
    for leg in np.flatnonzero(legs.drive != STRUT).tolist():
        raise NotOfferedError("only struts reach what lies between two spheres", leg=leg)
    centres = leg_centres(mechanism, pose)
    limits = [_strut(legs, leg) for leg in range(mechanism.leg_count)]
    return tuple(Shell(centre, *radii) for centre, radii in zip(centres, limits, strict=True))


def leg_centres(mechanism: Mechanism, pose: Floats) -> Floats:
    """Return A - R c0 of each leg, shape (legs, 3): there the platform point stands at A. [m]

    Raises
    ------
    PoseError : `pose` has another number of coordinates than the motion.
    """
    columns = mechanism.columns(np.asarray(pose, dtype=float)[None])
    rotation = mechanism.motion.place(columns)[1].reshape(3, 3)
    centres: Floats = mechanism.legs.base_point - mechanism.legs.platform_point @ rotation.T
    return centres


def require_translations(mechanism: Mechanism, translations: tuple[str, ...]) -> None:
    """Raise NotOfferedError unless the motion translates along just these directions."""
    if mechanism.motion.translations != translations:
        raise NotOfferedError(
            f"the motion must move the platform along {', '.join(translations)}; "
            f"{mechanism.motion.name} moves it along {', '.join(mechanism.motion.translations)}"
        )


def require_no_crank_limits(legs: Legs, leg: int) -> None:
    """Raise NotOfferedError if the leg is a crank that its limits keep from turning around."""
    lower, upper = float(legs.lower_limit[leg]), float(legs.upper_limit[leg])
    if legs.drive[leg] == CRANK and isfinite(lower) and isfinite(upper) and upper - lower < TURN:
        raise NotOfferedError("the limits of its crank cut its region along other lines", leg=leg)


def _radii(legs: Legs, leg: int, height: float, limited: bool) -> tuple[float, float]:
    """Return the radii of a leg's annulus; two zeros, which leave no area, if it has none."""
    if legs.drive[leg] == RAIL:
        raise NotOfferedError("the region of a rail is a strip, not an annulus", leg=leg)
    if legs.drive[leg] == STRUT:
        lower, upper = _strut(legs, leg) if limited else (0.0, inf)
        return (_leg_of(lower, height), _leg_of(upper, height)) if upper > height else (0.0, 0.0)
    if hypot(legs.axis[leg, 0], legs.axis[leg, 1]) > _PARALLEL:
        raise NotOfferedError("its crank must turn about the plane's normal", leg=leg)
    if limited:
        require_no_crank_limits(legs, leg)
    crank, rod = float(legs.crank_length[leg]), _leg_of(float(legs.rod_length[leg]), height)
    return (abs(crank - rod), crank + rod) if rod > 0.0 else (0.0, 0.0)


def _leg_of(hypotenuse: float, height: float) -> float:
    """Return the other leg of a right triangle, 0 where there is none."""
    return sqrt(max(0.0, (hypotenuse - height) * (hypotenuse + height)))


def _strut(legs: Legs, leg: int) -> tuple[float, float]:
    """Return the radii between a strut's stops; two zeros if it is never long enough."""
    lower, upper = max(0.0, float(legs.lower_limit[leg])), float(legs.upper_limit[leg])
    return (lower, upper) if upper > 0.0 else (0.0, 0.0)


def _only_heights(legs: Legs) -> Floats:
    points: Floats = legs.platform_point * np.array([0.0, 0.0, 1.0])
    return points
