"""Columns of a grid, cut anew into blocks of equal length."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from analyses.grids import DenseGrid, GridColumn
from exports.errors import ColumnError

Block = npt.NDArray[Any]


def column_blocks(grid: DenseGrid, column: GridColumn, nodes: int) -> Iterator[Block]:
    """Yield the column as contiguous blocks of `nodes` nodes, the last one shorter.

    Neither memory nor the bytes of a file depend on how the column's source is cut.

    Parameters
    ----------
    grid : DenseGrid
        The grid that the column belongs to.
    column : GridColumn
        The column to read, once, from its start.
    nodes : int
        Nodes a block, at least 1.

    Raises
    ------
    ColumnError : the column has another shape than the grid, or yields other elements or
        another number of nodes than it declares.
    """
    total = _node_count(grid, column)
    own_shape = column.shape[len(grid.axes) :]
    filled, seen = 0, 0
    block = np.empty((min(nodes, total), *own_shape), column.dtype)
    for chunk in column.chunks():
        _check_chunk(column, own_shape, chunk)
        seen += len(chunk)
        if seen > total:
            raise ColumnError(column.name, f"{total} nodes", f"at least {seen}")
        start = 0
        while start < len(chunk):
            taken = min(len(chunk) - start, len(block) - filled)
            block[filled : filled + taken] = chunk[start : start + taken]
            start, filled = start + taken, filled + taken
            if filled == len(block):
                yield block
                # The reader may keep what it was given.
                block, filled = np.empty_like(block), 0
    if seen != total:
        raise ColumnError(column.name, f"{total} nodes", f"{seen}")
    if filled:
        yield block[:filled]


def _node_count(grid: DenseGrid, column: GridColumn) -> int:
    shape = tuple(len(nodes) for nodes in grid.axes.values())
    if column.shape[: len(shape)] != shape:
        raise ColumnError(column.name, f"shape {shape} and its own axes", column.shape)
    return int(np.prod(shape, dtype=np.int64))


def _check_chunk(column: GridColumn, own_shape: tuple[int, ...], chunk: Block) -> None:
    if chunk.dtype != column.dtype:
        raise ColumnError(column.name, f"dtype {column.dtype}", chunk.dtype)
    if chunk.shape[1:] != own_shape or chunk.ndim == 0:
        raise ColumnError(column.name, f"pieces of shape (nodes, *{own_shape})", chunk.shape)
