"""`singularity`: how close a pose is to a singularity, and of which type that is."""

from typing import Literal

from pydantic import Field

from schemas.legged import WorkingMode
from schemas.mechanisms import Mechanism
from schemas.poses import Obstacle, Poses
from schemas.quantities import Model


class SingularityRequest(Model):
    """Ask about singularities at poses."""

    analysis: Literal["singularity"]
    mechanism: Mechanism
    poses: Poses
    working_mode: WorkingMode | None = None


class SingularityResult(Model):
    """Columns of one entry per pose; null where a leg cannot reach."""

    analysis: Literal["singularity"]
    working_mode: WorkingMode
    determinant: list[float | None] = Field(description="Of Jx as it is, rows of unit screws.")
    determinant_unit: str
    condition_number: list[float | None] = Field(
        description="Of Jx with turns measured at the characteristic length; null also where it "
        "is infinite, at types 2 and 3."
    )
    characteristic_length: float = Field(
        description="Rms distance of the platform's joints from the reference point. [m]"
    )
    type: list[int | None] = Field(
        description="0 regular; 1 a leg is stretched or folded, or a wrist's axes align; 2 the "
        "platform has an uncontrolled motion; 3 both."
    )
    pressure_angles: list[list[float | None]] = Field(
        description="Shape (poses, drives), 0 to pi/2: between the velocity of the leg's joint on "
        "the platform, all other drives braked, and the line of the rod's force; of a motor, "
        "between the axis it turns the platform about and that of the moment it bears alone. [rad]"
    )
    free_motion: list[list[float] | None] = Field(
        description="The twist [v, w] that the platform can make with all drives braked, at types "
        "2 and 3; else null."
    )
    obstacles: list[Obstacle]
