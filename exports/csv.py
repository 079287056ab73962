"""Grids as comma-separated values."""

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from analyses.grids import DenseGrid, GridColumn
from exports.blocks import column_blocks
from exports.files import whole_file

_BLOCK_NODES = 8192


def write_csv(path: Path, grid: DenseGrid) -> None:
    """Write the grid as text, one row a node in the order of the flat, C-ordered grid.

    A row holds the coordinates, then the columns: truth as 0 or 1, numbers with all their
    digits, nothing where a value is NaN. A column with legs takes one cell a leg, named
    ``<column>_0``, ``<column>_1`` and so on. Values are in the units of the grid. Memory
    does not grow with the grid, and `path` never holds a part of a file.

    Parameters
    ----------
    path : pathlib.Path
        Where the file is to stand; an older file is replaced.
    grid : DenseGrid
        What is to be written.

    Raises
    ------
    ColumnError : a column does not hold what it declares.
    """
    with whole_file(path) as file:
        file.write(_line(_names(grid)))
        blocks = [column_blocks(grid, column, _BLOCK_NODES) for column in grid.columns]
        for cells in zip(_coordinate_cells(grid), *map(_column_cells, blocks), strict=True):
            rows = zip(*(column for group in cells for column in group), strict=True)
            file.write(b"".join(map(_line, rows)))


def _line(cells: tuple[str, ...]) -> bytes:
    return (",".join(cells) + "\n").encode()


def _names(grid: DenseGrid) -> tuple[str, ...]:
    rank = len(grid.axes)
    columns = (name for column in grid.columns for name in _column_names(column, rank))
    return (*grid.axes, *columns)


def _column_names(column: GridColumn, rank: int) -> Iterator[str]:
    for index in np.ndindex(column.shape[rank:]):
        yield "_".join((column.name, *map(str, index)))


def _coordinate_cells(grid: DenseGrid) -> Iterator[list[list[str]]]:
    """Yield, block by block, one list of cells for each coordinate."""
    shape = tuple(len(nodes) for nodes in grid.axes.values())
    total = int(np.prod(shape, dtype=np.int64))
    texts = [_texts(nodes) for nodes in grid.axes.values()]
    for start in range(0, total, _BLOCK_NODES):
        flat = np.arange(start, min(start + _BLOCK_NODES, total))
        places = np.unravel_index(flat, shape)
        yield [[text[i] for i in place.tolist()] for text, place in zip(texts, places, strict=True)]


def _column_cells(blocks: Iterator[npt.NDArray[Any]]) -> Iterator[list[list[str]]]:
    """Yield, block by block, one list of cells for each number a node has in the column."""
    for block in blocks:
        numbers = block.reshape(len(block), math.prod(block.shape[1:])).T
        yield [_texts(number) for number in numbers]


def _texts(numbers: npt.NDArray[Any]) -> list[str]:
    if numbers.dtype == np.bool_:
        return ["1" if number else "0" for number in numbers.tolist()]
    if np.issubdtype(numbers.dtype, np.floating):
        # NaN is the only number that differs from itself.
        return [repr(number) if number == number else "" for number in numbers.tolist()]
    return [str(number) for number in numbers.tolist()]
