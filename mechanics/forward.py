"""Forward kinematics: where the platform can be at given drives, all its assembly modes."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.assembly import spheres, spherical, tetrahedra, turning
from mechanics.assembly.aspects import UNKNOWN, left_modes
from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.guess import STEPS, close_nearby
from mechanics.assembly.modes import Assemblies, Modes, NearbyModes
from mechanics.assembly.normal_form import normal_form
from mechanics.assembly.proposals import Proposals
from mechanics.assembly.rods import Rods
from mechanics.assembly.settling import describe, loose, settle
from mechanics.assembly.spatial import spatial_modes
from mechanics.errors import ActuatorsError
from mechanics.mechanism import Mechanism
from mechanics.rotations import coordinates, principal_angles
from mechanics.wrists import Wrist

IMPOSSIBLE = "impossible drives"
"""The route where drives cannot stand so: a strut of no length."""


def assembly_modes(mechanism: Mechanism, actuators: Floats) -> Assemblies:
    """Return all assembly modes at each row of drive coordinates, each once.

    The motors of a wrist hold one orientation. It is told by its principal angles, so motors that
    stand whole turns on have the same modes.

    Parameters
    ----------
    mechanism : its working mode does not matter: a mode tells its own.
    actuators : array, shape (rows, drives). [rad or m]

    Raises
    ------
    ActuatorsError : `actuators` has another number of columns than there are drives.
    """
    columns = _columns(mechanism, actuators)
    if mechanism.wrist is not None:
        return _wristed_modes(mechanism, mechanism.wrist, columns)
    legs = BrakedLegs(mechanism, columns)
    possible = np.flatnonzero(legs.possible)
    routes, certified = [IMPOSSIBLE] * columns.shape[1], np.ones(columns.shape[1], dtype=bool)
    braked = legs.take(possible)
    proposals = _proposals(braked) if possible.size else _no_proposals(mechanism)
    modes = settle(braked, proposals)
    certified[possible] = proposals.certified
    modes = modes._replace(cases=possible[modes.cases])
    certified[modes.cases[loose(legs, modes)]] = False
    for row, route in zip(possible, proposals.routes, strict=True):
        routes[row] = route
    return Assemblies(modes, tuple(routes), certified)


def nearby_modes(
    mechanism: Mechanism, actuators: Floats, guesses: Floats, iterations: int = STEPS
) -> NearbyModes:
    """Return the mode to which Newton's iteration leads from each row's guess.

    Not to converge is an answer: the pose is then the best that was met, and the guess itself,
    without determinant or residual, where the drives cannot stand so.

    Parameters
    ----------
    actuators : array, shape (rows, drives). [rad or m]
    guesses : array, shape (rows, coordinates); turns that a wrist makes need no guess. [m, rad]
    iterations : how many steps are tried at most.

    Raises
    ------
    ActuatorsError, PoseError : another number of columns than drives, or than coordinates.

    References
    ----------
    Glazunov et al., the iterative solution of the direct problem.
    """
    columns, start = _columns(mechanism, actuators), mechanism.columns(guesses)
    if start.shape[1] != columns.shape[1]:
        raise ActuatorsError(np.shape(actuators), mechanism.drive_count, rows=start.shape[1])
    if mechanism.wrist is not None:
        return _wristed_nearby(mechanism, mechanism.wrist, columns, start[:3], iterations)
    return _nearby(BrakedLegs(mechanism, columns), start, iterations)


def _nearby(legs: BrakedLegs, start: Floats, iterations: int) -> NearbyModes:
    found = _nowhere(legs, start)
    possible = np.flatnonzero(legs.possible)
    braked, guesses = legs.take(possible), np.ascontiguousarray(start[:, possible])
    with np.errstate(invalid="ignore", divide="ignore"):
        closed = close_nearby(braked, guesses, iterations)
        modes = describe(braked, np.arange(possible.size), closed.poses)
        left = np.where(closed.converged, left_modes(braked, guesses, modes), UNKNOWN)
    for whole, part in zip(found.modes[1:], modes[1:], strict=True):
        whole[..., possible] = part
    found.converged[possible], found.iterations[possible] = closed.converged, closed.iterations
    found.left[possible] = left
    return found


def _nowhere(legs: BrakedLegs, start: Floats) -> NearbyModes:
    """Return guesses, shape (coordinates, guesses), that have led nowhere."""
    count, signs = start.shape[1], (legs.mechanism.leg_count, start.shape[1])
    modes = Modes(
        np.arange(count),
        start.copy(),
        np.ones(signs, dtype=np.int64),
        np.full(count, np.nan),
        np.zeros(count, dtype=np.int64),
        np.full(count, np.nan),
    )
    tried = np.zeros(count, dtype=np.int64)
    return NearbyModes(modes, np.zeros(count, dtype=bool), tried, np.full(count, UNKNOWN))


def searched(mechanism: Mechanism, actuators: Floats) -> Booleans:
    """Return at which rows modes can only be searched for, from random poses; shape (rows,).

    So it is where six rods without structure join bodies that are affinely related.

    Parameters
    ----------
    actuators : array, shape (rows, drives). [rad or m]

    Raises
    ------
    ActuatorsError : `actuators` has another number of columns than there are drives.
    """
    columns = _columns(mechanism, actuators)
    found = np.zeros(columns.shape[1], dtype=bool)
    if mechanism.motion.name != "spatial" or mechanism.wrist is not None:
        return found
    legs = BrakedLegs(mechanism, columns)
    if tetrahedra.structure_of(legs) is None:
        starts, points = legs.rod_starts, mechanism.legs.platform_point
        for row in np.flatnonzero(legs.possible):
            start = np.ascontiguousarray(starts[:, :, row])
            rods = Rods(start, points, np.ascontiguousarray(legs.rod_lengths[:, row]))
            found[row] = normal_form(rods).affine
    return found


def _columns(mechanism: Mechanism, actuators: Floats) -> Floats:
    rows = np.asarray(actuators, dtype=float)
    if rows.ndim != 2 or rows.shape[1] != mechanism.drive_count:
        raise ActuatorsError(rows.shape, mechanism.drive_count)
    return np.ascontiguousarray(rows.T)


def _wristed_modes(mechanism: Mechanism, wrist: Wrist, columns: Floats) -> Assemblies:
    """Return the modes of the wrist's centre, each with the platform that the motors turn."""
    legs = mechanism.leg_count
    turns = principal_angles(wrist.angles(columns[legs:]))
    found = assembly_modes(mechanism.carrier, columns[:legs].T)
    return replace(found, modes=_on_wrist(mechanism, wrist, found.modes, turns))


def _wristed_nearby(
    mechanism: Mechanism, wrist: Wrist, columns: Floats, points: Floats, iterations: int
) -> NearbyModes:
    legs = mechanism.leg_count
    turns = principal_angles(wrist.angles(columns[legs:]))
    centres = wrist.centres(*mechanism.motion.place(np.vstack([points, turns])))
    found = nearby_modes(mechanism.carrier, columns[:legs].T, centres.T, iterations)
    return replace(found, modes=_on_wrist(mechanism, wrist, found.modes, turns))


def _on_wrist(mechanism: Mechanism, wrist: Wrist, modes: Modes, turns: Floats) -> Modes:
    """Return modes of the wrist's centre as those of the platform at angles, shape (3, cases)."""
    angles = turns[:, modes.cases]
    centres = np.ascontiguousarray(np.vstack([modes.poses, angles]))
    positions = wrist.positions(*mechanism.motion.place(centres))
    motors = np.ones((len(angles), modes.cases.size), dtype=np.int64)
    return modes._replace(
        poses=np.vstack([positions, angles]),
        working_modes=np.vstack([modes.working_modes, motors]),
        determinants=modes.determinants * mechanism.characteristic_length**3,
    )


def _proposals(legs: BrakedLegs) -> Proposals:
    motion = legs.mechanism.motion.name
    if motion == "spatial":
        found = tetrahedra.structure_of(legs)
        return tetrahedra.propose(legs, found) if found else _six_rods(legs)
    routes: dict[str, Callable[[BrakedLegs], Proposals]] = {
        "planar_translation": spheres.propose,
        "translation": spheres.propose,
        "planar": turning.propose,
        "schoenflies": turning.propose,
        "spherical": spherical.propose,
    }
    return routes[motion](legs)


def _no_proposals(mechanism: Mechanism) -> Proposals:
    nothing = np.empty((len(mechanism.motion.coordinates), 0))
    return Proposals(np.empty(0, dtype=np.int64), nothing, np.empty(0, dtype=bool), ())


def _six_rods(legs: BrakedLegs) -> Proposals:
    """Return proposals for all modes of six rods without structure, one case at a time."""
    starts, points = legs.rod_starts, legs.mechanism.legs.platform_point
    found = [
        spatial_modes(starts[:, :, case], points, legs.rod_lengths[:, case])
        for case in range(starts.shape[2])
    ]
    positions = np.concatenate([one.positions for one in found])
    rotations = np.concatenate([one.rotations for one in found]).reshape(-1, 9)
    return Proposals(
        np.repeat(np.arange(len(found)), [len(one.positions) for one in found]),
        coordinates(legs.mechanism.motion, positions.T, rotations.T),
        np.array([one.certified for one in found], dtype=bool),
        tuple(one.route for one in found),
    )
