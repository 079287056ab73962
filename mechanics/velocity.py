"""Velocities: between platform and drives, and of the passive joints."""

from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.drives import dead_drives
from mechanics.legs import (
    ARC_JOINTS,
    BALL_JOINTS,
    CRANK,
    PARALLEL_JOINTS,
    PLANE_JOINTS,
    STRUT,
    STRUT_JOINTS,
)
from mechanics.neighbourhoods import SLACK, Margins, Neighbourhood

PASSIVE_JOINTS = {
    PLANE_JOINTS: ("B", "C"),
    BALL_JOINTS: ("BA", "BC", "Cx", "Cy", "Cz"),
    PARALLEL_JOINTS: ("BA", "BC", "CD"),
    STRUT_JOINTS: ("Ax", "Ay", "Az", "Cx", "Cy", "Cz"),
    ARC_JOINTS: ("W", "V"),
}
"""The passive joints of a leg, in the order of their rates.

A is at the base, B at the elbow, C at the platform. BA is the first axis of the elbow's universal
joint, fixed in the driven link, BC its second one, across BA and the rod; x, y, z are a ball's axes
in the base frame. A parallelogram's BC turns its two rods, and CD undoes BA. W and V are the
intermediate and the platform axis of an arc.
"""


def actuator_rates(block: Configuration, twists: Floats) -> Floats:
    """Return drive rates J x' that follow the platform's twists.

    Parameters
    ----------
    twists : array, shape (6, poses): linear velocity of the reference point, angular velocity.

    Returns
    -------
    array, shape (drives, poses)
        NaN where the leg cannot reach or is stretched or folded (Jpsi = 0), and of a wrist where
        it cannot turn the platform every way. [m/s or rad/s]

    References
    ----------
    Laryushkin et al., 2019, doi:10.1134/S0235711919030106.
    """
    basis = block.mechanism.motion.twists
    rows, divisors = block.rate_rows
    along = np.einsum("kjn,jn->kn", rows, basis.T @ twists)
    driven: Floats = along / np.where(dead_drives(block), np.nan, divisors)
    return driven


@dataclass(frozen=True)
class Speed:
    """How fast the platform moves, in a direction that is not known.

    Parameters
    ----------
    linear : size of the reference point's velocity. [m/s]
    angular : size of the angular velocity. [rad/s]
    """

    linear: float = 0.0
    angular: float = 0.0


def greatest_rates(block: Configuration, speed: Speed) -> Floats:
    """Return the greatest drive rates over all directions of both parts of a platform's twist.

    With j_i and k_i the linear and the angular part of row i of J = Jpsi^-1 Jx this is
    v |j_i| + w |k_i|; parts along motions that the platform lacks have no share.

    Returns
    -------
    array, shape (drives, poses)
        Not below 0; infinite where the drive cannot move the platform (Jpsi = 0), NaN where its
        leg cannot reach. [m/s or rad/s]
    """
    translations = len(block.mechanism.motion.translations)
    rows, divisors = block.rate_rows
    squares = rows**2
    linear = np.sqrt(np.sum(squares[:, :translations], axis=1))
    angular = np.sqrt(np.sum(squares[:, translations:], axis=1))
    dead = dead_drives(block)
    levers = np.where(dead, 1.0, np.abs(divisors))
    rates = (speed.linear * linear + speed.angular * angular) / levers
    greatest: Floats = np.where(dead, np.inf, rates)
    return greatest


def greatest_rates_near(near: Neighbourhood, speed: Speed) -> Margins:
    """Return bounds on the greatest drive rates near the centres, rounding included."""
    block = near.centre
    translations = len(block.mechanism.motion.translations)
    squares = block.platform_jacobians**2
    linear = np.sqrt(np.sum(squares[:, :translations], axis=1))
    angular = np.sqrt(np.sum(squares[:, translations:], axis=1))
    own = speed.linear * linear + speed.angular * angular
    moved, turned = near.row_changes
    slow, fast = near.rates
    slow = np.where(slow > 0.0, slow, np.nan)
    # Changes without a bound, of a part of no size, are no number: not known.
    with np.errstate(invalid="ignore"):
        change = speed.linear * moved + speed.angular * turned
        least = np.maximum(own - change, 0.0) / fast * (1.0 - SLACK)
        return Margins(least, (own + change) / slow * (1.0 + SLACK))


def platform_twists(block: Configuration, rates: Floats) -> Floats:
    """Return the platform's twists J^-1 psi' under drive rates, shape (drives, poses).

    Returns
    -------
    array, shape (6, poses)
        NaN where a leg cannot reach or det Jx = 0. [m/s, rad/s]
    """
    columns, factors = block.twist_columns
    determinants = block.determinants
    moved = np.einsum("kjn,kn->jn", columns, factors * rates)
    twists: Floats = block.mechanism.motion.twists @ (
        moved / np.where(determinants == 0.0, np.nan, determinants)
    )
    return twists


def passive_rates(block: Configuration, twists: Floats, rates: Floats) -> list[Floats]:
    """Return the rates of each leg's passive joints.

    Parameters
    ----------
    twists : array, shape (6, poses), of the platform.
    rates : array, shape (drives, poses).

    Returns
    -------
    list of array, shape (joints, poses), one per leg
        In the order of `PASSIVE_JOINTS`; relative rates about the joints' axes. [rad/s]

    References
    ----------
    Laryushkin et al., 2019, doi:10.1134/S0235711919030106: unit screws of PUS and PUU legs.
    """
    turning = {
        PLANE_JOINTS: _plane_rates,
        BALL_JOINTS: _ball_rates,
        PARALLEL_JOINTS: _parallel_rates,
        STRUT_JOINTS: _strut_rates,
        ARC_JOINTS: _arc_rates,
    }
    joints, wrist = block.mechanism.legs.joints, block.mechanism.wrist
    if wrist is not None:
        twists = wrist.carried_twists(block.placement[1], twists)
    return [
        turning[int(joints[k])](block, k, twists, rates[k])
        for k in range(block.mechanism.leg_count)
    ]


def _dot(a: Floats, b: Floats) -> Floats:
    product: Floats = np.sum(a * b, axis=0)
    return product


def _cross(a: Floats, b: Floats) -> Floats:
    return np.cross(a, b, axis=0)


def _driven_turn(block: Configuration, k: int, rate: Floats) -> Floats:
    """Return the angular velocity of the link that the drive moves, shape (3, poses)."""
    legs = block.mechanism.legs
    turn: Floats = legs.axis[k][:, None] * (rate if legs.drive[k] == CRANK else 0.0 * rate)
    return turn


def _rod_swing(block: Configuration, k: int, twists: Floats, rate: Floats) -> Floats:
    """Return how fast the rod's direction changes, beyond what the driven link turns it.

    (c' - B') / L - w x u, shape (3, poses), w the angular velocity of the driven link. [1/s]
    """
    legs = block.mechanism.legs
    direction = block.rods[0][k]
    tip = twists[:3] + _cross(twists[3:], block.attachment[0][k])
    if legs.drive[k] == STRUT:
        swing: Floats = (tip - rate * direction) / block.travel[k, 0]
        return swing
    elbow = _elbow_velocity(block, k) * rate
    length = legs.rod_length[k]
    unit = direction * legs.rod_scale[k] / length
    swing = (tip - elbow) / length - _cross(_driven_turn(block, k, rate), unit)
    return swing


def _elbow_velocity(block: Configuration, k: int) -> Floats:
    legs = block.mechanism.legs
    if legs.drive[k] != CRANK:
        along: Floats = legs.axis[k][:, None] + 0.0 * block.travel[k, :1]
        return along
    cosine, sine = block.travel[k]
    e, f = legs.zero_direction[k][:, None], legs.quarter_direction[k][:, None]
    around: Floats = legs.crank_length[k] * (f * cosine - e * sine)
    return around


def _universal(
    block: Configuration, k: int, twists: Floats, rate: Floats
) -> tuple[Floats, Floats, Floats]:
    """Return the rates about BA and BC and the rod's angular velocity, shape (3, poses)."""
    direction = block.rods[0][k]
    first = block.mechanism.legs.hinge[k][:, None] + 0.0 * direction
    across = _cross(direction, first)
    size = np.linalg.norm(across, axis=0)
    second = across / size
    swing = _rod_swing(block, k, twists, rate)
    about_first = -_dot(swing, second) / size
    about_second = _dot(swing, _cross(second, direction))
    turn = _driven_turn(block, k, rate) + about_first * first + about_second * second
    return about_first, about_second, turn


def _ball_rates(block: Configuration, k: int, twists: Floats, rate: Floats) -> Floats:
    first, second, rod = _universal(block, k, twists, rate)
    return np.stack([first, second, *(twists[3:] - rod)])


def _parallel_rates(block: Configuration, k: int, twists: Floats, rate: Floats) -> Floats:
    # BC and CB turn alike and oppositely, so what is left at the platform is about BA's axis.
    first, second, _ = _universal(block, k, twists, rate)
    hinge = block.mechanism.legs.hinge[k][:, None]
    relative = twists[3:] - _driven_turn(block, k, rate)
    return np.stack([first, second, _dot(relative, hinge + 0.0 * relative) - first])


def _plane_rates(block: Configuration, k: int, twists: Floats, rate: Floats) -> Floats:
    legs = block.mechanism.legs
    direction = block.rods[0][k]
    normal = legs.hinge[k][:, None] + 0.0 * direction
    at_elbow = _dot(_rod_swing(block, k, twists, rate), _cross(normal, direction))
    driven = _dot(_driven_turn(block, k, rate), normal)
    return np.stack([at_elbow, _dot(twists[3:], normal) - driven - at_elbow])


def _strut_rates(block: Configuration, k: int, twists: Floats, rate: Floats) -> Floats:
    # A ball at either end leaves the strut's spin free: it is taken as none.
    turn = _cross(block.rods[0][k], _rod_swing(block, k, twists, rate))
    return np.concatenate([turn, twists[3:] - turn])


def _arc_rates(block: Configuration, k: int, twists: Floats, rate: Floats) -> Floats:
    """Solve omega - psi' u = W w + V v by its components across the two axes."""
    platform = block.attachment[0][k]
    middle = platform - block.rods[0][k]
    left = twists[3:] - _driven_turn(block, k, rate)
    normal = _cross(middle, platform)
    square = _dot(normal, normal)
    about_middle = _dot(_cross(left, platform), normal) / square
    about_platform = _dot(_cross(middle, left), normal) / square
    return np.stack([about_middle, about_platform])
