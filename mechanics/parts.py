"""The part of a region that can be reached from home without meeting a singularity."""

import numpy as np
from numpy.typing import NDArray

from mechanics.arrays import Booleans, Floats
from mechanics.errors import MechanicsError
from mechanics.kernels import pieces, runs
from mechanics.kernels.codes import INSIDE
from mechanics.regions import Region

Signs = NDArray[np.int8]


def signs_of(determinants: Floats) -> Signs:
    """Return the signs, -1, 0 or 1, of determinants of any shape; 0 for NaN."""
    return (determinants > 0.0).astype(np.int8) - (determinants < 0.0).astype(np.int8)


def home_part(region: Region, signs: Signs, home: int, code: int) -> Region:
    """Return the region with every node that home cannot reach given a code of its own.

    Neighbours, whose cells share a face, are joined if their signs are the same: between two of
    other signs det Jx vanishes, and where it does is a sign of its own, 0. Nodes see nothing of
    a singularity that is touched or crossed twice within a step. If home is not inside, no node is.

    Parameters
    ----------
    region : whose fields the signs are.
    signs : array, shape (nodes inside,), signs of det Jx in node order.
    home : a flat node of the grid (see `Region.node_nearest` for that of a pose).
    code : a reason code that the region does not use yet, for what is in other parts.

    Raises
    ------
    MechanicsError : there are not as many signs as nodes inside.
    """
    if signs.shape != (region.nodes,):
        raise MechanicsError(
            f"signs must have shape ({region.nodes},), one a node inside; given {signs.shape}"
        )
    shape = np.array(region.grid.shape, dtype=np.int64)
    codes, lengths = runs.join(region.codes, region.lengths, shape[-1])
    starts = stops = np.empty(0, np.int64)
    rank = _rank_inside(region, home)
    if rank is not None:
        starts, stops = pieces.of_sign(codes, lengths, shape[-1], signs, signs[rank])
        parts = runs.connect(starts, stops, shape)
        same = parts == parts[np.searchsorted(starts, home, side="right") - 1]
        starts, stops = starts[same], stops[same]
    return Region(region.grid, *pieces.recode(codes, lengths, starts, stops, code))


def kept(part: Region, code: int) -> Booleans:
    """Return which of the nodes that were inside still are, in node order.

    Parameters
    ----------
    part : what `home_part` returned.
    code : what it gave the nodes of other parts.

    Returns
    -------
    array, shape (nodes inside before,)
        For taking what the fields have at the nodes of the part.
    """
    chosen = (part.codes == INSIDE) | (part.codes == code)
    values: Booleans = np.repeat(part.codes[chosen] == INSIDE, part.lengths[chosen])
    return values


def _rank_inside(region: Region, node: int) -> int | None:
    """Return how many nodes inside come before this one; None if it is not inside itself."""
    stops = np.cumsum(region.lengths)
    run = int(np.searchsorted(stops, node, side="right"))
    if not 0 <= node < region.grid.size or region.codes[run] != INSIDE:
        return None
    before = region.lengths[:run][region.codes[:run] == INSIDE].sum()
    return int(before + node - (stops[run] - region.lengths[run]))
