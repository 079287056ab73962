"""Efforts against an independent multibody engine, as in Laryushkin et al., 2016.

The engine is exudyn: it is given bodies, rods and joints worked out anew from the wire, and
solves the equations of static equilibrium; no Jacobian of the product reaches it.
"""

import json
import math
from collections.abc import Callable, Sequence
from functools import cache
from itertools import islice
from typing import Any, NamedTuple
from zlib import crc32

import numpy as np
import pytest

import analyses
from analyses.mechanisms import build
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from schemas.effort import EffortResult
from schemas.mechanisms import parse_spec
from tests.oracles import engine, machines
from tests.oracles.draws import DRAWS, Draw
from tests.oracles.machines import Floats, Machine, Wire, machine

MECHANISMS = 10
POSES = 3
AGREEMENT = 1e-12
SPREAD = 50.0
"""The greatest condition number of a pose that is tried, turns measured at `ARM`."""

ARM = 0.2
"""About the size of the platforms. [m]"""

CLEAR = 0.1
"""The least share of its drive's motion that must go along a leg's rod."""

PAIRED = (
    "translational_3rrrr",
    "delta_rotary",
    "delta_linear",
    "delta_linear_4dof",
)
HALF_WIDTH = 0.04

Record = Callable[[str, Any], None]


class Sample(NamedTuple):
    """A mechanism at poses under a load each; arrays have one row a pose."""

    wire: Wire
    poses: Floats
    forces: Floats
    moments: Floats
    actuators: Floats
    efforts: Floats


class Comparison(NamedTuple):
    """Over all samples: poses, greatest difference by pose, greatest shift of the platform."""

    poses: int
    difference: float
    shift: float


def answer(wire: Wire, poses: Floats, **loads: Any) -> EffortResult:  # noqa: ANN401
    body = {"analysis": "effort", "mechanism": wire, "poses": poses.tolist(), **loads}
    request = analyses.parse(json.dumps(body))
    analyses.check(request, 10**9)
    result = analyses.answer(request)
    assert isinstance(result, EffortResult)
    return result


def known(forces: Floats, moments: Floats) -> dict[str, Any]:
    return {"known_load": {"force": forces.tolist(), "moment": moments.tolist()}}


def mechanism_of(wire: Wire) -> Mechanism:
    return build(parse_spec(json.dumps(wire)))


def regular(mechanism: Mechanism, poses: Floats) -> list[bool]:
    """Return which poses are in reach and clear of singularities of either type."""
    block = Configuration(mechanism, mechanism.columns(poses))
    turning = np.any(mechanism.motion.twists[3:], axis=0)
    size = np.where(turning, 1.0 / ARM, 1.0)
    driven = np.where(mechanism.legs.crank_length > 0.0, mechanism.legs.crank_length, 1.0)
    share = np.min(np.abs(block.rods[1]) / driven[:, None], axis=0)
    return [
        bool(np.isfinite(share[k]) and share[k] > CLEAR)
        and bool(np.linalg.cond(block.platform_jacobians[:, :, k] * size) < SPREAD)
        for k in range(len(poses))
    ]


def held(draw: Draw, random: np.random.Generator) -> Sample | None:
    """Return the drawn mechanism at regular poses under random loads, if it has enough."""
    mechanism = mechanism_of(draw.wire)
    tried = random.uniform(draw.least, draw.most, (40, len(draw.least)))
    poses = tried[regular(mechanism, tried)][:POSES]
    if len(poses) < POSES:
        return None
    forces, moments = random.normal(size=(2, POSES, 3))
    actuators = Configuration(mechanism, mechanism.columns(poses)).actuators.T
    efforts = np.array(answer(draw.wire, poses, **known(forces, moments)).effort)
    return Sample(draw.wire, poses, forces, moments, actuators, efforts)


@cache
def samples(name: str) -> list[Sample]:
    random = np.random.default_rng(crc32(name.encode()))
    drawn = (held(DRAWS[name](random), random) for _ in range(1000))
    return list(islice((sample for sample in drawn if sample is not None), MECHANISMS))


def firm(body: Machine, pose: Floats, actuators: Floats) -> bool:
    """Return whether parallelograms take the platform's turning away with room to spare."""
    if not body.pairs:
        return True
    screws = machines.rod_screws(body, pose, actuators)
    scaled = screws / np.array([1.0, 1.0, 1.0, *[body.pairs] * 3])
    return bool(np.linalg.cond(scaled) < SPREAD)


@cache
def compared(name: str, half_width: float = 0.0) -> Comparison:
    poses, difference, shift = 0, 0.0, 0.0
    for sample in samples(name):
        body = machine(sample.wire, half_width)
        for pose, *load, actuators, efforts in zip(*sample[1:], strict=True):
            if not firm(body, pose, actuators):
                continue
            poses += 1
            solved = engine.solve(body, pose, actuators, (load[0], load[1]))
            off = np.abs(efforts - solved.efforts).max() / np.abs(efforts).max()
            difference, shift = max(difference, float(off)), max(shift, solved.shift)
    return Comparison(poses, difference, shift)


@pytest.mark.parametrize("name", DRAWS)
def test_efforts_are_those_of_the_engine(name: str, record_testsuite_property: Record) -> None:
    found = compared(name)
    record_testsuite_property(f"{name} in {found.poses}", found.difference)
    assert found.poses == MECHANISMS * POSES
    assert found.difference <= AGREEMENT


@pytest.mark.parametrize("name", DRAWS)
def test_drives_put_the_platform_at_its_pose(name: str) -> None:
    assert compared(name).shift <= AGREEMENT


@pytest.mark.parametrize("name", PAIRED)
def test_parallelograms_are_pairs_of_rods(name: str, record_testsuite_property: Record) -> None:
    """No motion is locked here: the second rods take the platform's turning away."""
    found = compared(name, HALF_WIDTH)
    record_testsuite_property(f"{name} with pairs of rods in {found.poses}", found.difference)
    assert found.poses >= MECHANISMS
    assert found.difference <= AGREEMENT


@pytest.mark.parametrize("name", PAIRED)
def test_pairs_of_rods_leave_the_platform_at_its_pose(name: str) -> None:
    assert compared(name, HALF_WIDTH).shift <= AGREEMENT


@pytest.mark.parametrize("name", DRAWS)
def test_the_engine_confirms_the_worst_load(name: str) -> None:
    sample = samples(name)[0]
    result = answer(sample.wire, sample.poses[:1], load={"force": 7.0, "moment": 2.0})
    assert result.worst_force is not None
    assert result.worst_moment is not None
    loads = zip(result.worst_force[0], result.worst_moment[0], strict=True)
    body, pose, actuators = machine(sample.wire), sample.poses[0], sample.actuators[0]
    reached = [
        abs(engine.solve(body, pose, actuators, (force or [], moment or [])).efforts[leg])
        for leg, (force, moment) in enumerate(loads)
    ]
    assert reached == pytest.approx(result.effort[0], rel=1e-11)


def test_the_engine_counts_a_pushing_strut_as_positive() -> None:
    """Three struts at 45 degrees under a weight: each pushes with weight/(3 sin 45)."""
    feet = [[math.cos(a), math.sin(a), 0.0] for a in np.deg2rad([0.0, 120.0, 240.0])]
    legs = [{"drive": "strut", "base_point": f, "platform_point": [0.0, 0.0, 0.0]} for f in feet]
    body = machine({"kind": "custom", "motion": "translation", "legs": legs})
    lengths = np.full(3, math.sqrt(2.0))
    solved = engine.solve(body, [0.0, 0.0, 1.0], lengths, ([0.0, 0.0, -9.0], [0.0] * 3))
    assert solved.efforts == pytest.approx([3.0 * math.sqrt(2.0)] * 3, rel=1e-14)


def rose(size: float, times: Floats) -> Floats:
    """Return poses along a three-petalled rose, drawn once in 15 s, phi = 0."""
    turn = math.pi * times / 15.0
    reach = size * np.cos(3.0 * turn)
    return np.column_stack([reach * np.cos(turn), reach * np.sin(turn), np.zeros_like(turn)])


def test_the_published_rose(record_testsuite_property: Record) -> None:
    """Laryushkin, Glazunov, Erastova, 2016: at most 7e-10 per cent, by drive, as in their (9).

    P = (sin 2 pi t/15, cos 2 pi t/15, 0) N, every 0.01 s for 15 s. The rose's size is not
    printed: petals of 0.1 m about the base triangle's centroid lie within the workspace and clear
    of the points 0.151 m from it where a leg folds.
    """
    wire = {"kind": "planar_3rrr", "base_side": 0.4, "platform_radius": 0.08}
    wire |= {"crank_length": 0.18, "rod_length": 0.18}
    times = np.linspace(0.0, 15.0, 1501)
    poses = rose(0.1, times)
    phase = 2.0 * math.pi * times / 15.0
    forces = np.column_stack([np.sin(phase), np.cos(phase), np.zeros_like(phase)])
    efforts = np.array(answer(wire, poses, **known(forces, 0.0 * forces)).effort)
    mechanism = mechanism_of(wire)
    actuators = Configuration(mechanism, mechanism.columns(poses)).actuators.T
    expected = _along(wire, poses, actuators, forces)
    differences = np.abs(np.abs(efforts) - np.abs(expected)) / np.abs(expected)
    record_testsuite_property("rose", float(differences.max()))
    assert differences.max() <= 7e-12


def _along(wire: Wire, poses: Floats, actuators: Floats, forces: Floats) -> Floats:
    body, none = machine(wire), np.zeros(3)
    rows: Sequence[Floats] = [
        engine.solve(body, pose, drives, (force, none)).efforts
        for pose, drives, force in zip(poses, actuators, forces, strict=True)
    ]
    return np.array(rows)
