"""Unions of workspaces: where the conditions hold in some working mode."""

from collections.abc import Sequence

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.grid import Grid
from mechanics.kernels.codes import INSIDE, UNSEEN
from mechanics.kernels.orientations import at_some
from mechanics.workspace import Scan, line_runs, ranks_of


def union(scans: Sequence[Scan], conditions: Sequence[Condition], grid: Grid, start: int) -> Scan:
    """Return one scan of what belongs to any of several, of the same nodes from `start` on.

    The code of a node outside is that of the scan in which it came farthest, of equals the first
    code; fields are those of the first scan that a node belongs to.
    """
    if len(scans) == 1:
        return scans[0]
    dense = [np.repeat(scan.codes, scan.lengths) for scan in scans]
    codes = np.full(dense[0].size, UNSEEN, np.uint8)
    owners = np.zeros(codes.size, np.int64)
    for number, fresh in enumerate(dense):
        owners[(codes != INSIDE) & (fresh == INSIDE)] = number
        at_some(fresh, ranks_of(conditions), codes)
    fields = {name: _chosen(name, scans, dense, codes, owners) for name in scans[0].fields}
    return Scan(*line_runs(codes, start, grid.shape[-1]), fields)


def _chosen(
    name: str, scans: Sequence[Scan], dense: Sequence[Bytes], codes: Bytes, owners: Integers
) -> Floats:
    inside = np.flatnonzero(codes == INSIDE)
    own = scans[0].fields[name].shape[1:]
    values = np.empty((inside.size, *own))
    for number, (scan, fresh) in enumerate(zip(scans, dense, strict=True)):
        taken = owners[inside] == number
        values[taken] = scan.fields[name][owners[fresh == INSIDE] == number]
    return values
