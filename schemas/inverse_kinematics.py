"""`inverse_kinematics`: which drive positions hold a pose."""

from typing import Literal

from pydantic import Field

from schemas.legged import WorkingMode
from schemas.mechanisms import Mechanism
from schemas.poses import Obstacle, Poses
from schemas.quantities import Model


class InverseKinematicsRequest(Model):
    """Ask for the drive coordinates at poses."""

    analysis: Literal["inverse_kinematics"]
    mechanism: Mechanism
    poses: Poses
    working_mode: WorkingMode | Literal["all"] | None = Field(
        default=None, description='A branch; "all" for every one; by default the mechanism\'s own.'
    )


class InverseKinematicsResult(Model):
    """Drive coordinates in one working mode."""

    analysis: Literal["inverse_kinematics"]
    working_mode: WorkingMode
    units: list[str] = Field(description="Unit of each drive's coordinate.")
    reachable: list[bool] = Field(description="All legs reach, within their actuator limits.")
    actuators: list[list[float | None]] = Field(
        description="Shape (poses, legs); crank angles in (-pi, pi]; null where the leg cannot."
    )
    obstacles: list[Obstacle]


class ObstacleInMode(Obstacle):
    """An obstacle in one of several working modes."""

    mode: int = Field(description="Index into working_modes.")


class InverseKinematicsAllModesResult(Model):
    """Drive coordinates in every working mode; columns gain a leading axis, one per mode."""

    analysis: Literal["inverse_kinematics"]
    working_modes: list[WorkingMode]
    units: list[str]
    reachable: list[list[bool]]
    actuators: list[list[list[float | None]]]
    obstacles: list[ObstacleInMode]
