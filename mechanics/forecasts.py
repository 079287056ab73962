"""What scans of workspaces will take, seen from a few nodes of their grids."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from mechanics import octree
from mechanics.arcs import Arcs, cells, sampled
from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.configuration import Configuration
from mechanics.fields import Field
from mechanics.grid import Grid
from mechanics.judging import asked_share
from mechanics.kernels.all_round import try_all_round
from mechanics.kernels.bands import NOTHING, REACH, SPAN
from mechanics.kernels.codes import INSIDE
from mechanics.legs import STRUT
from mechanics.lines import provable
from mechanics.mechanism import Mechanism
from mechanics.orientations import Question
from mechanics.sweeps import arcs_left, swept, tests_of
from mechanics.turns import Turn

NODES = 768
"""Nodes that are tried of a scan at one orientation."""
PAIRED = (32, 512)
"""Nodes and orientations that are tried where pairs of them are told by closed forms."""
IN_ORDER = (32, 48)
"""The same where orientations are tried one after the other: the first, and ever fewer."""
SWEPT, SEARCHED, ANGLES = 512, 48, 24
"""Nodes at all angles of a turn, those of them whose arcs are searched, and parts of a turn."""
PARALLEL = 1e-9
"""The sine of the angle between a leg's axis and that of a turn, at most, if they are parallel."""


class Met(NamedTuple):
    """What nodes of a scan at one orientation meet.

    Parameters
    ----------
    shares : array, shape (conditions + 1,), of all nodes, those for which the conditions before
        each one hold; at the end all of them.
    asked : of the nodes that lines leave, those that boxes leave to be asked by themselves.
    """

    shares: Floats
    asked: float


class Paired(NamedTuple):
    """What pairs of node and orientation cost: which share is weighed, and of which arcs are cut.

    `kernels.all_round` says what that means.
    """

    weighed: float
    cut: float


class Ways(NamedTuple):
    """Which tests are told at all angles of a turn by bounds on |d|^2, and which by roots of waves.

    Shape (tests,) each, the parts of conditions with closed forms; neither where nothing is tested.
    """

    by_bounds: Booleans
    by_roots: Booleans


class Seen(NamedTuple):
    """Poses of some nodes, and the codes and arcs of a turn that closed forms give these."""

    poses: Floats
    codes: Bytes
    arcs: Arcs


class Search(NamedTuple):
    """How often nodes meet the conditions that are searched on arcs of a turn.

    Shape (conditions searched,) each, a node of the grid: angles looked at to find one at which all
    hold, angles from which ends of arcs are sought, and owners of arcs on which they are.
    """

    first: Floats
    sought: Floats
    owners: Floats


def met_along_lines(
    mechanism: Mechanism,
    conditions: Sequence[Condition],
    grid: Grid,
    fields: Mapping[str, Field],
) -> Met:
    """Return what nodes meet at the one orientation of each, lines and boxes told first."""
    poses = grid.poses_at(_spread(grid.size, NODES))
    walked = provable(mechanism, conditions, grid)
    if walked == len(conditions) and not fields:
        return Met(np.ones(len(conditions) + 1), 1.0)
    depths = _depths(mechanism, conditions, poses)
    left = np.ascontiguousarray(poses[:, depths >= walked])
    share = 1.0 if fields else asked_share(mechanism, conditions[walked:], grid, left)
    return Met(_shares(depths, len(conditions)), share)


def met_in_order(question: Question) -> Floats:
    """Return what nodes meet at orientations tried by lines one by one; shape as in `Met`.

    Each is asked no more once another orientation cannot change what is known of it.
    """
    grid, turns = question.grid, question.orientations.grid
    nodes, tried = _spread(grid.size, IN_ORDER[0]), _in_order(turns.size, IN_ORDER[1])
    poses = np.repeat(turns.poses_at(tried), nodes.size, axis=1)
    columns = list(grid.columns)
    poses[columns] = np.tile(grid.poses_at(nodes)[columns], tried.size)
    conditions = question.conditions
    depths = _depths(question.mechanism, conditions, np.ascontiguousarray(poses))
    depths = depths.reshape(tried.size, nodes.size)
    walked = provable(question.mechanism, conditions, grid)
    open_ = np.ones(depths.shape, bool)
    if not question.measured:
        open_[1:] = _still_open(depths[:-1], walked, len(conditions), every=question.every)
    weights = np.diff(tried, append=turns.size) / (turns.size * nodes.size)
    levels = np.arange(len(conditions) + 1)[:, None, None]
    counted = (depths >= levels) & (open_ | (levels < walked))
    shares: Floats = counted.sum(axis=2) @ weights
    return shares


def _still_open(depths: Integers, walked: int, most: int, *, every: bool) -> Booleans:
    """Return whether what lines do not tell can change a node's code after each orientation."""
    if every:
        open_: Booleans = np.minimum.accumulate(depths, axis=0) >= walked
        return open_
    missing: Booleans = np.maximum.accumulate(depths, axis=0) < most
    return missing


def pairs_told(question: Question, turn: Turn) -> Paired:
    """Return what orientations that are tried at once will cost, with all angles of a turn."""
    grid, turns = question.grid, question.orientations.grid
    nodes, tried = _spread(grid.size, PAIRED[0]), _spread(turns.size, PAIRED[1])
    weighed, cut = try_all_round(
        question.asked(turn),
        turn.positions(grid.poses_at(nodes)),
        turn.frames(turns.poses_at(tried)),
        np.full(nodes.size, question.unseen, np.uint8),
        np.zeros(nodes.size),
        1,
    )
    pairs = nodes.size * tried.size
    return Paired(weighed / pairs, cut / pairs)


def ways_told(question: Question, turn: Turn) -> Ways:
    """Return how the tests of conditions with closed forms are told at the first node."""
    tests, numbers, _ = tests_of(question.conditions[: swept(question.conditions)])[0]
    legs, axis = question.mechanism.legs, turn.frames(question.turned(0).poses(0, 1))[1][:, 0]
    # Across a leg's own axis its span goes around; along it, waves come in that have to be solved.
    around = np.linalg.norm(np.cross(legs.axis[numbers], axis), axis=1) <= PARALLEL
    bounded = (legs.drive[numbers] == STRUT) | (tests == SPAN) | ((tests == REACH) & around)
    asked = tests != NOTHING
    return Ways(asked & bounded, asked & ~bounded)


def seen_around(question: Question, turn: Turn) -> Seen:
    """Return what closed forms say of some nodes at the first orientation."""
    poses = question.turned(0).poses_at(_spread(question.grid.size, SWEPT))
    closed = question.conditions[: swept(question.conditions)]
    codes, arcs = arcs_left(question.mechanism, closed, turn, poses, every=question.every)
    return Seen(poses, codes, arcs)


def met_around(question: Question, seen: Seen) -> Floats:
    """Return which share of nodes meets each test that has a closed form, shape (tests,)."""
    tests = sum(len(c.legs) for c in question.conditions[: swept(question.conditions)])
    ends = np.where(seen.codes == INSIDE, tests + 1, seen.codes)
    shares: Floats = np.mean(ends >= np.arange(1, tests + 1)[:, None], axis=1)
    return shares


def boxes_told(question: Question, turn: Turn) -> octree.Work:
    """Return what the first orientation takes, with all angles of a turn, from large boxes."""
    grid = question.turned(0)
    sweep = question.sweep(grid, turn)
    return octree.foresee(question.mechanism.motion, grid, sweep.judge, sweep.fewest)


def searches(question: Question, turn: Turn, seen: Seen) -> Search:
    """Return what is searched on the arcs that closed forms leave."""
    rest, poses = question.conditions[swept(question.conditions) :], seen.poses
    arcs, share = _some_of(seen.arcs, poses.shape[1])
    coarse = max(turn.step, (turn.high - turn.low) / ANGLES)
    numbers, angles = sampled(arcs, coarse)
    owners = arcs.owners[numbers]
    depths = _depths(question.mechanism, rest, turn.poses(poses, owners, angles))
    # Each angle tried here stands for several, as far apart as they will be.
    weights = ((cells(arcs, turn.step) + 1) / (cells(arcs, coarse) + 1))[numbers]
    levels = np.arange(len(rest) + 1)[:, None]
    reaching = _ends(depths, owners, poses.shape[1], every=question.every) >= levels
    met = reaching[:, owners] if question.every else depths >= levels
    first = np.zeros(levels.size)
    if not question.every and not question.measured:
        # Where all conditions hold at an angle that is looked at first, no end is sought.
        first, reaching = met @ weights, reaching & ~reaching[-1]
    counts = first, (met & reaching[:, owners]) @ weights, reaching.sum(axis=1)
    return Search(*(np.asarray(count[:-1]) * share for count in counts))


def _some_of(arcs: Arcs, count: int) -> tuple[Arcs, float]:
    """Return the arcs of some owners of so many nodes, and how many nodes they stand for each."""
    own = np.flatnonzero(arcs.own(count))
    some = own[:: max(1, -(-own.size // SEARCHED))]
    chosen = np.zeros(count, np.bool_)
    chosen[some] = True
    return arcs.of(chosen), own.size / (count * max(1, some.size))


def _ends(depths: Integers, owners: Integers, count: int, *, every: bool) -> Integers:
    """Return the least depth of every owner's angles, or the greatest, shape (count,); -1: none."""
    ends = np.full(count, -1)
    if every:
        ends[owners] = np.iinfo(ends.dtype).max
        np.minimum.at(ends, owners, depths)
    else:
        np.maximum.at(ends, owners, depths)
    return ends


def _depths(mechanism: Mechanism, conditions: Sequence[Condition], poses: Floats) -> Integers:
    """Return how many conditions hold at each pose before one does not, shape (poses,)."""
    depths = np.zeros(poses.shape[1], np.int64)
    alive, block = np.arange(depths.size), Configuration(mechanism, poses)
    for condition in conditions:
        if not alive.size:
            break
        holds = np.all(condition.check(block) >= 0.0, axis=0)
        alive, block = alive[holds], block.take(holds)
        depths[alive] += 1
    return depths


def _shares(depths: Integers, most: int) -> Floats:
    """Return the share of depths of at least each, from 0 to the most; none is taken for half."""
    counts = np.count_nonzero(depths >= np.arange(most + 1)[:, None], axis=1)
    shares: Floats = np.maximum(counts, 0.5) / depths.size
    return shares


def _spread(size: int, most: int) -> Integers:
    """Return at most so many of `size` flat nodes, the same every time."""
    if size <= most:
        return np.arange(size)
    # Whatever is evenly spaced may fall in step with the grid's lines.
    return np.random.default_rng(0).integers(0, size, most)


def _in_order(size: int, most: int) -> Integers:
    """Return at most so many of the numbers below `size`, the first of them and ever fewer."""
    numbers = np.unique(np.geomspace(1, size, most).astype(np.int64)) - 1
    return numbers
