"""Many orientations of a grid, with all angles of one more turn at each of them.

Most nodes are far from most orientations: some test fails at all angles of the turn, which the
extremes of its waves tell (`sides`). Only where arcs may still change what is known of a node are
they cut (`sweeps`), for many such pairs of node and orientation together.
"""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.kernels.bands import NOTHING, by_band, turning
from mechanics.kernels.codes import INSIDE
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import arm, numbers
from mechanics.kernels.orientations import farther, sooner
from mechanics.kernels.sides import write_sides
from mechanics.kernels.sweeps import ARCS_PER_TEST, sweep
from mechanics.kernels.waves import TURN
from mechanics.legs import Legs

NODES = 512
"""Nodes weighed together: few enough for the first cache."""
PAIRS = 256
"""Pairs of node and orientation whose arcs are cut together: enough to hide the cost of a call."""


class Asked(NamedTuple):
    """What is asked of each pair: `sweeps.sweep` says of what.

    `every`: whether all angles are, not some; `measured`: on which share of them all holds.
    """

    tests: tuple[Integers, Integers, Integers]
    bounds: Floats
    legs: Legs
    ends: tuple[float, float]
    every: bool
    measured: bool
    ranks: Floats


class Weighed(NamedTuple):
    """What sides tell of nodes at one orientation, by codes: shape (nodes,) each. 0: none.

    `first` may take anything of what its condition meets, no test before it does; `last` leaves
    nothing or, if all angles are asked, does take something.
    """

    first: Integers
    last: Integers
    sides: Integers


@kernel
def try_all_round(
    asked: Asked,
    positions: Floats,
    frames: tuple[Floats, Floats],
    codes: Bytes,
    held: Floats,
    together: int,
) -> tuple[int, int]:
    """Put the verdicts of a block of orientations into the codes of nodes, and what is held.

    Return how many pairs of node and orientation were weighed, and of how many arcs were cut.

    Parameters
    ----------
    positions : shape (3, nodes). [m]
    frames : rotations and axes of the turn at each orientation while its angle is 0, shapes
        (9, orientations) and (3, orientations).
    codes, held : as `at_some` and `at_every` keep them, shape (nodes,).
    together : how many pairs wait for each other's arcs, at most `PAIRS`.
    """
    weighings = cuts = 0
    here, own = np.empty((3, NODES)), np.empty(NODES, np.int64)
    first, last = np.empty(NODES, np.int64), np.empty(NODES, np.int64)
    weighed = Weighed(first, last, np.empty(NODES, np.int64))
    pairs = np.empty((2, PAIRS + NODES), np.int64)
    for begin in range(0, codes.size, NODES):
        stop = min(begin + NODES, codes.size)
        count, waiting = _gather_open(asked, positions, begin, stop, codes, here, own), 0
        for o in range(frames[0].shape[1]):
            if count == 0:
                break
            _weigh(asked, frames, o, here, count, weighed)
            weighings += count
            waiting = _choose(asked, weighed, own, o, count, codes, held, pairs, waiting)
            if waiting >= together:
                _cut(asked, positions, frames, pairs, waiting, codes, held)
                count = _gather_open(asked, positions, begin, stop, codes, here, own)
                cuts, waiting = cuts + waiting, 0
        if waiting > 0:
            _cut(asked, positions, frames, pairs, waiting, codes, held)
            cuts += waiting
    return weighings, cuts


@kernel
def _gather_open(
    asked: Asked,
    positions: Floats,
    begin: int,
    stop: int,
    codes: Bytes,
    here: Floats,
    own: Integers,
) -> int:
    """Write which nodes another orientation can still change, and where; return how many."""
    every, measured, count = asked.every, asked.measured, 0
    for node in range(begin, stop):
        # The first code cannot become an earlier one.
        if codes[node] == 1 if every else codes[node] == INSIDE and not measured:
            continue
        own[count] = node
        for j in range(3):
            here[j, count] = positions[j, node]
        count += 1
    return count


@kernel
def _weigh(
    asked: Asked,
    frames: tuple[Floats, Floats],
    o: int,
    positions: Floats,
    count: int,
    weighed: Weighed,
) -> None:
    """Write what sides tell of nodes at orientation o."""
    tests, own_legs, groups = asked.tests
    first, last, sides = weighed
    rotations, axes = frames
    whole = asked.every and asked.ends[1] - asked.ends[0] >= TURN
    for i in range(count):
        first[i], last[i] = 0, 0
    group = -1
    for k in range(tests.size):
        if tests[k] == NOTHING:
            continue
        leg, drive = numbers(asked.legs, own_legs[k]), asked.legs.drive[own_legs[k]]
        d = turning(leg, arm(leg, rotations, o), (axes[0, o], axes[1, o], axes[2, o]))
        asked_band = asked.bounds[k, 0], asked.bounds[k, 1]
        write_sides(tests[k], drive, leg, asked_band, d, positions, count, sides)
        if asked.every:
            # Where waves leave their bounds anywhere, a part of a whole turn is missing.
            lost = 1 if whole and by_band(tests[k], drive, leg, d) else 0
            untold = _note_any(k + 1, lost, count, first, last, sides)
        else:
            untold = _note_all(k + 1, groups[k] == group, count, first, last, sides)
        group = groups[k]
        if untold == 0:
            break


@inlined
def _note_any(
    code: int, lost: int, count: int, first: Integers, last: Integers, sides: Integers
) -> int:
    """Note the first test that may take anything; return how many nodes have met none so far.

    It does take something where its side is below `lost`.
    """
    untold = 0
    for i in range(count):
        untouched = first[i] == 0
        last[i] = code if untouched and sides[i] < lost else last[i]
        first[i] = code if untouched and sides[i] < 1 else first[i]
        untold += 1 if first[i] == 0 else 0
    return untold


@inlined
def _note_all(
    code: int, same: bool, count: int, first: Integers, last: Integers, sides: Integers
) -> int:
    """Note the tests up to one that leaves nothing; return how many nodes have met none so far.

    What an earlier condition took counts no more where one, not the `same`, finds something left.
    """
    untold = 0
    for i in range(count):
        left = last[i] == 0
        former = first[i] if same or not left else 0
        first[i] = code if left and former == 0 and sides[i] < 1 else former
        last[i] = code if left and sides[i] < 0 else last[i]
        untold += 1 if last[i] == 0 else 0
    return untold


@kernel
def _choose(
    asked: Asked,
    weighed: Weighed,
    own: Integers,
    o: int,
    count: int,
    codes: Bytes,
    held: Floats,
    pairs: Integers,
    waiting: int,
) -> int:
    """Keep the codes that are told; return how many pairs wait for arcs, new ones among them.

    A code came at most as far as `last`, where none comes before `first`; if all angles are asked
    it is told where both are the same.
    """
    every, measured, ranks = asked.every, asked.measured, asked.ranks
    first, last, _ = weighed
    for i in range(count):
        former = codes[own[i]]
        if every:
            changes = sooner(first[i], former)
            held[own[i]] += 1.0 if first[i] == 0 else 0.0
        elif last[i] == 0:
            changes = former != INSIDE or measured
        else:
            changes = ranks[last[i]] > ranks[former] or farther(first[i], former, ranks)
        if changes and every and first[i] == last[i]:
            codes[own[i]] = last[i]
        elif changes:
            pairs[0, waiting], pairs[1, waiting] = own[i], o
            waiting += 1
    return waiting


@kernel
def _cut(
    asked: Asked,
    positions: Floats,
    frames: tuple[Floats, Floats],
    pairs: Integers,
    count: int,
    codes: Bytes,
    held: Floats,
) -> None:
    """Put the verdicts of the first `count` pairs into the codes and what is held."""
    rotations, axes = frames
    places = np.empty((3, count)), np.empty((9, count)), np.empty((3, count))
    place, turned, axis = places
    for i in range(count):
        node, o = pairs[0, i], pairs[1, i]
        for j in range(3):
            place[j, i], axis[j, i] = positions[j, node], axes[j, o]
        for j in range(9):
            turned[j, i] = rotations[j, o]
    most = 1 + ARCS_PER_TEST * asked.tests[0].size
    fresh, counts = np.empty(count, np.uint8), np.empty(count, np.int64)
    starts, stops = np.empty((most, count)), np.empty((most, count))
    tests, ends, every = asked.tests, asked.ends, asked.every
    sweep(tests, asked.bounds, asked.legs, places, ends, every, fresh, counts, starts, stops)
    whole, ranks = ends[1] - ends[0], asked.ranks
    for i in range(count):
        node, code, size = pairs[0, i], fresh[i], 0.0
        for k in range(counts[i]):
            size += stops[k, i] - starts[k, i]
        # A range of one angle is met or not.
        held[node] += size / whole if whole > 0.0 else 1.0 * (code == INSIDE)
        if sooner(code, codes[node]) if every else farther(code, codes[node], ranks):
            codes[node] = code
