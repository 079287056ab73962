"""Platforms that turn about a fixed point: up to eight modes.

A leg says w (R v) = k of the rotation, with w its rod's start and v its platform point, or the
intermediate and the platform axis of an arc. R = F Rz(theta) Ry(acos k) Rz(chi) G' holds the first
leg for every theta and chi, F and G being frames about its w and v; the other two are linear in
(cos chi, sin chi), a point of the unit circle.

References
----------
Gosselin, Sefrioui, Gagne, 1994, doi:10.1115/1.2919419 (eight modes);
Bonev, Chablat, Wenger, 2006, doi:10.1109/ROBOT.2006.1642059 (the agile eye's).
"""

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.one_angle import meetings
from mechanics.assembly.proposals import Proposals
from mechanics.rotations import about, fixed_axis_angles

ROUTE = "one angle"


def propose(legs: BrakedLegs) -> Proposals:
    """Return proposals for all modes of a spherical mechanism's braked legs."""
    starts, points, cosines = _cones(legs)
    # Of the legs that hold the platform the one whose cone is the most open.
    holding = np.any(starts != 0.0, axis=2) & np.any(points != 0.0, axis=2)
    first = np.argmin(np.where(holding, np.abs(cosines), np.inf), axis=1)
    order = (first[:, None] + np.arange(3)) % 3
    starts, points = _ordered(starts, order), _ordered(points, order)
    cosines = np.take_along_axis(cosines, order, axis=1)
    F, G = _frames(starts[:, 0]), _frames(points[:, 0])
    cosine = np.clip(cosines[:, 0], -1.0, 1.0)
    tilts = _about(np.array([0.0, 1.0, 0.0]), np.arccos(cosine))
    planes = _planes(starts[:, 1:] @ F, points[:, 1:] @ G, cosines[:, 1:], tilts)
    found = meetings(planes, np.ones(len(planes)), 4)
    chi = np.arctan2(found.points[:, 1], found.points[:, 0])
    upright = np.array([0.0, 0.0, 1.0])
    thetas, chis = _about(upright, found.angles), _about(upright, chi)
    cases = found.cases
    turned = F[cases] @ thetas @ tilts[cases] @ chis @ G[cases].transpose(0, 2, 1)
    poses = fixed_axis_angles(turned.reshape(-1, 9).T)
    return Proposals(cases, poses, ~found.free, (ROUTE,) * len(planes))


def _cones(legs: BrakedLegs) -> tuple[Floats, Floats, Floats]:
    """Return unit vectors w and v, shape (cases, legs, 3), and k = w (R v), shape (cases, legs)."""
    starts = legs.rod_starts.transpose(2, 0, 1)
    points = np.broadcast_to(legs.mechanism.legs.platform_point, starts.shape)
    w, v = np.linalg.norm(starts, axis=2), np.linalg.norm(points, axis=2)
    # A leg that starts or ends in the centre says nothing of the rotation: any size does.
    w, v = np.where(w > 0.0, w, 1.0), np.where(v > 0.0, v, 1.0)
    squares = np.sum(starts**2, axis=2) + np.sum(points**2, axis=2) - legs.rod_lengths.T**2
    return starts / w[..., None], points / v[..., None], 0.5 * squares / (w * v)


def _ordered(vectors: Floats, order: Integers) -> Floats:
    return np.take_along_axis(vectors, order[..., None], axis=1)


def _frames(axes: Floats) -> Floats:
    """Return frames, shape (cases, 3, 3), as columns, whose last axis is the given one."""
    least = np.eye(3)[np.argmin(np.abs(axes), axis=1)]
    aside = np.cross(axes, least)
    sizes = np.linalg.norm(aside, axis=1, keepdims=True)
    aside /= np.where(sizes > 0.0, sizes, 1.0)
    return np.stack([aside, np.cross(axes, aside), axes], axis=-1)


def _about(axis: Floats, angles: Floats) -> Floats:
    return about(axis[:, None] * angles).T.reshape(-1, 3, 3)


def _planes(starts: Floats, points: Floats, cosines: Floats, tilts: Floats) -> Floats:
    """Return [M | k], shape (cases, 3, 2, 3): two legs' equations in (cos chi, sin chi).

    With g = Ry' Rz(theta)' w: (g_x v_x + g_y v_y) cos chi + (g_y v_x - g_x v_y) sin chi
    + g_z v_z = k.
    """
    x, y, z = np.moveaxis(starts, 2, 0)
    nothing = np.zeros_like(x)
    parts = [(nothing, nothing, z), (x, y, nothing), (y, -x, nothing)]
    turned = np.stack([np.stack(part, axis=-1) for part in parts], axis=1)
    gx, gy, gz = np.moveaxis(turned @ tilts[:, None], 3, 0)
    vx, vy, vz = np.moveaxis(points, 2, 0)[:, :, None]
    k = gz * vz
    k[:, 0] -= cosines
    return np.stack([gx * vx + gy * vy, gy * vx - gx * vy, k], axis=-1)
