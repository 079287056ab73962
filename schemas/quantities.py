"""Numbers as they may arrive: finite, in SI units, within what a mechanism can have.

Strictly numbers: neither texts that look like one nor truth values.
"""

from typing import Annotated

from pydantic import AfterValidator, BaseModel, ConfigDict, Field


def _without_negative_zero(value: float) -> float:
    # -0.0 and 0.0 are the same dimension and must give the same canonical form.
    return value + 0.0


Finite = Annotated[
    float,
    Field(strict=True, allow_inf_nan=False, ge=-1e12, le=1e12),
    AfterValidator(_without_negative_zero),
]
Length = Annotated[float, Field(ge=1e-9, le=1e6, strict=True, allow_inf_nan=False)]
Angle = Annotated[float, Field(ge=0, le=3.141592653589793, strict=True, allow_inf_nan=False)]
Step = Annotated[float, Field(ge=1e-12, le=1e12, strict=True, allow_inf_nan=False)]
Size = Annotated[float, Field(ge=0, le=1e12, strict=True, allow_inf_nan=False)]
Limit = Annotated[float, Field(gt=0, le=1e12, strict=True, allow_inf_nan=False)]
Ratio = Annotated[float, Field(ge=1, le=1e12, strict=True, allow_inf_nan=False)]


class Model(BaseModel):
    """A frozen model that accepts no unknown field."""

    model_config = ConfigDict(frozen=True, extra="forbid", serialize_by_alias=True)
