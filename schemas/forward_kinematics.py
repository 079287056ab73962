"""`forward_kinematics`: where the platform is at drive positions, in every assembly mode."""

from dataclasses import dataclass
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from schemas.legged import Sign, WorkingMode
from schemas.mechanisms import Mechanism
from schemas.poses import MOST_POSES, Obstacle, Pose
from schemas.quantities import Finite, Model

ActuatorRows = Annotated[
    list[list[Finite]],
    Field(
        min_length=1,
        max_length=MOST_POSES,
        description="One row a question, one drive coordinate per drive. A row beyond actuator "
        "limits is answered all the same, and stands among the obstacles. [rad, m]",
    ),
]


def _shape(given: Any) -> str:  # noqa: ANN401
    """Return which branch a guess is of, so that only what is wrong in that one is told."""
    rows = isinstance(given, list) and any(isinstance(row, list) for row in given)
    return "rows" if rows else "pose"


Guess = Annotated[
    Annotated[Pose, Tag("pose")] | Annotated[list[Pose], Tag("rows")], Discriminator(_shape)
]

_OBSTACLES = "Which given drives are beyond their actuator limits; `pose` is the row of actuators."


class ForwardKinematicsRequest(Model):
    """Ask for the poses at drive positions: all of them, or the one reached from a guess."""

    analysis: Literal["forward_kinematics"]
    mechanism: Mechanism
    actuators: ActuatorRows
    guess: Guess | None = Field(
        default=None,
        description="A pose, or one per row, from which Newton's iteration starts; the answer is "
        "then where it led, and no other mode. Of the turns that a wrist makes no notice is taken: "
        "the motors tell them.",
    )


# Of these there may be a million: a model takes four times as long to make as a dataclass.


@dataclass(frozen=True, slots=True)
class AssemblyMode:
    """A pose at which the legs close."""

    __pydantic_config__ = Model.model_config

    pose: Annotated[
        list[float], Field(description="In the order of the kind's coordinates. [m, rad]")
    ]
    working_mode: Annotated[
        WorkingMode, Field(description="The branch in which the inverse gives these drives back.")
    ]
    determinant: Annotated[float, Field(description="Of Jx as it is. [m to the number of turns]")]
    side: Annotated[
        Sign | Literal[0],
        Field(
            description="The sign of det Jx: modes of one sign may be reached from each other "
            "without a type 2 singularity, modes of two signs cannot; 0: singular, two modes in "
            "one."
        ),
    ]
    residual: Annotated[
        float,
        Field(
            description="The greatest error of a rod's length over the mechanism's greatest length."
        ),
    ]


class ForwardKinematicsResult(Model):
    """All assembly modes, each once."""

    analysis: Literal["forward_kinematics"]
    determinant_unit: str
    assembly_modes: list[list[AssemblyMode]] = Field(
        description="Per row, by falling determinant; empty where the drives are out of reach. "
        "Where the platform can move while the drives stand still, samples of its path, if any."
    )
    route: list[str] = Field(
        description="How they were found: closed form, one angle (the roots of a polynomial), "
        "tetrahedra; of six rods homotopy, retracked, restarted or multistart; impossible drives."
    )
    certified: list[bool] = Field(
        description="Whether these are all: not known where the platform can move while the "
        "drives stand still, nor of multistart."
    )
    obstacles: list[Obstacle] = Field(description=_OBSTACLES)


@dataclass(frozen=True, slots=True)
class Iteration:
    """Where Newton's iteration led, and how."""

    __pydantic_config__ = Model.model_config

    converged: bool
    iterations: int
    left_mode: Annotated[
        bool | None,
        Field(
            description="Whether every motion of the mechanism from the guess to the pose reached "
            "passes a singularity: det Jx has two signs (type 2), or a leg two working modes "
            "(type 1). At the guess the drives are taken next to those given, as the inverse gives "
            "them there. false: no such sign; two singularities on the way cancel out. null: not "
            "converged, a leg does not reach to the guess, or one of the two is singular."
        ),
    ]
    pose: Annotated[
        list[float | None], Field(description="The best that was met, converged or not.")
    ]
    residual: float | None


class ForwardKinematicsGuessResult(Model):
    """The assembly mode reached from a guess."""

    analysis: Literal["forward_kinematics"]
    determinant_unit: str
    assembly_modes: list[list[AssemblyMode]] = Field(
        description="Per row the mode reached; empty where the iteration did not converge."
    )
    newton: list[Iteration]
    obstacles: list[Obstacle] = Field(description=_OBSTACLES)
