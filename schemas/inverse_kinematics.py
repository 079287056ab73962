"""`inverse_kinematics`: which drive positions hold a pose."""

from typing import Annotated, Literal

from pydantic import Field

from schemas.legged import Vector, WorkingMode
from schemas.mechanisms import Mechanism
from schemas.poses import MOST_POSES, Obstacle, Poses
from schemas.quantities import Model

Axes = Annotated[list[Vector], Field(min_length=2, max_length=2)]


class InverseKinematicsRequest(Model):
    """Ask for the drive coordinates at poses."""

    analysis: Literal["inverse_kinematics"]
    mechanism: Mechanism
    poses: Poses
    directions: Annotated[list[Axes], Field(min_length=1, max_length=MOST_POSES)] | None = Field(
        default=None,
        description="In place of rx, ry, rz, so that poses are positions only: the unit vectors of "
        "the platform's x and y axes in the base frame, a pair a pose. Angles are then the usual "
        "ones, rx and rz in (-pi, pi], ry in [-pi/2, pi/2].",
    )
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
        description="Shape (poses, drives); crank angles in (-pi, pi]; null where the leg cannot."
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
