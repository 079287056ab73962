"""Neighbourhoods: poses and all poses near them, with bounds on what changes in between."""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.configuration import Configuration
from mechanics.kernels import neighbourhoods as kernels
from mechanics.kernels import slopes
from mechanics.kernels.cofactors import EPSILON
from mechanics.legs import ARC_JOINTS, CRANK, STRUT
from mechanics.mechanism import Mechanism
from mechanics.octree import Reach

SLACK = 1e-9
"""Room for rounding: a share of lengths and of numbers, and so many radians."""
KEPT = 1e-3
"""No bound is given where det Jx may fall below this share of what it is at the centre."""
COARSEST = 1e-2
"""No bound is given where rounding may make this share of J^-1."""


class Margins(NamedTuple):
    """The least and the greatest that margins may be near a pose, shape (parts, poses) each.

    NaN, or an infinity of the useless sign, where nothing is known.
    """

    least: Floats
    greatest: Floats


class Neighbourhood:
    """A block of poses, the centres, and how far what is near each of them may differ.

    Every array carries the centres on its last axis. What has no bound is infinite or NaN.

    Parameters
    ----------
    centre : the configuration at the centres.
    reach : how far a pose may be from its centre to be near it, shape (poses,) each. [m, rad]
    size : the greatest length that leg equations meet, which rounding is a share of. [m]
    """

    def __init__(self, centre: Configuration, reach: Reach, size: float) -> None:
        self.centre = centre
        self.turns = reach.turns
        self._reach = reach
        self._size = size

    def take(self, chosen: Booleans) -> "Neighbourhood":
        """Return the chosen centres, shape (poses,), with what is already computed of them."""
        reach = Reach(self._reach.positions[chosen], self._reach.turns[chosen])
        taken = Neighbourhood(self.centre.take(chosen), reach, self._size)
        for name in ("arm_turns", "shifts", "_swings", "_mixings"):
            if name in vars(self):
                value = vars(self)[name]
                vars(taken)[name] = (
                    tuple(part[..., chosen] for part in value)
                    if isinstance(value, tuple)
                    else value[..., chosen]
                )
        return taken

    @cached_property
    def arm_turns(self) -> Floats:
        """How far the arms' ends move by turning, shape (legs, poses). [m]"""
        arms = np.linalg.norm(self.centre.mechanism.legs.platform_point, axis=1)
        turned: Floats = np.multiply.outer(arms, self._reach.turns)
        return turned

    @cached_property
    def shifts(self) -> Floats:
        """How far the legs' joints on the platform move, shape (legs, poses). [m]"""
        moved: Floats = self._reach.positions + self.arm_turns
        return moved * (1.0 + SLACK) + SLACK * self._size

    @cached_property
    def _swings(self) -> tuple[Floats, Floats, Floats]:
        found = self.centre
        turned, strokes = np.empty_like(self.shifts), np.empty_like(self.shifts)
        rates = np.empty((2, *self.shifts.shape))
        kernels.swings(
            found.mechanism.legs,
            found.attachment[1],
            found.travel,
            found.rods[0],
            self.shifts,
            turned,
            strokes,
            rates,
        )
        return turned, strokes, rates

    @property
    def swings(self) -> Floats:
        """How far the rods turn, shape (legs, poses); infinite where one may not reach. [rad]"""
        return self._swings[0]

    @property
    def strokes(self) -> Floats:
        """How far the drives move, shape (legs, poses). [rad or m]"""
        return self._swings[1]

    @property
    def rates(self) -> Floats:
        """The least and the greatest |Jpsi|, shape (2, legs, poses). [m or -]"""
        return self._swings[2]

    @property
    def squares(self) -> Floats:
        """The least and the greatest |d|^2, shape (2, legs, poses). [m^2]"""
        lengths = np.linalg.norm(self.centre.attachment[1], axis=1)
        near = np.maximum(lengths - self.shifts, 0.0)
        squares: Floats = np.square(np.stack([near, lengths + self.shifts]))
        return squares

    @property
    def elbow_shifts(self) -> Floats:
        """How far the base ends of the rods move, shape (legs, poses). [m]"""
        legs = self.centre.mechanism.legs
        levers = np.where(legs.drive == CRANK, legs.crank_length, 1.0)[:, None]
        return np.where((legs.drive == STRUT)[:, None], 0.0, levers * self.strokes)

    @property
    def row_changes(self) -> tuple[Floats, Floats]:
        """How far rows of Jx may be off, shape (legs, poses) each: of translations, of turns."""
        mechanism = self.centre.mechanism
        motion, none = mechanism.motion, np.zeros_like(self.swings)
        chords = 2.0 * np.sin(0.5 * np.minimum(self.swings, np.pi))
        chords = np.where(np.isfinite(self.swings), chords, np.inf)
        arms = np.linalg.norm(mechanism.legs.platform_point, axis=1, keepdims=True)
        with np.errstate(invalid="ignore"):
            turned = arms * chords + self.arm_turns
        return chords if motion.translations else none, turned if motion.turns else none

    @cached_property
    def blurs(self) -> Floats:
        """What rounding may make of J^-1 anywhere near, as a share, shape (poses,)."""
        motion, legs = self.centre.mechanism.motion, self.centre.mechanism.legs
        arms = np.linalg.norm(legs.platform_point, axis=1) if motion.turns else np.zeros(1)
        # Cofactors and determinants are right to so many units of the product of the rows' sizes.
        rows = float(np.prod(np.hypot(1.0, arms)))
        units = 32.0 * len(motion.coordinates) * EPSILON / KEPT
        determinants = np.abs(self.centre.determinants)
        blurs = SLACK + units * rows / np.where(determinants > 0.0, determinants, np.nan)
        return np.where(blurs <= COARSEST, blurs, np.nan)

    @cached_property
    def _columns(self) -> Floats:
        cofactors, determinants = self.centre.cofactors
        columns: Floats = cofactors / np.where(determinants != 0.0, determinants, np.nan)
        return columns

    @cached_property
    def _mixings(self) -> tuple[Floats, Floats, Floats]:
        found = self.centre
        columns = self._columns
        speeds, kept = np.empty((2, *self.shifts.shape)), np.empty(found.count)
        mixing = np.empty_like(columns, shape=(len(columns), *self.shifts.shape))
        kernels.mixings(
            found.mechanism.motion.twists,
            columns,
            found.attachment[0],
            self.swings,
            self.arm_turns,
            self.blurs,
            speeds,
            mixing,
            kept,
        )
        held = kept >= KEPT
        kept[~held] = np.nan
        mixing[..., ~held] = np.nan
        speeds[..., ~held] = np.nan
        return mixing, speeds, kept

    @property
    def mixing(self) -> Floats:
        """How the columns of J^-1 mix, shape (drives, drives, poses).

        Near a centre, column j is that at the centre plus each column k of the centre, times
        no more than [k, j].
        """
        return self._mixings[0]

    @property
    def joint_speeds(self) -> Floats:
        """|v_k(t_k)| at the centres and, near them, at most, shape (2, drives, poses).

        That is how fast a drive moves its own joint while all others are braked and the joint's
        velocity along the rod is 1.
        """
        return self._mixings[1]

    @property
    def kept(self) -> Floats:
        """The least share of |det Jx| at the centre that is left, shape (poses,)."""
        return self._mixings[2]

    @property
    def pressure_cosines(self) -> Margins:
        """The least and the greatest cosines of the pressure angles, shape (drives, poses)."""
        own, greatest = self.joint_speeds
        least = np.maximum(2.0 * own - greatest, 1.0)
        return Margins(1.0 / greatest - self.blurs, 1.0 / least + self.blurs)

    def others(self, own: Floats) -> Floats:
        """Return what other columns of J^-1 may bring into each, shape (drives, poses).

        `own` has the size of each at the centres, by any norm.
        """
        added = np.empty_like(own)
        kernels.add_others(own, self.mixing, added)
        return added

    @cached_property
    def _curls(self) -> tuple[Floats, Floats, Floats]:
        found, swerves = self.centre, 0.5 * self.arm_turns * self._reach.turns
        ways, left = np.empty_like(found.rods[0]), np.empty_like(swerves)
        inverses = np.empty_like(swerves)
        slopes.curls(
            found.mechanism.legs,
            found.attachment[1],
            found.travel,
            found.rods[0],
            self.shifts,
            swerves,
            self.rates[0],
            ways,
            inverses,
            left,
        )
        return ways, inverses, left

    def size_changes(self, load: tuple[float, float], own: Floats, known: Floats) -> Floats:
        """Return how far sizes F |a| + M |b| of the columns of Jx^-1 may fall and rise.

        Shape (2, drives, poses); a and b are velocity and turning, `own` the sizes at the centres
        with a known load's share, shape (drives, poses), and `known` that share alone.
        """
        changes = np.empty((2, *own.shape))
        ways, inverses, left = self._curls
        found = self.centre
        slopes.slopes(
            found.mechanism.motion.twists,
            self._columns,
            found.attachment[0],
            found.rods[0],
            ways,
            inverses,
            left,
            self.swings,
            self.arm_turns,
            np.stack([self._reach.positions, self._reach.turns]),
            self.blurs,
            self.mixing,
            load,
            own,
            known,
            changes,
        )
        return np.fmin(changes, self.others(own))

    @property
    def condition_numbers(self) -> Margins:
        """The least and the greatest condition numbers of Jx, shape (poses,).

        Singular values change by no more than the matrix does (Weyl); the greatest is no less
        than any row or column, nor than the root of the mean of their squares.
        """
        rows = self.centre.platform_jacobians / self.centre.mechanism.coordinate_scales[:, None]
        squares = rows**2
        sizes = [squares.sum(axis=0).max(axis=0), squares.sum(axis=1).max(axis=0)]
        moved, turned = self.row_changes
        turned = turned / self.centre.mechanism.characteristic_length
        change = np.sqrt(np.sum(moved**2 + turned**2, axis=0) / np.maximum(*sizes)) + SLACK
        own = self.centre.condition_numbers
        # Infinite numbers, or changes without a bound, end in what is no number: not known.
        with np.errstate(invalid="ignore"):
            left = np.maximum(1.0 - own * change, 0.0)
            least = own * (1.0 - change) / (1.0 + own * change)
            return Margins(least, own * (1.0 + change) / np.where(left > 0.0, left, np.nan))


def bounded(mechanism: Mechanism) -> bool:
    """Return whether there are bounds on what the mechanism's legs do near a pose."""
    return mechanism.wrist is None and bool((mechanism.legs.joints != ARC_JOINTS).all())


def within(margins: Floats, change: float | Floats) -> Margins:
    """Return the margins that may be off by a change. [as the margins]"""
    # Margins without end, where nothing is bounded, differ by what is no number: not known.
    with np.errstate(invalid="ignore"):
        return Margins(margins - change, margins + change)
