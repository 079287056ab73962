"""Two involute wheels turned numerically, and the forces between their teeth.

Nothing here knows of a line of action. Flanks are curves; where they touch is solved for, the
normal comes from the curve's tangent, sliding from the velocities of the two bodies, and the
moments from cross products.
"""

import math
from typing import NamedTuple

import numpy as np
from scipy.optimize import fsolve

from mechanics.arrays import Floats

STEP = 1e-5


class Touch(NamedTuple):
    """Where flanks touch and what a normal force of 1 N then does, friction included.

    Parameters
    ----------
    point : array, shape (2,). [m]
    radii : of the point about both centres. [m]
    moments : about both centres, along the turning of the first and against that of the second.
    sliding : speed at 1 rad/s of the first wheel. [m/s]
    loss : power lost at 1 rad/s of the first wheel. [W]
    """

    point: Floats
    radii: tuple[float, float]
    moments: tuple[float, float]
    sliding: float
    loss: float


class Wheels(NamedTuple):
    """The first wheel drives anticlockwise about (0, 0), the second has its centre at (a, 0)."""

    base: tuple[float, float]
    distance: float

    def flank(self, wheel: int, t: float, angle: float) -> Floats:
        """Return a point of a flank that leans clockwise with growing radius."""
        x = math.cos(t) + t * math.sin(t)
        y = -(math.sin(t) - t * math.cos(t))
        c, s = math.cos(angle), math.sin(angle)
        return self.base[wheel] * np.array([c * x - s * y, s * x + c * y]) + self.centre(wheel)

    def centre(self, wheel: int) -> Floats:
        """Return the centre of a wheel."""
        return np.array([wheel * self.distance, 0.0])

    def tangent(self, wheel: int, t: float, angle: float) -> Floats:
        """Return the direction of a flank by differences."""
        ahead, behind = (self.flank(wheel, t + h, angle) for h in (STEP, -STEP))
        along: Floats = (ahead - behind) / np.linalg.norm(ahead - behind)
        return along

    def closure(self, unknown: Floats, angle: float) -> Floats:
        """Return what is 0 where the flanks touch: unknown are both parameters and the angle."""
        first, second, turned = unknown
        gap = self.flank(0, first, angle) - self.flank(1, second, turned)
        one, other = self.tangent(0, first, angle), self.tangent(1, second, turned)
        return np.array([*(gap / self.distance), one[0] * other[1] - one[1] * other[0]])

    def solve(self, angle: float, guess: Floats) -> Floats:
        """Return both parameters and the second wheel's angle at which the flanks touch."""
        found, _, status, message = fsolve(
            self.closure, guess, args=(angle,), xtol=1e-13, full_output=True
        )
        assert status == 1 or np.abs(self.closure(found, angle)).max() < 1e-10, message
        return np.asarray(found, dtype=float)


def touches(wheels: Wheels, angles: Floats, friction: float, sense: float) -> list[Touch]:
    """Return where one pair of flanks touches as the first wheel turns from the pitch point.

    Parameters
    ----------
    wheels : both.
    angles : array, of the first wheel from where the flanks touch between the centres. [rad]
    friction : coefficient of friction.
    sense : 1 while the first wheel drives, -1 while the second one drives it back.
    """
    start = math.acos(sum(wheels.base) / wheels.distance)
    lean = math.tan(start) - start
    at_pitch = np.array([math.tan(start), math.tan(start), math.pi + lean])
    order = np.argsort(np.abs(angles), kind="stable")
    found: dict[int, Touch] = {}
    guesses = {-1: at_pitch, 1: at_pitch}
    for number in order:
        angle = float(angles[number])
        side = -1 if angle < 0 else 1
        solution = wheels.solve(lean + angle, guesses[side])
        guesses[side] = solution
        found[int(number)] = _touch(wheels, lean + angle, solution, friction, sense)
    return [found[number] for number in range(len(angles))]


def _touch(wheels: Wheels, angle: float, solution: Floats, friction: float, sense: float) -> Touch:
    ahead, behind = (wheels.solve(angle + h, solution)[2] for h in (STEP, -STEP))
    rate = (ahead - behind) / (2.0 * STEP)
    point = wheels.flank(0, solution[0], angle)
    to_first, to_second = point - wheels.centre(0), point - wheels.centre(1)
    one = sense * np.array([-to_first[1], to_first[0]])
    other = sense * rate * np.array([-to_second[1], to_second[0]])
    along = wheels.tangent(0, solution[0], angle)
    normal = np.array([-along[1], along[0]])
    # Onto the second wheel: it pushes the way the first wheel turns when it drives.
    normal *= np.sign(normal @ one) * sense
    slip = one - other
    speed = float(np.linalg.norm(slip))
    force = normal + (friction * slip / speed if speed > 1e-9 else 0.0)
    moments = (-_cross(to_first, -force), -_cross(to_second, force))
    radii = (float(np.linalg.norm(to_first)), float(np.linalg.norm(to_second)))
    return Touch(point, radii, moments, speed, friction * speed)


def _cross(first: Floats, second: Floats) -> float:
    return float(first[0] * second[1] - first[1] * second[0])
