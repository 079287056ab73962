"""Conditions at poses that can be worked out by hand."""

import math

import numpy as np
import pytest

from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import Condition
from mechanics.conditions.crank_rod_angle import CrankRodAngle
from mechanics.conditions.effort import Effort
from mechanics.conditions.reach import Reach
from mechanics.conditions.rod_rod_angle import RodRodAngle
from mechanics.configuration import Configuration
from mechanics.families.five_bar import five_bar
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.loads import Load
from mechanics.mechanism import Mechanism

TURN = 2 * math.pi
# Cranks upright, rods along (3, 4) and (-3, 4): elbows 90 + atan(4/3), rods 2 atan(3/4) apart.
POSE = (0.0, 9.0)
ELBOW = math.pi / 2 + math.atan2(4, 3)
SHARED = 2 * math.atan2(3, 4)


def bar(low: float = -math.inf, high: float = math.inf) -> Mechanism:
    return five_bar(
        base_distance=6.0,
        crank_length=5.0,
        rod_length=5.0,
        limits=np.array([[low, high], [-np.inf, np.inf]]),
        working_mode=np.array([1.0, -1.0]),
    )


def holds(condition: Condition, pose: tuple[float, float] = POSE) -> list[bool]:
    block = Configuration(bar(), np.array(pose)[:, None].copy())
    return [bool(margin >= 0) for margin in condition.check(block)[:, 0]]


@pytest.mark.parametrize("turns", [-2, -1, 0, 1, 2])
def test_limits_hold_whole_turns_away(turns: int) -> None:
    low = math.pi / 2 - 0.1 + turns * TURN
    assert holds(ActuatorLimits(bar(low, low + 0.2))) == [True, True]


@pytest.mark.parametrize("turns", [-2, -1, 0, 1, 2])
def test_limits_are_broken_whole_turns_away(turns: int) -> None:
    low = math.pi / 2 + 0.1 + turns * TURN
    assert holds(ActuatorLimits(bar(low, low + TURN - 0.2))) == [False, True]


@pytest.mark.parametrize(("low", "high"), [(-math.inf, 0.0), (0.0, math.inf)])
def test_a_limit_at_one_end_alone_stops_no_crank(low: float, high: float) -> None:
    # Some whole number of turns always brings the angle below it, or above it.
    assert holds(ActuatorLimits(bar(low, high))) == [True, True]


def test_limits_that_meet_allow_their_angle() -> None:
    angle = float(Configuration(bar(), np.array(POSE)[:, None].copy()).actuators[0, 0])
    assert holds(ActuatorLimits(bar(angle, angle))) == [True, True]


@pytest.mark.parametrize(
    ("low", "high", "held"),
    [
        (ELBOW - 1e-9, math.pi, True),
        (ELBOW + 1e-9, math.pi, False),
        (0.0, ELBOW + 1e-9, True),
        (0.0, ELBOW - 1e-9, False),
    ],
)
def test_the_angle_at_the_elbow_is_the_inside_one(low: float, high: float, held: bool) -> None:
    assert holds(CrankRodAngle(bar(), low, high)) == [held, held]


@pytest.mark.parametrize(
    ("low", "high", "held"),
    [
        (SHARED - 1e-9, math.pi, True),
        (SHARED + 1e-9, math.pi, False),
        (0.0, SHARED + 1e-9, True),
        (0.0, SHARED - 1e-9, False),
    ],
)
def test_the_angle_between_rods_is_0_when_folded(low: float, high: float, held: bool) -> None:
    assert holds(RodRodAngle(bar(), low, high)) == [held]


@pytest.mark.parametrize(("limit", "held"), [(3.1250001, True), (3.1249999, False)])
def test_effort_up_to_its_limit(limit: float, held: bool) -> None:
    # A tenth of the links of the worked example: 10 N give 3.125 N m there, 31.25 here.
    condition = Effort(bar(), Load(force=1.0), np.full(2, limit))
    assert holds(condition) == [held, held]


@pytest.mark.parametrize(
    ("pose", "held"),
    [((0.0, 9.0), [True, True]), ((12.0, 0.0), [False, True]), ((-12.0, 0.0), [True, False])],
)
def test_reach_is_said_leg_by_leg(pose: tuple[float, float], held: list[bool]) -> None:
    assert holds(Reach(bar()), pose) == held


def test_reach_names_the_rod_that_would_do() -> None:
    block = Configuration(bar(), np.array([[12.0], [0.0]]))
    breach = Reach(bar()).explain(block)
    assert breach.value[0, 0] == pytest.approx(10.0)
    assert breach.limit[0, 0] == 5.0


def test_what_cannot_be_reached_holds_nothing() -> None:
    condition = CrankRodAngle(bar(), 0.0, math.pi)
    assert holds(condition, (12.0, 0.0))[0] is False


def test_rods_of_a_3rrr_share_no_joint() -> None:
    mechanism = planar_3rrr(
        base_side=0.4,
        platform_radius=0.08,
        crank_length=0.18,
        rod_length=0.18,
        limits=np.array([[-np.inf, np.inf]] * 3),
        working_mode=np.ones(3),
    )
    assert RodRodAngle(mechanism, 0.0, 1.0).legs == ()
