"""Planar crank mechanisms worked out anew from geometry and statics, in plain NumPy.

Nothing of the product is used here. A leg is a triangle: base joint A, elbow B, platform joint
C, with |AB| the crank and |BC| the rod. Elbows come from intersecting two circles, drive
torques from cutting the mechanism free: rod forces hold the platform, each rod's force times
its arm about A loads the crank.
"""

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Booleans = npt.NDArray[np.bool_]
Circle = tuple[float, float, float]


@dataclass(frozen=True)
class PlanarMechanism:
    """Legs in a plane; arrays have one row a leg. `signs` +1: elbow left of the line A to C."""

    base: Floats
    platform: Floats
    crank: float
    rod: float
    signs: tuple[int, ...]
    turns: bool

    @property
    def legs(self) -> int:
        return len(self.base)


def five_bar(base: float, crank: float, rod: float, signs: tuple[int, ...]) -> PlanarMechanism:
    joints = np.array([[-base / 2, 0.0], [base / 2, 0.0]])
    return PlanarMechanism(joints, np.zeros((2, 2)), crank, rod, signs, turns=False)


def planar_3rrr(
    side: float, radius: float, crank: float, rod: float, signs: tuple[int, ...]
) -> PlanarMechanism:
    angles = np.deg2rad([90.0, 210.0, 330.0])
    corners = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return PlanarMechanism(
        corners * side / math.sqrt(3), corners * radius, crank, rod, signs, turns=True
    )


def cross(a: Floats, b: Floats) -> Floats:
    product: Floats = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return product


def angle_between(a: Floats, b: Floats) -> Floats:
    """Return the angle, 0 to pi, between vectors; the atan2 form is exact at both ends."""
    angle: Floats = np.arctan2(np.abs(cross(a, b)), np.sum(a * b, axis=-1))
    return angle


def arms(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    """Return the platform joints seen from the reference point, shape (poses, legs, 2)."""
    turn = poses[:, 2] if mechanism.turns else np.zeros(len(poses))
    c, s = np.cos(turn)[:, None], np.sin(turn)[:, None]
    x, y = mechanism.platform.T
    return np.stack([c * x - s * y, s * x + c * y], axis=-1)


def joints(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    """Return the platform joints C, shape (poses, legs, 2)."""
    placed: Floats = poses[:, None, :2] + arms(mechanism, poses)
    return placed


def spans(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    """Return the distances from A to C, shape (poses, legs)."""
    distances: Floats = np.linalg.norm(joints(mechanism, poses) - mechanism.base, axis=-1)
    return distances


def reach_margins(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    """Return how far C is from the borders of each leg's ring, shape (poses, legs). [m]"""
    distance = spans(mechanism, poses)
    outer, inner = mechanism.crank + mechanism.rod, abs(mechanism.crank - mechanism.rod)
    margins: Floats = np.minimum(outer - distance, distance - inner)
    return margins


def elbows(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    """Return the elbows B, shape (poses, legs, 2); NaN where the circles do not meet."""
    away = joints(mechanism, poses) - mechanism.base
    distance = np.linalg.norm(away, axis=-1)[..., None]
    r, rod = mechanism.crank, mechanism.rod
    with np.errstate(invalid="ignore", divide="ignore"):
        along = (distance**2 + r**2 - rod**2) / (2 * distance)
        aside = np.sqrt(r**2 - along**2) * np.array(mechanism.signs)[:, None]
        ahead = away / distance
    left = np.stack([-ahead[..., 1], ahead[..., 0]], axis=-1)
    met: Floats = mechanism.base + along * ahead + aside * left
    return met


def crank_angles(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    cranks = elbows(mechanism, poses) - mechanism.base
    angles: Floats = np.arctan2(cranks[..., 1], cranks[..., 0])
    return angles


def elbow_angles(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    """Return the inside angles at the elbows, 0 folded, pi stretched, shape (poses, legs)."""
    met = elbows(mechanism, poses)
    return angle_between(mechanism.base - met, joints(mechanism, poses) - met)


def rod_angle(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    """Return the angle of the first two rods at the joint that they share, shape (poses,)."""
    met = elbows(mechanism, poses)
    shared = joints(mechanism, poses)
    return angle_between(met[:, 0] - shared[:, 0], met[:, 1] - shared[:, 1])


def force_columns(mechanism: PlanarMechanism, poses: Floats) -> tuple[Floats, Floats]:
    """Return the wrenches of unit rod forces as columns, and each rod's arm about its A."""
    met = elbows(mechanism, poses)
    rods = (joints(mechanism, poses) - met) / mechanism.rod
    wrenches = [rods[..., 0], rods[..., 1]]
    if mechanism.turns:
        wrenches.append(cross(arms(mechanism, poses), rods))
    return np.stack(wrenches, axis=1), cross(met - mechanism.base, rods)


def torques(mechanism: PlanarMechanism, poses: Floats, loads: Floats) -> Floats:
    """Return drive torques, shape (poses, legs, loads), that hold loads (coordinates, loads).

    Platform in balance: the rods' wrenches and the load add up to nothing. Crank in balance:
    the drive takes the moment of the rod's reaction about A.
    """
    columns, levers = force_columns(mechanism, poses)
    pushes = np.linalg.solve(columns, -np.broadcast_to(loads, (len(poses), *loads.shape)))
    held: Floats = levers[..., None] * pushes
    return held


def worst_by_search(
    mechanism: PlanarMechanism, poses: Floats, force: float, directions: int
) -> Floats:
    """Return the greatest torque over evenly spread directions of a force, (poses, legs)."""
    along_x, along_y = np.moveaxis(
        torques(mechanism, poses, np.eye(3 if mechanism.turns else 2)[:, :2]), -1, 0
    )
    greatest: Floats = np.zeros_like(along_x)
    for turn in 2 * np.pi * np.arange(directions) / directions:
        torque = force * (math.cos(turn) * along_x + math.sin(turn) * along_y)
        np.maximum(greatest, np.abs(torque), out=greatest)
    return greatest


def worst(mechanism: PlanarMechanism, poses: Floats, force: float, moment: float = 0.0) -> Floats:
    """Return the greatest torque over all directions: torque is linear in the load."""
    unit = torques(mechanism, poses, np.eye(3 if mechanism.turns else 2))
    greatest: Floats = force * np.hypot(unit[..., 0], unit[..., 1])
    return greatest + moment * np.abs(unit[..., 2]) if mechanism.turns else greatest


def spread(mechanism: PlanarMechanism, poses: Floats) -> Floats:
    """Return the condition number of the platform's balance, which amplifies rounding."""
    columns, _ = force_columns(mechanism, poses)
    if mechanism.turns:
        columns = columns / np.array([1.0, 1.0, np.abs(mechanism.platform).max()])[:, None]
    numbers: Floats = np.linalg.cond(columns)
    return numbers


def rings_area(rings: list[tuple[float, float, float, float]]) -> float:
    """Return the exact area of the intersection of rings (x, y, inner, outer).

    Green's theorem along the border: every circle is cut where others cross it; an arc counts,
    forwards on an outer circle and backwards on an inner one, if its middle lies in all rings.
    """
    circles = [(x, y, outer) for x, y, _, outer in rings]
    circles += [(x, y, inner) for x, y, inner, _ in rings if inner > 0]
    area = 0.0
    for number, circle in enumerate(circles):
        others = [c for c in circles if c != circle]
        if circle in circles[:number]:
            continue
        sense = 1.0 if number < len(rings) else -1.0
        cuts = sorted({angle for other in others for angle in _crossings(circle, other)})
        bounds = [*cuts, cuts[0] + 2 * math.pi] if cuts else [0.0, 2 * math.pi]
        for start, stop in pairwise(bounds):
            if _borders(circle, 0.5 * (start + stop), rings):
                area += sense * _under(circle, start, stop)
    return area


def _crossings(circle: Circle, other: Circle) -> list[float]:
    x, y, r = circle
    u, v, q = other
    distance = math.hypot(u - x, v - y)
    if distance == 0 or not abs(r - q) < distance < r + q:
        return []
    half = math.acos((distance**2 + r**2 - q**2) / (2 * distance * r))
    towards = math.atan2(v - y, u - x)
    return [(towards + side * half) % (2 * math.pi) for side in (-1, 1)]


def _borders(circle: Circle, angle: float, rings: list[tuple[float, float, float, float]]) -> bool:
    x, y, r = circle
    px, py = x + r * math.cos(angle), y + r * math.sin(angle)
    slack = 1e-9 * r
    return all(
        inner - slack <= math.hypot(px - u, py - v) <= outer + slack for u, v, inner, outer in rings
    )


def _under(circle: Circle, start: float, stop: float) -> float:
    """Half the line integral of x dy - y dx along an arc."""
    x, y, r = circle
    across = x * (math.sin(stop) - math.sin(start)) - y * (math.cos(stop) - math.cos(start))
    return 0.5 * r * (across + r * (stop - start))


def lens_area(distance: float, first: float, second: float) -> float:
    """Return the area that two discs share, by the textbook formula."""
    if distance >= first + second:
        return 0.0
    if distance <= abs(first - second):
        return math.pi * min(first, second) ** 2
    near = (distance**2 + first**2 - second**2) / (2 * distance)
    far = distance - near
    return (
        first**2 * math.acos(near / first)
        - near * math.sqrt(first**2 - near**2)
        + second**2 * math.acos(far / second)
        - far * math.sqrt(second**2 - far**2)
    )
