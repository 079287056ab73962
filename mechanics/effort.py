"""Efforts: what the drives must bear under a load on the platform."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.kernels.efforts import known_efforts, part_norms
from mechanics.loads import Load


class WorstLoad(NamedTuple):
    """Per drive and pose, the load that asks most of the drive; shape (drives, 3, poses) each.

    Both are in the base frame and of the sign that makes the drive's total greatest; NaN where
    there is no effort. [N, N m]
    """

    force: Floats
    moment: Floats


def signed_efforts(block: Configuration, load: Load) -> Floats:
    """Return the efforts T = -J^-T P under the known load alone.

    Returns
    -------
    array, shape (drives, poses)
        NaN where a leg cannot reach or det Jx = 0. [N m or N]

    References
    ----------
    Laryushkin, Glazunov, Erastova, 2016, eq. (7), (8), where the minus was lost in print.
    """
    return _finite(known_efforts(block.effort_rows, load.known))


def worst_efforts(block: Configuration, load: Load) -> Floats:
    """Return the greatest efforts over all directions of the load's force and moment.

    With a_i and b_i the force and the moment part of row i of J^-T this is
    |T_i| = |(J^-T P0)_i| + F |a_i| + M |b_i|, P0 the known load on top.

    Returns
    -------
    array, shape (drives, poses)
        Not below 0; NaN where a leg cannot reach or det Jx = 0. [N m or N]

    References
    ----------
    Laryushkin, Glazunov, Erastova, 2016, "Computation of the maximal actuation efforts".
    """
    forces, moments = part_norms(block.effort_rows)
    known = np.abs(known_efforts(block.effort_rows, load.known))
    return _finite(known + load.force * forces + load.moment * moments)


def worst_load(block: Configuration, load: Load) -> WorstLoad:
    """Return, for each drive, the force and the moment at which `worst_efforts` is reached."""
    rows = block.effort_rows
    signs = np.where(known_efforts(rows, load.known) < 0.0, -1.0, 1.0)[:, None, :]
    sizes = part_norms(rows)
    parts = [
        0.0 - signs * size * _directions(part, norm)
        for part, norm, size in zip(
            (rows[:, :3], rows[:, 3:]), sizes, (load.force, load.moment), strict=True
        )
    ]
    return WorstLoad(*parts)


def _directions(vectors: Floats, norms: Floats) -> Floats:
    # A part of size 0 has no worst direction: any load of it is borne without effort.
    return vectors / np.where(norms == 0.0, 1.0, norms)[:, None, :]


def _finite(efforts: Floats) -> Floats:
    return np.where(np.isfinite(efforts), efforts, np.nan)
