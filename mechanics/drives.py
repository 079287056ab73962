"""Drives that cannot move the platform: of a leg stretched or folded, a wrist with axes aligned."""

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.configuration import Configuration
from mechanics.legs import CRANK, STRUT, Legs

TOLERANCE = 1e-7
"""A leg counts as stretched or folded, and axes of a wrist as aligned, within this angle.

The angle goes with the root of how near the leg is to its end, so rounding alone makes 1e-8. [rad]
"""


def dead_drives(block: Configuration) -> Booleans:
    """Return, shape (drives, poses), which drives have Jpsi = 0: those of a type 1 singularity.

    A wrist's motors go together: where ry is a right angle, no rate of theirs makes every turn.
    """
    cosines = elbow_cosines(block.mechanism.legs, block.rods[1])
    if block.mechanism.wrist is not None:
        cosines = np.concatenate([cosines, block.rate_rows[1][block.mechanism.leg_count :]])
    dead: Booleans = np.abs(cosines) <= TOLERANCE
    return dead


def elbow_cosines(legs: Legs, rates: Floats) -> Floats:
    """Return the cosines between rods and rates of their moving ends, shape (legs, poses).

    Parameters
    ----------
    rates : array, shape (legs, poses): the diagonal of Jpsi.
    """
    moved = np.where(legs.drive == CRANK, legs.crank_length, 1.0)
    rods = np.where(
        legs.drive == STRUT,
        1.0,
        legs.rod_length / np.where(legs.drive == STRUT, 1.0, legs.rod_scale),
    )
    cosines: Floats = rates / (moved * rods)[:, None]
    return cosines
