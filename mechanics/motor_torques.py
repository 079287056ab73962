"""Motor torques of a geared wrist, with the friction in the trains behind the motors."""

import math
from collections.abc import Sequence

import numpy as np

from mechanics.arrays import Booleans, Floats
from mechanics.configuration import Configuration
from mechanics.gears.contact import Sense
from mechanics.gears.mesh import Mesh
from mechanics.gears.train import Contact, transfer
from mechanics.mechanism import Mechanism
from mechanics.velocity import actuator_rates


def chain_factor(train: Sequence[Mesh], contact: Contact, sense: Sense) -> float:
    """Return a motor's torque over that without friction; NaN if its train locks.

    Without friction the wrist's gains say what a motor bears, and friction in a mesh multiplies
    what passes it, so a whole train is one factor: at least 1 of a motor that drives, at most 1 of
    one that is driven back. Meshes that all but lock may lock together: beyond every number.

    Parameters
    ----------
    train : meshes, the one at the platform first.
    contact : where the teeth of every mesh touch.
    sense : who drives.

    Raises
    ------
    GearError : there is no such contact in a mesh.
    """
    factor = math.prod(transfer(mesh, contact, sense).torque_factor for mesh in train)
    return factor if math.isfinite(factor) else math.nan


def motor_factors(
    mechanism: Mechanism, driving: float, back_driving: float, brakes: Booleans
) -> Floats:
    """Return the factors on the motors' torques, shape (3, poses); 1 of a motor without a train.

    Parameters
    ----------
    driving, back_driving : `chain_factor` in either sense.
    brakes : array, shape (3, poses): which motors are driven back.
    """
    geared = np.empty(0, dtype=bool) if mechanism.wrist is None else mechanism.wrist.geared
    factors: Floats = np.where(brakes, back_driving, driving)
    return np.where(geared[:, None], factors, 1.0)


def braking(block: Configuration, torques: Floats, turning: Floats) -> Booleans:
    """Return, shape (3, poses), which motors are driven back: their torque is against their rate.

    Friction turns the torque's size, not its sign, so what a motor bears without it tells; a motor
    that stands still is taken for one about to drive.

    Parameters
    ----------
    torques : array, shape (3, poses): what the motors bear without friction. [N m]
    turning : array, shape (3, poses): angular velocity of the platform. [rad/s]
    """
    twists = np.concatenate([np.zeros_like(turning), turning])
    rates = actuator_rates(block, twists)[block.mechanism.leg_count :]
    against: Booleans = torques * rates < 0.0
    return against
