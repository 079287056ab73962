"""What every analysis of poses takes and answers."""

from typing import Annotated, Literal

from pydantic import Field

from schemas.quantities import Finite, Model

MOST_POSES = 1_000_000

Pose = list[Finite]
Poses = Annotated[
    list[Pose],
    Field(
        min_length=1,
        max_length=MOST_POSES,
        description="One row a pose, in the order of the kind's coordinates. [m, rad]",
    ),
]


class Obstacle(Model):
    """Why a pose is not held: the leg, what was measured and the limit that it breaks."""

    pose: int = Field(description="Row of the request's poses, from 0.")
    leg: int | None = Field(
        description="The leg, from 0, or the motor, counted on; null where all together fail."
    )
    reason: Literal["reach", "actuator_limits", "singularity"] = Field(
        description="reach: value is the rod that would be needed, limit the leg's own [m]; "
        "actuator_limits: the drive and its limit; singularity: det Jx, or the drive's Jpsi, is 0."
    )
    value: float | None
    limit: float | None
