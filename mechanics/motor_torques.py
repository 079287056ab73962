"""Motor torques of a geared wrist, with the friction in the trains behind the motors."""

import math
from collections.abc import Sequence

import numpy as np

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.gears.contact import SIGNS, Sense
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
    mechanism: Mechanism, driving: float, back_driving: float, senses: Floats
) -> Floats:
    """Return the factors on the motors' torques, shape (3, poses); 1 of a motor without a train.

    NaN where a motor's sense is not known, or its train locks.

    Parameters
    ----------
    driving, back_driving : `chain_factor` in either sense.
    senses : array, shape (3, poses): `SIGNS` of the motors' senses; NaN where not known.
    """
    geared = np.empty(0, dtype=bool) if mechanism.wrist is None else mechanism.wrist.geared
    known = np.where(senses < 0.0, back_driving, driving)
    factors: Floats = np.where(np.isnan(senses), np.nan, known)
    return np.where(geared[:, None], factors, 1.0)


def motor_senses(block: Configuration, torques: Floats, turning: Floats) -> Floats:
    """Return `SIGNS` of the motors' senses, shape (3, poses): back where torque is against rate.

    Friction turns the torque's size, not its sign, so what a motor bears without it tells; a motor
    that stands still is taken for one about to drive. NaN where there is no torque, and where the
    wrist's axes align, so that no rates of the motors make every turn.

    Parameters
    ----------
    torques : array, shape (3, poses): what the motors bear without friction. [N m]
    turning : array, shape (3, poses): angular velocity of the platform. [rad/s]
    """
    twists = np.concatenate([np.zeros_like(turning), turning])
    rates = actuator_rates(block, twists)[block.mechanism.leg_count :]
    powers = torques * rates
    senses = np.where(powers < 0.0, SIGNS["back_driving"], SIGNS["driving"])
    return np.where(np.isnan(powers), np.nan, senses)
