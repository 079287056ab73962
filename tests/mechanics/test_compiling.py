"""How kernels are compiled."""

import numpy as np

from mechanics.kernels.compiling import kernel


@kernel
def first_bytes(count: int) -> int:
    """Return in which bytes of a cache line arrays of many sizes begin, one bit each."""
    found, kept = 0, [np.empty(1)]
    for size in range(1, count):
        made = np.empty(size)
        kept.append(made)
        found |= 1 << (made.ctypes.data % 64)
    return found


def test_arrays_made_in_kernels_begin_on_a_cache_line() -> None:
    """Else every load of a whole register takes two lines, as chance will have it."""
    assert first_bytes(300) == 1
