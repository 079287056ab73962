"""Dense arrays of a scanned grid, handed out piece by piece."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt


@dataclass(frozen=True)
class GridColumn:
    """One dense array over the nodes of a grid, never held whole.

    Parameters
    ----------
    name : str
        Name of the array: ``inside``, ``reason`` or that of a field.
    dtype : numpy dtype
        Type of every element: bool for ``inside``, uint8 for ``reason``, float64 for fields.
    shape : tuple of int
        Full dense shape: that of the grid, followed by the column's own axes (legs).
    unit : str
        Unit of the values; empty where they have none.
    chunks : callable
        Starts anew at every call and yields consecutive pieces along the flat, C-ordered
        nodes, each of shape (nodes of the piece, *own axes), together all nodes once.
    """

    name: str
    dtype: np.dtype[Any]
    shape: tuple[int, ...]
    unit: str
    chunks: Callable[[], Iterator[npt.NDArray[Any]]]


@dataclass(frozen=True)
class DenseGrid:
    """The nodes of a grid and the columns of values on them.

    Parameters
    ----------
    axes : dict of str to array, shape (nodes of the axis,)
        Coordinate to its nodes, in the order of the grid's axes. [m or rad]
    columns : tuple of GridColumn
        What is known at every node, in the order in which it is to be written.
    """

    axes: dict[str, npt.NDArray[np.float64]]
    columns: tuple[GridColumn, ...]
