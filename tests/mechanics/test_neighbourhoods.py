"""What is told of all poses near a centre holds there; scans by boxes and by nodes agree."""

import json
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from analyses.mechanisms import build
from mechanics import judging, workspace
from mechanics.arrays import Floats
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
from mechanics.conditions.rod_distance import RodDistance
from mechanics.conditions.rod_rod_angle import RodRodAngle
from mechanics.configuration import Configuration
from mechanics.effort import worst_efforts, worst_efforts_near
from mechanics.grid import Axis, Grid
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Neighbourhood, bounded
from mechanics.octree import Reach as Near
from mechanics.velocity import Speed
from mechanics.workspace import Scan, scan
from schemas.mechanisms import parse_spec
from tests.oracles.draws import DRAWS, EVERY, Draw, Fields, Random

NAMES = [name for name in sorted(DRAWS) if name != "spherical_3rrr"]
SIZE = 2.0
AROUND = 300
LOAD = Load(10.0, 1.0, np.array([[1.0, -2.0, 3.0, 0.1, 0.2, -0.3]]).T)


def wired(wire: Fields) -> Mechanism:
    return build(parse_spec(json.dumps(wire, default=float)))


def centres_of(draw: Draw, mechanism: Mechanism, random: Random, count: int) -> Floats:
    """Return poses, shape (coordinates, poses), that all legs reach."""
    poses = random.uniform(draw.least, draw.most, (40 * count, draw.least.size)).T.copy()
    reached = np.all(Configuration(mechanism, poses).reach >= 0.0, axis=0)
    return np.ascontiguousarray(poses[:, reached][:, :count])


def limited(mechanism: Mechanism, poses: Floats) -> Mechanism:
    """Return the mechanism with stops that some of these poses meet and others do not."""
    drives = Configuration(mechanism, poses).actuators
    low, high = (np.quantile(drives, q, axis=1) for q in (0.1, 0.9))
    return Mechanism(mechanism.motion, mechanism.legs._replace(lower_limit=low, upper_limit=high))


def quantile(values: Floats, share: float) -> float:
    return float(np.quantile(values[np.isfinite(values)], share))


def conditions_of(mechanism: Mechanism, poses: Floats, random: Random) -> list[Condition]:
    """Return conditions of every kind, with limits that some of these poses break."""
    block, share = Configuration(mechanism, poses), random.uniform(0.2, 0.9)
    count, three = mechanism.drive_count, (mechanism.leg_count, 3)
    rest = np.mean(block.rods[0], axis=2) + 0.1 * random.normal(size=three)
    speed = Speed(0.2, 0.3)
    made: list[Condition] = [
        Reach(mechanism),
        ActuatorLimits(mechanism),
        CrankRodAngle(mechanism, 0.6, 2.5),
        RodRodAngle(mechanism, 0.4, 2.6),
        BaseJointAngle(mechanism, rest, random.uniform(0.3, 1.5)),
        PlatformJointAngle(mechanism, rest, random.uniform(0.3, 1.5)),
        RodDistance(mechanism, random.uniform(0.01, 0.2)),
        ConditionNumber(quantile(block.condition_numbers, share)),
        Determinant(quantile(np.abs(block.determinants), 1.0 - share)),
    ]
    for make, limit in (
        (lambda values: Effort(mechanism, LOAD, values), np.zeros(count)),
        (lambda values: ActuatorSpeed(mechanism, speed, values), np.zeros(count)),
    ):
        worst = -make(limit).check(block)
        # Of struts that do not turn, rates never change: no limit is exactly that.
        made.append(make(np.full(count, 1.001 * quantile(worst, share))))
    made.append(PressureAngle(mechanism, quantile(block.pressure_angles, share)))
    return made


def spread_about(mechanism: Mechanism, centre: Floats, near: Near, random: Random) -> Floats:
    """Return poses near a centre, shape (coordinates, poses), as far as they may be and nearer."""
    motion, count = mechanism.motion, AROUND
    moves = np.zeros((centre.size, count))
    turning = np.array([name in motion.turns for name in motion.coordinates])
    for rows, size, order in ((~turning, near.positions, 2), (turning, near.turns, 1)):
        if rows.any():
            ways = random.normal(size=(int(rows.sum()), count))
            ways /= np.linalg.norm(ways, ord=order, axis=0)
            moves[rows] = ways * size * np.minimum(1.0, random.uniform(0.0, 2.0, count))
    return np.ascontiguousarray(centre[:, None] + moves)


@pytest.mark.parametrize("name", NAMES)
def test_no_pose_near_a_centre_breaks_what_is_told_of_it(name: str) -> None:
    random = np.random.default_rng(29)
    for _ in range(3):
        draw = DRAWS[name](random)
        poses = centres_of(draw, wired(draw.wire), random, 60)
        mechanism = limited(wired(draw.wire), poses)
        conditions = conditions_of(mechanism, poses, random)
        count = poses.shape[1]
        sizes = 10.0 ** random.uniform(-4.0, -0.7, (2, count))
        sizes[1] *= random.integers(0, 2, count)
        near = Neighbourhood(Configuration(mechanism, poses), Near(*sizes), SIZE)
        told = [condition.margins_near(near) for condition in conditions]
        for i in range(count):
            about = spread_about(mechanism, poses[:, i], Near(*sizes[:, i]), random)
            block = Configuration(mechanism, about)
            for condition, margins in zip(conditions, told, strict=True):
                holds = condition.check(block) >= 0.0
                assert holds[margins.least[:, i] >= 0.0].all(), condition.reason
                assert not holds[margins.greatest[:, i] < 0.0].any(), condition.reason


LOADS = [LOAD, Load(10.0, 0.0), Load(0.0, 1.0), Load(0.0, 0.0, LOAD.known)]


@pytest.mark.parametrize("load", LOADS, ids=["all", "force", "moment", "known"])
@pytest.mark.parametrize("name", NAMES)
def test_efforts_near_a_centre_are_between_their_bounds(name: str, load: Load) -> None:
    random = np.random.default_rng(71)
    for _ in range(2):
        draw = DRAWS[name](random)
        mechanism = wired(draw.wire)
        poses = centres_of(draw, mechanism, random, 60)
        sizes = 10.0 ** random.uniform(-5.0, -1.0, (2, poses.shape[1]))
        sizes[1] *= random.integers(0, 2, poses.shape[1])
        near = Neighbourhood(Configuration(mechanism, poses), Near(*sizes), SIZE)
        least, greatest = worst_efforts_near(near, load)
        for i in range(poses.shape[1]):
            about = spread_about(mechanism, poses[:, i], Near(*sizes[:, i]), random)
            efforts = worst_efforts(Configuration(mechanism, about), load)
            assert np.isfinite(efforts[np.isfinite(greatest[:, i])]).all()
            assert not np.any(efforts < least[:, [i]])
            assert not np.any(efforts > greatest[:, [i]])


def test_bounds_on_efforts_of_struts_are_off_by_squares_alone() -> None:
    random = np.random.default_rng(73)
    draw = DRAWS["gough_stewart"](random)
    mechanism, load = wired(draw.wire), Load(10.0, 1.0)
    poses = centres_of(draw, mechanism, random, 100)

    def efforts(moved: Floats) -> Floats:
        return worst_efforts(Configuration(mechanism, np.ascontiguousarray(moved)), load)

    steps = 1e-6 * np.eye(6)[:3, :, None]
    slopes = np.array([(efforts(poses + step) - efforts(poses - step)) / 2e-6 for step in steps])
    steepest = np.linalg.norm(slopes, axis=0)
    beyond = []
    for size in (1e-3, 5e-4):
        reach = Near(np.full(poses.shape[1], size), np.zeros(poses.shape[1]))
        near = Neighbourhood(Configuration(mechanism, poses), reach, SIZE)
        least, greatest = worst_efforts_near(near, load)
        beyond.append(np.stack([greatest - efforts(poses), efforts(poses) - least]))
        beyond[-1] -= size * steepest
    quartered = beyond[1] / beyond[0]
    assert np.nanmedian(quartered) < 0.27


@pytest.mark.parametrize("name", NAMES)
def test_what_holds_at_a_pose_does_not_depend_on_its_company(name: str) -> None:
    random = np.random.default_rng(61)
    draw = DRAWS[name](random)
    poses = centres_of(draw, wired(draw.wire), random, 200)
    mechanism = limited(wired(draw.wire), poses)
    for condition in conditions_of(mechanism, poses, random):
        together = condition.check(Configuration(mechanism, poses))
        for i in range(poses.shape[1]):
            own = condition.check(Configuration(mechanism, np.ascontiguousarray(poses[:, [i]])))
            assert own.tobytes() == together[:, [i]].tobytes(), condition.reason


def test_motors_of_a_wrist_do_not_depend_on_the_company_of_a_pose() -> None:
    random = np.random.default_rng(67)
    draw = EVERY["geared_decoupled"](random)
    poses = random.uniform(draw.least, draw.most, (100, draw.least.size)).T.copy()
    together = Configuration(wired(draw.wire), poses).actuators
    for i in range(poses.shape[1]):
        own = Configuration(wired(draw.wire), np.ascontiguousarray(poses[:, [i]])).actuators
        assert own.tobytes() == together[:, [i]].tobytes()


@pytest.mark.parametrize("name", NAMES)
def test_enough_is_told_of_small_neighbourhoods(name: str) -> None:
    random = np.random.default_rng(31)
    draw = DRAWS[name](random)
    poses = centres_of(draw, wired(draw.wire), random, 100)
    mechanism = limited(wired(draw.wire), poses)
    small = Near(*np.full((2, poses.shape[1]), 1e-5))
    near = Neighbourhood(Configuration(mechanism, poses), small, SIZE)
    for condition in conditions_of(mechanism, poses, random):
        holds = condition.check(near.centre) >= 0.0
        least, greatest = condition.margins_near(near)
        enough = 0.9 * holds.size
        assert np.count_nonzero((least >= 0.0) == holds) >= enough, condition.reason
        assert np.count_nonzero((greatest < 0.0) == ~holds) >= enough, condition.reason


@pytest.mark.parametrize("name", ["five_bar", "delta_linear", "gough_stewart"])
def test_out_of_reach_is_told_too(name: str) -> None:
    random = np.random.default_rng(37)
    draw = DRAWS[name](random)
    mechanism = wired(draw.wire)
    wide = 4.0 * np.ones(draw.least.size)
    poses = random.uniform(draw.least - wide, draw.most + wide, (200, wide.size)).T.copy()
    near = Neighbourhood(Configuration(mechanism, poses), Near(*np.full((2, 200), 1e-3)), 8.0)
    least, greatest = Reach(mechanism).margins_near(near)
    missed = ~(near.centre.reach >= 0.0)
    assert np.mean((greatest < 0.0) == missed) > 0.98
    assert not np.any((greatest < 0.0) & ~missed)
    assert not np.any((least >= 0.0) & missed)


def test_arcs_and_wrists_have_no_bounds() -> None:
    random = np.random.default_rng(41)
    without = [name for name in sorted(EVERY) if not bounded(wired(EVERY[name](random).wire))]
    assert without == ["geared_decoupled", "spherical_3rrr"]


@pytest.fixture
def boxes_always(monkeypatch: pytest.MonkeyPatch) -> None:
    """Judge boxes however few nodes they have, and there are."""
    worth = {"WORTH_BOXES": 1, "SPARSE": 10**9, "MOST_ASKED": 2.0, "MOST_ASKED_QUICKLY": 2.0}
    for name, value in worth.items():
        monkeypatch.setattr(judging, name, value)
    monkeypatch.setattr(workspace, "FEWEST", 4)


def same(one: Scan, other: Scan) -> bool:
    return one.codes.tobytes() == other.codes.tobytes() and (
        one.lengths.tobytes() == other.lengths.tobytes()
    )


def grid_of(draw: Draw, mechanism: Mechanism, names: list[str], nodes: int) -> Grid:
    """Return a grid along some coordinates, somewhat wider than the draw's box."""
    columns = [mechanism.motion.coordinates.index(name) for name in names]
    middle, wide = 0.5 * (draw.most + draw.least), 1.3 * (draw.most - draw.least)
    count = round(nodes ** (1.0 / len(names)))
    axes = tuple(
        Axis(name, middle[c] - 0.5 * wide[c], middle[c] + 0.5 * wide[c], wide[c] / (count - 0.5))
        for name, c in zip(names, columns, strict=True)
    )
    return Grid(axes, tuple(columns), middle)


def coordinates_of_one_kind() -> list[tuple[str, str]]:
    """Return the draws, with each kind of coordinates that their motions have."""
    motions = {name: wired(DRAWS[name](np.random.default_rng(0)).wire).motion for name in NAMES}
    kinds = ("translations", "turns")
    return [(name, kind) for name in NAMES for kind in kinds if getattr(motions[name], kind)]


@pytest.mark.usefixtures("boxes_always")
@pytest.mark.parametrize(("name", "kind"), coordinates_of_one_kind())
def test_boxes_and_nodes_agree(name: str, kind: str) -> None:
    random = np.random.default_rng(43)
    draw = DRAWS[name](random)
    poses = centres_of(draw, wired(draw.wire), random, 200)
    mechanism = limited(wired(draw.wire), poses)
    grid = grid_of(draw, mechanism, list(getattr(mechanism.motion, kind)), 20_000)
    asked = conditions_of(mechanism, poses, random)
    for conditions in (asked, asked[:1], [asked[0], asked[-1]], asked[1:3]):
        by_boxes = scan(mechanism, conditions, grid, {}, 0, grid.size)
        by_nodes = scan(mechanism, conditions, grid, {}, 0, grid.size, by_boxes=False)
        assert same(by_boxes, by_nodes)


def counting(monkeypatch: pytest.MonkeyPatch) -> Callable[[], int]:
    """Return how many nodes have been asked one by one since the last call."""
    asked: list[int] = []
    checked = Determinant.check

    def check(self: Determinant, block: Configuration) -> Floats:
        asked.append(block.count)
        return checked(self, block)

    monkeypatch.setattr(Determinant, "check", check)

    def count() -> int:
        total = sum(asked)
        asked.clear()
        return total

    return count


@pytest.mark.usefixtures("boxes_always")
def test_half_the_step_asks_far_less_than_all_the_nodes(monkeypatch: pytest.MonkeyPatch) -> None:
    random = np.random.default_rng(47)
    draw = DRAWS["delta_rotary"](random)
    mechanism = wired(draw.wire)
    poses = centres_of(draw, mechanism, random, 200)
    limit = quantile(np.abs(Configuration(mechanism, poses).determinants), 0.3)
    conditions = [Reach(mechanism), Determinant(limit)]
    count = counting(monkeypatch)
    asked = []
    for nodes in (30**3, 60**3):
        grid = grid_of(draw, mechanism, ["x", "y", "z"], nodes)
        scan(mechanism, conditions, grid, {}, 0, grid.size)
        asked.append(count() / grid.size)
    assert asked[1] < 0.7 * asked[0]


@pytest.mark.usefixtures("boxes_always")
@pytest.mark.parametrize("name", ["delta_rotary", "gough_stewart", "planar_3rrr"])
def test_a_stretch_by_boxes_may_begin_and_end_within_a_line(name: str) -> None:
    random = np.random.default_rng(53)
    draw = DRAWS[name](random)
    poses = centres_of(draw, wired(draw.wire), random, 200)
    mechanism = limited(wired(draw.wire), poses)
    grid = grid_of(draw, mechanism, list(mechanism.motion.translations), 60_000)
    conditions = conditions_of(mechanism, poses, random)[:1]
    conditions.append(PressureAngle(mechanism, 0.9))
    whole = scan(mechanism, conditions, grid, {}, 0, grid.size, by_boxes=False)
    dense = np.repeat(whole.codes, whole.lengths)
    line = grid.shape[-1]
    for start, stop in pairwise([0, 1, 5 * line + 3, grid.size // 2 + 7, grid.size - 1, grid.size]):
        part = scan(mechanism, conditions, grid, {}, start, stop)
        assert np.array_equal(np.repeat(part.codes, part.lengths), dense[start:stop])


@pytest.mark.usefixtures("boxes_always")
def test_only_nodes_asked_for_are_told_by_boxes() -> None:
    random = np.random.default_rng(59)
    draw = DRAWS["delta_linear"](random)
    mechanism = wired(draw.wire)
    grid = grid_of(draw, mechanism, ["x", "y", "z"], 30_000)
    conditions = [Reach(mechanism), PressureAngle(mechanism, 0.8)]
    among = random.uniform(size=grid.size) < 0.3
    both = [
        scan(mechanism, conditions, grid, {}, 0, grid.size, by_boxes=by_boxes, among=among)
        for by_boxes in (True, False)
    ]
    assert same(*both)
