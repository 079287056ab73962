"""Wheels of involute teeth by their design data."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from mechanics.gears.errors import GearError
from mechanics.gears.involute import inverse_involute, involute

_ROUNDING = 1e-9
"""A limit may be missed by this share of what it is measured in."""

WHEELS = ("input", "output")


@dataclass(frozen=True)
class Teeth:
    """Teeth as one rack would cut them.

    Parameters
    ----------
    module : pitch over pi. [m]
    pressure_angle : of the rack. [rad]
    addendum_coefficient : height of the rack's teeth above its pitch line over the module.
    counts : teeth of input and output wheel; of an equivalent pair not whole numbers.
    shifts : profile shifts of input and output wheel over the module.
    """

    module: float
    pressure_angle: float
    addendum_coefficient: float
    counts: tuple[float, float]
    shifts: tuple[float, float]


@dataclass(frozen=True)
class Pair:
    """Two wheels with external teeth on parallel shafts; pairs are of input and output wheel.

    Parameters
    ----------
    centre_distance : [m]
    pressure_angle : at work. [rad]
    pitch_radii, base_radii, tip_radii : the pitch radii are those at work. [m]
    tip_thickness : of the teeth, along the tip circle. [m]
    base_pitch : [m]
    approach, recess : how far the line of action is used on both sides of the pitch point. [m]
    """

    centre_distance: float
    pressure_angle: float
    pitch_radii: tuple[float, float]
    base_radii: tuple[float, float]
    tip_radii: tuple[float, float]
    tip_thickness: tuple[float, float]
    base_pitch: float
    approach: float
    recess: float


def least_shift(teeth: Teeth, count: float) -> float:
    """Return the least profile shift at which the rack's tip does not undercut the involute."""
    return teeth.addendum_coefficient - 0.5 * count * math.sin(teeth.pressure_angle) ** 2


def close_distance(teeth: Teeth) -> float:
    """Return the centre distance at which the teeth have no backlash. [m]

    Raises
    ------
    GearError : the shifts are so far below 0 that teeth overlap at any distance.

    References
    ----------
    ISO 21771:2007: inv aw = inv a + 2 tan a (x1 + x2) / (z1 + z2).
    """
    angle, count = teeth.pressure_angle, sum(teeth.counts)
    added = 2.0 * math.tan(angle) * sum(teeth.shifts) / count
    least = -0.5 * count * involute(angle) / math.tan(angle)
    if involute(angle) + added < 0.0:
        raise GearError(
            f"the profile shifts sum to {sum(teeth.shifts):g}; at any centre distance the teeth "
            f"would overlap unless they sum to at least {least:.6g}",
            "output",
            "profile_shift",
        )
    working = inverse_involute(involute(angle) + added)
    return 0.5 * teeth.module * count * math.cos(angle) / math.cos(working)


def pair(teeth: Teeth, centre_distance: float | None = None) -> Pair:
    """Return the geometry of two wheels in mesh.

    Tips are as high as leaves the rack's clearance at the centre distance without backlash.

    Parameters
    ----------
    teeth : of both wheels.
    centre_distance : without backlash unless given. [m]

    Raises
    ------
    GearError : teeth are undercut or pointed, overlap, or touch beyond the ends of the line of
        action.

    References
    ----------
    ISO 21771:2007, Gears - Cylindrical involute gears and gear pairs.
    """
    _check_undercut(teeth)
    close = close_distance(teeth)
    distance = _checked_distance(centre_distance, close)
    tips = _tip_radii(teeth, close)
    cosine = math.cos(teeth.pressure_angle)
    base = _both(0.5 * teeth.module * count * cosine for count in teeth.counts)
    angle = math.acos(min(1.0, sum(base) / distance))
    thickness = _tip_thickness(teeth, base, tips)
    pitch = _both(radius / math.cos(angle) for radius in base)
    recess, approach = (
        math.sqrt(tip**2 - root**2) - radius * math.sin(angle)
        for tip, root, radius in zip(tips, base, pitch, strict=True)
    )
    found = Pair(
        distance,
        angle,
        pitch,
        base,
        tips,
        thickness,
        math.pi * teeth.module * cosine,
        approach,
        recess,
    )
    _check_ends(found)
    return found


def _both(values: Iterable[float]) -> tuple[float, float]:
    first, second = values
    return first, second


def _check_undercut(teeth: Teeth) -> None:
    for wheel, count, shift in zip(WHEELS, teeth.counts, teeth.shifts, strict=True):
        least = least_shift(teeth, count)
        if shift < least - _ROUNDING:
            raise GearError(
                f"the {wheel} wheel's teeth are undercut: a profile shift of {shift:g} is "
                f"{least - shift:.6g} below the least, which is {least:.6g} for {count:.6g} teeth",
                wheel,
                "profile_shift",
            )


def _checked_distance(given: float | None, close: float) -> float:
    if given is None:
        return close
    if given < close * (1.0 - _ROUNDING):
        raise GearError(
            f"given {given:g} m; the wheels' pitch radii fit a distance of {close:.9g} m without "
            f"backlash, so the teeth would overlap by {close - given:.6g} m",
            "centre_distance",
        )
    return given


def _tip_radii(teeth: Teeth, close: float) -> tuple[float, float]:
    # By how much the wheels stand closer than the sum of their shifts: tips are shorter by that.
    closer = 0.5 * sum(teeth.counts) + sum(teeth.shifts) - close / teeth.module
    height = teeth.addendum_coefficient - closer
    return _both(
        teeth.module * (0.5 * count + height + shift)
        for count, shift in zip(teeth.counts, teeth.shifts, strict=True)
    )


def _tip_thickness(
    teeth: Teeth, base: tuple[float, float], tips: tuple[float, float]
) -> tuple[float, float]:
    """Return the thickness of both wheels' teeth at their tips. [m]

    Raises
    ------
    GearError : flanks meet below the tip, or the tip lies within the base circle.
    """
    found = []
    for number, wheel in enumerate(WHEELS):
        count, shift = teeth.counts[number], teeth.shifts[number]
        root, tip = base[number], tips[number]
        if tip <= root:
            raise GearError(
                f"the {wheel} wheel's tips, at a radius of {tip:.6g} m, are {root - tip:.6g} m "
                "within the base circle, where there is no involute",
                wheel,
                "profile_shift",
            )
        half_pitch = 0.5 * math.pi + 2.0 * shift * math.tan(teeth.pressure_angle)
        narrowing = involute(teeth.pressure_angle) - involute(math.acos(root / tip))
        found.append(2.0 * tip * (half_pitch / count + narrowing))
        if found[-1] <= 0.0:
            raise GearError(
                f"the {wheel} wheel's teeth are pointed: their flanks cross below the tip circle "
                f"of radius {tip:.6g} m, where the thickness would be {found[-1]:.6g} m; lower the "
                "profile shift or the addendum coefficient",
                wheel,
                "profile_shift",
            )
    return _both(found)


def _check_ends(found: Pair) -> None:
    """Raise GearError if a tip reaches beyond where the other wheel's involute begins."""
    ends = (found.approach, found.recess)
    for reach, radius, wheel in zip(ends, found.pitch_radii, reversed(WHEELS), strict=True):
        most = radius * math.sin(found.pressure_angle)
        if reach > most * (1.0 + _ROUNDING):
            raise GearError(
                f"the {wheel} wheel's tips touch {reach:.6g} m from the pitch point, outside of "
                f"the line of action: the other wheel's involute ends after {most:.6g} m, so they "
                f"reach {reach - most:.6g} m too far",
                wheel,
                "profile_shift",
            )
