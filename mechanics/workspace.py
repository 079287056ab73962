"""Workspaces: scans of a grid against conditions, node by node, kept as runs along its lines."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.configuration import Configuration
from mechanics.fields import Field
from mechanics.grid import Grid
from mechanics.kernels import runs as kernels
from mechanics.mechanism import Mechanism

BLOCK = 4096
"""Poses examined together: enough to hide the cost of a call, few enough to stay in cache."""

INSIDE = 0
"""The code of a node at which every condition holds."""


@dataclass(frozen=True)
class Excluded:
    """What a reason code means: the condition and the leg that it failed on."""

    code: int
    reason: str
    leg: int


def reason_codes(conditions: Sequence[Condition]) -> list[Excluded]:
    """Return the meaning of every code, conditions in their order, their parts within."""
    parts = [(condition.reason, leg) for condition in conditions for leg in condition.legs]
    return [Excluded(code, reason, leg) for code, (reason, leg) in enumerate(parts, start=1)]


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
) -> Scan:
    """Return which flat nodes `start` to `stop` of the grid belong to the workspace.

    A node belongs when every condition holds; its code is 0 then, else that of the first
    condition, and of that condition's first part, that fails (see `reason_codes`).

    References
    ----------
    Erastova, Laryushkin, 2017, doi:10.18698/0536-1044-2017-8-78-87, fig. 6 (the iterative way).
    """
    codes = np.zeros(stop - start, np.uint8)
    kept: dict[str, list[Floats]] = {name: [] for name in fields}
    for first in range(start, stop, BLOCK):
        last = min(first + BLOCK, stop)
        block = Configuration(mechanism, grid.poses(first, last))
        block = _sift(block, conditions, codes[first - start : last - start])
        for name, field in fields.items():
            kept[name].append(field(block).T)
    values, lengths = kernels.encode(codes, start, grid.shape[-1])
    return Scan(values, lengths, {name: np.concatenate(parts) for name, parts in kept.items()})


def _sift(block: Configuration, conditions: Sequence[Condition], codes: Bytes) -> Configuration:
    """Write the codes of a block's nodes and return what is left inside."""
    alive = np.arange(block.count)
    code = 1
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
