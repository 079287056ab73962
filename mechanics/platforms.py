"""The platform as a body: what its weight and inertia ask of the drives."""

from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Floats


@dataclass(frozen=True)
class Platform:
    """A rigid body that moves with the platform.

    Parameters
    ----------
    mass : [kg]
    centre : array, shape (3,), centre of mass in the platform's frame. [m]
    inertia : array, shape (3, 3), about the centre of mass, in the platform's frame. [kg m^2]
    """

    mass: float
    centre: Floats
    inertia: Floats


def inertial_wrench(
    platform: Platform, rotations: Floats, twists: Floats, accelerations: Floats, gravity: Floats
) -> Floats:
    """Return the wrench of weight and inertia on the platform, about the reference point.

    After d'Alembert: force m (g - a_c), moment c x force - (I alpha + omega x I omega).

    Parameters
    ----------
    rotations : array, shape (9, poses), row by row.
    twists : array, shape (6, poses) or (6, 1): velocity of the reference point, omega.
    accelerations : array, same shapes: acceleration of the reference point, alpha.
    gravity : array, shape (3,). [m/s^2]

    Returns
    -------
    array, shape (6, poses). [N, N m]
    """
    turn = rotations.reshape(3, 3, -1)
    centre = np.einsum("jkn,k->jn", turn, platform.centre)
    omega, alpha = twists[3:] + 0.0 * centre, accelerations[3:] + 0.0 * centre
    swing = np.cross(omega, np.cross(omega, centre, axis=0), axis=0)
    of_centre = accelerations[:3] + np.cross(alpha, centre, axis=0) + swing
    force = platform.mass * (gravity[:, None] - of_centre)
    inertia = np.einsum("jkn,kl,mln->jmn", turn, platform.inertia, turn)
    spin = np.einsum("jmn,mn->jn", inertia, omega)
    moment = (
        np.cross(centre, force, axis=0)
        - np.einsum("jmn,mn->jn", inertia, alpha)
        - np.cross(omega, spin, axis=0)
    )
    return np.concatenate([force, moment])
