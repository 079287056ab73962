"""Grids as comma-separated values."""

import csv
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import exports.csv
from analyses.grids import DenseGrid, GridColumn
from exports import ColumnError, write_csv

GridMaker = Callable[[int], DenseGrid]


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "grid.csv"


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def test_header_names_coordinates_then_columns_one_a_leg(make_grid: GridMaker, path: Path) -> None:
    write_csv(path, make_grid(7))
    assert path.read_text().splitlines()[0] == ("x,y,rz,inside,reason,effort_0,effort_1,effort_max")


def test_coordinates_follow_the_flat_order_of_the_grid(make_grid: GridMaker, path: Path) -> None:
    grid = make_grid(7)
    write_csv(path, grid)
    expected = np.stack(np.meshgrid(*grid.axes.values(), indexing="ij"), axis=-1).reshape(-1, 3)
    found = np.array([[float(row[name]) for name in grid.axes] for row in rows(path)])
    np.testing.assert_array_equal(found, expected)


def test_numbers_keep_all_their_digits(make_grid: GridMaker, path: Path) -> None:
    grid = make_grid(7)
    write_csv(path, grid)
    expected = np.concatenate(list(grid.columns[2].chunks()))[:, 1]
    found = np.array([float(row["effort_1"] or "nan") for row in rows(path)])
    np.testing.assert_array_equal(found, expected)


def test_nan_is_an_empty_cell(make_grid: GridMaker, path: Path) -> None:
    write_csv(path, make_grid(7))
    assert {row["effort_max"] == "" for row in rows(path) if row["inside"] == "0"} == {True}


def test_inside_is_zero_or_one(make_grid: GridMaker, path: Path) -> None:
    write_csv(path, make_grid(7))
    assert [row["inside"] for row in rows(path)][:4] == ["1", "0", "0", "1"]


def test_infinity_keeps_its_sign(path: Path) -> None:
    values = np.array([np.inf, -np.inf])
    column = GridColumn("effort", values.dtype, (2,), "N", lambda: iter([values]))
    write_csv(path, DenseGrid({"x": np.zeros(2)}, (column,)))
    assert [row["effort"] for row in rows(path)] == ["inf", "-inf"]


def test_text_does_not_depend_on_how_source_and_rows_are_cut(
    make_grid: GridMaker, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_csv(path, make_grid(60))
    at_once = path.read_bytes()
    monkeypatch.setattr(exports.csv, "_BLOCK_NODES", 11)
    write_csv(path, make_grid(7))
    assert path.read_bytes() == at_once


@pytest.mark.parametrize("nodes", [1, 3])
def test_a_column_of_another_length_is_refused(path: Path, nodes: int) -> None:
    column = GridColumn("inside", np.dtype(bool), (2,), "", lambda: iter([np.ones(nodes, bool)]))
    with pytest.raises(ColumnError):
        write_csv(path, DenseGrid({"x": np.zeros(2)}, (column,)))
    assert not path.exists()
