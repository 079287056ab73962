"""Newton's iteration from guesses: the pose that the legs close at, near each of them."""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.assembly.braked import BrakedLegs, LegErrors
from mechanics.kernels.elimination import solve_each
from mechanics.kernels.newton import solve_rods
from mechanics.rotations import coordinates, move

CLOSED = 2e-14
"""Legs are closed where no rod's length is off by more, as a share of the greatest length."""

STEPS = 60
"""Steps that are tried at most, shortened ones included."""

_LARGEST_TURN = 0.7
"""No step turns further, nor moves further than the mechanism spans: rates say nothing of that."""

_SHORTEST = 2.0**-20


class Convergence(NamedTuple):
    """Where guesses have led, one column a guess.

    Parameters
    ----------
    poses : array, shape (coordinates, guesses), the best that was met. [m, rad]
    residuals : array, shape (guesses,): the greatest error of a rod's length over the greatest
        length of the mechanism.
    iterations : array, shape (guesses,): steps tried.
    converged : array, shape (guesses,): whether the legs are closed there.
    """

    poses: Floats
    residuals: Floats
    iterations: Integers
    converged: Booleans


def close_legs(legs: BrakedLegs, guesses: Floats, iterations: int = STEPS) -> Convergence:
    """Return where Newton's iteration on the leg equations leads from each guess.

    A step is the screw that would close all legs at once, shortened by halves until the sum of
    squared errors falls; at a singular pose the part of it that is determined. It ends where no
    step helps any more, so poses that are met are as exact as rounding lets them be.

    Parameters
    ----------
    legs : with drives that are `possible`.
    guesses : array, shape (coordinates, guesses), one a case. [m, rad]
    iterations : how many steps are tried at most.

    References
    ----------
    Glazunov et al., the iterative solution of the direct problem.
    """
    search = _Search(legs, guesses)
    for _ in range(iterations):
        if not search.going.size:
            break
        search.advance()
    residuals = np.abs(search.excess).max(axis=0) / search.sizes
    return Convergence(search.poses, residuals, search.tried, residuals <= CLOSED)


def close_nearby(legs: BrakedLegs, guesses: Floats, iterations: int = STEPS) -> Convergence:
    """Return what `close_legs` does, far sooner where legs are the six rods of a free platform.

    Many guesses go through one kernel then, with the same steps, none of them shortened by halves;
    those that it does not close are led again as all others are.
    """
    if legs.mechanism.motion.name != "spatial":
        return close_legs(legs, guesses, iterations)
    found = _closed_rods(legs, guesses, iterations)
    rest = np.flatnonzero(~found.converged)
    if not rest.size:
        return found
    led = close_legs(legs.take(rest), guesses[:, rest], iterations)
    for whole, part in zip(found, led, strict=True):
        whole[..., rest] = part
    return found


def _closed_rods(legs: BrakedLegs, guesses: Floats, iterations: int) -> Convergence:
    motion, count = legs.mechanism.motion, guesses.shape[1]
    positions, rotations = motion.place(np.ascontiguousarray(guesses))
    tried, missed = np.zeros(count, dtype=np.int64), np.empty(count)
    solve_rods(
        legs.rod_starts,
        legs.mechanism.legs.platform_point,
        legs.rod_lengths,
        positions,
        rotations,
        _LARGEST_TURN,
        iterations,
        tried,
        missed,
        np.empty(count, dtype=bool),
    )
    residuals = missed / legs.sizes
    poses = coordinates(motion, positions, rotations)
    return Convergence(poses, residuals, tried, residuals <= CLOSED)


class _Search:
    """Poses on their way; `going` are the cases that still may get better."""

    def __init__(self, legs: BrakedLegs, guesses: Floats) -> None:
        self.legs = legs
        self.sizes, self.extents = legs.sizes, legs.extents
        self.poses = np.array(guesses, dtype=float)
        errors = legs.errors(self.poses)
        self.excess = errors.excess
        self.steps = self._screws(errors, self.extents)
        self.shares = np.ones(self.sizes.size)
        self.tried = np.zeros(self.sizes.size, dtype=np.int64)
        self.going = np.flatnonzero(np.any(self.excess != 0.0, axis=0))

    def advance(self) -> None:
        """Try a step of every case that goes on."""
        legs, cases = self.legs.take(self.going), self.going
        steps = self.steps[:, cases] * self.shares[cases]
        poses = move(legs.mechanism.motion, self.poses[:, cases], steps)
        errors = legs.errors(poses)
        better = np.sum(errors.excess**2, axis=0) < np.sum(self.excess[:, cases] ** 2, axis=0)
        self.tried[cases] += 1
        self._keep(cases, better, poses, errors)
        self.shares[cases] = np.where(better, 1.0, 0.5 * self.shares[cases])
        self.going = cases[better | self._undecided(cases)]

    def _keep(self, cases: Integers, better: Booleans, poses: Floats, errors: LegErrors) -> None:
        kept = cases[better]
        self.poses[:, kept] = poses[:, better]
        self.excess[:, kept] = errors.excess[:, better]
        self.steps[:, kept] = self._screws(
            LegErrors(*(part[..., better] for part in errors)), self.extents[kept]
        )

    def _undecided(self, cases: Integers) -> Booleans:
        """Return whether shorter steps may help: not where only rounding is left."""
        rough = np.abs(self.excess[:, cases]).max(axis=0) > CLOSED * self.sizes[cases]
        undecided: Booleans = rough & (self.shares[cases] > _SHORTEST)
        return undecided

    def _screws(self, errors: LegErrors, extents: Floats) -> Floats:
        steps = np.empty(errors.rows.shape[1:])
        solve_each(np.ascontiguousarray(errors.rows), np.ascontiguousarray(errors.sides), steps)
        turning = np.any(self.legs.mechanism.motion.twists[3:], axis=0)
        turns = np.linalg.norm(steps[turning], axis=0) / _LARGEST_TURN
        shifts = np.linalg.norm(steps[~turning], axis=0) / extents
        short: Floats = steps / np.maximum(1.0, np.maximum(turns, shifts))
        return short
