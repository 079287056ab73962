"""Meshes by points in their plane: centres, pitch point and contact."""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.gears.errors import GearError
from mechanics.gears.friction import Friction
from mechanics.gears.mesh import Mesh, check_contact_ratio, check_friction

_OFF_LINE = 1e-3
"""A point may be off its line by this share of its distance; coordinates are rounded by hand."""

LEAST_DISTANCE = 1e-9
"""Between centres. [m]"""

_NOTHING = 1e-9
"""Shares of the centre distance below this are rounding."""


def point_mesh(
    *,
    input_centre: Floats,
    output_centre: Floats,
    pitch_point: Floats,
    contact: Floats,
    opposite_contact: Floats | None,
    base_pitch: float | None,
    friction: Friction,
) -> Mesh:
    """Return the mesh of two wheels of which these points are known.

    The line of action passes through pitch point and contact. Its other end is the contact's
    mirror image, or where the involute ends if that is nearer, unless it is given. A pitch point
    outside the centres makes the wheel whose centre is farther a ring with teeth inside.

    Parameters
    ----------
    input_centre, output_centre, pitch_point, contact, opposite_contact : array, shape (2,). [m]
    base_pitch : from one pair of teeth to the next along the line of action, if known. [m]
    friction : law of friction between the teeth.

    Raises
    ------
    GearError : points coincide or are off the line on which they must lie, a contact lies beyond
        the line of action, teeth lose touch, or friction would wedge them.

    References
    ----------
    Glazunov et al., 2022, doi:10.31857/S0235711922020043, fig. 6 and 7.
    """
    radii = _pitch_radii(input_centre, output_centre, pitch_point)
    along = _direction(input_centre, output_centre, pitch_point, contact, radii)
    place = float((contact - pitch_point) @ along)
    axis = _unit(output_centre - input_centre)
    angle = math.asin(min(1.0, abs(float(along @ axis))))
    reach = _reach(radii, angle)
    _check_reach(place, reach, "contact")
    other = _other_end(opposite_contact, pitch_point, along, place, reach)
    mesh = Mesh(
        ratio=abs(radii[0] / radii[1]),
        pitch_radii=radii,
        pressure_angle=angle,
        approach=-min(place, other),
        recess=max(place, other),
        base_pitch=base_pitch,
        speed_radius=abs(radii[1]),
        friction=friction,
        contact=place,
    )
    check_contact_ratio(mesh, "base_pitch")
    check_friction(mesh, "friction_coefficient")
    return mesh


def _pitch_radii(first: Floats, second: Floats, pitch_point: Floats) -> tuple[float, float]:
    """Return the pitch radii, below 0 for a ring. [m]"""
    distance = float(np.linalg.norm(second - first))
    if distance < LEAST_DISTANCE:
        raise GearError(
            f"must be at least {LEAST_DISTANCE:g} m from input_centre; they are {distance:.6g} m "
            "apart",
            "output_centre",
        )
    off = abs(_cross(second - first, pitch_point - first)) / distance
    if off > _OFF_LINE * distance:
        raise GearError(
            f"the pitch radii do not fit the centres: the pitch point must lie on the line of "
            f"centres and is {off:.6g} m off; at most {_OFF_LINE * distance:.3g} m is allowed",
            "pitch_point",
        )
    signed = float((pitch_point - first) @ (second - first)) / distance
    radii = signed, distance - signed
    if min(abs(radii[0]), abs(radii[1])) <= _NOTHING * distance:
        raise GearError("must not be a centre: one pitch radius would be 0 m", "pitch_point")
    # Beyond both centres the farther one is the ring's, whose radius is then the negative one.
    return radii if min(radii) > 0.0 else (-radii[0], -radii[1])


def _direction(
    first: Floats,
    second: Floats,
    pitch_point: Floats,
    contact: Floats,
    radii: tuple[float, float],
) -> Floats:
    """Return the unit vector along which the input wheel pushes the output wheel's teeth.

    Teeth only push: the force on a wheel with teeth outside has a part towards its centre.
    """
    size = float(np.linalg.norm(contact - pitch_point))
    if size <= _NOTHING * float(np.linalg.norm(second - first)):
        raise GearError(
            "must differ from pitch_point: the line of action passes through both; ask for the "
            "pitch point as the place of contact instead",
            "contact",
        )
    along = (contact - pitch_point) / size
    if abs(_cross(along, _unit(second - first))) <= _OFF_LINE:
        raise GearError(
            "must not lie on the line of centres: a force along it turns no wheel", "contact"
        )
    inward = second - pitch_point if radii[1] > 0.0 else pitch_point - first
    return -along if float(along @ inward) < 0.0 else along


def _reach(radii: tuple[float, float], angle: float) -> tuple[float, float]:
    """Return the ends of the involutes along the line of action; a ring's has none. [m]"""
    sine = math.sin(angle)
    first = -radii[0] * sine if radii[0] > 0.0 else -math.inf
    second = radii[1] * sine if radii[1] > 0.0 else math.inf
    return first, second


def _check_reach(place: float, reach: tuple[float, float], field: str) -> None:
    beyond = max(reach[0] - place, place - reach[1])
    if beyond > _NOTHING * abs(place):
        raise GearError(
            f"lies {abs(place):.6g} m from the pitch point and so {beyond:.6g} m outside of the "
            f"line of action: on that side of the pitch point the involute ends after "
            f"{abs(place) - beyond:.6g} m",
            field,
        )


def _other_end(
    given: Floats | None,
    pitch_point: Floats,
    along: Floats,
    place: float,
    reach: tuple[float, float],
) -> float:
    if given is None:
        return min(max(-place, reach[0]), reach[1])
    off = abs(_cross(along, given - pitch_point))
    if off > _OFF_LINE * abs(place):
        raise GearError(
            f"must lie on the line of action through pitch_point and contact and is {off:.6g} m "
            f"off; at most {_OFF_LINE * abs(place):.3g} m is allowed",
            "opposite_contact",
        )
    other = float((given - pitch_point) @ along)
    if other * place > 0.0:
        raise GearError(
            "must lie on the other side of pitch_point than contact", "opposite_contact"
        )
    _check_reach(other, reach, "opposite_contact")
    return other


def _unit(vector: Floats) -> Floats:
    unit: Floats = vector / np.linalg.norm(vector)
    return unit


def _cross(first: Floats, second: Floats) -> float:
    return float(first[0] * second[1] - first[1] * second[0])
