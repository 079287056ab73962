"""Fields: numbers that a scan keeps for every node inside a workspace."""

from collections.abc import Callable
from functools import partial

import numpy as np

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.effort import worst_efforts
from mechanics.loads import Load

Field = Callable[[Configuration], Floats]
"""A field's values, shape (poses,) or (drives, poses)."""


def effort(load: Load) -> Field:
    """Return the field of each drive's greatest effort, shape (drives, poses). [N m or N]"""
    return partial(worst_efforts, load=load)


def effort_max(load: Load) -> Field:
    """Return the field of the greatest effort of any drive, shape (poses,). [N m or N]"""
    return lambda block: np.max(worst_efforts(block, load), axis=0)


def determinant(block: Configuration) -> Floats:
    """Return the field of det Jx, shape (poses,). [m to the number of turns]"""
    return block.determinants


def actuators(block: Configuration) -> Floats:
    """Return the field of the drive coordinates, shape (drives, poses). [rad or m]"""
    return block.actuators


def condition_number(block: Configuration) -> Floats:
    """Return the field of the condition number of Jx, shape (poses,); NaN where it is infinite.

    Turns are measured at the characteristic length.
    """
    numbers = block.condition_numbers
    return np.where(np.isinf(numbers), np.nan, numbers)


def pressure_angle(block: Configuration) -> Floats:
    """Return the field of the greatest pressure angle of any drive, shape (poses,). [rad]"""
    greatest: Floats = np.max(block.pressure_angles, axis=0)
    return greatest
