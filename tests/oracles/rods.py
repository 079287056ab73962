"""Random platforms on six rods, and their modes by Newton's method in plain NumPy.

Nothing of the product is used here. The unknowns are a position and a quaternion of any length,
the equations those of the rods and the quaternion's length: seven, solved for many random poses.
"""

import math
from collections.abc import Callable
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Booleans = npt.NDArray[np.bool_]
Random = np.random.Generator


class Platform(NamedTuple):
    """Ends of six rods, their lengths, and a pose that has them."""

    base: Floats
    platform: Floats
    lengths: Floats
    position: Floats
    rotation: Floats


def rotations(q: Floats) -> Floats:
    """Return |q|^2 R for quaternions, shape (n, 4)."""
    w, x, y, z = q.T
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    found: Floats = np.moveaxis(np.array(rows), 2, 0)
    return found


def rotation_rates(q: Floats) -> Floats:
    """Return the derivatives of `rotations` by the four numbers, shape (n, 4, 3, 3)."""
    # Quadratic: half the difference over steps of one, exactly.
    steps = np.eye(4)
    return np.stack([0.5 * (rotations(q + e) - rotations(q - e)) for e in steps], axis=1)


def lengths_at(base: Floats, platform: Floats, position: Floats, rotation: Floats) -> Floats:
    spans: Floats = position + platform @ rotation.T - base
    lengths: Floats = np.linalg.norm(spans, axis=1)
    return lengths


def turned_anyhow(random: Random, count: int = 1) -> Floats:
    q = random.normal(size=(count, 4))
    return rotations(q / np.linalg.norm(q, axis=1, keepdims=True))


def turned_a_little(random: Random) -> Floats:
    q = np.array([[1.0, *random.normal(0.0, 0.2, 3)]])
    rotation: Floats = rotations(q / np.linalg.norm(q))[0]
    return rotation


def modes(of: Platform, random: Random, starts: int = 1000, steps: int = 30) -> Floats:
    """Return the modes found from random poses, shape (modes, 12): positions and rotations."""
    q = random.normal(size=(starts, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    size = of.lengths.max()
    away = random.normal(size=(starts, 3)) * size / 2
    centre = np.einsum("nij,j->ni", rotations(q), of.platform.mean(axis=0))
    x = np.hstack([of.base.mean(axis=0) - centre + away, q])
    moving = np.arange(starts)
    with np.errstate(all="ignore"):
        for _ in range(steps):
            errors, jacobians = _equations(of, x[moving])
            jacobians += 1e-14 * np.eye(7)
            step = np.linalg.solve(jacobians, errors[..., None])[..., 0]
            sizes = np.linalg.norm(step / np.r_[np.full(3, size), np.ones(4)], axis=1)
            x[moving] -= step * np.minimum(1.0, 0.5 / sizes)[:, None]
            x[moving, 3:] /= np.linalg.norm(x[moving, 3:], axis=1, keepdims=True)
            # A step as small as this leaves an error of rounding, unless the root is a double one.
            moving = moving[sizes > 1e-9]
        errors = np.abs(_equations(of, x)[0]).max(axis=1)
    found = x[errors < 1e-12 * size**2]
    return _each_once(np.hstack([found[:, :3], rotations(found[:, 3:]).reshape(-1, 9)]))


def _equations(of: Platform, x: Floats) -> tuple[Floats, Floats]:
    p, q = x[:, :3], x[:, 3:]
    spans = p[:, None] + np.einsum("nij,kj->nki", rotations(q), of.platform) - of.base
    rates = np.einsum("ncij,kj->nkci", rotation_rates(q), of.platform)
    errors = np.empty((len(x), 7))
    jacobians = np.zeros((len(x), 7, 7))
    errors[:, :6] = np.sum(spans**2, axis=2) - of.lengths**2
    errors[:, 6] = np.sum(q**2, axis=1) - 1.0
    jacobians[:, :6, :3] = 2.0 * spans
    jacobians[:, :6, 3:] = 2.0 * np.einsum("nkci,nki->nkc", rates, spans)
    jacobians[:, 6, 3:] = 2.0 * q
    return errors, jacobians


def _each_once(found: Floats) -> Floats:
    kept = []
    while len(found):
        kept.append(found[0])
        found = found[np.abs(found - found[0]).max(axis=1) > 1e-6]
    rows: Floats = np.array(kept).reshape(-1, 12)
    return rows


def _hexagon(radius: float, half_angle: float) -> Floats:
    angles = np.repeat(np.arange(3) * 2 * math.pi / 3, 2) + np.tile([-half_angle, half_angle], 3)
    corners: Floats = radius * np.c_[np.cos(angles), np.sin(angles), np.zeros(6)]
    return corners


def _general(random: Random) -> tuple[Floats, Floats]:
    return random.normal(size=(6, 3)), random.normal(size=(6, 3))


def _planar(random: Random) -> tuple[Floats, Floats]:
    flat = np.array([1.0, 1.0, 0.0])
    return flat * random.normal(size=(6, 3)), flat * random.normal(size=(6, 3))


def _semi_planar(random: Random) -> tuple[Floats, Floats]:
    return random.normal(size=(6, 3)), np.array([1.0, 1.0, 0.0]) * random.normal(size=(6, 3))


def _hexagons(random: Random) -> tuple[Floats, Floats]:
    base = _hexagon(1.0, random.uniform(0.05, 0.5))
    return base, _hexagon(random.uniform(0.4, 0.9), random.uniform(0.5, 1.0))


def _nearly_hexagons(random: Random) -> tuple[Floats, Floats]:
    base, platform = _hexagons(random)
    return base + random.normal(0.0, 1e-3, (6, 3)), platform + random.normal(0.0, 1e-3, (6, 3))


def _shared(base: str, platform: str) -> Callable[[Random], tuple[Floats, Floats]]:
    def draw(random: Random) -> tuple[Floats, Floats]:
        ends = random.normal(size=(2, 6, 3))
        return ends[0][[int(c) for c in base]], ends[1][[int(c) for c in platform]]

    return draw


CLASSES = MappingProxyType(
    {
        "general": _general,
        "planar": _planar,
        "semi-planar": _semi_planar,
        "hexagons": _hexagons,
        "nearly hexagons": _nearly_hexagons,
        "6-4": _shared("012345", "001123"),
        "5-5": _shared("001234", "011234"),
        "6-3": _shared("012345", "001122"),
        "4-4": _shared("001123", "011233"),
        "3-3": _shared("001122", "011220"),
    }
)
"""How joints lie: anyhow, in planes, in symmetric hexagons, or some of them in one point."""


def draw(kind: str, random: Random) -> Platform:
    """Return a random platform of a kind, at a random pose; hexagons stand above their base."""
    base, platform = CLASSES[kind](random)
    if "hexagons" in kind:
        rotation = turned_a_little(random)
        position = np.r_[random.uniform(-0.3, 0.3, 2), random.uniform(0.7, 1.3)]
    else:
        rotation, position = turned_anyhow(random)[0], random.normal(0.0, 0.8, 3)
    lengths = lengths_at(base, platform, position, rotation)
    return Platform(base, platform, lengths, position, rotation)


def at_singularity(kind: str, random: Random) -> Platform:
    """Return a platform at a pose of type 2: between poses where the determinant has two signs."""
    while True:
        of = draw(kind, random)
        velocity, turn = random.normal(size=3), random.normal(size=3)

        def place(t: float, of: Platform = of, v: Floats = velocity, w: Floats = turn) -> Platform:
            q = np.array([[1.0, *(t * w)]])
            rotation = rotations(q / np.linalg.norm(q))[0] @ of.rotation
            position = of.position + t * v
            lengths = lengths_at(of.base, of.platform, position, rotation)
            return of._replace(position=position, rotation=rotation, lengths=lengths)

        low, high = 0.0, 0.5
        sign = _determinant(place(low)) > 0
        if (_determinant(place(high)) > 0) == sign:
            continue
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (
                (middle, high) if (_determinant(place(middle)) > 0) == sign else (low, middle)
            )
        return place(low)


def _determinant(of: Platform) -> float:
    arms = of.platform @ of.rotation.T
    rods = (of.position + arms - of.base) / of.lengths[:, None]
    return float(np.linalg.det(np.hstack([rods, np.cross(arms, rods)])))
