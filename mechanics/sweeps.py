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
from mechanics.kernels.codes import INSIDE, UNSEEN
from mechanics.kernels.sweeps import ARCS_PER_TEST, sweep
from mechanics.kernels.turn_boxes import judge_boxes
from mechanics.mechanism import Mechanism
from mechanics.octree import Reach
from mechanics.turns import Turn
from mechanics.workspace import BLOCK

NODES_SWEPT = 16384
"""Nodes told together by closed forms alone."""
NODES_SEARCHED = 128
"""Nodes whose arcs are searched together: each has hundreds of angles."""
ANGLES_SEARCHED = 1 << 16
"""Angles looked at together, of all nodes: each has the margins of many parts."""
NO_PART = 255
FEWEST_SWEPT = 16
"""Boxes of no more nodes cost as much to judge as their nodes, where closed forms tell these."""

Tests = tuple[tuple[Integers, Integers, Integers], Floats]


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
    tests, count = tests_of(conditions), poses.shape[1]
    most = 1 + ARCS_PER_TEST * len(tests[1])
    codes, counts = np.empty(count, np.uint8), np.empty(count, np.int64)
    starts, stops = np.empty((most, count)), np.empty((most, count))
    places, ends = turn.places(poses), (turn.low, turn.high)
    sweep(*tests, mechanism.legs, places, ends, every, codes, counts, starts, stops)
    owners = np.repeat(np.arange(count), counts)
    numbers = np.arange(owners.size) - np.repeat(np.cumsum(counts) - counts, counts)
    return codes, Arcs(owners, starts[numbers, owners], stops[numbers, owners])


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

    @property
    def fewest(self) -> int:
        """How many nodes a box must have more than to be judged."""
        return FEWEST_SWEPT if swept(self.conditions) == len(self.conditions) else 1

    def judge(self, poses: Floats, reach: Reach) -> Bytes:
        """Return the codes that all poses of boxes have, `UNSEEN` where they may differ.

        The conditions that have closed forms tell who is outside, and inside too if nothing else
        is asked for.
        """
        closed = self.conditions[: swept(self.conditions)]
        tests, ends = tests_of(closed), (self.turn.low, self.turn.high)
        codes = np.empty(poses.shape[1], np.uint8)
        places = self.turn.places(poses)
        judge_boxes(*tests, self.mechanism.legs, places, reach, ends, self.every, codes)
        if len(closed) < len(self.conditions) or (self.measured and not self.every):
            codes[codes == INSIDE] = UNSEEN
        return codes

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
        codes, arcs = arcs_left(self.mechanism, closed, self.turn, poses, every=self.every)
        if len(closed) < len(self.conditions) and not self.every and not self.measured:
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
