"""Meshes by design data: spur wheels, and bevel wheels by their equivalent pair."""

import math
from dataclasses import replace

from mechanics.gears.errors import GearError
from mechanics.gears.friction import Friction
from mechanics.gears.mesh import Mesh, check_contact_ratio, check_friction
from mechanics.gears.wheels import Pair, Teeth, pair

_ROUNDING = 1e-9


def spur_mesh(
    teeth: Teeth,
    friction: Friction,
    *,
    centre_distance: float | None = None,
    contact: float | None = None,
) -> Mesh:
    """Return the mesh of two spur wheels with external teeth.

    Parameters
    ----------
    teeth : of both wheels.
    friction : law of friction between the teeth.
    centre_distance : without backlash unless given. [m]
    contact : a place on the line of action. [m]

    Raises
    ------
    GearError : the wheels do not mesh, teeth lose touch, the contact lies outside the line of
        action, or friction would wedge the teeth.
    """
    found = pair(teeth, centre_distance)
    ratio = teeth.counts[0] / teeth.counts[1]
    return _checked(_mesh(found, ratio, found.pitch_radii[1], friction, contact))


def bevel_mesh(
    teeth: Teeth, friction: Friction, *, shaft_angle: float, contact: float | None = None
) -> Mesh:
    """Return the mesh of two bevel wheels: that of their equivalent spur pair, with their ratio.

    The equivalent wheels roll on the back cones at the mean diameter (Tredgold): radii and counts
    of teeth over the cosine of the pitch cone's angle, tan d1 = sin S / (u + cos S).

    Parameters
    ----------
    teeth : of both wheels, the module being that at the mean diameter; shifts sum to 0.
    friction : law of friction between the teeth.
    shaft_angle : between the axes. [rad]
    contact : a place on the equivalent pair's line of action. [m]

    Raises
    ------
    GearError : as for spur wheels; the shifts do not sum to 0, or a wheel would be a ring.
    """
    check_balanced(teeth)
    ratio = teeth.counts[0] / teeth.counts[1]
    counts = equivalent_counts(teeth.counts, shaft_angle)
    found = pair(replace(teeth, counts=counts))
    speed_radius = 0.5 * teeth.module * teeth.counts[1]
    return _checked(_mesh(found, ratio, speed_radius, friction, contact))


def check_balanced(teeth: Teeth) -> None:
    """Raise GearError unless the shifts of bevel wheels leave their pitch cones where they are."""
    if abs(sum(teeth.shifts)) > _ROUNDING:
        raise GearError(
            f"the profile shifts of bevel wheels must sum to 0; given {teeth.shifts[0]:g} and "
            f"{teeth.shifts[1]:g}, which sum to {sum(teeth.shifts):g}",
            "output",
            "profile_shift",
        )


def equivalent_counts(counts: tuple[float, float], shaft_angle: float) -> tuple[float, float]:
    """Return the teeth of the spur wheels that mesh as these bevel wheels do.

    Raises
    ------
    GearError : the greater wheel's pitch cone is flat or hollow.
    """
    sine, cosine = math.sin(shaft_angle), math.cos(shaft_angle)
    first = math.atan2(sine, counts[1] / counts[0] + cosine)
    second = math.atan2(sine, counts[0] / counts[1] + cosine)
    widest = max(first, second)
    if widest >= 0.5 * math.pi - _ROUNDING:
        raise GearError(
            f"with {counts[0]:g} and {counts[1]:g} teeth and axes {shaft_angle:g} rad apart, one "
            f"pitch cone has a half-angle of {widest:.6g} rad; it must be below pi/2",
            "shaft_angle",
        )
    return counts[0] / math.cos(first), counts[1] / math.cos(second)


def _mesh(
    found: Pair, ratio: float, speed_radius: float, friction: Friction, contact: float | None
) -> Mesh:
    return Mesh(
        ratio=ratio,
        pitch_radii=found.pitch_radii,
        pressure_angle=found.pressure_angle,
        approach=found.approach,
        recess=found.recess,
        base_pitch=found.base_pitch,
        speed_radius=speed_radius,
        friction=friction,
        contact=contact,
        tip_radii=found.tip_radii,
        tip_thickness=found.tip_thickness,
    )


def _checked(mesh: Mesh) -> Mesh:
    check_contact_ratio(mesh)
    check_friction(mesh, "friction_coefficient")
    contact = mesh.contact
    if contact is not None and not -mesh.approach <= contact <= mesh.recess:
        beyond = max(-mesh.approach - contact, contact - mesh.recess)
        raise GearError(
            f"given {contact:g} m, outside of the line of action: teeth touch from "
            f"{-mesh.approach:.6g} to {mesh.recess:.6g} m, and this is {beyond:.6g} m beyond",
            "contact_position",
        )
    return mesh
