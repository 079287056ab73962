"""Laryushkin, Glazunov, Erastova, 2016: the planar 3-RRR and its greatest efforts."""

import json
import math

import numpy as np
import pytest

import analyses
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.effort import signed_efforts, worst_efforts
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.grid import Axis, Grid
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.regions import Region
from mechanics.workspace import scan
from schemas.workspace_result import WorkspaceResult
from tests.oracles import planar

NODES = 160_725
FORCE = 10.0
FREE = np.array([[-np.inf, np.inf]] * 3)
GRID = Grid((Axis("x", -0.3, 0.3, 0.001), Axis("y", -0.3, 0.3, 0.001)), (0, 1), np.zeros(3))
REQUEST = {
    "analysis": "workspace",
    "mechanism": {
        "kind": "planar_3rrr",
        "base_side": 0.4,
        "platform_radius": 0.08,
        "crank_length": 0.18,
        "rod_length": 0.18,
    },
    "class": "theoretical",
    "type": "constant_orientation",
    "grid": [
        {"coordinate": "x", "min": -0.3, "max": 0.3, "step": 0.001},
        {"coordinate": "y", "min": -0.3, "max": 0.3, "step": 0.001},
    ],
    "fixed": {"phi": 0.0},
}


ORACLE = planar.planar_3rrr(0.4, 0.08, 0.18, 0.18, (1, 1, 1))
STEP = math.radians(1.0)


@pytest.fixture(scope="module")
def mechanism() -> Mechanism:
    return planar_3rrr(
        base_side=0.4,
        platform_radius=0.08,
        crank_length=0.18,
        rod_length=0.18,
        limits=FREE,
        working_mode=np.ones(3),
    )


@pytest.fixture(scope="module")
def inside(mechanism: Mechanism) -> planar.Booleans:
    found = scan(mechanism, [Reach(mechanism)], GRID, {}, 0, GRID.size)
    held: planar.Booleans = np.repeat(found.codes, found.lengths) == 0
    return held


@pytest.fixture(scope="module")
def block(mechanism: Mechanism, inside: planar.Booleans) -> Configuration:
    """All nodes that the scan reaches."""
    return Configuration(mechanism, np.ascontiguousarray(GRID.poses(0, GRID.size)[:, inside]))


@pytest.fixture(scope="module")
def poses(inside: planar.Booleans) -> planar.Floats:
    return GRID.poses(0, GRID.size).T[inside]


@pytest.fixture(scope="module")
def efforts(block: Configuration) -> planar.Floats:
    """The closed form, shape (poses, legs)."""
    return worst_efforts(block, Load(force=FORCE)).T


@pytest.fixture(scope="module")
def searched(poses: planar.Floats) -> planar.Floats:
    """The greatest of 360 directions by statics of its own, shape (poses, legs)."""
    return planar.worst_by_search(ORACLE, poses, FORCE, 360)


def test_the_published_number_of_nodes_by_analysis() -> None:
    result = analyses.answer(analyses.parse(json.dumps(REQUEST)))
    assert isinstance(result, WorkspaceResult)
    assert result.inside == NODES


def test_the_published_number_of_nodes_by_scan(mechanism: Mechanism) -> None:
    found = scan(mechanism, [Reach(mechanism)], GRID, {}, 0, GRID.size)
    assert Region(GRID, found.codes, found.lengths).nodes == NODES


def test_the_nodes_are_those_of_the_circles(inside: planar.Booleans) -> None:
    margins = planar.reach_margins(ORACLE, GRID.poses(0, GRID.size).T)
    np.testing.assert_array_equal(inside, np.all(margins >= 0, axis=1))


def test_every_node_has_a_finite_effort(efforts: planar.Floats) -> None:
    assert np.isfinite(efforts).all()


def test_no_direction_asks_more_than_the_worst(
    efforts: planar.Floats, searched: planar.Floats
) -> None:
    assert np.all(searched <= efforts * (1 + 1e-12))


def test_some_direction_asks_nearly_the_worst(
    efforts: planar.Floats, searched: planar.Floats
) -> None:
    assert np.all(searched >= efforts * (math.cos(STEP / 2) - 1e-12))


def test_signed_efforts_of_known_loads_stay_within_the_worst(
    block: Configuration, efforts: planar.Floats
) -> None:
    for turn in STEP * np.arange(0, 360, 30):
        wrench = np.array([[FORCE * math.cos(turn)], [FORCE * math.sin(turn)], *[[0.0]] * 4])
        signed = signed_efforts(block, Load(known=wrench)).T
        assert np.all(np.abs(signed) <= efforts * (1 + 1e-12))


def test_the_worst_effort_is_that_of_statics(efforts: planar.Floats, poses: planar.Floats) -> None:
    # Near a stretched or folded leg and near det Jx = 0 both sides lose figures.
    clear = planar.spread(ORACLE, poses) < 1e3
    clear &= np.sin(planar.elbow_angles(ORACLE, poses)).min(axis=1) > 0.01
    assert clear.sum() > 0.9 * NODES
    expected = planar.worst(ORACLE, poses[clear], FORCE)
    np.testing.assert_allclose(efforts[clear], expected, rtol=1e-10)


def test_a_grid_around_the_centroid_is_mirrored_in_x(inside: planar.Booleans) -> None:
    square = inside.reshape(GRID.shape)
    np.testing.assert_array_equal(square, square[::-1])
