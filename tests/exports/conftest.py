"""Grids and pictures that the tests of the exports share."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from analyses.grids import DenseGrid, GridColumn
from analyses.pictures import PictureAxis, PictureField, Skeleton, WorkspacePicture

GridMaker = Callable[[int], DenseGrid]
PictureMaker = Callable[..., WorkspacePicture]


def column(
    name: str, values: npt.NDArray[Any], rank: int, piece: int, unit: str = ""
) -> GridColumn:
    """Return a column that yields its nodes in pieces of the given length."""
    flat = values.reshape(-1, *values.shape[rank:])

    def chunks() -> Iterator[npt.NDArray[Any]]:
        for start in range(0, len(flat), piece):
            yield flat[start : start + piece]

    return GridColumn(name, values.dtype, values.shape, unit, chunks)


@pytest.fixture
def make_grid() -> GridMaker:
    """Return a maker of a 3 x 4 x 5 grid, cut into pieces of a given number of nodes."""

    def make(piece: int) -> DenseGrid:
        axes = {
            "x": np.linspace(0.0, 0.2, 3),
            "y": np.linspace(-0.2, 0.1, 4),
            "rz": np.linspace(0.0, 4 / 3, 5),
        }
        shape = (3, 4, 5)
        reason = (np.arange(60) % 3).astype(np.uint8).reshape(shape)
        effort = np.linspace(0.0, 1.0, 120).reshape(*shape, 2) / 3
        effort[reason > 0] = np.nan
        return DenseGrid(
            axes,
            (
                column("inside", reason == 0, 3, piece),
                column("reason", reason, 3, piece),
                column("effort", effort, 3, piece, "N"),
                column("effort_max", effort.max(axis=-1), 3, piece, "N"),
            ),
        )

    return make


@pytest.fixture
def make_picture() -> PictureMaker:
    """Return a maker of a disc of nodes in a plane, with or without its parts."""

    def make(
        *,
        size: tuple[float, float] = (0.8, 0.6),
        nodes: tuple[int, int] = (41, 31),
        limit: float | None = None,
        with_field: bool = True,
        with_skeleton: bool = True,
        title: str = "Five-bar mechanism",
    ) -> WorkspacePicture:
        axes = tuple(
            PictureAxis(label, "m", np.linspace(-length / 2, length / 2, count))
            for label, length, count in zip("xy", size, nodes, strict=True)
        )
        x, y = np.meshgrid(axes[0].nodes / size[0], axes[1].nodes / size[1], indexing="ij")
        inside = np.hypot(x, y) < 0.45
        values = np.where(inside, 1 + x + y, np.nan)
        field = PictureField("Largest drive torque", "N·m", values, limit) if with_field else None
        skeleton = five_bar() if with_skeleton else None
        return WorkspacePicture(title, "load 10 N", axes, inside, field, skeleton)

    return make


def five_bar() -> Skeleton:
    """Return a five-bar mechanism that stands out from the grid."""
    top = np.array([0.0, 0.35])
    left = np.array([[-0.6, 0.0], [-0.5, 0.3], top])
    return Skeleton((left, left * [-1, 1]), top[np.newaxis])
