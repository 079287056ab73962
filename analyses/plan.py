"""How a request is cut into tiles."""

from dataclasses import dataclass

LEAST_TILES = 12
"""Into so many tiles even a short request is cut: workers end together, and progress shows."""
LEAST_SECONDS = 0.1
"""Of a tile; less is not worth the way to a worker and back."""


@dataclass(frozen=True)
class Plan:
    """Items (poses, grid nodes or meshes) in tiles of equal size, the last one smaller."""

    items: int
    items_per_tile: int


def cut(
    items: int,
    seconds_per_item: float,
    tile_seconds: float,
    line: int = 1,
    least_seconds: float = LEAST_SECONDS,
) -> Plan:
    """Return a plan of tiles of about `tile_seconds` or less, of whole lines where several fit.

    Only tiles longer than `least_seconds` are made shorter, so that there are enough of them.
    """
    shared = max(int(least_seconds / seconds_per_item), -(-items // LEAST_TILES))
    fitting = max(1, min(int(tile_seconds / seconds_per_item), shared))
    whole_lines = fitting - fitting % line if fitting >= line else fitting
    return Plan(items, min(whole_lines, items))
