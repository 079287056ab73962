"""What every inline mechanism may say beside its dimensions."""

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, Field, ValidationInfo, field_validator

from schemas.quantities import Finite, Model


def _no_truth(value: Any) -> Any:  # noqa: ANN401
    # True equals 1 and would pass for it.
    if isinstance(value, bool):
        raise ValueError("must be 1 or -1")
    return value


Sign = Annotated[Literal[1, -1], BeforeValidator(_no_truth)]
WorkingMode = list[Sign]
Vector = Annotated[list[Finite], Field(min_length=3, max_length=3)]
Twist = Annotated[list[Finite], Field(min_length=6, max_length=6)]


class ActuatorLimit(Model):
    """Least and greatest coordinate of a drive, null where unbounded. [m or rad]

    A crank's limit holds if its angle plus some whole number of turns lies within.
    """

    min: Finite | None = None
    max: Finite | None = None

    @field_validator("max", mode="after")
    @classmethod
    def _right_way_round(cls, value: float | None, info: ValidationInfo) -> float | None:
        least = info.data.get("min")
        if value is not None and least is not None and value < least:
            raise ValueError(f"max must not be below min, which is {least}")
        return value


class LeggedMechanism(Model):
    """What every inline mechanism may say. Lengths in m, angles in rad."""

    drive_count: ClassVar[int]
    default_working_mode: ClassVar[tuple[Sign, ...]] = ()

    name: str | None = Field(default=None, max_length=200, description="A name for people.")
    actuator_limits: list[ActuatorLimit | None] | ActuatorLimit | None = Field(
        default=None,
        validate_default=True,
        description="One for all drives, or a list with one (or null) per drive.",
    )
    working_mode: WorkingMode | None = Field(
        default=None,
        validate_default=True,
        description="The default branch of the inverse solution: 1 or -1 per drive.",
    )

    # Both write out what was left to default, so that equal mechanisms have equal forms.

    @field_validator("actuator_limits", mode="after")
    @classmethod
    def _one_limit_per_drive(
        cls, limits: list[ActuatorLimit | None] | ActuatorLimit | None, info: ValidationInfo
    ) -> list[ActuatorLimit | None]:
        count = cls.count_drives(info.data)
        if not isinstance(limits, list):
            limits = [limits] * count
        if len(limits) != count:
            raise ValueError(f"a list must have {count} entries, one per drive")
        return [None if limit == ActuatorLimit() else limit for limit in limits]

    @field_validator("working_mode", mode="after")
    @classmethod
    def _one_sign_per_drive(cls, mode: WorkingMode | None, info: ValidationInfo) -> WorkingMode:
        count = cls.count_drives(info.data)
        ones: WorkingMode = [1] * count
        signs = (list(cls.default_working_mode) or ones) if mode is None else mode
        if len(signs) != count:
            raise ValueError(f"must have {count} signs, one per drive")
        return signs

    @classmethod
    def count_drives(cls, data: Mapping[str, Any]) -> int:
        """Return how many drives a mechanism of these fields has."""
        return cls.drive_count

    @property
    def limits(self) -> list[ActuatorLimit | None]:
        """The limits of the drives."""
        return self.actuator_limits if isinstance(self.actuator_limits, list) else []

    @property
    def signs(self) -> tuple[int, ...]:
        """The default working mode."""
        return tuple(self.working_mode or ())
