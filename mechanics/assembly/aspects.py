"""Whether a guess and the mode reached from it are parted by singularities.

A guess stands for the mechanism there, its drives as near to those given as the legs let them be.
Where det Jx has another sign than at the mode reached, every motion of the mechanism from one to
the other passes a singularity of type 2; where a leg is in another working mode, one of type 1.
Two singularities on the way bring both signs back: that is not seen, and modes of one sign may be
in aspects that do not touch.

References
----------
Chablat, Wenger, Working modes and aspects in fully parallel manipulators, 1998.
"""

from dataclasses import replace

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.assembly.braked import BrakedLegs, determinants
from mechanics.assembly.modes import Modes
from mechanics.assembly.settling import branches, sides
from mechanics.configuration import Configuration
from mechanics.drives import TOLERANCE, elbow_cosines
from mechanics.legs import CRANK, STRUT
from mechanics.rotations import wrapped

UNKNOWN = -1
"""A leg does not reach to the guess, or one end of the way is itself singular."""


def left_modes(legs: BrakedLegs, guesses: Floats, reached: Modes) -> Integers:
    """Return, shape (guesses,), 1 where a guess has left its mode, 0 where not, or `UNKNOWN`.

    Parameters
    ----------
    legs : with the drives that are given, one case a guess.
    guesses : array, shape (coordinates, guesses). [m, rad]
    reached : the mode that each guess leads to, in their order.
    """
    drives = nearest_drives(legs, guesses)
    standing = np.all(np.isfinite(drives), axis=0)
    there = BrakedLegs(legs.mechanism, drives).errors(guesses)
    product = sides(legs.mechanism, determinants(there.rows)) * reached.sides
    left = np.where(product < 0, 1, np.where(product > 0, 0, UNKNOWN))
    turned = branches(legs.mechanism, there.drive_rates) != reached.working_modes
    odd = np.flatnonzero(np.any(turned, axis=0) & standing)
    if odd.size:
        here = legs.take(odd).errors(reached.poses[:, odd])
        before, after = there.drive_rates[:, odd], here.drive_rates
        left[odd[_parted(legs, before, after)]] = 1
    left[~standing] = UNKNOWN
    return left.astype(np.int64)


def nearest_drives(legs: BrakedLegs, poses: Floats) -> Floats:
    """Return the inverse solution of each leg next to its drive; NaN where it does not reach.

    Shapes (legs, cases) and (coordinates, cases). [rad or m]
    """
    of = legs.mechanism.legs
    ahead, back = (
        Configuration(
            replace(legs.mechanism, legs=of._replace(working_mode=np.full(of.drive.size, sign))),
            poses,
        ).actuators
        for sign in (1.0, -1.0)
    )
    turning = (of.drive == CRANK)[:, None]
    gaps = [other - legs.actuators for other in (ahead, back)]
    first, second = (np.abs(np.where(turning, wrapped(gap), gap)) for gap in gaps)
    nearest: Floats = np.where(second < first, back, ahead)
    return nearest


def _parted(legs: BrakedLegs, before: Floats, after: Floats) -> Integers:
    """Return the columns at which some leg is bent one way first, and then clearly the other."""
    of = legs.mechanism.legs
    first, second = elbow_cosines(of, before), elbow_cosines(of, after)
    clear = np.minimum(np.abs(first), np.abs(second)) > TOLERANCE
    bent = (first * second < 0.0) & clear & (of.drive != STRUT)[:, None]
    return np.flatnonzero(np.any(bent, axis=0))
