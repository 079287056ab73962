"""The rails of the geared mechanism against an independent multibody engine.

The engine has the rails and what they carry, not the motors: rails bear the force at the tool's
point and nothing of a moment. What motors bear is held against virtual work in
`tests/properties/test_wrists.py`.
"""

from functools import cache

import numpy as np
import pytest

from mechanics.configuration import Configuration
from tests.oracles import engine, wrists
from tests.oracles.draws import WRISTED
from tests.oracles.machines import Floats, machine
from tests.reference.test_independent_engine import (
    AGREEMENT,
    HALF_WIDTH,
    MECHANISMS,
    POSES,
    Sample,
    firm,
    held,
    mechanism_of,
)


@cache
def samples() -> list[Sample]:
    random = np.random.default_rng(1922)
    drawn = (held(WRISTED["geared_decoupled"](random), random) for _ in range(1000))
    found = [sample for sample in drawn if sample is not None]
    return found[:MECHANISMS]


@pytest.mark.parametrize("half_width", [0.0, HALF_WIDTH])
def test_rails_bear_the_force(half_width: float) -> None:
    """With pairs of rods nothing keeps what is carried from turning but the rods themselves."""
    compared = 0
    for sample in samples():
        body = machine(sample.wire, half_width)
        for pose, force, drives, efforts in zip(
            sample.poses, sample.forces, sample.actuators, sample.efforts, strict=True
        ):
            centre = wrists.centre(sample.wire, pose)
            if not firm(body, centre, drives[:3]):
                continue
            solved = engine.solve(body, centre, drives[:3], (force, np.zeros(3)))
            off = np.abs(efforts[:3] - solved.efforts).max() / np.abs(solved.efforts).max()
            compared += 1
            assert off <= AGREEMENT
            assert solved.shift <= AGREEMENT
    assert compared == MECHANISMS * POSES or (half_width and compared >= MECHANISMS)


def test_rails_bear_nothing_of_a_moment() -> None:
    for sample in samples():
        mechanism = mechanism_of(sample.wire)
        block = Configuration(mechanism, mechanism.columns(sample.poses))
        rows: Floats = block.effort_rows
        assert np.all(rows[:3, 3:] == 0.0)
