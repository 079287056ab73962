"""Whole lines of a grid, held against the conditions that are decided along them."""

from collections.abc import Sequence

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.grid import Grid
from mechanics.kernels.line_ends import NOTHING, REACH
from mechanics.kernels.lines import Tests, walk
from mechanics.legs import CRANK, STRUT
from mechanics.mechanism import Mechanism

LINES = 1 << 18
"""Lines walked in one call: enough to hide its cost, few enough for their runs to be copied."""

FINEST = 1e-5
"""Lines with a step below this share of the greatest length are left to single nodes."""

NEAR = 1e-7
"""Nodes nearer to a root than this share of the greatest length decide for themselves."""


def provable(mechanism: Mechanism, conditions: Sequence[Condition], grid: Grid) -> int:
    """Return how many of the leading conditions are decided along whole lines of the grid."""
    motion, line = mechanism.motion, grid.axes[-1]
    if line.coordinate not in motion.translations or line.step < FINEST * greatest_length(
        mechanism, grid
    ):
        return 0
    tested = [condition.line_tests is not None for condition in conditions]
    return tested.index(False) if False in tested else len(tested)


def walk_lines(
    mechanism: Mechanism, conditions: Sequence[Condition], grid: Grid, start: int, stop: int
) -> tuple[Bytes, Integers]:
    """Return the runs of whole lines under conditions that are decided along them."""
    tests = _tests(conditions, mechanism.legs.drive)
    line = grid.shape[-1]
    near = NEAR * greatest_length(mechanism, grid)
    parts: list[tuple[Bytes, Integers]] = []
    told = start
    while told < stop or not parts:
        behind = min(told - told % line + LINES * line, stop)
        codes, lengths, told = walk(
            tests, mechanism.legs, mechanism.motion.kernel, grid.kernel, near, told, behind
        )
        parts.append((codes, lengths))
    if len(parts) > 1:
        codes, lengths = (np.concatenate(column) for column in zip(*parts, strict=True))
    return codes, lengths


def greatest_length(mechanism: Mechanism, grid: Grid) -> float:
    """Return the greatest length that the leg equations meet, at whatever angles. [m]"""
    legs, translations = mechanism.legs, mechanism.motion.translations
    axes = [axis for axis in grid.axes if axis.coordinate in translations]
    ends = np.array([(axis.minimum, axis.maximum) for axis in axes])
    sliding, moved = legs.drive != CRANK, grid.fixed[: len(translations)]
    lengths: list[Floats] = [
        *(legs.base_point, legs.platform_point, legs.rod_length, legs.crank_length),
        *(legs.lower_limit[sliding], legs.upper_limit[sliding], moved, ends),
    ]
    met = np.concatenate([values.ravel() for values in lengths])
    return float(np.max(np.abs(met[np.isfinite(met)]), initial=0.0))


def _tests(conditions: Sequence[Condition], drives: Integers) -> Tests:
    """Return what lines are held against; first a leg must reach at all."""
    tests: list[tuple[int, int, int]] = []
    # The length of a strut is known even where it has no direction.
    reached = {leg for leg, drive in enumerate(drives) if drive == STRUT}
    parts = [part for c in conditions for part in zip(c.line_tests or (), c.legs, strict=True)]
    for code, (test, leg) in enumerate(parts, start=1):
        asked = {test} if leg in reached else {REACH, test}
        tests += [(each, leg, code) for each in sorted(asked - {NOTHING})]
        reached.add(leg)
    rows = np.array(tests, dtype=np.int64).reshape(-1, 3).T.copy()
    return Tests(*rows)
