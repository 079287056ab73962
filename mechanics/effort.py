"""Efforts: what the drives must bear under a load on the platform."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.kernels import batches, efforts
from mechanics.loads import Load
from mechanics.neighbourhoods import Margins, Neighbourhood


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
    columns, factors = block.twist_columns
    known: Floats = efforts.known_efforts(
        columns, block.determinants, factors, _in_coordinates(block, load)
    )
    return known


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
    motion = block.mechanism.motion
    translations = len(motion.translations)
    worst: Floats
    if block.has("cofactors") or block.mechanism.wrist is not None:
        columns, factors = block.twist_columns
        worst = efforts.worst_efforts(
            columns,
            block.determinants,
            factors,
            translations,
            load.force,
            load.moment,
            _in_coordinates(block, load),
        )
    else:
        worst = batches.worst_efforts(
            motion.kernel,
            block.mechanism.legs,
            block.poses,
            translations,
            load.force,
            load.moment,
            motion.twists.T @ load.known,
        )
    return worst


def worst_efforts_near(near: Neighbourhood, load: Load) -> Margins:
    """Return bounds on the greatest efforts near the centres, rounding included. [N m or N]

    Row i of J^-T is Jpsi times column i of Jx^-1, of which `near.mixing` says what others bring in.
    """
    rates = np.abs(near.centre.rods[1])
    rates = np.where(rates > 0.0, rates, np.nan)
    own = worst_efforts(near.centre, load) / rates
    known = np.zeros_like(own)
    if np.any(load.known):
        known = np.abs(signed_efforts(near.centre, load)) / rates
    falls, rises = near.size_changes((load.force, load.moment), own, known)
    blurs = near.blurs
    least = np.maximum(own - falls, 0.0) * near.rates[0] * (1.0 - blurs)
    return Margins(least, (own + rises) * near.rates[1] * (1.0 + blurs))


def worst_load(block: Configuration, load: Load) -> WorstLoad:
    """Return, for each drive, the force and the moment at which `worst_efforts` is reached."""
    rows = block.effort_rows
    signs = np.where(signed_efforts(block, load) < 0.0, -1.0, 1.0)[:, None, :]
    return WorstLoad(
        0.0 - signs * load.force * _directions(rows[:, :3]),
        0.0 - signs * load.moment * _directions(rows[:, 3:]),
    )


def _in_coordinates(block: Configuration, load: Load) -> Floats:
    """Return the known load, shape (coordinates, poses): what it does along each coordinate."""
    twists = block.mechanism.motion.twists
    shares = np.broadcast_to(twists.T @ load.known, (twists.shape[1], block.count))
    return np.ascontiguousarray(shares)


def _directions(vectors: Floats) -> Floats:
    norms = np.linalg.norm(vectors, axis=1)
    # A part of size 0 has no worst direction: any load of it is borne without effort.
    directions: Floats = vectors / np.where(norms == 0.0, 1.0, norms)[:, None, :]
    return directions
