"""Inverse kinematics: constraint, working modes, rates."""

import json

import numpy as np
from hypothesis import assume, given

import analyses
from mechanics.configuration import Configuration
from schemas.inverse_kinematics import InverseKinematicsAllModesResult
from tests.oracles import planar
from tests.oracles.drives import actuators
from tests.properties.samples import MODEST, Sample, samples


def crank_ends(sample: Sample, angles: planar.Floats) -> planar.Floats:
    oracle = sample.oracle
    turned = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    ends: planar.Floats = oracle.base + oracle.crank * turned
    return ends


@MODEST
@given(samples(clear=0.0))
def test_rods_keep_their_length(sample: Sample) -> None:
    angles = actuators(sample.mechanism, sample.row)[0]
    joints = planar.joints(sample.oracle, sample.row)[0]
    if np.isnan(angles).any():  # on the very border of reach
        assert planar.reach_margins(sample.oracle, sample.row).min() < 1e-12
        return
    squares = np.sum((joints - crank_ends(sample, angles)) ** 2, axis=1)
    largest = np.maximum(planar.spans(sample.oracle, sample.row)[0], sample.crank)
    scale = np.maximum(largest, sample.rod) ** 2
    assert np.all(np.abs(squares - sample.rod**2) <= 1e-12 * scale)


@MODEST
@given(samples())
def test_angles_are_those_of_crossing_circles(sample: Sample) -> None:
    gap = actuators(sample.mechanism, sample.row) - planar.crank_angles(sample.oracle, sample.row)
    assert np.abs(np.angle(np.exp(1j * gap))).max() < 1e-11


@MODEST
@given(samples())
def test_angles_lie_in_one_turn(sample: Sample) -> None:
    angles = actuators(sample.mechanism, sample.row)
    assert np.all((angles > -np.pi) & (angles <= np.pi))


@MODEST
@given(samples())
def test_every_working_mode_puts_the_elbow_on_its_side(sample: Sample) -> None:
    away = planar.joints(sample.oracle, sample.row)[0] - sample.oracle.base
    for mode in sample.mechanism.working_modes:
        angles = actuators(sample.mechanism.in_working_mode(mode), sample.row)[0]
        side = planar.cross(away, crank_ends(sample, angles) - sample.oracle.base)
        assert tuple(np.sign(side)) == mode


@MODEST
@given(samples())
def test_all_working_modes_are_listed_once(sample: Sample) -> None:
    modes = sample.mechanism.working_modes
    assert len(modes) == len(set(modes)) == 2**sample.legs


@MODEST
@given(samples())
def test_all_modes_by_request_are_each_mode_alone(sample: Sample) -> None:
    body = {
        "analysis": "inverse_kinematics",
        "mechanism": sample.wire,
        "poses": [list(sample.pose)],
    }
    every = analyses.answer(analyses.parse(json.dumps({**body, "working_mode": "all"})))
    assert isinstance(every, InverseKinematicsAllModesResult)
    assert len(every.working_modes) == 2**sample.legs
    for mode, rows in zip(every.working_modes, every.actuators, strict=True):
        alone = analyses.answer(analyses.parse(json.dumps({**body, "working_mode": mode})))
        assert alone.model_dump()["actuators"] == rows


@MODEST
@given(samples(clear=0.2))
def test_jacobian_is_the_derivative_of_the_inverse(sample: Sample) -> None:
    """Central differences with a step h of 1e-5 of the shortest length l.

    With s the sine of the elbow angle (here > 0.3) the truncation is of the order of
    (h/l)^2 / s^5 < 1e-7 of a unit rate 1/l, the rounding of 1e-16 pi / (h/l) < 1e-10.
    """
    block, mechanism = sample.block, sample.mechanism
    elbows = planar.elbow_angles(sample.oracle, sample.row)
    assume(np.sin(elbows).min() > 0.3)
    _, levers = block.rods
    jacobian = (block.platform_jacobians / levers[:, None])[..., 0]
    shortest = min(sample.crank, sample.rod, float(planar.spans(sample.oracle, sample.row).min()))
    reach = np.ones(len(sample.pose))
    reach[2:] = max(sample.radius or 0.0, shortest)
    for column, arm in enumerate(reach):
        step = np.zeros(len(sample.pose))
        step[column] = 1e-5 * shortest / arm
        ends = actuators(mechanism, np.stack([sample.row[0] + step, sample.row[0] - step]))
        change = np.angle(np.exp(1j * (ends[0] - ends[1])))
        slope = change / (2 * step[column])
        np.testing.assert_allclose(jacobian[:, column], slope, rtol=0, atol=1e-6 * arm / shortest)


@MODEST
@given(samples())
def test_jacobians_are_those_of_cut_free_bodies(sample: Sample) -> None:
    columns, levers = planar.force_columns(sample.oracle, sample.row)
    block = Configuration(sample.mechanism, np.ascontiguousarray(sample.row.T))
    np.testing.assert_allclose(block.platform_jacobians[..., 0].T, columns[0], atol=1e-11)
    np.testing.assert_allclose(block.rods[1][:, 0], levers[0], atol=1e-11 * sample.crank)
