"""From proposals to modes: polished, closed, each once, with all that is told of one."""

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.assembly.braked import BrakedLegs, determinants
from mechanics.assembly.guess import close_legs
from mechanics.assembly.modes import Modes
from mechanics.assembly.proposals import Proposals
from mechanics.kernels.placing import TURNING_NONE
from mechanics.legs import STRUT
from mechanics.mechanism import Mechanism
from mechanics.rotations import move, product, wrapped

_ROUGH = 0.1
"""Proposals that miss by more of the mechanism's size are not polished."""

_STEPS = 40
SINGULAR = 1e-6
"""Jx is singular if its least singular value is not above this share of the greatest, and its
determinant 0 if not above this, turns measured at the characteristic length."""

_AWAY = 0.02
"""How far such a mode is left, as a share of the mechanism's size."""

_SAME = 1e-12
"""Two modes are one if half-way between them no rod is off by more, of the mechanism's extent."""

_ROUNDING = 8.0 * 2.0**-52
"""What is known of a rod, as a share of the mechanism's size, its distance from 0 included."""

_CLOSE = 0.02
"""Modes further apart than this, of the mechanism's size or in rad, are never one."""


def settle(legs: BrakedLegs, proposals: Proposals) -> Modes:
    """Return the modes among the proposals: those at which Newton's iteration closes the legs."""
    braked = legs.take(proposals.cases)
    missed = np.abs(braked.errors(proposals.poses).excess).max(axis=0) / braked.sizes
    likely = np.flatnonzero(missed <= _ROUGH)
    closed = close_legs(braked.take(likely), proposals.poses[:, likely], _STEPS)
    cases = proposals.cases[likely[closed.converged]]
    return _distinct(describe(legs, cases, closed.poses[:, closed.converged]), legs)


def describe(legs: BrakedLegs, cases: Integers, poses: Floats) -> Modes:
    """Return what is told of modes at these poses, shape (coordinates, modes), of these cases."""
    mechanism, motion = legs.mechanism, legs.mechanism.motion
    poses = poses + 0.0  # no -0
    if motion.turning != TURNING_NONE:
        turns = slice(len(motion.translations), None)
        poses[turns] = wrapped(poses[turns])
    braked = legs.take(cases)
    errors = braked.errors(poses)
    signs, dets = branches(mechanism, errors.drive_rates), determinants(errors.rows)
    residuals = np.abs(errors.excess).max(axis=0) / braked.sizes
    found = Modes(cases, poses, signs, dets, sides(mechanism, dets), residuals)
    return found.take(np.lexsort((-dets, cases)))


def branches(mechanism: Mechanism, drive_rates: Floats) -> Integers:
    """Return the sign of the inverse solution that each leg is in, of Jpsi; shapes (legs, poses).

    A strut has no other than +1.
    """
    folded = (drive_rates > 0.0) & (mechanism.legs.drive != STRUT)[:, None]
    return np.where(folded, -1, 1).astype(np.int64)


def sides(mechanism: Mechanism, dets: Floats) -> Integers:
    """Return the signs of det Jx, and 0 where a mode is two in one or there is no determinant.

    Such a mode is known to about the root of rounding only, and so is its determinant.
    """
    lengths = mechanism.characteristic_length ** len(mechanism.motion.turns)
    clear = np.abs(dets) > SINGULAR * lengths
    return np.where(clear, np.sign(np.where(clear, dets, 0.0)), 0.0).astype(np.int64)


def _distinct(modes: Modes, legs: BrakedLegs) -> Modes:
    """Return the modes without repetitions.

    Two are one if the pose half-way closes the legs too: so do two copies of a mode, and the ends
    of the short stretch, about the root of rounding, within which a double mode is not told apart.
    """
    first, second = _neighbours(modes, legs)
    repeated = np.zeros(modes.cases.size, dtype=bool)
    repeated[second[_same(modes, first, second, legs)]] = True
    return modes.take(~repeated)


def _neighbours(modes: Modes, legs: BrakedLegs) -> tuple[Integers, Integers]:
    """Return the pairs of modes of one case whose positions are close, the earlier one first."""
    positions = modes.poses[: len(legs.mechanism.motion.translations)]
    limits = _CLOSE * legs.extents[modes.cases]
    nothing = np.empty(0, dtype=np.int64)
    found, aheads = [nothing], [nothing]
    for ahead in range(1, modes.cases.size):
        pairs = np.flatnonzero(modes.cases[:-ahead] == modes.cases[ahead:])
        if not pairs.size:
            break
        away = np.abs(positions[:, pairs + ahead] - positions[:, pairs]).max(axis=0, initial=0.0)
        close = pairs[away <= limits[pairs]]
        found.append(close)
        aheads.append(close + ahead)
    return np.concatenate(found), np.concatenate(aheads)


def loose(legs: BrakedLegs, modes: Modes) -> Booleans:
    """Return, shape (modes,), at which modes the platform can move while the drives stand still.

    A mode that is singular is left along its free motion; the iteration leads back to a double
    mode, but not back along a path on which the legs stay closed.
    """
    moving = np.zeros(modes.cases.size, dtype=bool)
    singular, ways = _free_motions(legs, modes)
    if singular.size:
        braked, start = legs.take(modes.cases[singular]), modes.poses[:, singular]
        gaps = _AWAY * braked.extents * ways
        led = close_legs(braked, move(legs.mechanism.motion, start, gaps), _STEPS)
        left = _gaps(legs, start, led.poses)
        far = np.abs(left).max(axis=0) > 0.3 * np.abs(gaps).max(axis=0)
        moving[singular] = far & led.converged
    return moving


def _free_motions(legs: BrakedLegs, modes: Modes) -> tuple[Integers, Floats]:
    """Return which modes are singular, and along which twist, shape (coordinates, those)."""
    scales = legs.mechanism.coordinate_scales
    rows = legs.take(modes.cases).errors(modes.poses).rows / scales[:, None]
    greatest = np.prod(np.linalg.norm(rows, axis=1), axis=0) * np.prod(scales)
    # No singular value is asked for where the determinant can tell.
    small = np.flatnonzero(np.abs(modes.determinants) <= SINGULAR * greatest)
    _, values, ways = np.linalg.svd(np.moveaxis(rows[..., small], 2, 0))
    open_ways = values[:, -1] <= SINGULAR * values[:, 0]
    return small[open_ways], ways[open_ways, -1].T / (scales * scales.max())[:, None]


def _same(modes: Modes, first: Integers, second: Integers, legs: BrakedLegs) -> Booleans:
    if not first.size:
        return np.zeros(0, dtype=bool)
    braked = legs.take(modes.cases[first])
    motion, start = legs.mechanism.motion, modes.poses[:, first]
    gaps = _gaps(legs, start, modes.poses[:, second])
    turning = np.any(motion.twists[3:], axis=0)
    scales = np.where(turning[:, None], 1.0, braked.extents)
    near = np.flatnonzero(np.abs(gaps / scales).max(axis=0, initial=0.0) <= _CLOSE)
    half = move(motion, start[:, near], 0.5 * gaps[:, near])
    braked = braked.take(near)
    excess = np.abs(braked.errors(half).excess).max(axis=0)
    same = np.zeros(first.size, dtype=bool)
    same[near] = excess <= np.maximum(_SAME * braked.extents, _ROUNDING * braked.sizes)
    return same


def _gaps(legs: BrakedLegs, start: Floats, end: Floats) -> Floats:
    """Return the small steps, along the motion's unit twists, from poses to others."""
    motion = legs.mechanism.motion
    gaps = end - start
    turns = slice(len(motion.translations), None)
    if len(motion.turns) == 1:
        gaps[turns] = wrapped(gaps[turns])
    if len(motion.turns) == 3:
        _, before = motion.place(start)
        _, after = motion.place(end)
        r = product(after, before[[0, 3, 6, 1, 4, 7, 2, 5, 8]])
        # The sine of the turn about its axis; turns of more than a right angle are far anyway.
        sines = 0.5 * np.stack([r[7] - r[5], r[2] - r[6], r[3] - r[1]])
        gaps[turns] = np.where(r[0] + r[4] + r[8] > 1.0, sines, np.pi)
    return gaps
