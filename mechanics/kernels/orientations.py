"""Verdicts at many orientations put together: runs of one orientation into a node's code so far."""

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.kernels.compiling import kernel


@kernel
def at_some(runs: Bytes, lengths: Integers, ranks: Floats, codes: Bytes, held: Integers) -> None:
    """Keep, shape (nodes,), the code that came farthest, of equals the first; 0 came through."""
    node = 0
    for run in range(runs.size):
        code = runs[run]
        for i in range(node, node + lengths[run]):
            former = codes[i]
            if ranks[code] > ranks[former] or (ranks[code] == ranks[former] and code < former):
                codes[i] = code
            held[i] += code == 0
        node += lengths[run]


@kernel
def at_every(runs: Bytes, lengths: Integers, codes: Bytes, held: Integers) -> None:
    """Keep, shape (nodes,), the first code that any orientation breaks; 0 while none does."""
    node = 0
    for run in range(runs.size):
        code = runs[run]
        for i in range(node, node + lengths[run]):
            if code != 0 and (codes[i] == 0 or code < codes[i]):
                codes[i] = code
            held[i] += code == 0
        node += lengths[run]
