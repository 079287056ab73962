"""Answers to single poses, by the million, against bare floors and other programs."""

from functools import partial

import numpy as np

from analyses.analysis import POSES_PER_BLOCK
from benchmarks import rivals
from benchmarks.measuring import compare
from benchmarks.mechanisms import POSES, hexapod
from mechanics import effort
from mechanics.arrays import Floats
from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.guess import Convergence, close_nearby
from mechanics.configuration import Configuration
from mechanics.kernels import batches
from mechanics.loads import Load
from mechanics.mechanism import Mechanism


def inverse_of_struts() -> None:
    """Compare the inverse of a 6-SPS, a pose, with bare roots, NumPy and basic-robotics."""
    mechanism, rows = hexapod()
    poses = np.ascontiguousarray(rows.T)
    lengths = np.empty_like(poses)
    base, platform = mechanism.legs.base_point, mechanism.legs.platform_point

    def ours() -> None:
        batches.actuators(mechanism.motion.kernel, mechanism.legs, poses, lengths)

    name = "6-SPS inverse, a pose"
    roots, roots_by_pose = np.empty_like(poses), np.empty_like(rows)
    compare(name, ours, POSES, "six roots, by coordinate", lambda: rivals.roots(poses, roots))
    compare(name, ours, POSES, "six roots, by pose", lambda: rivals.roots(rows, roots_by_pose))
    numpy = partial(rivals.strut_lengths, rows, base, platform)
    ours()
    np.testing.assert_allclose(lengths.T, numpy(), rtol=1e-12)
    compare(name, ours, POSES, "NumPy, blocks of 4096", numpy)
    inverse = rivals.basic_robotics_inverse(base, platform)
    asked = rivals.transformations(rows[:200])
    difference = np.abs([inverse(pose) for pose in asked] - lengths[:, :200].T).max()
    assert difference < 1e-12, f"basic-robotics and we differ by {difference} m"
    loop = partial(rivals.for_each, inverse, asked)
    compare(name, ours, POSES, "basic-robotics, IK", loop, rival_items=200)


def forward_of_struts() -> None:
    """Compare Newton's iteration from a guess, a pose, with basic-robotics' forward kinematics.

    What is compared is where guesses lead; the determinant and sign of each mode come on top.
    """
    mechanism, rows = hexapod()
    rows = np.ascontiguousarray(rows[:100_000] * [1.0, 1.0, 1.0, 0.3, 0.3, 0.3])
    poses = np.ascontiguousarray(rows.T)
    lengths = np.empty((6, len(rows)))
    batches.actuators(mechanism.motion.kernel, mechanism.legs, poses, lengths)
    starts = range(0, len(rows), POSES_PER_BLOCK)
    blocks = [np.ascontiguousarray(lengths[:, a : a + POSES_PER_BLOCK]) for a in starts]
    guesses = np.repeat([[0.0], [0.0], [1.0], [0.0], [0.0], [0.0]], POSES_PER_BLOCK, axis=1)

    def ours() -> list[Convergence]:
        legs = [BrakedLegs(mechanism, block) for block in blocks]
        return [close_nearby(some, guesses[:, : some.actuators.shape[1]]) for some in legs]

    found = np.concatenate([one.poses for one in ours()], axis=1)
    assert all(one.converged.all() for one in ours()), "some guesses did not converge"
    assert np.abs(found - poses).max() < 1e-9
    joints = mechanism.legs.base_point, mechanism.legs.platform_point
    forward = rivals.basic_robotics_forward(*joints)
    asked = lengths[:, :50].T.copy()
    difference = np.abs([forward(row) for row in asked] - poses[:3, :50].T).max()
    assert difference < 1e-3, f"basic-robotics and we differ by {difference} m"
    loop = partial(rivals.for_each, forward, asked)
    name = "6-SPS from a guess, a pose"
    compare(name, ours, len(rows), "basic-robotics, FK", loop, rival_items=50)


def efforts(name: str, mechanism: Mechanism, rows: Floats) -> None:
    """Compare worst-direction efforts from poses with batched inversion of ready Jacobians."""
    poses = np.ascontiguousarray(rows.T)
    ready = Configuration(mechanism, poses)
    jacobians = ready.platform_jacobians / ready.rods[1][:, None, :]
    matrices = np.ascontiguousarray(np.moveaxis(jacobians, 2, 0))
    split = len(mechanism.motion.translations)
    load = Load(10.0, 2.0)
    starts = range(0, len(rows), POSES_PER_BLOCK)
    blocks = [np.ascontiguousarray(poses[:, a : a + POSES_PER_BLOCK]) for a in starts]

    def ours() -> list[Floats]:
        return [effort.worst_efforts(Configuration(mechanism, block), load) for block in blocks]

    def theirs() -> Floats:
        return rivals.worst_efforts(matrices, 10.0, 2.0, split)

    np.testing.assert_allclose(np.concatenate(ours(), axis=1), theirs().T, rtol=1e-6)
    compare(name, ours, len(rows), "numpy.linalg.inv + norms, J given", theirs)
