"""Two ways to do the same, timed in turns."""

import time
from collections.abc import Callable

import numpy as np

REPEATS = 9


def compare(
    name: str,
    ours: Callable[[], object],
    items: int,
    rival: str,
    theirs: Callable[[], object],
    rival_items: int | None = None,
) -> None:
    """Print one line; a ratio above 1 says how many times faster we are, an item.

    Both run in turns, since other work on a machine slows it for seconds at a time; what counts
    is the shortest time of each.
    """
    times = []
    ours(), theirs()
    for _ in range(REPEATS):
        times.append([seconds(ours) / items, seconds(theirs) / (rival_items or items)])
    mine, other = 1e9 * np.min(times, axis=0)
    print(f"{name:42} {mine:9.2f} ns  {rival:40} {other:9.2f} ns  ratio {other / mine:7.2f}")


def seconds(work: Callable[[], object]) -> float:
    """Return how long a piece of work keeps the processor, whatever else runs on the machine."""
    start = time.process_time()
    work()
    return time.process_time() - start
