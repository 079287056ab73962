"""Arcs of a turn on which conditions without closed forms hold, found by search.

A condition is looked at on angles a step apart, at singularities between them, and where its
margin may dip below 0 between them; where its verdict changes, the angle is halved down to
`RESOLUTION`. What is narrower than a step and does not show in the margins at its sides is lost.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers

RESOLUTION = 1e-9
"""How exactly the ends of arcs are found. [rad]"""
LEAST_CELLS = 3
"""An arc shorter than a step is looked at within too."""
GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
HALVINGS = 60
DIP_STEPS = 40

Look = Callable[[Integers, Floats], Floats]
"""Margins, shape (parts, angles), of owners at angles; < 0 or NaN: it does not hold."""
Signs = Callable[[Integers, Floats], Floats]
"""Det Jx, shape (angles,), of owners at angles."""


@dataclass(frozen=True)
class Arcs:
    """Arcs, each owned by a pose, ascending within it. Shapes (arcs,); angles in rad."""

    owners: Integers
    starts: Floats
    stops: Floats

    def of(self, chosen: Booleans) -> "Arcs":
        """Return the arcs of the chosen owners, shape (owners,)."""
        own = chosen[self.owners]
        return Arcs(self.owners[own], self.starts[own], self.stops[own])

    def own(self, owners: int) -> Booleans:
        """Return which owners have any arc, shape (owners,)."""
        owning: Booleans = np.bincount(self.owners, minlength=owners) > 0
        return owning

    def measures(self, owners: int) -> Floats:
        """Return the size of all arcs of each owner, shape (owners,). [rad]"""
        sizes = self.stops - self.starts
        return np.bincount(self.owners, sizes, minlength=owners).astype(np.float64)


@dataclass(frozen=True)
class Samples:
    """Angles along arcs, both ends of each among them, and what a condition says there.

    Shapes (angles,), and (parts, angles) for margins; NaN there is as good as -inf.
    """

    arcs: Integers
    owners: Integers
    angles: Floats
    margins: Floats

    @property
    def holds(self) -> Booleans:
        """Whether each part holds, shape (parts, angles)."""
        holds: Booleans = self.margins >= 0.0
        return holds

    @property
    def joined(self) -> Booleans:
        """Whether each angle and its successor are of one arc, shape (angles - 1,)."""
        joined: Booleans = self.arcs[1:] == self.arcs[:-1]
        return joined

    def among(self, look: Look, left: Integers, angles: Floats) -> "Samples":
        """Return the samples with more angles, each after the sample `left`, in any order."""
        order = np.lexsort((angles, left))
        left, angles = left[order], angles[order]
        owners = self.owners[left]
        at = left + 1
        return Samples(
            np.insert(self.arcs, at, self.arcs[left]),
            np.insert(self.owners, at, owners),
            np.insert(self.angles, at, angles),
            np.insert(self.margins, at, look(owners, angles), axis=1),
        )


def cells(arcs: Arcs, step: float) -> Integers:
    """Return into how many parts each arc is cut, for angles at most a step apart."""
    sizes = arcs.stops - arcs.starts
    return np.maximum(LEAST_CELLS, np.ceil(sizes / step - 1e-9)).astype(np.int64)


def sampled(arcs: Arcs, step: float) -> tuple[Integers, Floats]:
    """Return angles along arcs, with both ends and at most a step apart, and each one's arc.

    The ends are taken within `RESOLUTION` inside: at them a leg may be stretched, and rounding
    would say whether it reaches.
    """
    trims = np.minimum(RESOLUTION, 0.25 * (arcs.stops - arcs.starts))
    starts, stops = arcs.starts + trims, arcs.stops - trims
    parts = cells(arcs, step)
    numbers = np.repeat(np.arange(parts.size), parts + 1)
    firsts = np.cumsum(parts + 1) - (parts + 1)
    shares = (np.arange(numbers.size) - firsts[numbers]) / parts[numbers]
    angles = starts[numbers] + shares * (stops - starts)[numbers]
    angles[firsts + parts] = stops
    return numbers, angles


def examined(arcs: Arcs, step: float, look: Look, signs: Signs | None) -> Samples:
    """Return samples between which nothing more is to be expected, except where verdicts change.

    Parameters
    ----------
    step : the largest between angles. [rad]
    look : the condition.
    signs : det Jx, if the condition fails wherever it vanishes.
    """
    numbers, angles = sampled(arcs, step)
    owners = arcs.owners[numbers]
    samples = Samples(numbers, owners, angles, look(owners, angles))
    if signs is not None:
        samples = _with_singularities(samples, look, signs)
    return _with_dips(samples, look)


def narrowed(samples: Samples, look: Look) -> Arcs:
    """Return the arcs on which all parts hold, their ends to `RESOLUTION`."""
    samples = _with_ends(samples, look)
    holds = np.all(samples.holds, axis=0)
    kept = holds[:-1] & holds[1:] & samples.joined
    first = holds & ~np.concatenate([[False], kept])
    last = holds & ~np.concatenate([kept, [False]])
    return Arcs(samples.owners[first], samples.angles[first], samples.angles[last])


def _with_ends(samples: Samples, look: Look) -> Samples:
    """Return the samples with the two angles beside each change of a part's verdict."""
    holds = samples.holds
    parts, left = np.nonzero((holds[:, 1:] != holds[:, :-1]) & samples.joined)
    owners, before = samples.owners[left], holds[parts, left]
    low, high = samples.angles[left], samples.angles[left + 1]

    def same(angles: Floats) -> Booleans:
        margins = look(owners, angles)[parts, np.arange(parts.size)]
        alike: Booleans = (margins >= 0.0) == before
        return alike

    low, high = _halved(low, high, same)
    return samples.among(look, np.concatenate([left, left]), np.concatenate([low, high]))


def _with_singularities(samples: Samples, look: Look, signs: Signs) -> Samples:
    """Return the samples with the angle at which det Jx changes its sign between two."""
    positive = signs(samples.owners, samples.angles) > 0.0
    left = np.flatnonzero((positive[1:] != positive[:-1]) & samples.joined)
    owners, before = samples.owners[left], positive[left]

    def same(angles: Floats) -> Booleans:
        alike: Booleans = (signs(owners, angles) > 0.0) == before
        return alike

    low, high = _halved(samples.angles[left], samples.angles[left + 1], same, 0.0)
    return samples.among(look, np.concatenate([left, left]), np.concatenate([low, high]))


def _halved(
    low: Floats,
    high: Floats,
    same: Callable[[Floats], Booleans],
    resolution: float = RESOLUTION,
) -> tuple[Floats, Floats]:
    """Return the last angles that are as `low` is and the first that are not, so far apart."""
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        # Each goes its own way to its own end: what is found does not depend on its company.
        wide = (high - low > resolution) & (middle != low) & (middle != high)
        if not wide.any():
            break
        as_low = same(middle)
        low, high = np.where(wide & as_low, middle, low), np.where(wide & ~as_low, middle, high)
    return low, high


def _with_dips(samples: Samples, look: Look) -> Samples:
    """Return the samples with an angle of the other verdict wherever one is found between two.

    Where a margin, held or missed, is nearer to 0 than at its neighbours, it may come nearer still
    between them; how near is sought by golden sections, unless it would have to
    change by more than it does from one angle to the next about it.
    """
    size = np.where(np.isnan(samples.margins), -np.inf, samples.margins)
    holds = samples.holds
    size = np.where(holds, size, -size)
    parts, at = _candidates(samples, size)
    owners, held = samples.owners[at], holds[parts, at]

    def height(angles: Floats) -> Floats:
        margins = look(owners, angles)[parts, np.arange(parts.size)]
        margins = np.where(np.isnan(margins), -np.inf, margins)
        return np.where(held, margins, -margins)

    first = at - np.concatenate([[False], samples.joined])[at]
    last = at + np.concatenate([samples.joined, [False]])[at]
    angles, heights = _lowest(samples.angles[first], samples.angles[last], height)
    found = heights < 0.0
    left = np.where(angles > samples.angles[at], at, first)
    return samples.among(look, left[found], angles[found])


def _candidates(samples: Samples, size: Floats) -> tuple[Integers, Integers]:
    """Return the parts and samples whose size is least beside them, and may be less between.

    Beyond the ends of an arc there is nothing to compare with.
    """
    joined, holds = samples.joined, samples.holds
    before, after = np.full((2, *size.shape), np.nan)
    before[:, 1:] = np.where(joined, size[:, :-1], np.nan)
    after[:, :-1] = np.where(joined, size[:, 1:], np.nan)
    alike = np.ones(size.shape, dtype=bool)
    changed = (holds[:, 1:] != holds[:, :-1]) & joined
    alike[:, 1:] &= ~changed
    alike[:, :-1] &= ~changed
    with np.errstate(invalid="ignore"):
        least = ~(size > before) & ~(size > after) & ((size < before) | (size < after))
        changes = np.where(joined, np.abs(size[:, 1:] - size[:, :-1]), 0.0)
        around = np.pad(changes, ((0, 0), (2, 2)))
        steepest = np.maximum.reduce([around[:, k : k + size.shape[1]] for k in range(4)])
        reachable = ~(size >= steepest)
    parts, at = np.nonzero(alike & least & reachable)
    return parts, at


def _lowest(low: Floats, high: Floats, height: Callable[[Floats], Floats]) -> tuple[Floats, Floats]:
    """Return the angles between `low` and `high` at which each height is least, and the heights.

    One that is below 0 is low enough.
    """
    if not low.size:
        return low, low
    one, other = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    h_one, h_other = height(one), height(other)
    for _ in range(DIP_STEPS):
        going = (np.minimum(h_one, h_other) >= 0.0) & (high - low > RESOLUTION)
        if not going.any():
            break
        left = h_one < h_other
        low, high = np.where(going & ~left, one, low), np.where(going & left, other, high)
        fresh = np.where(left, high - GOLDEN * (high - low), low + GOLDEN * (high - low))
        h_fresh = height(fresh)
        # Each goes its own way to its own end: what is found does not depend on its company.
        one, other, h_one, h_other = (
            np.where(going, np.where(left, fresh, other), one),
            np.where(going, np.where(left, one, fresh), other),
            np.where(going, np.where(left, h_fresh, h_other), h_one),
            np.where(going, np.where(left, h_one, h_fresh), h_other),
        )
    return np.where(h_one < h_other, one, other), np.minimum(h_one, h_other)
