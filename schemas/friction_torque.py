"""`friction_torque`: what friction between the teeth of a gear train costs."""

from typing import Literal, Self

from pydantic import Field, model_validator

from schemas.effort import KnownLoad, LoadSize, Vectors
from schemas.gears import Mesh, Train
from schemas.legged import WorkingMode
from schemas.mechanisms import Mechanism
from schemas.poses import Obstacle, Poses
from schemas.quantities import Model, Size

Contact = Literal["pitch", "approach_end", "recess_end", "worst", "mean", "explicit"]
Sense = Literal["driving", "back_driving"]
MOST_POINTS = 1_000
OF_A_TRAIN = ("output_torque", "output_speed", "curve_points")
OF_A_MECHANISM = ("poses", "load", "known_load", "angular_velocity", "working_mode")


class FrictionTorqueRequest(Model):
    """Ask for the torques along a train of meshes, or those of a mechanism's geared motors.

    Of a `train` under an `output_torque` torques are sizes: both flanks of a tooth are alike, so
    the direction of turning is free. Of a `mechanism` at `poses`, under a `load` or a `known_load`
    as in `effort`, they have signs unless the load's direction is open.
    """

    analysis: Literal["friction_torque"]
    train: Train | None = None
    output_torque: Size | None = Field(
        default=None, description="Of the load on a train's output. [N m]"
    )
    mechanism: Mechanism | None = Field(
        default=None, description="In place of a train: geared_decoupled, with a train of its own."
    )
    poses: Poses | None = None
    load: LoadSize | None = None
    known_load: KnownLoad | None = None
    angular_velocity: Vectors | None = Field(
        default=None,
        description="How the platform turns, for all poses or one row per pose: each motor then "
        "has its own sense, driven back where its torque is against its rate. Not with a load of "
        "open direction, against which every motor may drive. [rad/s]",
    )
    working_mode: WorkingMode | None = Field(
        default=None, description="Of the mechanism; by default its own."
    )
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
        "the motor, which must then hold the input torque. Of all motors of a mechanism, unless "
        "angular_velocity says more.",
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

    @model_validator(mode="after")
    def _one_of_two(self) -> Self:
        if (self.train is None) == (self.mechanism is None):
            raise ValueError("give either train, with output_torque, or mechanism, with poses")
        kind, needed, foreign = (
            ("a mechanism", "poses", OF_A_TRAIN)
            if self.train is None
            else ("a train", "output_torque", OF_A_MECHANISM)
        )
        if getattr(self, needed) is None:
            raise ValueError(f"{kind} needs {needed}")
        given = [name for name in foreign if getattr(self, name) is not None]
        if given:
            raise ValueError(f"{kind} takes no {given[0]}")
        if self.mechanism is not None:
            self._check_load()
        return self

    @property
    def meshes(self) -> list[Mesh]:
        """The train that is asked about alone; none if a mechanism is."""
        return self.train or []

    @property
    def load_torque(self) -> float:
        """The torque on the output of that train; 0 if there is none. [N m]"""
        return self.output_torque or 0.0

    def _check_load(self) -> None:
        if self.load is None and self.known_load is None:
            raise ValueError("a mechanism needs load or known_load")
        if self.load is not None and self.angular_velocity is not None:
            raise ValueError(
                "a load of open direction takes no angular_velocity: every motor may drive"
            )


class MeshGeometry(Model):
    """The line of action of a mesh; of bevel wheels, that of their equivalent spur pair.

    Radii are of input and output wheel, below 0 for a ring with teeth inside.
    """

    pitch_radii: list[float] = Field(description="At work. [m]")
    base_radii: list[float] = Field(description="[m]")
    pressure_angle: float = Field(description="At work. [rad]")
    tip_radii: list[float] | None = Field(description="Null for an explicit mesh. [m]")
    tip_thickness: list[float] | None = Field(
        description="Of the teeth, along their tip circles; null for an explicit mesh. [m]"
    )
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
    self_locking: bool = Field(
        description="Whether the train locks in this sense at this contact: one of its meshes "
        "does, or all together multiply the torque beyond every number."
    )
    stages: list[GearStage] = Field(description="Mesh by mesh, from the output to the motor.")


Torques = list[list[float | None]]
Factors = list[float | None]


class MotorTorqueResult(Model):
    """Torques of the motors, columns D1, D2, D3; null where there is none.

    Friction in a train multiplies what passes it, so a motor's torque is its frictionless one
    times the factor of its train in its sense, and a load of open direction is worst in the same
    direction as without friction. D3 turns the wrist itself, and is told without friction.
    """

    analysis: Literal["friction_torque"]
    working_mode: WorkingMode
    contact: Contact
    torque: Torques = Field(
        description="With friction, shape (poses, 3); null also where the motor's train locks in "
        "its sense, or the sense is null. Under load the greatest over its directions. [N m]"
    )
    frictionless_torque: Torques = Field(description="Without friction, likewise. [N m]")
    sense: list[list[Sense | None]] = Field(
        description="Whether each motor drives or is driven back, shape (poses, 3); null under "
        "angular_velocity where there is no torque, and where the wrist's axes align (ry a right "
        "angle), so that no rates of the motors make every turn."
    )
    driving_factor: Factors = Field(
        description="Of each motor, torque over that without friction while it drives; null if its "
        "train locks."
    )
    back_driving_factor: Factors = Field(description="The same while the load drives it back.")
    self_locking: list[bool] = Field(
        description="Of each motor, whether no load on the platform drives it back."
    )
    worst_force: list[list[list[float] | None]] | None = Field(
        description="Shape (poses, 3, 3): the force that asks most of the motor; null without a "
        "load. [N]"
    )
    worst_moment: list[list[list[float] | None]] | None = Field(
        description="Shape (poses, 3, 3): the moment that asks most of the motor; null without a "
        "load. [N m]"
    )
    obstacles: list[Obstacle]
