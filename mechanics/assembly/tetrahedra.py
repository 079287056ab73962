"""Six rods of which three meet in one joint and two in another: three tetrahedra in a row.

The joint of three is the apex over the other ends of its rods, the joint of two that over the
first joint and the other ends of its own, the third likewise: each to either side, so up to eight
modes in closed form. It does not matter whether platform or base carries the three joints.

References
----------
Glazunov et al., closed solutions of the direct problem for l-coordinate mechanisms.
"""

from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.proposals import Proposals
from mechanics.assembly.spheres import meet
from mechanics.legs import STRUT
from mechanics.rotations import coordinates

ROUTE = "tetrahedra"

_COINCIDENT = 1e-9
"""Joints closer than this share of the points' extent are one."""

Joints = tuple[tuple[int, int, int], tuple[int, int], int]
"""The legs of the joint of three, of the joint of two, and the last one."""


class Structure(NamedTuple):
    """How six rods make tetrahedra: their joints, and whether those are the platform's."""

    joints: Joints
    on_platform: bool


def structure(base_points: Floats, platform_points: Floats) -> Structure | None:
    """Return the 3-2-1 structure of six rods, the platform's before the base's; None: neither.

    Parameters
    ----------
    base_points, platform_points : arrays, shape (6, 3). [m]
    """
    for points, on_platform in ((platform_points, True), (base_points, False)):
        joints = three_two_one(points)
        if joints is not None:
            return Structure(joints, on_platform)
    return None


def three_two_one(points: Floats) -> Joints | None:
    """Return which of six points are three in one and two in another; None: no such points."""
    extent = np.linalg.norm(np.ptp(points, axis=0))
    gaps = np.linalg.norm(points[:, None] - points, axis=2)
    first = np.argmax(gaps <= _COINCIDENT * extent, axis=1)
    groups = sorted((np.flatnonzero(first == one) for one in set(first.tolist())), key=len)
    if [len(group) for group in groups] != [1, 2, 3]:
        return None
    (c,), (b, d), (a, e, f) = (group.tolist() for group in groups)
    return (a, e, f), (b, d), c


def structure_of(legs: BrakedLegs) -> Structure | None:
    """Return the 3-2-1 structure that a mechanism has wherever its drives stand."""
    of = legs.mechanism.legs
    if np.all(of.drive == STRUT):
        return structure(of.base_point, of.platform_point)
    joints = three_two_one(of.platform_point)
    return None if joints is None else Structure(joints, True)


def propose(legs: BrakedLegs, found: Structure) -> Proposals:
    """Return proposals for all modes of six braked legs of this structure."""
    starts = legs.rod_starts.transpose(2, 0, 1)
    ends = np.broadcast_to(legs.mechanism.legs.platform_point, starts.shape)
    near, far = (ends, starts) if found.on_platform else (starts, ends)
    apexes, determined = _apexes(found.joints, near, far, legs.rod_lengths.T**2)
    own = _corners(found.joints, near)
    cases, modes = np.nonzero(np.all(np.isfinite(apexes), axis=(2, 3)))
    there, here = apexes[cases, modes], own[cases]
    # Found is the triangle of joints as the other body sees it.
    platform, base = (here, there) if found.on_platform else (there, here)
    rotations = _triads(base) @ _triads(platform).transpose(0, 2, 1)
    positions = base[:, 0] - np.sum(rotations * platform[:, :1], axis=2)
    poses = coordinates(legs.mechanism.motion, positions.T, rotations.reshape(-1, 9).T)
    sound = np.all(np.isfinite(poses), axis=0)
    certified = determined & ~_in_line(own)
    return Proposals(cases[sound], poses[:, sound], certified, (ROUTE,) * len(starts))


def _corners(joints: Joints, points: Floats) -> Floats:
    """Return the three joints, shape (cases, 3, 3), among six points."""
    return points[:, [joints[0][0], joints[1][0], joints[2]]]


def _apexes(joints: Joints, near: Floats, far: Floats, squares: Floats) -> tuple[Floats, Booleans]:
    """Return the three joints, shape (cases, 8, 3, 3), as the other body sees them."""
    three, two, one = list(joints[0]), list(joints[1]), [joints[2]]
    corners = _corners(joints, near)
    sides = np.sum((corners[:, [0, 0, 1]] - corners[:, [1, 2, 2]]) ** 2, axis=2)
    first, sound = meet(far[:, three], squares[:, three])
    second, more = _above([first], sides[:, :1], far[:, two], squares[:, two])
    first = np.broadcast_to(first[:, :, None], second.shape)
    third, most = _above([first, second], sides[:, 1:], far[:, one], squares[:, one])
    branches = [np.broadcast_to(joint[..., None, :], third.shape) for joint in (first, second)]
    apexes = np.stack([*branches, third], axis=-2).reshape(-1, 8, 3, 3)
    determined = sound & np.all(more, axis=1) & np.all(most, axis=(1, 2))
    return apexes, determined


def _above(
    found: list[Floats], sides: Floats, far: Floats, squares: Floats
) -> tuple[Floats, Booleans]:
    """Return both places of a joint, shape (cases, ..., 2, 3), over found joints and far ends."""
    branches = found[0].shape[1:-1]
    wide = (slice(None), *(None for _ in branches))
    ends = np.broadcast_to(far[wide], (len(far), *branches, *far.shape[1:]))
    centres = np.concatenate([np.stack(found, axis=-2), ends], axis=-2)
    lengths = np.concatenate([sides, squares], axis=1)[wide]
    return meet(centres, np.broadcast_to(lengths, centres.shape[:-1]))


def _in_line(corners: Floats) -> Booleans:
    """Return, shape (cases,), where the joints are in one line, about which the platform spins."""
    sides = corners[:, 1:] - corners[:, :1]
    upright = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    in_line: Booleans = upright <= _COINCIDENT * np.prod(np.linalg.norm(sides, axis=2), axis=1)
    return in_line


def _triads(corners: Floats) -> Floats:
    """Return frames, shape (cases, 3, 3), as columns, that triangles carry along."""
    along = corners[:, 1] - corners[:, 0]
    upright = np.cross(along, corners[:, 2] - corners[:, 0])
    with np.errstate(divide="ignore", invalid="ignore"):
        along = along / np.linalg.norm(along, axis=1, keepdims=True)
        upright = upright / np.linalg.norm(upright, axis=1, keepdims=True)
    return np.stack([along, np.cross(upright, along), upright], axis=-1)
