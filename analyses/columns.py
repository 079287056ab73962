"""From arrays to the columns of an answer."""

from typing import Any

import numpy as np

from mechanics.arrays import Floats

BYTES_PER_NUMBER = 22
"""A float of full precision in JSON, with its separator."""


def nullable(values: Floats) -> list[Any]:
    """Return the values as nested lists with None where there is no number."""
    missing = np.isnan(values)
    if not missing.any():
        whole: list[Any] = values.tolist()
        return whole
    cells = values.astype(object)
    cells[missing] = None
    rows: list[Any] = cells.tolist()
    return rows


def nullable_vectors(values: Floats) -> list[Any]:
    """Return vectors, on the last axis, as lists; None for a vector without numbers."""
    missing = np.isnan(values).any(axis=-1)
    rows: list[Any] = values.tolist()
    for index in np.argwhere(missing):
        target = rows
        for k in index[:-1]:
            target = target[k]
        target[index[-1]] = None
    return rows
