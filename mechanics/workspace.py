"""Workspaces: scans of a grid against conditions, node by node, kept as runs along its lines."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Booleans, Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.configuration import Configuration
from mechanics.fields import Field
from mechanics.grid import Grid
from mechanics.judging import FEWEST, Judgement, sparse, worth_judging
from mechanics.kernels import runs as kernels
from mechanics.kernels.codes import INSIDE
from mechanics.lines import provable, walk_lines
from mechanics.mechanism import Mechanism
from mechanics.octree import decide, window_about

BLOCK = 4096
"""Poses examined together: enough to hide the cost of a call, few enough to stay in cache."""


@dataclass(frozen=True)
class Excluded:
    """What a reason code means: the condition and the leg, or two, that it failed on."""

    code: int
    reason: str
    leg: int
    partner: int | None


def reason_codes(conditions: Sequence[Condition]) -> list[Excluded]:
    """Return the meaning of every code, conditions in their order, their parts within."""
    parts = [
        (condition.reason, leg, partner)
        for condition in conditions
        for leg, partner in zip(
            condition.legs, condition.partners or [None] * len(condition.legs), strict=True
        )
    ]
    return [Excluded(code, *part) for code, part in enumerate(parts, start=1)]


def ranks_of(conditions: Sequence[Condition]) -> Floats:
    """Return how far each code's node came, shape (256,): how many conditions held."""
    ranks = np.full(256, -1.0)
    code = 1
    for number, condition in enumerate(conditions):
        ranks[code : code + len(condition.legs)] = number
        code += len(condition.legs)
    ranks[INSIDE] = len(conditions)
    return ranks


@dataclass(frozen=True)
class Scan:
    """A stretch of flat grid nodes, examined.

    Parameters
    ----------
    codes, lengths : arrays, shape (runs,), the reason code and the nodes of each run.
    fields : name to array, shape (nodes inside,) or (nodes inside, legs), in node order.
    """

    codes: Bytes
    lengths: Integers
    fields: dict[str, Floats]


def scan(
    mechanism: Mechanism,
    conditions: Sequence[Condition],
    grid: Grid,
    fields: Mapping[str, Field],
    start: int,
    stop: int,
    *,
    by_lines: bool = True,
    by_boxes: bool = True,
    among: Booleans | None = None,
) -> Scan:
    """Return which flat nodes `start` to `stop` of the grid belong to the workspace.

    A node belongs when every condition holds; its code is 0 then, else that of the first
    condition, and of that condition's first part, that fails (see `reason_codes`). The leading
    conditions that have closed forms along a line are decided line by line, unless `by_lines` is
    false. Of the nodes that are left, whole boxes are told by what bounds prove of them, unless
    `by_boxes` is false or fields are asked for, and all others by themselves. The result is that
    of nodes asked one by one. With `among`, shape (stop - start,), only these nodes are held
    against the other conditions, and have fields.

    References
    ----------
    Erastova, Laryushkin, 2017, doi:10.18698/0536-1044-2017-8-78-87, fig. 6 (the iterative way).
    """
    walked = provable(mechanism, conditions, grid) if by_lines else 0
    codes, lengths = walk_lines(mechanism, conditions[:walked], grid, start, stop)
    rest, first = conditions[walked:], 1 + sum(len(c.legs) for c in conditions[:walked])
    if not rest and not fields:
        return Scan(codes, lengths, {})
    left = _Left(mechanism, rest, first, grid)
    nodes = kernels.nodes_with(INSIDE, codes, lengths, start)
    verdicts = np.zeros(nodes.size, np.uint8)
    asked = slice(None) if among is None else np.flatnonzero(among[nodes - start])
    told = left.by_boxes(nodes[asked]) if by_boxes and not fields else None
    kept: dict[str, Floats] = {}
    if told is None:
        told, kept = left.by_nodes(nodes[asked], fields)
    verdicts[asked] = told
    codes, lengths = kernels.refine(codes, lengths, verdicts, grid.shape[-1], start)
    return Scan(codes, lengths, kept)


@dataclass(frozen=True)
class _Left:
    """The conditions that whole lines do not tell, and the code of the first part of them."""

    mechanism: Mechanism
    conditions: Sequence[Condition]
    first: int
    grid: Grid

    def by_nodes(
        self, nodes: Integers, fields: Mapping[str, Field]
    ) -> tuple[Bytes, dict[str, Floats]]:
        """Return the codes of flat nodes and the fields of those inside, block by block."""
        codes = np.zeros(nodes.size, np.uint8)
        kept: dict[str, list[Floats]] = {name: [] for name in fields}
        # Fields of no node at all still have a shape.
        for at in range(0, max(1, nodes.size), BLOCK):
            part = slice(at, at + BLOCK)
            block = Configuration(self.mechanism, self.grid.poses_at(nodes[part]))
            block = _sift(block, self.conditions, self.first, codes[part])
            for name, field in fields.items():
                kept[name].append(field(block).T)
        return codes, {name: np.concatenate(parts) for name, parts in kept.items()}

    def by_boxes(self, nodes: Integers) -> Bytes | None:
        """Return the codes of flat nodes, boxes told by bounds first; None: not worth it."""
        if not worth_judging(self.mechanism, self.conditions, self.grid, nodes):
            return None
        window, places = window_about(self.grid, nodes)
        size = math.prod(window.shape)
        if sparse(size, nodes.size):
            return None
        asked = np.zeros(size, np.bool_)
        asked[places] = True
        codes = decide(
            self.mechanism.motion,
            self.grid,
            0,
            size,
            Judgement(self.mechanism, self.conditions, self.first, self.grid),
            lambda some: self.by_nodes(window.of(self.grid, some), {})[0],
            window=window,
            among=asked,
            fewest=FEWEST,
        )
        return codes[places]


def codes_of(mechanism: Mechanism, conditions: Sequence[Condition], poses: Floats) -> Bytes:
    """Return the codes of a block of poses, shape (coordinates, poses), as a scan has them."""
    codes = np.zeros(poses.shape[1], np.uint8)
    _sift(Configuration(mechanism, poses), conditions, 1, codes)
    return codes


def line_runs(codes: Bytes, start: int, line: int) -> tuple[Bytes, Integers]:
    """Return codes and lengths of the runs of nodes with these codes, the first being `start`."""
    changed = np.ones(codes.size, np.bool_)
    np.not_equal(codes[1:], codes[:-1], out=changed[1:])
    changed[-start % line :: line] = True
    begins = np.flatnonzero(changed)
    return codes[begins], np.diff(begins, append=codes.size)


def _sift(
    block: Configuration, conditions: Sequence[Condition], code: int, codes: Bytes
) -> Configuration:
    """Write the codes of a block's nodes, from `code` on, and return what is left inside."""
    alive = np.arange(block.count)
    for condition in conditions:
        holds = condition.check(block) >= 0.0
        every = np.all(holds, axis=0)
        if not every.all():
            failed = ~every
            codes[alive[failed]] = code + np.argmin(holds[:, failed], axis=0)
            alive = alive[every]
            block = block.take(every)
        code += len(condition.legs)
    return block
