"""Grids as NumPy archives."""

import tracemalloc
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

from analyses.grids import DenseGrid, GridColumn
from exports import ColumnError, write_npz

Bools = npt.NDArray[np.bool_]
GridMaker = Callable[[int], DenseGrid]


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "grid.npz"


def whole(grid: DenseGrid, name: str) -> npt.NDArray[np.generic]:
    column = next(column for column in grid.columns if column.name == name)
    return np.concatenate(list(column.chunks())).reshape(column.shape)


@pytest.mark.parametrize("name", ["inside", "reason", "effort", "effort_max"])
def test_numpy_reads_back_every_column_to_the_bit(
    make_grid: GridMaker, path: Path, name: str
) -> None:
    grid = make_grid(7)
    write_npz(path, grid)
    with np.load(path, allow_pickle=False) as archive:
        found, expected = archive[name], whole(grid, name)
    assert found.dtype == expected.dtype
    assert found.shape == expected.shape
    assert found.tobytes() == expected.tobytes()


def test_axes_stand_under_their_coordinates(make_grid: GridMaker, path: Path) -> None:
    grid = make_grid(7)
    write_npz(path, grid)
    with np.load(path, allow_pickle=False) as archive:
        for coordinate, nodes in grid.axes.items():
            np.testing.assert_array_equal(archive[f"axis_{coordinate}"], nodes)


def test_keys_are_columns_then_axes(make_grid: GridMaker, path: Path) -> None:
    write_npz(path, make_grid(7))
    with np.load(path, allow_pickle=False) as archive:
        assert archive.files == [
            *("inside", "reason", "effort", "effort_max"),
            *("axis_x", "axis_y", "axis_rz"),
        ]


def test_bytes_do_not_depend_on_how_the_source_is_cut(make_grid: GridMaker, path: Path) -> None:
    other = path.with_name("other.npz")
    write_npz(path, make_grid(1))
    write_npz(other, make_grid(60))
    assert path.read_bytes() == other.read_bytes()


def test_members_carry_no_time_of_writing(make_grid: GridMaker, path: Path) -> None:
    write_npz(path, make_grid(7))
    with zipfile.ZipFile(path) as archive:
        assert {member.date_time for member in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_an_archive_is_sound(make_grid: GridMaker, path: Path) -> None:
    write_npz(path, make_grid(7))
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None


def test_memory_does_not_grow_with_the_grid(path: Path) -> None:
    shape = (4_000, 10_000)
    piece = np.arange(400_000) % 1000 < 300

    def chunks() -> Iterator[Bools]:
        for _ in range(shape[0] * shape[1] // len(piece)):
            yield piece

    column = GridColumn("inside", np.dtype(bool), shape, "", chunks)
    grid = DenseGrid({"x": np.zeros(shape[0]), "y": np.zeros(shape[1])}, (column,))
    tracemalloc.start()
    try:
        write_npz(path, grid)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < 8 * 2**20


def test_a_grid_without_nodes_is_written(path: Path) -> None:
    column = GridColumn("inside", np.dtype(bool), (0, 2), "", lambda: iter(()))
    write_npz(path, DenseGrid({"x": np.zeros(0), "y": np.zeros(2)}, (column,)))
    with np.load(path, allow_pickle=False) as archive:
        assert archive["inside"].shape == (0, 2)


@pytest.mark.parametrize(
    ("shape", "piece"),
    [
        ((4,), np.zeros(3, bool)),
        ((4,), np.zeros(5, bool)),
        ((4,), np.zeros(4, np.uint8)),
        ((4,), np.zeros((4, 2), bool)),
        ((3,), np.zeros(3, bool)),
    ],
    ids=["too few nodes", "too many nodes", "other type", "other legs", "other grid"],
)
def test_a_column_that_breaks_its_word_is_refused(
    path: Path, shape: tuple[int, ...], piece: Bools
) -> None:
    column = GridColumn("inside", np.dtype(bool), shape, "", lambda: iter([piece]))
    with pytest.raises(ColumnError) as caught:
        write_npz(path, DenseGrid({"x": np.zeros(4)}, (column,)))
    assert caught.value.column == "inside"


def test_a_failure_leaves_the_old_file_and_no_other(make_grid: GridMaker, path: Path) -> None:
    path.write_bytes(b"old")
    broken = GridColumn("late", np.dtype(bool), (3, 4, 5), "", lambda: iter(()))
    grid = make_grid(7)
    with pytest.raises(ColumnError):
        write_npz(path, DenseGrid(grid.axes, (*grid.columns, broken)))
    assert path.read_bytes() == b"old"
    assert list(path.parent.iterdir()) == [path]
