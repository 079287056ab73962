"""How a request is cut into tiles."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Plan:
    """Items (poses or grid nodes) in tiles of equal size, the last one smaller."""

    items: int
    items_per_tile: int

    @property
    def tiles(self) -> int:
        """How many tiles there are."""
        return math.ceil(self.items / self.items_per_tile)

    def bounds(self, index: int) -> tuple[int, int]:
        """Return the first item of a tile and the first one after it."""
        start = index * self.items_per_tile
        return start, min(start + self.items_per_tile, self.items)


def cut(items: int, seconds_per_item: float, tile_seconds: float, line: int = 1) -> Plan:
    """Return a plan whose tiles take about `tile_seconds`, whole lines where several fit."""
    fitting = max(1, int(tile_seconds / seconds_per_item))
    whole_lines = fitting - fitting % line if fitting >= line else fitting
    return Plan(items, min(whole_lines, items))
