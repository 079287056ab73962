"""One cycle of a mesh: from one pair of teeth coming into contact to the next.

Pairs in contact carry equal normal forces, so the moments of the forces of all pairs about a
centre are summed as they are. Between two events (a pair comes, leaves, or passes the pitch point)
both sums are smooth.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Floats, Integers
from mechanics.gears.contact import Sense, Shares, shares, torque_factor
from mechanics.gears.errors import GearError
from mechanics.gears.mesh import Mesh

_LEAST_PIECE = 1e-12
"""Of the cycle; events nearer to each other are one, told apart by rounding alone."""

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(32)


class Piece(NamedTuple):
    """A stretch of the cycle during which the same pairs touch on the same sides.

    Parameters
    ----------
    start, stop : parts of the cycle, from 0 to 1.
    first : place of the pair that came last, at the cycle's start. [m]
    sides : array, shape (pairs,): -1 in approach, 1 in recess; the pair that came last first.
    """

    start: float
    stop: float
    first: float
    sides: Floats


class Curve(NamedTuple):
    """What happens over a cycle; at jumps the phase occurs twice, before and after.

    Parameters
    ----------
    phase : array, shape (points,), parts of the cycle since a pair came into contact, 0 to 1.
    pairs : array, shape (points,), how many pairs of teeth touch.
    torque_factor : array, shape (points,), input torque over that without friction; NaN if locked.
    """

    phase: Floats
    pairs: Integers
    torque_factor: Floats


def require_cycle(mesh: Mesh) -> float:
    """Return the base pitch, which is the length of a cycle. [m]

    Raises
    ------
    GearError : the base pitch is not known.
    """
    if mesh.base_pitch is None:
        raise GearError("must be given: a cycle is one base pitch long", "base_pitch")
    return mesh.base_pitch


def pieces(mesh: Mesh) -> Iterator[Piece]:
    """Yield the stretches of a cycle in order.

    Raises
    ------
    GearError : the base pitch is not known.
    """
    pitch = require_cycle(mesh)
    ratio = (mesh.approach + mesh.recess) / pitch
    events = sorted({0.0, 1.0, ratio % 1.0, (mesh.approach / pitch) % 1.0})
    numbers = np.arange(math.ceil(ratio))
    start = events[0]
    for stop in events[1:]:
        if stop - start > _LEAST_PIECE:
            middle = 0.5 * (start + stop) + numbers
            touching = -mesh.approach + pitch * middle[middle < ratio]
            yield Piece(start, stop, -mesh.approach, np.sign(touching))
            start = stop


def mean_torque_factor(mesh: Mesh, sense: Sense, pitch_speed: float) -> float:
    """Return the mean input torque over that without friction; NaN if teeth lock on the way.

    The output torque and the speed stay the same over the cycle.

    Raises
    ------
    GearError : the base pitch is not known.
    """
    # Of what is lost, so that no friction loses exactly nothing.
    lost = 0.0
    for piece in pieces(mesh):
        half = 0.5 * (piece.stop - piece.start)
        phase = np.concatenate([[piece.start], piece.start + half * (1.0 + _NODES), [piece.stop]])
        # Both ends only tell whether teeth lock: the sums are monotonous between them.
        weights = half * np.concatenate([[0.0], _WEIGHTS, [0.0]])
        lost += float(weights @ (_factor(mesh, piece, phase, sense, pitch_speed) - 1.0))
    return 1.0 + lost


def curve(mesh: Mesh, points: int, sense: Sense, pitch_speed: float) -> Curve:
    """Return the cycle at about `points` phases, at least two a piece, ends and jumps included.

    Raises
    ------
    GearError : the base pitch is not known.
    """
    parts = []
    for piece in pieces(mesh):
        count = max(2, math.ceil(points * (piece.stop - piece.start)))
        phase = np.linspace(piece.start, piece.stop, count)
        factor = _factor(mesh, piece, phase, sense, pitch_speed)
        parts.append((phase, np.full(count, piece.sides.size), factor))
    phases, pairs, factors = zip(*parts, strict=True)
    return Curve(np.concatenate(phases), np.concatenate(pairs), np.concatenate(factors))


def _factor(mesh: Mesh, piece: Piece, phase: Floats, sense: Sense, pitch_speed: float) -> Floats:
    pairs = np.arange(piece.sides.size)[:, None]
    places = piece.first + require_cycle(mesh) * (phase + pairs)
    force = shares(
        mesh, places, np.broadcast_to(piece.sides[:, None], places.shape), sense, pitch_speed
    )
    return torque_factor(Shares(*(np.sum(part, axis=0) for part in force)))
