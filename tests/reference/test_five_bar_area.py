"""The five-bar's theoretical workspace is where the rings of its two legs meet."""

import math

import numpy as np
import pytest

from mechanics.conditions.reach import Reach
from mechanics.families.five_bar import five_bar
from mechanics.grid import Axis, Grid
from mechanics.regions import Region
from mechanics.workspace import scan
from tests.oracles import planar

Dimensions = tuple[float, float, float]

# Base distance, crank, rod: the paper's, equal links (no hole), and holes that meet, stand
# apart, lie across each other's rings, or leave only the two ends.
MACHINES: list[Dimensions] = [
    (0.12, 0.16, 0.22),
    (0.6, 0.5, 0.5),
    (0.3, 0.2, 0.45),
    (1.0, 0.7, 0.4),
    (0.8, 0.2, 0.7),
    (0.5, 0.3, 0.31),
]
STEPS = (0.02, 0.01, 0.005, 0.0025, 0.00125)


def exact_area(dimensions: Dimensions) -> float:
    base, crank, rod = dimensions
    inner, outer = abs(crank - rod), crank + rod
    return planar.rings_area([(-base / 2, 0, inner, outer), (base / 2, 0, inner, outer)])


def region(dimensions: Dimensions, step: float) -> Region:
    base, crank, rod = dimensions
    mechanism = five_bar(
        base_distance=base,
        crank_length=crank,
        rod_length=rod,
        limits=np.array([[-np.inf, np.inf]] * 2),
        working_mode=np.array([1.0, -1.0]),
    )
    extent = (math.floor((base / 2 + crank + rod) / step) + 1.37) * step
    axes = (Axis("x", -extent, extent, step), Axis("y", -extent, extent, step))
    grid = Grid(axes, (0, 1), np.zeros(2))
    found = scan(mechanism, [Reach(mechanism)], grid, {}, 0, grid.size)
    return Region(grid, found.codes, found.lengths)


@pytest.mark.parametrize("dimensions", MACHINES)
def test_line_integral_agrees_with_lenses(dimensions: Dimensions) -> None:
    base, crank, rod = dimensions
    inner, outer = abs(crank - rod), crank + rod
    lenses = (
        planar.lens_area(base, outer, outer)
        - 2 * planar.lens_area(base, outer, inner)
        + planar.lens_area(base, inner, inner)
    )
    assert exact_area(dimensions) == pytest.approx(lenses, rel=1e-12)


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("dimensions", MACHINES)
def test_area_is_within_its_error_bound(dimensions: Dimensions, step: float) -> None:
    counted = region(dimensions, step)
    assert abs(counted.measure - exact_area(dimensions)) <= counted.measure_error


@pytest.mark.parametrize("dimensions", MACHINES)
def test_area_error_falls_with_the_step(dimensions: Dimensions) -> None:
    exact = exact_area(dimensions)
    errors = [abs(region(dimensions, step).measure - exact) for step in (0.02, 0.00125)]
    assert errors[1] < errors[0] / 4


@pytest.mark.parametrize("dimensions", MACHINES)
def test_error_bound_falls_as_the_step(dimensions: Dimensions) -> None:
    bounds = [region(dimensions, step).measure_error for step in (0.005, 0.0025)]
    assert bounds[1] == pytest.approx(bounds[0] / 2, rel=0.1)


def test_the_hole_is_not_overlooked() -> None:
    base, crank, rod = MACHINES[0]
    without = planar.lens_area(base, crank + rod, crank + rod)
    assert without - exact_area(MACHINES[0]) == pytest.approx(2 * math.pi * 0.06**2)
