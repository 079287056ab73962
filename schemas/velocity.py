"""`velocity`: rates of platform, drives and passive joints."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from schemas.legged import Twist, WorkingMode
from schemas.mechanisms import Mechanism
from schemas.poses import MOST_POSES, Obstacle, Poses
from schemas.quantities import Finite, Model


class VelocityRequest(Model):
    """Ask for drive rates under a platform's rates, or the other way round; give one of the two."""

    analysis: Literal["velocity"]
    mechanism: Mechanism
    poses: Poses
    platform_rates: Annotated[list[Twist], Field(min_length=1, max_length=MOST_POSES)] | None = (
        Field(
            default=None,
            description="[vx, vy, vz, wx, wy, wz] per pose: linear velocity of the reference "
            "point, angular velocity, in the base frame; 0 where the motion has none. [m/s, rad/s]",
        )
    )
    actuator_rates: (
        Annotated[list[list[Finite]], Field(min_length=1, max_length=MOST_POSES)] | None
    ) = Field(default=None, description="One row per pose, one number per drive. [rad/s or m/s]")
    working_mode: WorkingMode | None = None

    @model_validator(mode="after")
    def _one_of_two(self) -> Self:
        if (self.platform_rates is None) == (self.actuator_rates is None):
            raise ValueError("give either platform_rates or actuator_rates")
        return self


class VelocityResult(Model):
    """Rates at each pose; null where there is none."""

    analysis: Literal["velocity"]
    working_mode: WorkingMode
    units: list[str] = Field(description="Unit of each drive's rate.")
    platform_rates: list[list[float] | None] = Field(description="Shape (poses, 6). [m/s, rad/s]")
    actuator_rates: list[list[float | None]] = Field(description="Shape (poses, drives).")
    passive_joints: list[list[str]] = Field(
        description="Names of each leg's passive joints: A at the base, B at the elbow (BA its "
        "first axis, fixed in the driven link, BC the second), C at the platform (CD undoes BA of "
        "a parallelogram; x, y, z are a ball's axes in the base frame), W and V of an arc."
    )
    passive_rates: list[list[list[float] | None]] = Field(
        description="Shape (poses, legs, joints); relative rates about the joints' axes. A wrist "
        "adds none. [rad/s]"
    )
    obstacles: list[Obstacle]
