"""How a request is cut into tiles."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Plan:
    """Items (poses, grid nodes or meshes) in tiles of equal size, the last one smaller."""

    items: int
    items_per_tile: int


def cut(items: int, seconds_per_item: float, tile_seconds: float, line: int = 1) -> Plan:
    """Return a plan whose tiles take about `tile_seconds`, whole lines where several fit."""
    fitting = max(1, int(tile_seconds / seconds_per_item))
    whole_lines = fitting - fitting % line if fitting >= line else fitting
    return Plan(items, min(whole_lines, items))
