"""All assembly modes of a platform on six rods of given lengths.

Forty paths lead from a platform whose complex solutions are all known to this one's. If the ends
do not add up, the doubtful paths are followed again with care, then all of them from another start
in other frames; what is left over then, and platforms affinely related to their base, for which
the equations lose rank, is searched from random poses, without certainty.
"""

from dataclasses import dataclass
from functools import reduce
from typing import Literal

import numpy as np

from mechanics.arrays import Floats
from mechanics.assembly.endpoints import Endpoints, endpoints_of
from mechanics.assembly.normal_form import NormalForm, normal_form, poses
from mechanics.assembly.rods import Poses, Rods, distinct, improve, joined, search
from mechanics.assembly.starts import PATHS, Start, stored
from mechanics.errors import GeometryError
from mechanics.kernels.homotopy import track
from mechanics.kernels.normal_form import faulty_rod
from mechanics.kernels.path_steps import CAREFUL, SWIFT, Pace
from mechanics.kernels.quadrics import in_all_frames

Route = Literal["homotopy", "retracked", "restarted", "multistart"]

TOLERANCE = 1e-6
FINAL_TOLERANCE = 1e-7

TURNS = (0.0, 1.0, 2.3)
"""How far the axes are turned for each start. [rad]"""


@dataclass(frozen=True)
class SpatialModes:
    """All real poses in which six rods have given lengths, each once.

    Parameters
    ----------
    positions, rotations : arrays, shapes (modes, 3) and (modes, 3, 3), of the platform. [m, -]
    residuals : array, shape (modes,): by how much the worst rod misses its length. [m]
    certified : whether the forty complex solutions add up, so that no mode is missing.
    route : how they were found: by the paths as first followed, followed again with care,
        followed from another start, or from random poses.
    """

    positions: Floats
    rotations: Floats
    residuals: Floats
    certified: bool
    route: Route


def spatial_modes(base: Floats, platform: Floats, lengths: Floats) -> SpatialModes:
    """Return all assembly modes of a platform on six rods.

    Parameters
    ----------
    base : array, shape (6, 3): the rods' fixed ends; B of cranks and rails. [m]
    platform : array, shape (6, 3): their ends on the platform, in its frame. [m]
    lengths : array, shape (6,). [m]

    Raises
    ------
    GeometryError : a length is not above 0 or a number is not finite; with the leg.

    References
    ----------
    Dietmaier, The Stewart-Gough platform of general geometry can have 40 real postures, 1998;
    Sommese and Wampler, The numerical solution of systems of polynomials, 2005, ch. 7.
    """
    rods = Rods(*(np.ascontiguousarray(given, dtype=float) for given in (base, platform, lengths)))
    _check(rods)
    found: list[Poses] = []
    for number, (start, turn) in enumerate(zip(stored(), TURNS, strict=True)):
        form = normal_form(rods, turn)
        if form.affine:
            break
        ends, again = _follow_all(form, start, SWIFT if number == 0 else CAREFUL)
        modes, certified = _modes(rods, form, ends)
        if certified:
            route: Route = "restarted" if number else "retracked" if again else "homotopy"
            return _answer(modes, True, route)
        found.append(modes)
    every = reduce(joined, found, search(rods, np.random.default_rng(0)))
    return _answer(distinct(rods, every), False, "multistart")


def _check(rods: Rods) -> None:
    leg = faulty_rod(rods.base, rods.platform, rods.lengths)
    if leg >= 0:
        raise GeometryError(
            f"its ends must be finite and its length above 0 m; given {rods.base[leg]}, "
            f"{rods.platform[leg]} and {rods.lengths[leg]}",
            leg=leg,
        )


def _answer(modes: Poses, certified: bool, route: Route) -> SpatialModes:
    return SpatialModes(modes.positions, modes.rotations, modes.residuals, certified, route)


def _follow_all(form: NormalForm, start: Start, pace: Pace) -> tuple[Endpoints, bool]:
    """Return where the paths end, and whether some had to be followed again."""
    target = in_all_frames(form.coefficients)
    points, frames = np.empty_like(start.points), np.empty_like(start.frames)
    outcomes = np.empty(PATHS, dtype=np.int64)
    ends = (points, frames, outcomes)
    track(start.coefficients, target, start.points, start.frames, np.arange(PATHS), pace, *ends)
    found = endpoints_of(*ends, TOLERANCE, final=False)
    if not found.doubtful.any():
        return found, False
    # Both of a pair that fell together are doubtful: either may have jumped.
    chosen = np.flatnonzero(found.doubtful | found.multiple)
    track(start.coefficients, target, start.points, start.frames, chosen, CAREFUL, *ends)
    return endpoints_of(*ends, FINAL_TOLERANCE, final=True), True


def _modes(rods: Rods, form: NormalForm, ends: Endpoints) -> tuple[Poses, bool]:
    """Return the real modes, each once, and whether all ends add up to them."""
    improved = improve(rods, *poses(rods, form, ends.nearly_real_parts))
    modes = distinct(rods, improved)
    simple = ends.real[ends.nearly_real]
    apart = modes if simple.all() else distinct(rods, improved.take(simple))
    certified = len(apart.residuals) == np.count_nonzero(simple) and not ends.doubtful.any()
    return modes, bool(certified)
