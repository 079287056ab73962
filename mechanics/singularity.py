"""Closeness to singularities: types, condition, pressure angles, free motion."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.configuration import Configuration
from mechanics.drives import dead_drives


class Singularities(NamedTuple):
    """What is known about the singularity of each pose.

    Parameters
    ----------
    determinant : array, shape (poses,), of Jx as it is. [m to the number of turns]
    condition_number : array, shape (poses,), of Jx with turns measured at the characteristic
        length; infinite at a type 2 singularity.
    type : array, shape (poses,): 0 none; 1 a leg stretched or folded, or a wrist's axes aligned
        (det Jpsi = 0); 2 the platform has an uncontrolled motion (det Jx = 0); 3 both; -1 a leg
        cannot reach.
    pressure_angles : array, shape (drives, poses). [rad]
    free_motion : array, shape (6, poses): unit twist that the braked drives allow, turns
        measured at the characteristic length; NaN unless of type 2 or 3.
    """

    determinant: Floats
    condition_number: Floats
    type: Integers
    pressure_angles: Floats
    free_motion: Floats


def singularities(block: Configuration) -> Singularities:
    """Return how close each pose is to singularities, and of which type those are.

    References
    ----------
    Gosselin, Angeles, 1990, doi:10.1109/70.56660 (types); Glazunov et al. (pressure angles).
    """
    reached = np.all(block.reach >= 0.0, axis=0)
    condition = np.where(reached, block.condition_numbers, np.nan)
    first = np.any(dead_drives(block), axis=0)
    second = np.isinf(condition)
    kinds = np.where(reached, first + 2 * second, -1).astype(np.int64)
    return Singularities(
        np.where(reached, block.determinants, np.nan),
        condition,
        kinds,
        block.pressure_angles,
        _free_motions(block, second),
    )


def _free_motions(block: Configuration, loose: Booleans) -> Floats:
    """Return the right singular vector of the least singular value at the poses chosen, as twist.

    Shape (6, poses); of unit size with turns measured at the characteristic length.
    """
    scales = block.mechanism.coordinate_scales
    free = np.full((6, block.count), np.nan)
    if loose.any():
        scaled = np.moveaxis(block.platform_jacobians[..., loose] / scales[:, None], 2, 0)
        directions = np.linalg.svd(scaled)[2][:, -1].T
        free[:, loose] = block.mechanism.motion.twists @ (directions / scales[:, None])
    return free
