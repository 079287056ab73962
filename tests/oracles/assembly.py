"""Assembly modes found the slow way: by scanning one angle, and by Newton from many starts.

Nothing of the product is used here. Drives stand still, so that a leg is a rod of given length
from a given point.
"""

import math
from dataclasses import dataclass

import numpy as np

from tests.oracles.legs import Floats, Machine, basis, driven


@dataclass(frozen=True)
class Rods:
    """Rods from `starts` to the platform's `points`, shape (rods, 3), and the platform's twists."""

    starts: Floats
    points: Floats
    lengths: Floats
    twists: Floats


def rods(machine: Machine, actuators: Floats) -> Rods:
    """Return the rods of a machine; the two ends of an arc lie on the unit sphere."""
    pairs = list(zip(machine.legs, actuators, strict=True))
    lengths = [
        drive
        if leg.drive == "strut"
        else math.sqrt(2.0 - 2.0 * math.cos(leg.rod))
        if leg.drive == "arc"
        else leg.rod
        for leg, drive in pairs
    ]
    starts = np.array([driven(leg, drive)[0] for leg, drive in pairs])
    points = np.array([leg.point for leg in machine.legs])
    return Rods(starts, points, np.array(lengths), basis(machine))


def count_by_scan(of: Rods, samples: int = 100_000) -> int:
    """Return how many modes three rods in the plane have, each seen as a change of sign.

    At every angle the first two rods put the platform where two circles cross, in two points; the
    third rod's error changes its sign at a mode. Where circles cease to cross, the two points are
    one: errors of different sign next to there hide one more mode.
    """
    errors = _third_errors(of, np.linspace(-math.pi, math.pi, samples, endpoint=False))
    met = np.isfinite(errors[0])
    changes = int(np.sum(errors * np.roll(errors, -1, axis=1) < 0.0))
    ends = met & ~(np.roll(met, -1) & np.roll(met, 1))
    return changes + int(np.sum(errors[0, ends] * errors[1, ends] < 0.0))


def _third_errors(of: Rods, angles: Floats) -> Floats:
    """Return, shape (2, angles), what the third rod lacks at both crossings; NaN: none."""
    flat = of.starts[:, 0] + 1j * of.starts[:, 1], of.points[:, 0] + 1j * of.points[:, 1]
    centres = flat[0][:, None] - np.exp(1j * angles) * flat[1][:, None]
    first, second = of.lengths[:2]
    away = centres[1] - centres[0]
    distance = np.abs(away)
    along = (distance**2 + first**2 - second**2) / (2.0 * distance)
    with np.errstate(invalid="ignore"):
        aside = np.sqrt(first**2 - along**2)
    crossings = [centres[0] + away / distance * (along + s * 1j * aside) for s in (1.0, -1.0)]
    return np.array([np.abs(point - centres[2]) - of.lengths[2] for point in crossings])


def newton_from_everywhere(of: Rods, random: np.random.Generator, starts: int) -> list[Floats]:
    """Return the different places, the rotation's rows and the position, that starts lead to.

    Newton's steps, damped after Levenberg and Marquardt wherever they do not help.
    """
    size = float(max(np.abs(of.starts).max(), np.abs(of.points).max(), of.lengths.max()))
    twists = np.concatenate([size * of.twists[:3], of.twists[3:]])
    shifts = random.uniform(-1.5, 1.5, (starts, twists.shape[1])) @ twists[:3].T
    turns = _rotations(random.uniform(-3.0, 3.0, (starts, twists.shape[1])) @ twists[3:].T)
    errors, rows = _errors(of, shifts, turns)
    damping = np.ones(starts)
    for _ in range(80):
        slopes = rows @ twists
        across = slopes.transpose(0, 2, 1)
        normal = across @ slopes + (1e-15 + damping)[:, None, None] * size**2 * np.eye(
            len(twists.T)
        )
        moved = -np.linalg.solve(normal, across @ errors[..., None])[..., 0] @ twists.T
        place = shifts + moved[:, :3], _rotations(moved[:, 3:]) @ turns
        tried = _errors(of, *place)
        better = np.sum(tried[0] ** 2, axis=1) < np.sum(errors**2, axis=1)
        for old, new in zip((shifts, turns, errors, rows), (*place, *tried), strict=True):
            old[better] = new[better]
        damping = np.where(better, 0.05 * damping, np.minimum(10.0 * damping + 1e-12, 10.0))
    closed = np.abs(errors).max(axis=1) < 1e-12 * size
    distinct: list[Floats] = []
    for place in np.hstack([turns.reshape(-1, 9), shifts])[closed]:
        if all(np.abs(place - other).max() > 1e-6 * max(1.0, size) for other in distinct):
            distinct.append(place)
    return distinct


def _errors(of: Rods, shifts: Floats, turns: Floats) -> tuple[Floats, Floats]:
    """Return lengths less those wanted, and the rods' unit wrenches, shape (starts, rods, 6)."""
    arms = np.einsum("nij,kj->nki", turns, of.points)
    spans = shifts[:, None] + arms - of.starts
    lengths = np.linalg.norm(spans, axis=2)
    along = spans / lengths[..., None]
    return lengths - of.lengths, np.concatenate([along, np.cross(arms, along)], axis=2)


def _rotations(vectors: Floats) -> Floats:
    """Return the rotations about vectors by their lengths, after Rodrigues."""
    angles = np.linalg.norm(vectors, axis=1)
    x, y, z = (vectors / np.where(angles > 0.0, angles, 1.0)[:, None]).T
    o = np.zeros_like(x)
    skew = np.moveaxis(np.array([[o, -z, y], [z, o, -x], [-y, x, o]]), 2, 0)
    s, c = np.sin(angles)[:, None, None], np.cos(angles)[:, None, None]
    turned: Floats = np.eye(3) + s * skew + (1.0 - c) * (skew @ skew)
    return turned
