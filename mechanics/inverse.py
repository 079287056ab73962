"""Inverse kinematics: which drive positions hold a pose."""

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism


def actuators(mechanism: Mechanism, poses: Floats) -> Floats:
    """Return the drive coordinates that hold the platform at each pose.

    Parameters
    ----------
    mechanism : the mechanism, in its working mode.
    poses : array, shape (poses, coordinates), in the motion's coordinates. [m, rad]

    Returns
    -------
    array, shape (poses, legs)
        Drive coordinates, crank angles in (-pi, pi]; NaN where the leg cannot reach. [rad]

    Raises
    ------
    PoseError : `poses` has another number of columns.

    References
    ----------
    Laryushkin et al., 2019, doi:10.1134/S0235711919030106; the leg equation |c - B|^2 = L^2.
    """
    return Configuration(mechanism, mechanism.columns(poses)).actuators.T
