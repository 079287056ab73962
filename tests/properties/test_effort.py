"""Efforts: balance of power, scaling, symmetries, worst loads."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from mechanics.configuration import Configuration
from mechanics.effort import signed_efforts, worst_efforts, worst_load
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from tests.oracles import planar
from tests.properties.samples import MODEST, Sample, away_from_type_2, numbers, samples

LOADS = st.builds(Load, force=numbers(0.0, 50.0), moment=numbers(0.0, 20.0))
WRENCHES = st.lists(numbers(-50.0, 50.0), min_size=6, max_size=6).map(
    lambda wrench: np.array(wrench)[:, None]
)


def in_plane(wrench: planar.Floats, turns: bool) -> planar.Floats:
    """Return the part of a wrench that the platform can follow: (fx, fy) or (fx, fy, mz)."""
    return wrench[[0, 1, 5] if turns else [0, 1], 0]


def sizes(sample: Sample, wrench: planar.Floats) -> float:
    """Return how large any torque's rounding may be, in units of the machine's precision."""
    condition = float(planar.spread(sample.oracle, sample.row)[0])
    arm = sample.radius or 1.0
    force = float(np.abs(wrench[:3]).max() + np.abs(wrench[3:]).max() / arm)
    # A rod's direction is known to r / (height of the crank's triangle) roundings.
    slant = 1 / float(np.sin(planar.elbow_angles(sample.oracle, sample.row)).min())
    stretch = float(planar.spans(sample.oracle, sample.row).max()) / sample.rod
    return 1e3 * condition**2 * slant * stretch**2 * force * sample.crank


@MODEST
@given(samples(), WRENCHES)
def test_signed_efforts_are_those_of_statics(sample: Sample, wrench: planar.Floats) -> None:
    away_from_type_2(sample)
    load = in_plane(wrench, sample.radius is not None)[:, None]
    expected = planar.torques(sample.oracle, sample.row, load)[0, :, 0]
    given_ = signed_efforts(sample.block, Load(known=wrench))[:, 0]
    slack = np.finfo(float).eps * sizes(sample, wrench)
    np.testing.assert_allclose(given_, expected, rtol=1e-9, atol=slack)


@MODEST
@given(samples(), WRENCHES, WRENCHES)
def test_drives_give_the_power_that_the_load_takes(
    sample: Sample, wrench: planar.Floats, motion: planar.Floats
) -> None:
    """T . psidot = -P . xdot, the rates from the constraint Jx xdot = Jpsi psidot."""
    away_from_type_2(sample)
    turns = sample.radius is not None
    block, rates = sample.block, in_plane(motion, turns)
    drives = (block.platform_jacobians[..., 0] @ rates) / block.rods[1][:, 0]
    powers = signed_efforts(block, Load(known=wrench))[:, 0] * drives
    taken = in_plane(wrench, turns) @ rates
    lost = np.abs(rates).max() * np.finfo(float).eps * sizes(sample, wrench) / sample.crank
    assert powers.sum() == pytest.approx(-taken, rel=1e-9, abs=1e-9 * np.abs(powers).max() + lost)


@MODEST
@given(samples(), LOADS)
def test_worst_effort_is_that_of_statics(sample: Sample, load: Load) -> None:
    away_from_type_2(sample, 100.0)
    expected = planar.worst(sample.oracle, sample.row, load.force, load.moment)[0]
    np.testing.assert_allclose(worst_efforts(sample.block, load)[:, 0], expected, rtol=1e-8)


@MODEST
@given(samples(), numbers(0.1, 50.0))
def test_no_direction_of_force_asks_more(sample: Sample, force: float) -> None:
    away_from_type_2(sample, 100.0)
    searched = planar.worst_by_search(sample.oracle, sample.row, force, 3600)[0]
    worst = worst_efforts(sample.block, Load(force=force))[:, 0]
    assert np.all(searched <= worst * (1 + 1e-8))
    assert np.all(searched >= worst * (math.cos(math.radians(0.05)) - 1e-8))


@MODEST
@given(samples(), numbers(0.1, 50.0), st.integers(-6, 6))
def test_scaling_by_a_power_of_two_is_exact(sample: Sample, force: float, power: int) -> None:
    scale = 2.0**power
    small, large = sample.block, sample.scaled(scale).block
    np.testing.assert_array_equal(
        worst_efforts(large, Load(force=force)), scale * worst_efforts(small, Load(force=force))
    )


@MODEST
@given(samples(), LOADS, st.floats(0.01, 100.0))
def test_efforts_grow_with_the_lengths(sample: Sample, load: Load, scale: float) -> None:
    away_from_type_2(sample, 100.0)
    longer = Load(force=load.force, moment=load.moment * scale)
    expected = scale * worst_efforts(sample.block, load)
    grown = worst_efforts(sample.scaled(scale).block, longer)
    np.testing.assert_allclose(grown, expected, rtol=1e-8)


@MODEST
@given(samples(), LOADS, st.floats(0.001, 1000.0))
def test_efforts_grow_with_the_load(sample: Sample, load: Load, factor: float) -> None:
    more = Load(force=load.force * factor, moment=load.moment * factor)
    expected = factor * worst_efforts(sample.block, load)
    np.testing.assert_allclose(worst_efforts(sample.block, more), expected, rtol=1e-13)


@MODEST
@given(samples(radii=False), LOADS)
def test_five_bar_mirrored_left_to_right(sample: Sample, load: Load) -> None:
    away_from_type_2(sample, 100.0)
    x, y = sample.pose
    left, right = sample.signs
    mirrored = replace(sample, pose=(-x, y), signs=(-right, -left))
    there = worst_efforts(mirrored.block, load)[::-1]
    np.testing.assert_allclose(there, worst_efforts(sample.block, load), rtol=1e-9)


@MODEST
@given(samples(radii=False), LOADS)
def test_five_bar_mirrored_upside_down(sample: Sample, load: Load) -> None:
    away_from_type_2(sample, 100.0)
    x, y = sample.pose
    mirrored = replace(sample, pose=(x, -y), signs=(-sample.signs[0], -sample.signs[1]))
    there = worst_efforts(mirrored.block, load)
    np.testing.assert_allclose(there, worst_efforts(sample.block, load), rtol=1e-9)


@MODEST
@given(samples(radii=True), LOADS)
def test_3rrr_turned_by_a_third(sample: Sample, load: Load) -> None:
    away_from_type_2(sample, 100.0)
    x, y, phi = sample.pose
    turned = complex(x, y) * np.exp(2j * np.pi / 3)
    first, second, third = sample.signs
    moved = replace(sample, pose=(turned.real, turned.imag, phi), signs=(third, first, second))
    there = worst_efforts(moved.block, load)[[1, 2, 0]]
    np.testing.assert_allclose(there, worst_efforts(sample.block, load), rtol=1e-8)


@MODEST
@given(samples(radii=True), LOADS)
def test_3rrr_mirrored_left_to_right(sample: Sample, load: Load) -> None:
    away_from_type_2(sample, 100.0)
    x, y, phi = sample.pose
    top, left, right = sample.signs
    mirrored = replace(sample, pose=(-x, y, -phi), signs=(-top, -right, -left))
    there = worst_efforts(mirrored.block, load)[[0, 2, 1]]
    np.testing.assert_allclose(there, worst_efforts(sample.block, load), rtol=1e-8)


@MODEST
@given(samples(radii=True), LOADS)
def test_whole_turns_of_the_platform_change_nothing(sample: Sample, load: Load) -> None:
    away_from_type_2(sample, 100.0)
    x, y, phi = sample.pose
    turned = replace(sample, pose=(x, y, phi + 4 * math.pi))
    there = worst_efforts(turned.block, load)
    np.testing.assert_allclose(there, worst_efforts(sample.block, load), rtol=1e-8)


def moved(mechanism: Mechanism, angle: float, shift: planar.Floats) -> Mechanism:
    """Return the mechanism with its base turned about z and shifted in the plane."""
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    base = mechanism.legs.base_point @ turn.T + np.array([*shift, 0.0])
    return replace(mechanism, legs=mechanism.legs._replace(base_point=base))


@MODEST
@given(samples(), LOADS, numbers(-3.0, 3.0), numbers(-2.0, 2.0), numbers(-2.0, 2.0))
def test_moving_everything_changes_no_effort(
    sample: Sample, load: Load, angle: float, right: float, up: float
) -> None:
    away_from_type_2(sample, 100.0)
    x, y, *turn = sample.pose
    there = complex(x, y) * np.exp(1j * angle) + complex(right, up)
    pose = np.array([there.real, there.imag, *(phi + angle for phi in turn)])[:, None]
    block = Configuration(moved(sample.mechanism, angle, np.array([right, up])), pose)
    expected = worst_efforts(sample.block, load)
    np.testing.assert_allclose(worst_efforts(block, load), expected, rtol=1e-7)


@MODEST
@given(samples(), LOADS, WRENCHES)
def test_the_worst_load_reaches_the_effort(
    sample: Sample, load: Load, wrench: planar.Floats
) -> None:
    away_from_type_2(sample)
    asked = Load(force=load.force, moment=load.moment, known=wrench)
    block = sample.block
    efforts, worst = worst_efforts(block, asked), worst_load(block, asked)
    for drive in range(sample.legs):
        total = wrench + np.concatenate([worst.force[drive], worst.moment[drive]])
        reached = abs(signed_efforts(block, Load(known=total))[drive, 0])
        terms = np.abs(block.effort_rows[drive, :, 0]) @ (np.abs(total) + np.abs(wrench))[:, 0]
        assert reached == pytest.approx(efforts[drive, 0], rel=1e-13, abs=1e-14 * terms)


@MODEST
@given(samples(), LOADS)
def test_the_worst_load_has_the_given_size(sample: Sample, load: Load) -> None:
    away_from_type_2(sample)
    worst = worst_load(sample.block, load)
    np.testing.assert_allclose(np.linalg.norm(worst.force, axis=1), load.force, rtol=1e-13)
    turning = load.moment if sample.radius is not None else 0.0
    np.testing.assert_allclose(np.linalg.norm(worst.moment, axis=1), turning, rtol=1e-13)


@MODEST
@given(samples(), LOADS, WRENCHES)
def test_a_known_load_adds_its_size(sample: Sample, load: Load, wrench: planar.Floats) -> None:
    block = sample.block
    together = worst_efforts(block, Load(load.force, load.moment, known=wrench))
    known = np.abs(signed_efforts(block, Load(known=wrench)))
    np.testing.assert_allclose(together, known + worst_efforts(block, load), rtol=1e-13)


@MODEST
@given(samples(), WRENCHES)
def test_turning_the_known_load_round_turns_the_torque(
    sample: Sample, wrench: planar.Floats
) -> None:
    forth = signed_efforts(sample.block, Load(known=wrench))
    back = signed_efforts(sample.block, Load(known=-wrench))
    np.testing.assert_array_equal(forth, -back)


@MODEST
@given(samples())
def test_loads_that_the_bearings_carry_ask_nothing(sample: Sample) -> None:
    away_from_type_2(sample)
    wrench = np.array([0.0, 0.0, 7.0, 3.0, -2.0, 0.0 if sample.radius else 5.0])[:, None]
    np.testing.assert_array_equal(signed_efforts(sample.block, Load(known=wrench)), 0.0)


@MODEST
@given(st.lists(samples(radii=False), min_size=1, max_size=4), LOADS)
def test_a_pose_of_a_block_is_as_if_alone(drawn: list[Sample], load: Load) -> None:
    first = drawn[0]
    poses = np.ascontiguousarray(np.array([sample.pose for sample in drawn] * 33).T)
    together = worst_efforts(Configuration(first.mechanism, poses), load)
    assume(not np.isnan(together[:, 0]).any())
    for number in range(0, poses.shape[1], 7):
        alone = Configuration(first.mechanism, np.ascontiguousarray(poses[:, number : number + 1]))
        np.testing.assert_array_equal(together[:, number], worst_efforts(alone, load)[:, 0])


def test_each_pose_has_its_own_known_load() -> None:
    sample = Sample(6.0, None, 5.0, 5.0, (1, -1), (0.5, 4.0))
    poses = np.ascontiguousarray(np.repeat(sample.row, 3, axis=0).T)
    loads = np.zeros((6, 3))
    loads[0] = [1.0, 2.0, -1.0]
    efforts = signed_efforts(Configuration(sample.mechanism, poses), Load(known=loads))
    np.testing.assert_allclose(efforts, efforts[:, :1] * loads[0], rtol=1e-15)
