"""Conditions at poses that can be worked out by hand."""

import math

import numpy as np
import pytest

from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.actuator_speed import ActuatorSpeed
from mechanics.conditions.base_joint_angle import BaseJointAngle
from mechanics.conditions.condition import Condition
from mechanics.conditions.condition_number import ConditionNumber
from mechanics.conditions.crank_rod_angle import CrankRodAngle
from mechanics.conditions.determinant import Determinant
from mechanics.conditions.effort import Effort
from mechanics.conditions.platform_joint_angle import PlatformJointAngle
from mechanics.conditions.pressure_angle import PressureAngle
from mechanics.conditions.reach import Reach
from mechanics.conditions.rod_distance import RodDistance, separate_rods
from mechanics.conditions.rod_rod_angle import RodRodAngle
from mechanics.configuration import Configuration
from mechanics.families.five_bar import five_bar, planar_leg
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.legs import STRUT, STRUT_JOINTS, Leg, gather
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.motions import PLANAR
from mechanics.velocity import Speed

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


def strut_mechanism(*bases: tuple[float, float, float]) -> Mechanism:
    """Return three struts in the plane from these points to (0, 0), (1, 0) and (0, 1)."""
    points = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    legs = [
        Leg(STRUT, base, point, joints=STRUT_JOINTS)
        for base, point in zip(bases, points, strict=True)
    ]
    return Mechanism(PLANAR, gather(legs, np.array([[-np.inf, np.inf]] * 3), np.ones(3)))


def margins(condition: Condition, mechanism: Mechanism, *pose: float) -> list[float]:
    block = Configuration(mechanism, np.array(pose)[:, None].copy())
    found: list[float] = condition.check(block)[:, 0].tolist()
    return found


STRUTS = strut_mechanism((-3.0, -4.0, 0.0), (1.0, -2.0, 0.0), (0.0, -1.0, 0.0))
LEAN = math.atan2(3, 4)


def test_a_struts_base_joint_rests_in_the_base_frame() -> None:
    upright = np.array([[0.0, 1.0, 0.0]] * 3)
    condition = BaseJointAngle(STRUTS, upright, 1.0)
    assert margins(condition, STRUTS, 0.0, 0.0, 0.0) == pytest.approx([1.0 - LEAN, 1.0, 1.0])


def test_a_crank_turns_the_joint_at_its_elbow_along() -> None:
    # At rest along the crank, so along y where the crank stands upright.
    along = np.array([[1.0, 0.0, 0.0]] * 2)
    assert margins(BaseJointAngle(bar(), along, 1.0), bar(), *POSE) == pytest.approx([1 - LEAN] * 2)


def test_a_cranks_joint_may_rest_along_its_axis() -> None:
    axis = np.array([[0.0, 0.0, 3.0]] * 2)
    found = margins(BaseJointAngle(bar(), axis, math.pi), bar(), *POSE)
    assert found == pytest.approx([math.pi / 2] * 2)


def test_a_platform_joint_rests_in_the_platforms_frame() -> None:
    aside = np.array([[1.0, 0.0, 0.0]] * 3)
    condition = PlatformJointAngle(STRUTS, aside, 2.0)
    # x of the platform is y of the base after a quarter turn; leg 0 leans as before.
    assert margins(condition, STRUTS, 0.0, 0.0, math.pi / 2)[0] == pytest.approx(2.0 - LEAN)
    assert margins(condition, STRUTS, 0.0, 0.0, 0.0) == pytest.approx(
        [2.0 - (math.pi / 2 - LEAN), 2.0 - math.pi / 2, 2.0 - math.pi / 2]
    )


@pytest.mark.parametrize(("limit", "held"), [(LEAN + 1e-9, True), (LEAN - 1e-9, False)])
def test_a_cone_holds_up_to_its_limit(limit: float, held: bool) -> None:
    along = np.array([[1.0, 0.0, 0.0]] * 2)
    assert holds(BaseJointAngle(bar(), along, limit)) == [held, held]
    assert holds(PlatformJointAngle(bar(), along[:, [1, 0, 2]], limit)) == [held, held]


def test_rods_that_share_a_joint_keep_no_distance() -> None:
    assert separate_rods(bar()) == []


def test_struts_that_share_a_base_point_keep_no_distance() -> None:
    shared = strut_mechanism((0.0, -3.0, 0.0), (0.0, -3.0, 0.0), (1.0, -3.0, 0.0))
    assert separate_rods(shared) == [(0, 2), (1, 2)]


def test_rods_on_cranks_of_one_axis_may_still_touch() -> None:
    ends = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)]
    legs = [planar_leg(np.zeros(3), np.array(end), 1.0, 2.0) for end in (*ends, (0.0, 1.0, 0.0))]
    limits = np.array([[-np.inf, np.inf]] * 3)
    mechanism = Mechanism(PLANAR, gather(legs, limits, np.ones(3)))
    assert separate_rods(mechanism) == [(0, 1), (0, 2), (1, 2)]


def test_rods_keep_their_distance_pair_by_pair() -> None:
    # Upright from (1, -2) to (1, 0) and from (0, -1) to (0, 1): 1 apart. The first leg leans
    # from (-3, -4) to (0, 0): 1 from the second's top, and through the third's middle.
    condition = RodDistance(STRUTS, 0.25)
    assert condition.legs == (0, 0, 1)
    assert margins(condition, STRUTS, 0.0, 0.0, 0.0) == pytest.approx([0.75, -0.25, 0.75])


@pytest.mark.parametrize(("limit", "held"), [(1.0 - 1e-9, True), (1.0 + 1e-9, False)])
def test_a_distance_holds_down_to_its_limit(limit: float, held: bool) -> None:
    block = Configuration(STRUTS, np.zeros((3, 1)))
    assert bool(RodDistance(STRUTS, limit).check(block)[2, 0] >= 0) is held


WORKED = math.acos(0.96)


@pytest.mark.parametrize(("limit", "held"), [(WORKED + 1e-9, True), (WORKED - 1e-9, False)])
def test_pressure_angles_of_the_worked_example(limit: float, held: bool) -> None:
    assert holds(PressureAngle(bar(), limit)) == [held, held]


@pytest.mark.parametrize(("limit", "held"), [(0.96 - 1e-9, True), (0.96 + 1e-9, False)])
def test_the_determinant_of_the_worked_example(limit: float, held: bool) -> None:
    assert holds(Determinant(limit)) == [held]


@pytest.mark.parametrize(("limit", "held"), [(4 / 3 + 1e-9, True), (4 / 3 - 1e-9, False)])
def test_the_condition_number_of_the_worked_example(limit: float, held: bool) -> None:
    assert holds(ConditionNumber(limit)) == [held]


@pytest.mark.parametrize(("limit", "held"), [(2 / 3 + 1e-9, True), (2 / 3 - 1e-9, False)])
def test_the_actuator_speed_of_the_worked_example(limit: float, held: bool) -> None:
    # The elbow's speed along its rod is 3 m/s at 1 rad/s, and the platform's at most 2.
    condition = ActuatorSpeed(bar(), Speed(linear=2.0, angular=9.0), np.full(2, limit))
    assert holds(condition) == [held, held]


def five_bar_at(crank: float, rod: float, *pose: float) -> Configuration:
    mechanism = five_bar(
        base_distance=6.0,
        crank_length=crank,
        rod_length=rod,
        limits=np.array([[-np.inf, np.inf]] * 2),
        working_mode=np.array([1.0, -1.0]),
    )
    return Configuration(mechanism, np.array(pose)[:, None].copy())


def test_no_speed_is_enough_for_a_stretched_leg() -> None:
    block = five_bar_at(2.0, 3.0, 1.0, 3.0)
    condition = ActuatorSpeed(block.mechanism, Speed(linear=1e-9), np.full(2, 1e12))
    assert condition.explain(block).value[0, 0] == math.inf
    assert (condition.check(block)[:, 0] >= 0).tolist() == [False, True]


def test_nothing_holds_the_platform_where_rods_are_in_line() -> None:
    block = five_bar_at(5.0, 6.0, 0.0, 4.0)
    assert not Determinant(1e-9).check(block)[0, 0] >= 0
    assert not ConditionNumber(1e9).check(block)[0, 0] >= 0
    assert not PressureAngle(block.mechanism, 1.57).check(block)[0, 0] >= 0


FAR = (12.0, 0.0)


@pytest.mark.parametrize(
    "condition",
    [
        BaseJointAngle(bar(), np.eye(3)[:2], math.pi),
        PlatformJointAngle(bar(), np.eye(3)[:2], math.pi),
        PressureAngle(bar(), math.pi),
        ActuatorSpeed(bar(), Speed(), np.full(2, 1e12)),
        Determinant(1e-12),
        ConditionNumber(1e12),
    ],
    ids=lambda condition: condition.reason,
)
def test_a_pose_out_of_reach_holds_nothing(condition: Condition) -> None:
    assert holds(condition, FAR)[0] is False


@pytest.mark.parametrize(
    "condition",
    [
        BaseJointAngle(bar(), np.eye(3)[:2], 0.3),
        PlatformJointAngle(bar(), np.eye(3)[:2], 0.3),
        PressureAngle(bar(), 0.2),
        ActuatorSpeed(bar(), Speed(1.0), np.full(2, 0.1)),
        Determinant(0.5),
        ConditionNumber(1.2),
    ],
    ids=lambda condition: condition.reason,
)
def test_a_breach_is_as_large_as_its_margin(condition: Condition) -> None:
    block = Configuration(bar(), np.array(POSE)[:, None].copy())
    breach, margin = condition.explain(block), condition.check(block)
    assert np.abs(breach.value - breach.limit) == pytest.approx(np.abs(margin))
