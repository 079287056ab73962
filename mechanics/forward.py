"""Forward kinematics: where the platform can be at given drives, all its assembly modes."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.assembly import spheres, spherical, tetrahedra, turning
from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.guess import STEPS, close_nearby
from mechanics.assembly.normal_form import normal_form
from mechanics.assembly.proposals import Proposals
from mechanics.assembly.rods import Rods
from mechanics.assembly.settling import SINGULAR, Modes, describe, loose, settle
from mechanics.assembly.spatial import spatial_modes
from mechanics.errors import ActuatorsError
from mechanics.mechanism import Mechanism, WorkingMode
from mechanics.rotations import coordinates, principal_angles
from mechanics.wrists import Wrist

IMPOSSIBLE = "impossible drives"
"""The route where drives cannot stand so: a strut of no length."""


@dataclass(frozen=True)
class AssemblyMode:
    """One place of the platform at which the legs close.

    Parameters
    ----------
    pose : array, shape (coordinates,). [m, rad]
    working_mode : the signs with which the inverse solution gives the drives back.
    determinant : of Jx as it is; modes of one sign are on one side of singularities of type 2,
        and one that is 0 is two modes in one. [m to the number of turns]
    residual : the greatest error of a rod's length over the mechanism's greatest length.
    """

    pose: Floats
    working_mode: WorkingMode
    determinant: float
    residual: float


@dataclass(frozen=True)
class Assembly:
    """All that is found for one row of drive coordinates.

    Parameters
    ----------
    modes : by falling determinant; none where the drives are out of reach.
    route : how they were found: `closed form`, `one angle`, `tetrahedra`, a route of
        `mechanics.assembly.spatial`, or `IMPOSSIBLE`.
    certified : whether these are all. Not so where the platform can move while the drives stand
        still, and where the route itself cannot tell.
    """

    modes: tuple[AssemblyMode, ...]
    route: str
    certified: bool


@dataclass(frozen=True)
class NearbyMode:
    """Where Newton's iteration from a guess has led; `mode` holds the drives only if converged."""

    mode: AssemblyMode
    converged: bool
    iterations: int


def assembly_modes(mechanism: Mechanism, actuators: Floats) -> list[Assembly]:
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
    found = [Assembly((), IMPOSSIBLE, True)] * legs.actuators.shape[1]
    if not possible.size:
        return found
    braked = legs.take(possible)
    proposals = _proposals(braked)
    modes = settle(braked, proposals)
    certified = proposals.certified.copy()
    certified[modes.cases[loose(braked, modes)]] = False
    bounds = np.searchsorted(modes.cases, np.arange(possible.size + 1))
    every = [_mode(modes, i) for i in range(modes.cases.size)]
    for case, row in enumerate(possible):
        own = tuple(every[bounds[case] : bounds[case + 1]])
        found[row] = Assembly(own, proposals.routes[case], bool(certified[case]))
    return found


def nearby_modes(
    mechanism: Mechanism, actuators: Floats, guesses: Floats, iterations: int = STEPS
) -> list[NearbyMode]:
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


def _nearby(legs: BrakedLegs, start: Floats, iterations: int) -> list[NearbyMode]:
    signs = (1,) * legs.mechanism.leg_count
    nowhere = [AssemblyMode(guess.copy(), signs, np.nan, np.nan) for guess in start.T]
    found = [NearbyMode(mode, converged=False, iterations=0) for mode in nowhere]
    possible = np.flatnonzero(legs.possible)
    braked = legs.take(possible)
    with np.errstate(invalid="ignore", divide="ignore"):
        closed = close_nearby(braked, start[:, possible], iterations)
        modes = describe(braked, np.arange(possible.size), closed.poses)
    for i, row in enumerate(possible):
        reached = bool(closed.converged[i])
        found[row] = NearbyMode(_mode(modes, i), reached, int(closed.iterations[i]))
    return found


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


def side(mechanism: Mechanism, determinant: float) -> int:
    """Return the sign of det Jx, and 0 where a mode is two in one or there is no determinant.

    Such a mode is known to about the root of rounding only, and so is its determinant.
    """
    lengths = mechanism.characteristic_length ** len(mechanism.motion.turns)
    return int(np.sign(determinant)) if abs(determinant) > SINGULAR * lengths else 0


def _columns(mechanism: Mechanism, actuators: Floats) -> Floats:
    rows = np.asarray(actuators, dtype=float)
    if rows.ndim != 2 or rows.shape[1] != mechanism.drive_count:
        raise ActuatorsError(rows.shape, mechanism.drive_count)
    return np.ascontiguousarray(rows.T)


def _wristed_modes(mechanism: Mechanism, wrist: Wrist, columns: Floats) -> list[Assembly]:
    """Return the modes of the wrist's centre, each with the platform that the motors turn."""
    legs = mechanism.leg_count
    turns = principal_angles(wrist.angles(columns[legs:]))
    found = assembly_modes(mechanism.carrier, columns[:legs].T)
    return [
        replace(one, modes=tuple(_on_wrist(mechanism, wrist, m, angles) for m in one.modes))
        for one, angles in zip(found, turns.T, strict=True)
    ]


def _wristed_nearby(
    mechanism: Mechanism, wrist: Wrist, columns: Floats, points: Floats, iterations: int
) -> list[NearbyMode]:
    legs = mechanism.leg_count
    turns = principal_angles(wrist.angles(columns[legs:]))
    centres = wrist.centres(*mechanism.motion.place(np.vstack([points, turns])))
    found = nearby_modes(mechanism.carrier, columns[:legs].T, centres.T, iterations)
    return [
        replace(one, mode=_on_wrist(mechanism, wrist, one.mode, angles))
        for one, angles in zip(found, turns.T, strict=True)
    ]


def _on_wrist(
    mechanism: Mechanism, wrist: Wrist, mode: AssemblyMode, angles: Floats
) -> AssemblyMode:
    """Return a mode of the wrist's centre as one of the platform at these angles, shape (3,)."""
    centre = np.concatenate([mode.pose, angles])[:, None]
    position = wrist.positions(*mechanism.motion.place(np.ascontiguousarray(centre)))
    return AssemblyMode(
        np.concatenate([position[:, 0], angles]),
        (*mode.working_mode, *(1,) * len(angles)),
        mode.determinant * mechanism.characteristic_length**3,
        mode.residual,
    )


def _mode(modes: Modes, i: int) -> AssemblyMode:
    return AssemblyMode(
        modes.poses[:, i].copy(),
        tuple(modes.working_modes[:, i].tolist()),
        float(modes.determinants[i]),
        float(modes.residuals[i]),
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
