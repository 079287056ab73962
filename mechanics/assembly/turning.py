"""Platforms with one turning angle: planar motion and Schoenflies motion.

With s = c_0 - B_0 for one leg, the others say |s + R beta - Gamma|^2 = L^2 of it, beta and Gamma
their platform points and rod starts as seen from that leg's. Less |s|^2 = L_0^2 these are planes
that turn with the angle.

References
----------
Merlet, Parallel Robots, 2006, sec. 4.3 (three legs in a plane: six modes).
"""

import numpy as np

from mechanics.arrays import Floats
from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.one_angle import meetings
from mechanics.assembly.proposals import Proposals
from mechanics.rotations import about

ROUTE = "one angle"


def propose(legs: BrakedLegs) -> Proposals:
    """Return proposals for all modes of a planar or Schoenflies mechanism's braked legs."""
    motion = legs.mechanism.motion
    axis, basis = motion.axis, motion.twists[:3, :-1]
    points = legs.mechanism.legs.platform_point
    starts, sizes = legs.rod_starts.transpose(2, 0, 1), legs.sizes
    # Lengths of about 1: the polynomial is of high degree in them.
    squares = (legs.rod_lengths.T / sizes[:, None]) ** 2
    arms = (points - points[0]) / sizes[:, None, None]
    feet = (starts - starts[:, :1]) / sizes[:, None, None]
    # What the motion cannot change of c_0 - B_0 is taken off its rod.
    level = (points[0] - starts[:, 0]) / sizes[:, None]
    level = level - level @ basis @ basis.T
    planes = _planes(axis, basis, arms[:, 1:], feet[:, 1:], squares, level)
    degree = 3 if len(points) == 3 else 4
    found = meetings(planes, squares[:, 0] - np.sum(level**2, axis=1), degree)
    rotations = about(axis[:, None] * found.angles)
    turned = np.sum(rotations.reshape(3, 3, -1) * points[0][:, None], axis=1).T
    away = found.points * sizes[found.cases, None]
    moved = away + (starts[found.cases, 0] - turned) @ basis
    poses = np.vstack([moved.T, found.angles])
    return Proposals(found.cases, poses, ~found.free, (ROUTE,) * len(planes))


def _planes(
    axis: Floats, basis: Floats, arms: Floats, feet: Floats, squares: Floats, level: Floats
) -> Floats:
    """Return [M | k], shape (cases, 3, m, m + 1), of M s = -k: 1, cos(phi), sin(phi).

    |s + v|^2 = L^2 - L_0^2 + |s|^2 with v = R beta - Gamma and s = T s' + level.
    """
    parts = _turning_parts(axis, arms)
    moved = parts.copy()
    moved[:, 0] -= feet
    heads = moved @ basis
    k = np.sum(moved * level[:, None, None] - feet[:, None] * parts, axis=-1)
    fixed = np.sum(arms**2, axis=-1) + np.sum(feet**2, axis=-1)
    k[:, 0] += 0.5 * (fixed + squares[:, :1] - squares[:, 1:])
    return np.concatenate([heads, k[..., None]], axis=-1)


def _turning_parts(axis: Floats, arms: Floats) -> Floats:
    """Return the parts of R beta without, with cos(phi) and with sin(phi): (cases, 3, legs, 3)."""
    along = (arms @ axis)[..., None] * axis
    return np.stack([along, arms - along, np.cross(axis, arms)], axis=1)
