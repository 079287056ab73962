"""What is found in one pass and by way of everything else are the same numbers."""

import numpy as np
import pytest

from analyses.mechanisms import build
from mechanics.configuration import Configuration
from mechanics.effort import worst_efforts
from mechanics.loads import Load
from schemas.starters import STARTERS


@pytest.mark.parametrize("kind", sorted(STARTERS))
@pytest.mark.parametrize("count", [1, 127, 128, 300])
def test_one_pass_agrees_bit_for_bit(kind: str, count: int) -> None:
    mechanism = build(STARTERS[kind])
    random = np.random.default_rng(count)
    poses = random.uniform(-0.4, 0.4, (len(mechanism.motion.coordinates), count))
    in_one_pass = Configuration(mechanism, poses).actuators
    block = Configuration(mechanism, poses)
    assert block.travel.shape == (mechanism.leg_count, 2, count)
    assert in_one_pass.tobytes() == block.actuators.tobytes()


@pytest.mark.parametrize("kind", sorted(STARTERS))
@pytest.mark.parametrize("count", [1, 63, 64, 300])
def test_efforts_in_one_pass_agree_bit_for_bit(kind: str, count: int) -> None:
    mechanism = build(STARTERS[kind])
    random = np.random.default_rng(count)
    poses = random.uniform(-0.4, 0.4, (len(mechanism.motion.coordinates), count))
    for known in (np.zeros((6, 1)), random.normal(size=(6, 1)), random.normal(size=(6, count))):
        load = Load(3.0, 0.7, known)
        in_one_pass = worst_efforts(Configuration(mechanism, poses), load)
        block = Configuration(mechanism, poses)
        assert block.determinants.shape == (count,)
        assert in_one_pass.tobytes() == worst_efforts(block, load).tobytes()
        alone = Configuration(mechanism, np.ascontiguousarray(poses[:, -1:]))
        last = worst_efforts(alone, Load(3.0, 0.7, known[:, -1:]))
        assert last[:, 0].tobytes() == in_one_pass[:, -1].tobytes()


def test_angles_far_out_do_not_change_their_neighbours() -> None:
    mechanism = build(STARTERS["gough_stewart"])
    poses = np.random.default_rng(1).uniform(-0.4, 0.4, (6, 128))
    alone = Configuration(mechanism, poses.copy()).actuators
    poses[3:, 40] = 1e9
    beside = Configuration(mechanism, poses).actuators
    others = np.arange(128) != 40
    assert np.array_equal(alone[:, others], beside[:, others])
