"""`effort`: what the drives must bear under a load on the platform."""

from typing import Annotated, Any, Literal, Self

import numpy as np
from pydantic import Discriminator, Field, Tag, field_validator, model_validator

from schemas.legged import Twist, Vector, WorkingMode
from schemas.mechanisms import Mechanism
from schemas.poses import Obstacle, Poses
from schemas.quantities import Model, Size


def _shape(value: Any) -> str:  # noqa: ANN401
    """Return which of the two forms is meant, so that errors speak of that one alone."""
    return "rows" if isinstance(value, list) and value and isinstance(value[0], list) else "vector"


Rows = Annotated[list[Vector], Field(min_length=1)]
Vectors = Annotated[
    Annotated[Vector, Tag("vector")] | Annotated[Rows, Tag("rows")], Discriminator(_shape)
]


class LoadSize(Model):
    """A load whose size is known and whose direction is not."""

    force: Size = Field(default=0.0, description="Size of the force on the reference point. [N]")
    moment: Size = Field(default=0.0, description="Size of the moment. [N m]")


class KnownLoad(Model):
    """A load of known direction, in the base frame: one for all poses, or one row per pose."""

    force: Vectors | None = Field(
        default=None, description="On the reference point; none by default. [N]"
    )
    moment: Vectors | None = Field(
        default=None, description="About the reference point; none by default. [N m]"
    )


Matrix = Annotated[list[Vector], Field(min_length=3, max_length=3)]


def is_inertia(matrix: list[list[float]]) -> bool:
    """Return whether a 3 x 3 matrix can be a body's inertia about its centre of mass."""
    tensor = np.array(matrix)
    slack = 1e-9 * float(np.max(np.abs(tensor)))
    if np.max(np.abs(tensor - tensor.T)) > slack:
        return False
    least, middle, greatest = np.linalg.eigvalsh(tensor)
    return bool(least >= -slack and greatest <= least + middle + slack)


class PlatformBody(Model):
    """A rigid body on the platform, whose weight and inertia the drives must bear."""

    mass: Size = Field(description="[kg]")
    centre_of_mass: Vector | None = Field(
        default=None, description="In the platform's frame; its reference point by default. [m]"
    )
    inertia: Matrix | None = Field(
        default=None,
        description="About the centre of mass, in the platform's frame; none by default. [kg m^2]",
    )
    gravity: Vector | None = Field(
        default=None, description="In the base frame; [0, 0, -9.80665] by default. [m/s^2]"
    )

    @field_validator("inertia", mode="after")
    @classmethod
    def _of_a_body(cls, matrix: list[list[float]] | None) -> list[list[float]] | None:
        if matrix is not None and not is_inertia(matrix):
            raise ValueError(
                "must be symmetric with principal moments of which none is below 0 nor above the "
                "sum of the others"
            )
        return matrix


class EffortRequest(Model):
    """Ask for drive efforts at poses under a `load`, a `known_load` or a platform's body.

    With `load` the answer is the greatest effort over all directions of its force and its
    moment (each in its own worst direction), on top of what is known; without it, the signed
    effort under what is known: `known_load`, and the weight and inertia of `platform`.
    """

    analysis: Literal["effort"]
    mechanism: Mechanism
    poses: Poses
    load: LoadSize | None = None
    known_load: KnownLoad | None = None
    platform: PlatformBody | None = None
    platform_rates: list[Twist] | None = Field(
        default=None,
        description="[v, w] per pose, or one row for all; only w matters. [m/s, rad/s]",
    )
    platform_accelerations: list[Twist] | None = Field(
        default=None,
        description="Of the reference point and angular, per pose, or one row for all. "
        "[m/s^2, rad/s^2]",
    )
    working_mode: WorkingMode | None = Field(
        default=None,
        description="A branch of the inverse solution; by default the mechanism's own.",
    )

    @model_validator(mode="after")
    def _some_load(self) -> Self:
        if self.load is None and self.known_load is None and self.platform is None:
            raise ValueError("give load, known_load or platform")
        moving = self.platform_rates is not None or self.platform_accelerations is not None
        if moving and self.platform is None:
            raise ValueError("platform_rates and platform_accelerations need a platform")
        return self


class EffortResult(Model):
    """Efforts of the drives, shape (poses, drives); null rows where there is none."""

    analysis: Literal["effort"]
    working_mode: WorkingMode
    units: list[str] = Field(description="Unit of each drive's effort.")
    effort: list[list[float | None]] = Field(
        description="Greatest effort, not below 0, with load; signed with known_load alone."
    )
    worst_force: list[list[list[float] | None]] | None = Field(
        description="Shape (poses, drives, 3): the force that asks most of the drive; null "
        "without load. [N]"
    )
    worst_moment: list[list[list[float] | None]] | None = Field(
        description="Shape (poses, drives, 3): the moment that asks most of the drive; null "
        "without load. [N m]"
    )
    obstacles: list[Obstacle]
