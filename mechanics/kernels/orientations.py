"""Verdicts at many orientations put together: those at fresh ones into a node's code so far."""

from mechanics.arrays import Bytes, Floats
from mechanics.kernels.compiling import inlined, kernel


@inlined
def farther(code: int, former: int, ranks: Floats) -> bool:
    """Return whether a code came farther than a former one, or as far and stands before it."""
    return bool(ranks[code] > ranks[former] or (ranks[code] == ranks[former] and code < former))


@inlined
def sooner(code: int, former: int) -> bool:
    """Return whether a code breaks, and before a former one does."""
    return code != 0 and (former == 0 or code < former)


@kernel
def at_some(fresh: Bytes, ranks: Floats, codes: Bytes) -> None:
    """Keep, shape (nodes,), the code that came farthest, of equals the first; 0 came through."""
    for i in range(codes.size):
        if farther(fresh[i], codes[i], ranks):
            codes[i] = fresh[i]


@kernel
def at_every(fresh: Bytes, codes: Bytes) -> None:
    """Keep, shape (nodes,), the first code that any orientation breaks; 0 while none does."""
    for i in range(codes.size):
        if sooner(fresh[i], codes[i]):
            codes[i] = fresh[i]
