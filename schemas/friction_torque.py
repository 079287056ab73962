"""`friction_torque`: what friction between the teeth of a gear train costs."""

from typing import Literal

from pydantic import Field

from schemas.gears import Train
from schemas.quantities import Model, Size

Contact = Literal["pitch", "approach_end", "recess_end", "worst", "mean", "explicit"]
Sense = Literal["driving", "back_driving"]
MOST_POINTS = 1_000


class FrictionTorqueRequest(Model):
    """Ask for the torques along a train of meshes under a torque on its output.

    Torques are sizes: both flanks of a tooth are alike, so the direction of turning is free.
    """

    analysis: Literal["friction_torque"]
    train: Train
    output_torque: Size = Field(description="Of the load on the output. [N m]")
    contact: Contact = Field(
        description="Where the teeth of every mesh touch: `pitch`, the pitch point, without loss; "
        "`approach_end` and `recess_end`, where a pair of teeth meets and parts while the motor "
        "drives; `worst`, the one of both that loses more, one pair carrying all; `explicit`, each "
        "mesh's own contact or contact_position; `mean` over the cycle, pairs in contact carrying "
        "equal normal forces, cycles of different meshes not keeping step."
    )
    sense: Sense = Field(
        default="driving",
        description="Whether the motor drives the output against its load, or the load drives "
        "the motor, which must then hold the input torque.",
    )
    output_speed: Size | None = Field(
        default=None, description="Of the output, for sliding speeds and powers. [rad/s]"
    )
    curve_points: int | None = Field(
        default=None,
        ge=2,
        le=MOST_POINTS,
        strict=True,
        description="Answer the cycle of every mesh at about this many phases.",
    )


class MeshGeometry(Model):
    """The line of action of a mesh; of bevel wheels, that of their equivalent spur pair.

    Radii are of input and output wheel, below 0 for a ring with teeth inside.
    """

    pitch_radii: list[float] = Field(description="At work. [m]")
    base_radii: list[float] = Field(description="[m]")
    pressure_angle: float = Field(description="At work. [rad]")
    approach: float = Field(
        description="Used length of the line of action before the pitch point. [m]"
    )
    recess: float = Field(
        description="Used length of the line of action after the pitch point. [m]"
    )
    contact_ratio: float | None = Field(
        description="Mean number of pairs in contact; null without a base pitch."
    )


class MeshCurve(Model):
    """The cycle of a mesh; at jumps a phase stands twice, before and after."""

    phase: list[float] = Field(
        description="Part of the cycle since a pair of teeth came into contact, 0 to 1."
    )
    pairs: list[int] = Field(description="Pairs of teeth in contact.")
    torque_factor: list[float | None] = Field(
        description="Input torque over that without friction, at one output torque; null where "
        "the teeth lock."
    )
    input_torque: list[float | None] = Field(
        description="Under the stage's output_torque; null where the teeth lock. [N m]"
    )


class GearStage(Model):
    """One mesh of the train, from the output on.

    Torques with friction are null from the first mesh on that locks.
    """

    output_torque: float | None = Field(description="On the output wheel, with friction. [N m]")
    input_torque: float | None = Field(description="At the input wheel, with friction. [N m]")
    frictionless_output_torque: float = Field(description="[N m]")
    frictionless_input_torque: float = Field(description="[N m]")
    excess: float | None = Field(
        description="Of input_torque over frictionless_input_torque, less 1: what friction in "
        "this mesh and those before it has made; below 0 when the load drives back."
    )
    ratio: float = Field(description="Input torque over output torque without friction.")
    efficiency: float = Field(description="Power out over power in of this mesh; 0 if it locks.")
    loss: float = Field(description="Share of the power into this mesh that is lost, 0 to 1.")
    power_loss: float | None = Field(description="Null without output_speed, or if locked. [W]")
    self_locking: bool = Field(
        description="Whether this mesh locks: driving, no finite input torque moves it; "
        "back-driving, the load alone cannot, and an input torque of the other sign would have to "
        "help."
    )
    contact_position: float | None = Field(
        description="From the pitch point, above 0 in recess while the motor drives; null for "
        "means. [m]"
    )
    input_arm: float | None = Field(
        description="Of the tooth force about the input wheel's centre, below 0 past it; null "
        "for means. [m]"
    )
    output_arm: float | None = Field(
        description="Of the tooth force about the output wheel's centre, below 0 past it; null "
        "for means. [m]"
    )
    sliding_speed: float | None = Field(
        description="Between the teeth at the contact; null for means or without output_speed. "
        "[m/s]"
    )
    geometry: MeshGeometry
    curve: MeshCurve | None = Field(description="Null unless curve_points was given.")


class FrictionTorqueResult(Model):
    """Torques along the train; null where it locks."""

    analysis: Literal["friction_torque"]
    contact: Contact
    sense: Sense
    input_torque: float | None = Field(
        description="At the motor, with friction: needed to drive, or to hold the load that "
        "drives back; null if the train locks. [N m]"
    )
    frictionless_input_torque: float = Field(description="At the motor, without friction. [N m]")
    excess: float | None = Field(
        description="Of input_torque over frictionless_input_torque, less 1; null if locked."
    )
    ratio: float = Field(description="Motor torque over output torque without friction.")
    efficiency: float = Field(description="Power out over power in; 0 if the train locks.")
    loss: float = Field(description="Share of the power in that is lost, 0 to 1.")
    power_loss: float | None = Field(description="Null without output_speed, or if locked. [W]")
    self_locking: bool = Field(description="Whether a mesh locks in this sense at this contact.")
    stages: list[GearStage] = Field(description="Mesh by mesh, from the output to the motor.")
