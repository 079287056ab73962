"""Rotation matrices back into a motion's coordinates, and small turns put on top of them.

Matrices have shape (9, poses), row by row, as `Motion.place` gives them.
"""

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.placing import TURNING_ABOUT_AXIS, TURNING_ABOUT_FIXED_AXES
from mechanics.motions import Motion


def coordinates(motion: Motion, positions: Floats, rotations: Floats) -> Floats:
    """Return the poses, shape (coordinates, poses), that place the platform there. [m, rad]

    Parameters
    ----------
    motion : what the platform can do; of a place that it cannot take, the part that it can.
    positions, rotations : arrays, shapes (3, poses) and (9, poses).
    """
    moved = motion.twists[:3, : len(motion.translations)].T @ positions
    if motion.turning == TURNING_ABOUT_AXIS:
        return np.vstack([moved, _angle_about(motion.axis, rotations)])
    if motion.turning == TURNING_ABOUT_FIXED_AXES:
        return np.vstack([moved, fixed_axis_angles(rotations)])
    return moved


def fixed_axis_angles(rotations: Floats) -> Floats:
    """Return rx, ry, rz of Rz(rz) Ry(ry) Rx(rx), shape (3, poses); ry in [-pi/2, pi/2]. [rad]

    rx is read after rz has been taken off, so that the three together are exact where ry is at
    its ends and rx and rz turn about one axis.
    """
    r = rotations
    ry = np.arctan2(-r[6], np.hypot(r[0], r[3]))
    rz = np.arctan2(r[3], r[0])
    c, s = np.cos(rz), np.sin(rz)
    rx = np.arctan2(s * r[2] - c * r[5], c * r[4] - s * r[1])
    return np.stack([rx, ry, rz])


def move(motion: Motion, poses: Floats, steps: Floats) -> Floats:
    """Return the poses, shape (coordinates, poses), after a step along the motion's unit twists.

    Turns are finite: a step of turning is carried out about its own axis.
    """
    moved: Floats = poses + steps
    if motion.turning == TURNING_ABOUT_FIXED_AXES:
        _, rotations = motion.place(poses)
        moved[-3:] = fixed_axis_angles(product(about(steps[-3:]), rotations))
    return moved


def about(turns: Floats) -> Floats:
    """Return the rotations, shape (9, poses), by rotation vectors, shape (3, poses). [rad]"""
    x, y, z = turns
    angle = np.sqrt(x * x + y * y + z * z)
    # sin(a)/a and (1 - cos(a))/a^2, both whole at 0.
    s, half = np.sinc(angle / np.pi), np.sinc(0.5 * angle / np.pi)
    v, c = 0.5 * half * half, np.cos(angle)
    return np.stack(
        [
            c + v * x * x,
            v * x * y - s * z,
            v * x * z + s * y,
            v * x * y + s * z,
            c + v * y * y,
            v * y * z - s * x,
            v * x * z - s * y,
            v * y * z + s * x,
            c + v * z * z,
        ]
    )


def product(left: Floats, right: Floats) -> Floats:
    """Return the rotations left right, shape (9, poses)."""
    factors = left.reshape(3, 3, 1, -1) * right.reshape(1, 3, 3, -1)
    turned: Floats = np.sum(factors, axis=1).reshape(9, -1)
    return turned


def wrapped(angles: Floats) -> Floats:
    """Return the angles in (-pi, pi]; those that are there already bit for bit. [rad]"""
    turns = np.ceil((angles - np.pi) / (2.0 * np.pi))
    once: Floats = angles - 2.0 * np.pi * turns
    return once


def principal_angles(angles: Floats) -> Floats:
    """Return the angles rx, ry, rz of the same rotations as `fixed_axis_angles` gives them. [rad]

    Those that are in their ranges already stay as they are, bit for bit, also where ry is at its
    ends.
    """
    rx, ry, rz = wrapped(angles)
    over = np.abs(ry) > 0.5 * np.pi
    beyond = np.where(over, np.pi, 0.0)
    back = np.where(over, np.copysign(np.pi, ry) - ry, ry)
    return np.stack([wrapped(rx + beyond), back, wrapped(rz + beyond)])


def _angle_about(axis: Floats, rotations: Floats) -> Floats:
    r = rotations
    x, y, z = axis
    sine = 0.5 * (x * (r[7] - r[5]) + y * (r[2] - r[6]) + z * (r[3] - r[1]))
    cosine = 0.5 * (r[0] + r[4] + r[8] - 1.0)
    angle: Floats = np.arctan2(sine, cosine)
    return angle
