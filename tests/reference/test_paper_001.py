"""Erastova, Laryushkin, 2017: the five-bar with limit switches and its greatest torques."""

import math
from collections.abc import Sequence

import numpy as np
import pytest

import analyses
from mechanics import fields
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import Condition
from mechanics.conditions.crank_rod_angle import CrankRodAngle
from mechanics.conditions.effort import Effort
from mechanics.conditions.reach import Reach
from mechanics.conditions.rod_rod_angle import RodRodAngle
from mechanics.families.five_bar import five_bar
from mechanics.grid import Axis, Grid
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.workspace import Scan, scan
from schemas.presets import PRESETS
from schemas.workspace import WorkspaceRequest
from schemas.workspace_result import WorkspaceResult
from tests.oracles import planar

SWITCH = math.asin(0.005 / math.hypot(0.05, 0.05))
# The switches bound each crank on its outer side; a crank that has come round below the base
# joints is on the wrong side of the frame, so the other ends point straight down.
LIMITS = np.array(
    [
        [math.radians(-90), math.radians(225) - SWITCH],
        [math.radians(-45) + SWITCH, math.radians(270)],
    ]
)
ORACLE = planar.five_bar(0.12, 0.16, 0.22, (1, -1))
UPPER = Grid((Axis("x", -0.4, 0.4, 0.001), Axis("y", 0.0, 0.4, 0.001)), (0, 1), np.zeros(2))
FINE = Grid((Axis("x", -0.4, 0.4, 0.0005), Axis("y", 0.0, 0.4, 0.0005)), (0, 1), np.zeros(2))
LOAD = Load(force=1.0)
BOTH_ENDS = ((20.0, 160.0), (5.0, 175.0))
LOWER_ENDS = ((20.0, 180.0), (5.0, 180.0))
Bounds = tuple[tuple[float, float], tuple[float, float]]


@pytest.fixture(scope="module")
def mechanism() -> Mechanism:
    return five_bar(
        base_distance=0.12,
        crank_length=0.16,
        rod_length=0.22,
        limits=LIMITS,
        working_mode=np.array([1.0, -1.0]),
    )


def constructive(mechanism: Mechanism, bounds: Bounds) -> list[Condition]:
    elbow, shared = np.deg2rad(bounds)
    return [
        Reach(mechanism),
        ActuatorLimits(mechanism),
        CrankRodAngle(mechanism, elbow[0], elbow[1]),
        RodRodAngle(mechanism, shared[0], shared[1]),
    ]


def examined(mechanism: Mechanism, conditions: Sequence[Condition], grid: Grid = UPPER) -> Scan:
    kept = {"effort_max": fields.effort_max(LOAD)}
    return scan(mechanism, conditions, grid, kept, 0, grid.size)


def inside(found: Scan) -> planar.Booleans:
    held: planar.Booleans = np.repeat(found.codes, found.lengths) == 0
    return held


def built(bounds: Bounds) -> tuple[planar.Booleans, planar.Booleans]:
    """Which nodes are constructive by geometry of its own, and which it can decide."""
    poses = UPPER.poses(0, UPPER.size).T
    elbow, shared = np.deg2rad(bounds)
    reach = planar.reach_margins(ORACLE, poses)
    angles = planar.crank_angles(ORACLE, poses)
    turned = angles[..., None] + 2 * np.pi * np.array([-1, 0, 1])
    stops = np.minimum(turned - LIMITS[:, :1], LIMITS[:, 1:] - turned).max(axis=-1)
    elbows = planar.elbow_angles(ORACLE, poses)
    rods = planar.rod_angle(ORACLE, poses)[:, None]
    margins = np.concatenate(
        [
            reach,
            stops,
            elbows - elbow[0],
            np.where(elbow[1] < np.pi, elbow[1] - elbows, 1.0),
            rods - shared[0],
            np.where(shared[1] < np.pi, shared[1] - rods, 1.0),
        ],
        axis=1,
    )
    least = np.where(np.isnan(margins), -1.0, margins).min(axis=1)
    return least >= 0, np.abs(least) > 1e-12


def test_the_switch_takes_four_degrees() -> None:
    assert math.degrees(SWITCH) == pytest.approx(4.05, abs=0.01)


def test_greatest_torque_with_angles_bounded_at_both_ends(mechanism: Mechanism) -> None:
    found = examined(mechanism, constructive(mechanism, BOTH_ENDS), FINE)
    assert 0.2015 <= found.fields["effort_max"].max() <= 0.204


def test_greatest_torque_with_lower_bounds_alone(mechanism: Mechanism) -> None:
    found = examined(mechanism, constructive(mechanism, LOWER_ENDS), FINE)
    assert found.fields["effort_max"].max() == pytest.approx(0.235, abs=0.0005)


def test_every_torque_is_below_the_motor_limit(mechanism: Mechanism) -> None:
    found = examined(mechanism, constructive(mechanism, LOWER_ENDS))
    assert found.fields["effort_max"].max() < 0.34


def test_the_preset_has_the_published_greatest_torque() -> None:
    preset = next(preset for preset in PRESETS if preset.name == "five_bar_printer_2017")
    request = WorkspaceRequest.model_validate(
        {
            "analysis": "workspace",
            "mechanism": preset.mechanism.model_dump(),
            "class": "constructive",
            "type": "constant_orientation",
            "grid": [
                {"coordinate": "x", "min": -0.4, "max": 0.4, "step": 0.001},
                {"coordinate": "y", "min": 0.0, "max": 0.4, "step": 0.001},
            ],
            "constructive": {
                "min_crank_rod_angle": math.radians(20),
                "max_crank_rod_angle": math.radians(160),
                "min_rod_rod_angle": math.radians(5),
                "max_rod_rod_angle": math.radians(175),
            },
            "effective": {"load": {"force": 1.0}},
            "fields": ["effort_max"],
        }
    )
    result = analyses.answer(request)
    assert isinstance(result, WorkspaceResult)
    greatest = result.fields["effort_max"].max
    assert greatest is not None
    assert 0.2015 <= greatest <= 0.204


@pytest.mark.parametrize("bounds", [BOTH_ENDS, LOWER_ENDS])
def test_constructive_nodes_are_those_of_geometry(mechanism: Mechanism, bounds: Bounds) -> None:
    found = inside(examined(mechanism, constructive(mechanism, bounds)))
    kept, decided = built(bounds)
    np.testing.assert_array_equal(found[decided], kept[decided])


def test_all_but_a_few_nodes_are_decided_by_geometry() -> None:
    _, decided = built(BOTH_ENDS)
    assert (~decided).sum() < 10


@pytest.mark.parametrize("bounds", [BOTH_ENDS, LOWER_ENDS])
def test_torques_are_those_of_statics(mechanism: Mechanism, bounds: Bounds) -> None:
    # A millimetre from a stretched leg, rounding of its lever is magnified some 100 times.
    found = examined(mechanism, constructive(mechanism, bounds))
    kept, _ = built(bounds)
    both = kept & inside(found)
    poses = UPPER.poses(0, UPPER.size).T[both]
    expected = planar.worst(ORACLE, poses, 1.0).max(axis=1)
    given = found.fields["effort_max"][both[inside(found)]]
    np.testing.assert_allclose(given, expected, rtol=1e-11)


def test_effective_nodes_are_the_constructive_ones_below_the_limit(mechanism: Mechanism) -> None:
    limited = [*constructive(mechanism, BOTH_ENDS), Effort(mechanism, LOAD, np.full(2, 0.15))]
    kept, decided = built(BOTH_ENDS)
    poses = UPPER.poses(0, UPPER.size).T
    greatest = planar.worst(ORACLE, poses[kept], 1.0).max(axis=1)
    decided[kept] &= np.abs(greatest - 0.15) > 1e-12
    kept[kept] = greatest <= 0.15
    found = inside(examined(mechanism, limited))
    np.testing.assert_array_equal(found[decided], kept[decided])
