"""The force between two teeth at a place on the line of action.

The normal force lies on the line of action; friction turns it by atan f against the sliding, one
way in approach and the other way in recess. Per unit of normal force, the force's moments about
the centres are r_b (1 + g (tan a + s / r_b)) for the input wheel and r_b (1 + g (tan a - s / r_b))
for the output wheel, where g = f sgn(s) while the motor drives and -f sgn(s) while the load drives
back. Here `shares` are the factors beside r_b, so that they are exactly 1 without friction.
"""

from typing import Literal, NamedTuple

import numpy as np

from mechanics.arrays import Floats
from mechanics.gears.mesh import Mesh

Sense = Literal["driving", "back_driving"]
"""Whether the motor drives the output, or the load on the output drives the motor."""

SIGNS: dict[Sense, float] = {"driving": 1.0, "back_driving": -1.0}


class Shares(NamedTuple):
    """Moments of the tooth force over those without friction, about both centres.

    Parameters
    ----------
    input, output : array, shape of the places.
    coefficient : array, coefficient of friction at each place; 0 where nothing slides.
    """

    input: Floats
    output: Floats
    coefficient: Floats


def shares(mesh: Mesh, places: Floats, sides: Floats, sense: Sense, pitch_speed: float) -> Shares:
    """Return what friction makes of the tooth force's moments about both centres.

    Parameters
    ----------
    mesh : the wheels.
    places : array, on the line of action. [m]
    sides : array, of the shape of `places`: -1 in approach, 1 in recess, 0 at the pitch point,
        where nothing slides.
    sense : who drives.
    pitch_speed : speed of both pitch circles; NaN if it is not known. [m/s]
    """
    coefficient = mesh.friction.coefficient(sliding_speed(mesh, places, pitch_speed))
    turning = SIGNS[sense] * sides * coefficient
    slope = np.tan(mesh.pressure_angle)
    first, second = mesh.base_radii
    return Shares(
        1.0 + turning * (slope + places / first),
        1.0 + turning * (slope - places / second),
        coefficient * np.abs(sides),
    )


def sliding_speed(mesh: Mesh, places: Floats, pitch_speed: float) -> Floats:
    """Return how fast the teeth slide on each other at places on the line of action. [m/s]"""
    speed: Floats = np.abs(pitch_speed * mesh.sliding_per_length * places)
    return speed


def arms(mesh: Mesh, force: Shares) -> tuple[Floats, Floats]:
    """Return the distances of the force's line from both centres; below 0 past a centre. [m]"""
    cosine = 1.0 / np.hypot(1.0, force.coefficient)
    first, second = mesh.base_radii
    return abs(first) * force.input * cosine, abs(second) * force.output * cosine


def torque_factor(force: Shares) -> Floats:
    """Return the input torque over that without friction; NaN where the teeth lock.

    They lock where the force's line passes a centre on its other side or through it: while the
    motor drives no finite torque moves the output wheel, while the load drives back none arrives.
    """
    free = (force.input > 0.0) & (force.output > 0.0)
    return np.where(free, force.input / np.where(free, force.output, 1.0), np.nan)
