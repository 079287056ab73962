"""Workspaces over many orientations: where conditions hold at some of them, or at every one."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from mechanics import octree
from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.grid import Grid
from mechanics.kernels.all_round import PAIRS, Asked, try_all_round
from mechanics.kernels.codes import INSIDE, UNSEEN
from mechanics.kernels.orientations import at_every, at_some
from mechanics.lines import provable
from mechanics.mechanism import Mechanism
from mechanics.sweeps import Sweep, swept, tests_of
from mechanics.turns import Turn
from mechanics.workspace import BLOCK, Scan, codes_of, line_runs, ranks_of, scan

FRAMES = 4096
"""Orientations that one call of a kernel takes."""
FEW = 512
"""Nodes that are rather tried at several orientations together than along lines at one."""


@dataclass(frozen=True)
class Orientations:
    """The orientations that a workspace's type runs over.

    Parameters
    ----------
    grid : a grid of turns of the platform, each orientation tried by itself; it may have no axes.
        Its `fixed` is that of the positions' grid.
    turn : one more turn, over all of its angles, together with each orientation of the grid.
    extent : the size of the whole range. [rad to the number of turns]
    """

    grid: Grid
    turn: Turn | None
    extent: float

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The turns that the range is of."""
        last = () if self.turn is None else (self.turn.coordinate,)
        return (*(axis.coordinate for axis in self.grid.axes), *last)


@dataclass(frozen=True)
class Question:
    """What is asked of the nodes of a grid of positions at many orientations.

    Parameters
    ----------
    grid : positions; what its `fixed` says of turns does not matter.
    every : whether conditions must hold at every orientation, not at some.
    measured : whether the field `free_orientation` is kept, the size of the part of the range at
        which the conditions hold. [rad to the number of turns]
    """

    mechanism: Mechanism
    conditions: Sequence[Condition]
    grid: Grid
    orientations: Orientations
    every: bool
    measured: bool

    def turned(self, orientation: int) -> Grid:
        """Return the grid of the same positions at one orientation of the orientations' grid."""
        tried = self.orientations.grid.poses(orientation, orientation + 1)
        return replace(self.grid, fixed=tried[:, 0])

    def sweep(self, grid: Grid, turn: Turn) -> Sweep:
        """Return what is asked at one orientation and all angles of a turn."""
        return Sweep(self.mechanism, self.conditions, grid, turn, self.every, self.measured)

    def asked(self, turn: Turn) -> Asked:
        """Return what kernels are asked of pairs of a node and an orientation."""
        ends, ranks = (turn.low, turn.high), ranks_of(self.conditions)
        tests = tests_of(self.conditions)
        return Asked(*tests, self.mechanism.legs, ends, self.every, self.measured, ranks)

    @property
    def unseen(self) -> int:
        """The code of a node that no orientation was tried at."""
        return INSIDE if self.every else UNSEEN


def all_round(conditions: Sequence[Condition], orientations: Orientations) -> bool:
    """Return whether many orientations are tried at once, each with all angles of a turn."""
    closed = swept(conditions) == len(conditions)
    return closed and orientations.turn is not None and bool(orientations.grid.axes)


def scan_orientations(question: Question, start: int, stop: int, *, by_boxes: bool = True) -> Scan:
    """Return which flat nodes `start` to `stop` belong at some, or at every, orientation.

    A node's code is 0 if all conditions hold together at some orientation, or at every one; else
    that of the first condition at which no orientation is left, or which any breaks, with the
    first of its parts that does.

    Parameters
    ----------
    by_boxes : whether nodes are told many at once where bounds allow it; else all of them one by
        one, with the same result.
    """
    codes = np.full(stop - start, question.unseen, np.uint8)
    held = np.zeros(codes.size)
    tried = _Tried(question, start, codes, held, by_boxes)
    orientations = question.orientations
    turn = orientations.turn
    if turn is not None and all_round(question.conditions, orientations):
        tried.all_round(turn)
    else:
        at = 0
        while at < orientations.grid.size and tried.undecided.any():
            at = tried.in_order(at, turn)
    values, lengths = line_runs(codes, start, question.grid.shape[-1])
    if not question.measured:
        return Scan(values, lengths, {})
    share = orientations.extent / orientations.grid.size
    return Scan(values, lengths, {"free_orientation": tried.held[codes == INSIDE] * share})


@dataclass(frozen=True)
class _Tried:
    """What is asked of the flat nodes from `start` on, and what is known of them so far.

    `codes`, and in how many orientations, or shares of their turns, all conditions held.
    """

    question: Question
    start: int
    codes: Bytes
    held: Floats
    by_boxes: bool

    @property
    def _stop(self) -> int:
        return self.start + self.codes.size

    @cached_property
    def _ranks(self) -> Floats:
        return ranks_of(self.question.conditions)

    def all_round(self, turn: Turn) -> None:
        """Try all orientations, each with all angles of a turn, by closed forms."""
        orientations, asked = self.question.orientations.grid, self.question.asked(turn)
        positions = turn.positions(self.question.grid.poses(self.start, self._stop))
        for first in range(0, orientations.size, FRAMES):
            poses = orientations.poses(first, min(first + FRAMES, orientations.size))
            try_all_round(asked, positions, turn.frames(poses), self.codes, self.held, PAIRS)

    def in_order(self, first: int, turn: Turn | None) -> int:
        """Try an orientation, or of few nodes some at once; return which one is next."""
        nodes = np.flatnonzero(self.undecided)
        if turn is not None:
            self.by_arcs(self.question.turned(first), turn)
        elif nodes.size > FEW:
            self.by_lines(self.question.turned(first))
        else:
            behind = min(first + BLOCK // nodes.size, self.question.orientations.grid.size)
            self.by_poses(nodes, first, behind)
            return behind
        return first + 1

    def by_poses(self, nodes: Integers, first: int, behind: int) -> None:
        """Try nodes, counted from `start` on, at each of some orientations by itself."""
        question, turned = self.question, self.question.orientations.grid
        poses = np.tile(question.grid.poses_at(self.start + nodes), behind - first)
        turns = list(turned.columns)
        poses[turns] = np.repeat(turned.poses(first, behind)[turns], nodes.size, axis=1)
        found = codes_of(question.mechanism, question.conditions, poses).reshape(-1, nodes.size)
        codes = self.codes[nodes]
        for fresh in found:
            self._put(fresh, codes)
        self.codes[nodes] = codes
        self.held[nodes] += np.count_nonzero(found == INSIDE, axis=0)

    def by_lines(self, grid: Grid) -> None:
        """Try the one orientation of a grid of the same positions, along its lines."""
        among = None if self.question.measured else self._open
        found = scan(
            *(self.question.mechanism, self.question.conditions, grid, {}, self.start, self._stop),
            by_boxes=self.by_boxes,
            among=among,
        )
        fresh = np.repeat(found.codes, found.lengths)
        self._put(fresh, self.codes)
        self.held[:] += fresh == INSIDE

    def by_arcs(self, grid: Grid, turn: Turn) -> None:
        """Try the one orientation of a grid of the same positions, at all angles of a turn."""
        sweep = self.question.sweep(grid, turn)
        sizes, open_ = np.zeros(self.codes.size), self.undecided

        def ask(nodes: Integers) -> Bytes:
            codes, sizes[nodes - self.start] = sweep.verdicts(nodes)
            return codes

        if self.by_boxes:
            fresh = octree.decide(
                self.question.mechanism.motion,
                grid,
                self.start,
                self._stop,
                sweep.judge,
                ask,
                among=None if open_.all() else open_,
                fewest=sweep.fewest,
            )
        else:
            fresh = np.full(self.codes.size, self.question.unseen, np.uint8)
            fresh[open_] = ask(self.start + np.flatnonzero(open_))
        if self.question.every and self.question.measured:
            # Of measured nodes whole boxes are inside only where all of the turn is.
            sizes[fresh == INSIDE] = 1.0
        self._put(fresh, self.codes)
        self.held[:] += sizes

    def _put(self, fresh: Bytes, codes: Bytes) -> None:
        """Put what a fresh orientation says into the codes of nodes."""
        if self.question.every:
            at_every(fresh, codes)
        else:
            at_some(fresh, self._ranks, codes)

    @property
    def _open(self) -> Booleans:
        """For which nodes the conditions that lines do not tell can still change anything."""
        if self.question.every:
            undecided: Booleans = (self.codes == INSIDE) | (self.codes >= self._untold)
            return undecided
        missing: Booleans = self.codes != INSIDE
        return missing

    @cached_property
    def _untold(self) -> int:
        """The first code of the conditions that lines do not tell."""
        conditions = self.question.conditions
        told = conditions[: provable(self.question.mechanism, conditions, self.question.grid)]
        return 1 + sum(len(condition.legs) for condition in told)

    @property
    def undecided(self) -> Booleans:
        """Which nodes another orientation can still change."""
        # The first code cannot become an earlier one.
        settled = (
            self.codes == 1
            if self.question.every
            else (self.codes == INSIDE) & (not self.question.measured)
        )
        open_: Booleans = ~settled
        return open_
