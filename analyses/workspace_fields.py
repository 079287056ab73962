"""Least, greatest and where: what a workspace's fields amount to, tile by tile."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np

from analyses.analysis import Arrays, Stretches
from analyses.workspace_setup import WorkspaceSetup
from mechanics.arrays import Floats
from mechanics.histograms import histogram as counted
from mechanics.kernels.codes import INSIDE
from schemas.workspace_result import FieldSummary, Histogram


@dataclass
class Extremes:
    """Least and greatest value of one field so far, and the flat node of the greatest."""

    least: float = np.inf
    greatest: float = -np.inf
    node: int | None = None


@dataclass
class FieldSummaries:
    """Gathers the fields of successive stretches of flat nodes."""

    setup: WorkspaceSetup
    units: dict[str, str]
    _node: int = 0
    _extremes: dict[str, Extremes] = field(default_factory=dict)

    def add(self, arrays: Arrays) -> None:
        """Take in the next stretch."""
        codes, lengths = arrays["codes"], arrays["lengths"]
        inside = codes == INSIDE
        firsts = self._node + np.cumsum(lengths) - lengths
        for name in self.units:
            extremes = self._extremes.setdefault(name, Extremes())
            _update(extremes, arrays[f"field_{name}"], firsts[inside], lengths[inside])
        self._node += int(lengths.sum())

    def answer(self, histograms: Mapping[str, Histogram]) -> dict[str, FieldSummary]:
        """Return the summaries; null where no node inside has a value."""
        return {
            name: self._summary(name, unit, histograms.get(name))
            for name, unit in self.units.items()
        }

    def _summary(self, name: str, unit: str, histogram: Histogram | None) -> FieldSummary:
        extremes = self._extremes.get(name, Extremes())
        if extremes.node is None:
            return FieldSummary.model_construct(
                min=None, max=None, at_max=None, unit=unit, histogram=histogram
            )
        pose = self.setup.grid.poses(extremes.node, extremes.node + 1)[:, 0]
        names = self.setup.mechanism.motion.coordinates
        orientations = self.setup.orientations
        ranged = () if orientations is None else orientations.coordinates
        return FieldSummary.model_construct(
            min=extremes.least,
            max=extremes.greatest,
            at_max={
                name: value
                for name, value in zip(names, pose.tolist(), strict=True)
                if name not in ranged
            },
            unit=unit,
            histogram=histogram,
        )


def histograms(stretches: Stretches, names: Iterable[str]) -> dict[str, Histogram]:
    """Return the histogram of each of these fields."""
    return {name: _histogram(stretches, name) for name in names}


def _histogram(stretches: Stretches, name: str) -> Histogram:
    found = counted(lambda: (arrays[f"field_{name}"] for arrays in stretches()))
    return Histogram.model_construct(
        edges=found.edges.tolist(),
        counts=found.counts.tolist(),
        undefined=found.undefined + found.infinite,
    )


def _update(extremes: Extremes, values: Floats, firsts: Floats, lengths: Floats) -> None:
    flat = values.reshape(-1)
    if not flat.size or np.isnan(flat).all():
        return
    extremes.least = min(extremes.least, float(np.nanmin(flat)))
    at = int(np.nanargmax(flat))
    if flat[at] > extremes.greatest:
        extremes.greatest = float(flat[at])
        extremes.node = _flat_node(at * len(values) // flat.size, firsts, lengths)


def _flat_node(position: int, firsts: Floats, lengths: Floats) -> int:
    """Return the flat node that is the `position`-th one inside."""
    ends = np.cumsum(lengths)
    run = int(np.searchsorted(ends, position, side="right"))
    return int(firsts[run] + position - (ends[run] - lengths[run]))
