"""Two wheels in mesh: the line on which their teeth touch."""

import math
from dataclasses import dataclass

from mechanics.gears.errors import GearError
from mechanics.gears.friction import Coulomb, Friction

MOST_PAIRS = 20.0
"""Greatest contact ratio; teeth in use stay below 4."""


@dataclass(frozen=True)
class Mesh:
    """Wheels whose teeth touch on a straight line through the pitch point.

    The input wheel is the one nearer to the motor. Places on the line of action are signed
    distances from the pitch point, positive where the contact goes while the motor drives; that
    part is the recess, the other the approach, also when the load drives back.

    Parameters
    ----------
    ratio : input torque over output torque without friction, above 0.
    pitch_radii : of input and output wheel; below 0 for a wheel with teeth inside. Of bevel
        wheels, those of the equivalent spur pair. [m]
    pressure_angle : of the line of action at work. [rad]
    approach, recess : how far the line of action is used before and after the pitch point; one of
        them may be below 0 when the teeth touch on one side of it only. [m]
    base_pitch : from one pair of teeth to the next along the line; None if not known. [m]
    speed_radius : pitch line speed over the speed of the output shaft. [m]
    friction : law of friction between the teeth.
    contact : a place on the line of action that was asked for; None if there is none. [m]
    tip_radii, tip_thickness : of input and output wheel, as `wheels.Pair`; None if not known. [m]
    """

    ratio: float
    pitch_radii: tuple[float, float]
    pressure_angle: float
    approach: float
    recess: float
    base_pitch: float | None
    speed_radius: float
    friction: Friction
    contact: float | None = None
    tip_radii: tuple[float, float] | None = None
    tip_thickness: tuple[float, float] | None = None

    @property
    def base_radii(self) -> tuple[float, float]:
        """Base radii of input and output wheel, with the signs of the pitch radii. [m]"""
        cosine = math.cos(self.pressure_angle)
        return self.pitch_radii[0] * cosine, self.pitch_radii[1] * cosine

    @property
    def contact_ratio(self) -> float | None:
        """How many pairs of teeth touch on average; None if the base pitch is not known."""
        if self.base_pitch is None:
            return None
        return (self.approach + self.recess) / self.base_pitch

    @property
    def sliding_per_length(self) -> float:
        """Sliding speed a pitch line speed of 1 m/s and metre from the pitch point. [1/m]"""
        return 1.0 / self.pitch_radii[0] + 1.0 / self.pitch_radii[1]


def check_contact_ratio(mesh: Mesh, *field: str) -> None:
    """Raise GearError, naming `field`, unless one pair of teeth takes over before another ends."""
    ratio = mesh.contact_ratio
    if ratio is not None and not 1.0 <= ratio <= MOST_PAIRS:
        used = mesh.approach + mesh.recess
        raise GearError(
            f"the contact ratio is {ratio:.4g}: teeth touch along {used:.6g} m of the line of "
            f"action, {mesh.base_pitch:.6g} m apart; it must be from 1 to {MOST_PAIRS:g}",
            *field,
        )


def check_friction(mesh: Mesh, *field: str) -> None:
    """Raise GearError if the teeth would wedge at the pitch point whichever wheel drives.

    With a friction angle of 90 degrees less the pressure angle, the force between the teeth points
    along the line of centres and turns neither wheel.
    """
    if not isinstance(mesh.friction, Coulomb):
        return
    angle, most = math.atan(mesh.friction.number), 0.5 * math.pi - mesh.pressure_angle
    if angle >= most:
        raise GearError(
            f"the coefficient {mesh.friction.number:g} is a friction angle of {angle:.6g} rad; it "
            f"must be {angle - most:.6g} rad less, below {most:.6g} rad, pi/2 less the pressure "
            f"angle; that is a coefficient below {1.0 / math.tan(mesh.pressure_angle):.6g}",
            *field,
        )
