"""Trains of meshes, from the output to the motor."""

import itertools
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from mechanics.gears.contact import (
    SIGNS,
    Sense,
    Shares,
    arms,
    shares,
    sliding_speed,
    torque_factor,
)
from mechanics.gears.cycle import mean_torque_factor, require_cycle
from mechanics.gears.errors import GearError
from mechanics.gears.mesh import Mesh

Contact = Literal["pitch", "approach_end", "recess_end", "worst", "mean", "explicit"]
"""Where teeth touch. `worst` is the end of the line of action with the greater loss, of a pair that
carries all: the input torque of several pairs lies between those of each alone, and that of one
pair changes the more, the farther it is from the pitch point."""


@dataclass(frozen=True)
class Transfer:
    """What one mesh makes of a torque.

    Parameters
    ----------
    torque_factor : input torque over that without friction; NaN if the teeth lock.
    efficiency : power that comes out over power that goes in; 0 if the teeth lock.
    place : of the contact on the line of action; NaN for a mean. [m]
    input_arm, output_arm : of the force about the centres; NaN for a mean. [m]
    sliding_speed : at the contact; NaN for a mean or without a speed. [m/s]
    """

    torque_factor: float
    efficiency: float
    place: float
    input_arm: float
    output_arm: float
    sliding_speed: float

    @property
    def locks(self) -> bool:
        """Whether the teeth lock: no torque at the driving wheel turns the other one."""
        return math.isnan(self.torque_factor)


@dataclass(frozen=True)
class Stage:
    """One mesh of a train under its torques.

    Parameters
    ----------
    transfer : what friction does.
    output_torque, input_torque : with friction in this mesh and those before it, towards the
        output; NaN from the first mesh on that locks. [N m]
    frictionless_output_torque, frictionless_input_torque : without any friction. [N m]
    output_speed, input_speed : of the shafts; NaN if not known. [rad/s]
    """

    transfer: Transfer
    output_torque: float
    input_torque: float
    frictionless_output_torque: float
    frictionless_input_torque: float
    output_speed: float
    input_speed: float


def carry(
    train: Sequence[Mesh],
    output_torque: float,
    contact: Contact,
    *,
    sense: Sense = "driving",
    output_speed: float = math.nan,
) -> tuple[Stage, ...]:
    """Return the torques mesh by mesh, from the output to the motor.

    Torques are the same for both directions of turning, since both flanks of a tooth are alike.
    Under `mean`, each mesh passes its mean on to the next: the cycles of different meshes are taken
    not to keep step.

    Parameters
    ----------
    train : meshes, the one at the output first.
    output_torque : of the load on the output. [N m]
    contact : where the teeth of every mesh touch.
    sense : whether the motor drives or the load drives back.
    output_speed : of the output shaft; NaN if not known. [rad/s]

    Raises
    ------
    GearError : there is no such contact in a mesh, see `transfer`.
    """
    speeds = shaft_speeds(train, output_speed)
    transfers = [
        transfer(mesh, contact, sense, mesh.speed_radius * speed)
        for mesh, speed in zip(train, speeds, strict=False)
    ]
    return pass_on(train, transfers, output_torque, speeds)


def shaft_speeds(train: Sequence[Mesh], output_speed: float) -> tuple[float, ...]:
    """Return the speeds of all shafts, one more than meshes, from the output to the motor. [rad/s]

    Parameters
    ----------
    train : meshes, the one at the output first.
    output_speed : of the output shaft; NaN if not known. [rad/s]
    """
    ratios = itertools.accumulate((mesh.ratio for mesh in train), operator.mul, initial=1.0)
    return tuple(output_speed / ratio for ratio in ratios)


def pass_on(
    train: Sequence[Mesh],
    transfers: Sequence[Transfer],
    output_torque: float,
    speeds: Sequence[float],
) -> tuple[Stage, ...]:
    """Return the torques mesh by mesh, given what each mesh makes of a torque.

    Parameters
    ----------
    train, transfers : of each mesh, the one at the output first.
    output_torque : of the load on the output. [N m]
    speeds : of the shafts, as `shaft_speeds`. [rad/s]
    """
    stages = []
    torque = frictionless = output_torque
    for mesh, found, speeds_here in zip(train, transfers, itertools.pairwise(speeds), strict=True):
        before, before_frictionless = torque, frictionless
        torque = before * mesh.ratio * found.torque_factor
        frictionless = before_frictionless * mesh.ratio
        stages.append(Stage(found, before, torque, before_frictionless, frictionless, *speeds_here))
    return tuple(stages)


def transfer(mesh: Mesh, contact: Contact, sense: Sense, pitch_speed: float = math.nan) -> Transfer:
    """Return what one mesh makes of a torque.

    Parameters
    ----------
    mesh : the wheels.
    contact : where their teeth touch; `explicit` is the mesh's own place.
    sense : who drives.
    pitch_speed : of the pitch circles; NaN if not known. [m/s]

    Raises
    ------
    GearError : a mean is asked for and the base pitch is not known, the mesh has no place of its
        own, or its teeth never touch at the pitch point.
    """
    check_contact(mesh, contact)
    if contact == "mean":
        factor = mean_torque_factor(mesh, sense, pitch_speed)
        return Transfer(factor, efficiency(factor, sense), *[math.nan] * 4)
    if contact == "worst":
        ends = (
            at_place(mesh, -mesh.approach, sense, pitch_speed),
            at_place(mesh, mesh.recess, sense, pitch_speed),
        )
        return min(ends, key=lambda end: end.efficiency)
    return at_place(mesh, _place(mesh, contact), sense, pitch_speed)


def check_contact(mesh: Mesh, contact: Contact) -> None:
    """Raise GearError if the teeth of a mesh cannot be asked about this contact."""
    if contact == "mean":
        require_cycle(mesh)
    elif contact == "explicit" and mesh.contact is None:
        raise GearError("must be given where the contact is explicit", "contact_position")
    elif contact == "pitch" and min(mesh.approach, mesh.recess) < 0.0:
        raise GearError(
            "the pitch point lies outside of the part of the line of action where teeth touch, "
            f"which is from {-mesh.approach:.6g} to {mesh.recess:.6g} m from it"
        )


def at_place(mesh: Mesh, place: float, sense: Sense, pitch_speed: float = math.nan) -> Transfer:
    """Return what a mesh makes of a torque that one pair of teeth carries at a place. [m]"""
    places = np.array([place])
    force: Shares = shares(mesh, places, np.sign(places), sense, pitch_speed)
    factor = torque_factor(force).item()
    first, second = arms(mesh, force)
    slide = sliding_speed(mesh, places, pitch_speed).item()
    return Transfer(factor, efficiency(factor, sense), place, first.item(), second.item(), slide)


def efficiency(factor: float, sense: Sense) -> float:
    """Return power out over power in, from the input torque over that without friction."""
    return 0.0 if math.isnan(factor) else float(factor ** -SIGNS[sense])


def _place(mesh: Mesh, contact: Contact) -> float:
    if contact == "approach_end":
        return -mesh.approach
    if contact == "recess_end":
        return mesh.recess
    return mesh.contact if contact == "explicit" and mesh.contact is not None else 0.0
