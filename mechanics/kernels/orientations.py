"""Verdicts at many orientations put together: those at fresh ones into a node's code so far.

`sizes` says which share of the fresh orientations each node meets all conditions at, and `held`
sums it up.
"""

from mechanics.arrays import Bytes, Floats
from mechanics.kernels.compiling import kernel


@kernel
def at_some(fresh: Bytes, sizes: Floats, ranks: Floats, codes: Bytes, held: Floats) -> None:
    """Keep, shape (nodes,), the code that came farthest, of equals the first; 0 came through."""
    for i in range(codes.size):
        code, former = fresh[i], codes[i]
        if ranks[code] > ranks[former] or (ranks[code] == ranks[former] and code < former):
            codes[i] = code
        held[i] += sizes[i]


@kernel
def at_every(fresh: Bytes, sizes: Floats, codes: Bytes, held: Floats) -> None:
    """Keep, shape (nodes,), the first code that any orientation breaks; 0 while none does."""
    for i in range(codes.size):
        if fresh[i] != 0 and (codes[i] == 0 or fresh[i] < codes[i]):
            codes[i] = fresh[i]
        held[i] += sizes[i]
