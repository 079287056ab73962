"""What an analysis would cost."""

from typing import Literal

from pydantic import Field

from schemas.quantities import Model


class Estimate(Model):
    """The price of a request, before anyone pays."""

    nodes: int = Field(description="Poses, grid nodes or meshes to be examined.")
    seconds: float = Field(description="Computing on one core. [s]")
    bytes: int = Field(description="Size of the result, arrays included. [B]")
    mode: Literal["sync", "job"] = Field(description="How POST /v1/analyses would answer.")
