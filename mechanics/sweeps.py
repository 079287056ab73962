"""All angles of one turn at once: where conditions hold together, and why nowhere else."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import takewhile

import numpy as np

from mechanics.arcs import Arcs, examined, narrowed, sampled
from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.configuration import Configuration
from mechanics.grid import Grid
from mechanics.kernels.bands import hold_at
from mechanics.kernels.sweeps import ARCS_PER_TEST, sweep
from mechanics.mechanism import Mechanism
from mechanics.turns import Turn
from mechanics.workspace import BLOCK, INSIDE

NODES_SWEPT = 16384
"""Nodes told together by closed forms alone."""
NODES_SEARCHED = 128
"""Nodes whose arcs are searched together: each has hundreds of angles."""
ANGLES_SEARCHED = 1 << 16
"""Angles looked at together, of all nodes: each has the margins of many parts."""
STRIDE = 8
"""Of so many neighbours one is asked first, and the others for what it found."""
NO_PART = 255

Tests = tuple[tuple[Integers, Integers, Integers], Floats]
Places = tuple[Floats, Floats, Floats]


def swept(conditions: Sequence[Condition]) -> int:
    """Return how many of the leading conditions are decided at all angles of a turn at once."""
    return len(list(takewhile(lambda c: c.turn_tests is not None, conditions)))


def arcs_left(
    mechanism: Mechanism,
    conditions: Sequence[Condition],
    turn: Turn,
    poses: Floats,
    *,
    every: bool = False,
) -> tuple[Bytes, Arcs]:
    """Return codes of poses, and on which arcs of a turn conditions with closed forms hold.

    Parameters
    ----------
    poses : array, shape (coordinates, poses); what they say of the turn does not matter.
    every : whether a pose is done with, and its code that of the part, as soon as any of the
        turn is missing; else when nothing of it is left.

    Returns
    -------
    codes : array, shape (poses,), 0 for those that own arcs.
    arcs : those on which all conditions hold together.
    """
    places = turn.places(poses)
    return _arcs(mechanism, tests_of(conditions), turn, places, every=every)


def codes_at_some(
    mechanism: Mechanism, conditions: Sequence[Condition], turn: Turn, poses: Floats
) -> Bytes:
    """Return the codes that `arcs_left` does, sooner where neighbours have an angle in common.

    Every eighth pose is asked for its arcs, and the seven beside it for the middle of one; only
    those that do not hold there are asked for arcs of their own.
    """
    places, tests = turn.places(poses), tests_of(conditions)
    few = slice(0, None, STRIDE)
    codes = np.full(poses.shape[1], INSIDE, np.uint8)
    codes[few], counts, starts, stops = _swept(mechanism, tests, turn, _chosen(places, few))
    middles = np.where(counts > 0, 0.5 * (starts[0] + stops[0]), np.nan)
    cosines, sines = (np.repeat(f(middles), STRIDE)[: codes.size] for f in (np.cos, np.sin))
    holds = np.empty(codes.size, np.bool_)
    hold_at(*tests, mechanism.legs, places, cosines, sines, holds)
    holds[few] = True
    rest = np.flatnonzero(~holds)
    codes[rest] = _swept(mechanism, tests, turn, _chosen(places, rest))[0]
    return codes


def _arcs(
    mechanism: Mechanism, tests: Tests, turn: Turn, places: Places, *, every: bool = False
) -> tuple[Bytes, Arcs]:
    """Return what `arcs_left` does, of places."""
    codes, counts, starts, stops = _swept(mechanism, tests, turn, places, every=every)
    owners = np.repeat(np.arange(codes.size), counts)
    numbers = np.arange(owners.size) - np.repeat(np.cumsum(counts) - counts, counts)
    return codes, Arcs(owners, starts[numbers, owners], stops[numbers, owners])


def _swept(
    mechanism: Mechanism, tests: Tests, turn: Turn, places: Places, *, every: bool = False
) -> tuple[Bytes, Integers, Floats, Floats]:
    """Return codes, numbers of arcs, and where these start and stop, shape (arcs, poses) each."""
    count, most = places[0].shape[1], 1 + ARCS_PER_TEST * len(tests[1])
    codes, counts = np.empty(count, np.uint8), np.empty(count, np.int64)
    starts, stops = np.empty((most, count)), np.empty((most, count))
    ends = turn.low, turn.high
    sweep(*tests, mechanism.legs, places, ends, every, codes, counts, starts, stops)
    return codes, counts, starts, stops


def _chosen(places: Places, chosen: slice | Integers) -> Places:
    """Return the chosen places; one rotation and axis that stand for all still do."""
    positions, rotations, axes = (
        part if part.shape[1] == 1 else np.ascontiguousarray(part[:, chosen]) for part in places
    )
    return positions, rotations, axes


def tests_of(conditions: Sequence[Condition]) -> Tests:
    """Return what kernels take of conditions: tests, legs, numbers of conditions; and bounds."""
    tests = [
        (test.test, leg, number, test.least, test.greatest)
        for number, condition in enumerate(conditions)
        for test, leg in zip(condition.turn_tests or (), condition.legs, strict=True)
    ]
    table = np.array(tests, dtype=float).reshape(-1, 5)
    columns = np.ascontiguousarray(table[:, :3].T.astype(np.int64))
    return (columns[0], columns[1], columns[2]), np.ascontiguousarray(table[:, 3:])


@dataclass(frozen=True)
class Sweep:
    """Conditions, at one orientation but for one turn, asked at all angles of that."""

    mechanism: Mechanism
    conditions: Sequence[Condition]
    grid: Grid
    turn: Turn
    every: bool
    measured: bool

    def verdicts(self, nodes: Integers) -> tuple[Bytes, Floats]:
        """Return the codes of flat nodes, and the share of the turn at which all holds."""
        parts = [
            self._block(nodes[at : at + self._together])
            for at in range(0, nodes.size, self._together)
        ]
        if not parts:
            return np.empty(0, np.uint8), np.empty(0)
        codes, sizes = (np.concatenate(column) for column in zip(*parts, strict=True))
        return codes, sizes

    @property
    def _together(self) -> int:
        if swept(self.conditions) == len(self.conditions):
            return NODES_SWEPT
        angles = 1 + math.ceil((self.turn.high - self.turn.low) / self.turn.step)
        return max(1, min(NODES_SEARCHED, ANGLES_SEARCHED // angles))

    def _block(self, nodes: Integers) -> tuple[Bytes, Floats]:
        poses = self.grid.poses_at(nodes)
        closed = self.conditions[: swept(self.conditions)]
        if len(closed) == len(self.conditions) and not self.measured and not self.every:
            codes = codes_at_some(self.mechanism, closed, self.turn, poses)
            return codes, (codes == INSIDE).astype(np.float64)
        codes, arcs = arcs_left(self.mechanism, closed, self.turn, poses, every=self.every)
        if not self.every and not self.measured:
            arcs = arcs.of(~self._somewhere_inside(poses, arcs, nodes.size))
        first = 1
        for number, condition in enumerate(self.conditions):
            if number >= swept(self.conditions):
                arcs = self._search(condition, first, poses, codes, arcs)
            first += len(condition.legs)
        whole = self.turn.high - self.turn.low
        inside = (codes == INSIDE).astype(np.float64)
        return codes, arcs.measures(nodes.size) / whole if whole else inside

    def _somewhere_inside(self, poses: Floats, arcs: Arcs, count: int) -> Booleans:
        """Return which of so many owners meet all conditions at an angle that is tried first."""
        searched = self.conditions[swept(self.conditions) :]
        numbers, angles = sampled(arcs, self.turn.step)
        owners = arcs.owners[numbers]
        for condition in searched:
            parts = len(condition.legs)
            holds = self._at(poses, owners, angles, condition.check, parts) >= 0.0
            kept = np.all(holds, axis=0)
            owners, angles = owners[kept], angles[kept]
        inside: Booleans = np.bincount(owners, minlength=count) > 0
        return inside

    def _search(
        self, condition: Condition, first: int, poses: Floats, codes: Bytes, arcs: Arcs
    ) -> Arcs:
        """Write codes, from `first` on, where a condition leaves nothing; return what it leaves."""

        def look(owners: Integers, angles: Floats) -> Floats:
            return self._at(poses, owners, angles, condition.check, len(condition.legs))

        def determinants(owners: Integers, angles: Floats) -> Floats:
            signs: Floats = self._at(poses, owners, angles, lambda b: b.determinants[None], 1)[0]
            return signs

        signs = determinants if condition.fails_at_singularities else None
        samples = examined(arcs, self.turn.step, look, signs)
        broken = np.full(codes.size, NO_PART)
        missed = ~samples.holds
        some = missed.any(axis=0)
        np.minimum.at(broken, samples.owners[some], np.argmax(missed[:, some], axis=0))
        if self.every:
            lost = broken != NO_PART
            arcs = arcs.of(~lost)
        else:
            kept = narrowed(samples, look)
            lost = arcs.own(codes.size) & ~kept.own(codes.size)
            arcs = kept
        codes[lost] = first + broken[lost]
        return arcs

    def _at(
        self,
        poses: Floats,
        owners: Integers,
        angles: Floats,
        ask: Callable[[Configuration], Floats],
        parts: int,
    ) -> Floats:
        """Return an answer, shape (parts, angles), of owners at angles, block by block."""
        answers = np.empty((parts, owners.size))
        for at in range(0, owners.size, BLOCK):
            own = slice(at, at + BLOCK)
            turned = self.turn.poses(poses, owners[own], angles[own])
            answers[:, own] = ask(Configuration(self.mechanism, turned))
        return answers
