"""The involute of a circle."""

import math

_MOST_STEPS = 60


def involute(angle: float) -> float:
    """Return inv a = tan a - a. [rad]"""
    return math.tan(angle) - angle


def inverse_involute(value: float) -> float:
    """Return the angle from 0 to pi/2 whose involute this is. [rad]

    inv is convex and both starting values lie above the root (tan a >= a + a^3/3, a < pi/2), so
    Newton's steps fall until rounding stops them.

    Parameters
    ----------
    value : at least 0. [rad]
    """
    if value == 0.0:
        return 0.0
    angle = min(math.cbrt(3.0 * value), math.atan(value + 0.5 * math.pi))
    for _ in range(_MOST_STEPS):
        step = (involute(angle) - value) / math.tan(angle) ** 2
        if not angle - step < angle:
            break
        angle -= step
    return angle
