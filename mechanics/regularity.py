"""Whether a mechanism can ever be regular."""

import numpy as np

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.errors import GeometryError
from mechanics.legs import STRUT
from mechanics.mechanism import Mechanism
from mechanics.singularity import singularities

_TRIED = (32, 256, 4096)
"""Random poses of one round after the other, until `_ENOUGH` are in reach."""
_ENOUGH = 24
_IRREGULAR = 1e-9


def check_regular(mechanism: Mechanism) -> None:
    """Raise GeometryError if the mechanism is singular wherever its legs reach.

    Legs that are the same are named; any other mechanism is tried at random poses, and is
    architecturally singular if the inverse condition number vanishes at all that it reaches.
    Says nothing of a mechanism that reaches none of them.
    """
    _check_distinct(mechanism)
    few = Configuration(mechanism, _reached_poses(mechanism))
    if not few.count:
        return
    worst = 1.0 / singularities(few).condition_number
    if np.all(worst <= _IRREGULAR):
        raise GeometryError(
            "architecturally singular: det Jx = 0 at every pose, so the platform always has an "
            "uncontrolled motion"
        )


def _check_distinct(mechanism: Mechanism) -> None:
    legs = mechanism.legs
    vectors = (legs.base_point, legs.platform_point, legs.axis, legs.zero_direction)
    numbers = (legs.drive, legs.crank_length, legs.rod_length, legs.working_mode)
    ends = np.hstack([*vectors, np.stack(numbers, axis=1)])
    for one in range(len(ends)):
        for two in range(one):
            if np.array_equal(ends[one], ends[two]):
                raise GeometryError(
                    f"its joints coincide with those of leg {two}, at base and platform", leg=one
                )


def _reached_poses(mechanism: Mechanism) -> Floats:
    """Return at most `_ENOUGH` random poses that all legs reach, as columns; repeatable."""
    random = np.random.default_rng(20161105)
    reached = np.empty((len(mechanism.motion.coordinates), 0))
    for count in _TRIED:
        poses = _random_poses(mechanism, random, count)
        held = np.all(Configuration(mechanism, poses).reach >= 0.0, axis=0)
        reached = np.hstack([reached, poses[:, held]])
        if reached.shape[1] >= _ENOUGH:
            break
    return np.ascontiguousarray(reached[:, :_ENOUGH])


def _random_poses(mechanism: Mechanism, random: np.random.Generator, count: int) -> Floats:
    """Return poses, shape (coordinates, poses), in the space that the legs span."""
    legs = mechanism.legs
    centre = legs.base_point.mean(axis=0)
    extent = float(np.max(np.linalg.norm(legs.base_point - centre, axis=1)))
    lengths = legs.crank_length + np.where(legs.drive == STRUT, extent, legs.rod_length)
    size = max(extent, float(lengths.max()))
    motion = mechanism.motion
    poses = random.uniform(-1.0, 1.0, (len(motion.coordinates), count))
    for k, name in enumerate(motion.coordinates):
        if name in motion.translations:
            poses[k] = centre @ motion.twists[:3, k] + size * poses[k]
        else:
            poses[k] *= 0.7
    return np.ascontiguousarray(poses)
