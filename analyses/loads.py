"""From loads of a request to those of `mechanics`."""

from collections.abc import Sequence

import numpy as np

from analyses.poses import check_rows
from mechanics.arrays import Floats
from mechanics.loads import Load
from schemas.effort import KnownLoad, LoadSize


def check_known_load(known: KnownLoad, poses: int) -> None:
    """Raise AnalysisError unless a known load is one for all poses, or has one row per pose."""
    for name in ("force", "moment"):
        rows = getattr(known, name)
        if rows is not None and isinstance(rows[0], list):
            check_rows(f"/known_load/{name}", rows, poses, 3)


def load_of(size: LoadSize | None, known: KnownLoad | None, start: int, stop: int) -> Load:
    """Return the load on the poses `start` to `stop`."""
    wrench = np.zeros((6, stop - start))
    if known is not None:
        wrench[:3] += vectors(known.force or [0.0] * 3, start, stop)
        wrench[3:] += vectors(known.moment or [0.0] * 3, start, stop)
    sizes = (0.0, 0.0) if size is None else (size.force, size.moment)
    return Load(*sizes, wrench)


def vectors(rows: Sequence[float] | Sequence[Sequence[float]], start: int, stop: int) -> Floats:
    """Return vectors, one for all or one per pose, as columns of the poses `start` to `stop`."""
    table = np.atleast_2d(np.array(rows, dtype=float))
    chosen = table[start:stop] if len(table) > 1 else table
    return np.array(np.broadcast_to(chosen.T, (table.shape[1], stop - start)))
