"""Closeness to singularities: types, condition, pressure angles, free motion."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.configuration import Configuration
from mechanics.drives import dead_drives
from mechanics.legs import ARC_JOINTS
from mechanics.mechanism import Mechanism

TOLERANCE = 1e-10
"""A pose counts as of type 2 where the inverse condition number is below this."""


class Singularities(NamedTuple):
    """What is known about the singularity of each pose.

    Parameters
    ----------
    determinant : array, shape (poses,), of Jx as it is. [m to the number of turns]
    condition_number : array, shape (poses,), of Jx with turns measured at the characteristic
        length; infinite at a type 2 singularity.
    type : array, shape (poses,): 0 none; 1 a leg stretched or folded (Jpsi = 0); 2 the platform
        has an uncontrolled motion (det Jx = 0); 3 both; -1 a leg cannot reach.
    pressure_angles : array, shape (legs, poses). [rad]
    free_motion : array, shape (6, poses): unit twist that the braked drives allow, turns
        measured at the characteristic length; NaN unless of type 2 or 3.
    """

    determinant: Floats
    condition_number: Floats
    type: Integers
    pressure_angles: Floats
    free_motion: Floats


def characteristic_length(mechanism: Mechanism) -> float:
    """Return the rms distance of the platform's joints from the reference point. [m]

    1 for mechanisms whose joints meet there, where no turn is measured with it.
    """
    points = mechanism.legs.platform_point
    length = float(np.sqrt(np.mean(np.sum(points**2, axis=1))))
    return length or 1.0


def singularities(block: Configuration) -> Singularities:
    """Return how close each pose is to singularities, and of which type those are.

    References
    ----------
    Gosselin, Angeles, 1990, doi:10.1109/70.56660 (types); Glazunov et al. (pressure angles).
    """
    reached = np.all(block.reach >= 0.0, axis=0)
    scaled, scales = _scaled_jacobians(block)
    smallest, condition, direction = _spectrum(scaled, reached)
    first = np.any(dead_drives(block), axis=0)
    second = reached & (smallest <= TOLERANCE)
    kinds = np.where(reached, first + 2 * second, -1).astype(np.int64)
    free = block.mechanism.motion.twists @ (direction / scales[:, None])
    return Singularities(
        np.where(reached, block.determinants, np.nan),
        np.where(second, np.inf, np.where(reached, condition, np.nan)),
        kinds,
        pressure_angles(block),
        np.where(second, free, np.nan),
    )


def _scaled_jacobians(block: Configuration) -> tuple[Floats, Floats]:
    """Return Jx, shape (poses, legs, coordinates), turns over the length, and what by."""
    motion = block.mechanism.motion
    turning = np.array([c in motion.turns for c in motion.coordinates])
    scales = np.where(turning, characteristic_length(block.mechanism), 1.0)
    return np.moveaxis(block.platform_jacobians / scales[None, :, None], 2, 0), scales


def _spectrum(matrices: Floats, valid: Booleans) -> tuple[Floats, Floats, Floats]:
    """Return inverse condition, condition number and the direction of the least singular value."""
    count, _, size = matrices.shape
    inverse, condition = np.full(count, np.nan), np.full(count, np.nan)
    direction = np.full((size, count), np.nan)
    if valid.any():
        _, values, rows = np.linalg.svd(matrices[valid])
        inverse[valid] = values[:, -1] / values[:, 0]
        with np.errstate(divide="ignore"):
            condition[valid] = 1.0 / inverse[valid]
        direction[:, valid] = rows[:, -1].T
    return inverse, condition, direction


def pressure_angles(block: Configuration) -> Floats:
    """Return the pressure angles, shape (legs, poses), within [0, pi/2]. [rad]

    With all other drives braked, drive i moves the platform by J^-1 e_i; its pressure angle is
    between the velocity of the leg's joint on the platform and the line of the rod's force. At a
    type 2 singularity the platform's free motion takes its place. For an arc the force acts
    along the great circle from the platform's axis to the intermediate one.
    """
    adjugates, _ = block.cofactors
    basis = block.mechanism.motion.twists
    arms = block.attachment[0]
    angles = np.empty((block.mechanism.leg_count, block.count))
    for k in range(block.mechanism.leg_count):
        # The direction alone counts: a row of cofactors has it, singular or not.
        twist = basis @ adjugates[k]
        velocity = twist[:3] + np.cross(twist[3:], arms[k], axis=0)
        line = _force_line(block, k)
        across = np.linalg.norm(np.cross(velocity, line, axis=0), axis=0)
        along = np.abs(np.sum(velocity * line, axis=0))
        # Without any motion there is no angle.
        angles[k] = np.where(across + along == 0.0, np.nan, np.arctan2(across, along))
    return angles


def _force_line(block: Configuration, k: int) -> Floats:
    direction = block.rods[0][k]
    if block.mechanism.legs.joints[k] != ARC_JOINTS:
        line: Floats = direction
        return line
    platform = block.attachment[0][k]
    tangent: Floats = direction - np.sum(direction * platform, axis=0) * platform
    return tangent
