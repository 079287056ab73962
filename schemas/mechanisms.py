"""Mechanisms on the wire, their canonical form and their id."""

import hashlib
import json
from collections.abc import Mapping
from types import MappingProxyType
from typing import Annotated, Any, Literal

from pydantic import Field, TypeAdapter

from schemas.custom import Custom
from schemas.families import (
    DeltaLinear,
    DeltaLinear4Dof,
    DeltaRotary,
    FiveBar,
    GoughStewart,
    HexaLinear,
    HexaRotary,
    Planar3RRR,
    Spherical3RRR,
    Translational3RRRR,
)
from schemas.geared import GearedDecoupled
from schemas.quantities import Model


class StoredMechanism(Model):
    """A mechanism that was stored before."""

    kind: Literal["stored"]
    id: str = Field(pattern=r"^m_[0-9a-f]{32}$", description="The id that storing it answered.")


InlineMechanism = (
    FiveBar
    | Planar3RRR
    | Translational3RRRR
    | DeltaRotary
    | DeltaLinear
    | DeltaLinear4Dof
    | HexaLinear
    | GoughStewart
    | HexaRotary
    | Spherical3RRR
    | GearedDecoupled
    | Custom
)
MechanismSpec = Annotated[InlineMechanism, Field(discriminator="kind")]
Mechanism = Annotated[InlineMechanism | StoredMechanism, Field(discriminator="kind")]

KINDS: Mapping[str, type[InlineMechanism]] = MappingProxyType(
    {
        "five_bar": FiveBar,
        "planar_3rrr": Planar3RRR,
        "translational_3rrrr": Translational3RRRR,
        "delta_rotary": DeltaRotary,
        "delta_linear": DeltaLinear,
        "delta_linear_4dof": DeltaLinear4Dof,
        "hexa_linear": HexaLinear,
        "gough_stewart": GoughStewart,
        "hexa_rotary": HexaRotary,
        "spherical_3rrr": Spherical3RRR,
        "geared_decoupled": GearedDecoupled,
        "custom": Custom,
    }
)
_SPECS: TypeAdapter[InlineMechanism] = TypeAdapter(MechanismSpec)


def parse_spec(text: str) -> InlineMechanism:
    """Return the mechanism of a canonical JSON text."""
    return _SPECS.validate_json(text)


def canonical_json(model: Model) -> str:
    """Return the one JSON text of a model: every field written out, keys sorted, no spaces."""
    document: dict[str, Any] = model.model_dump(mode="json")
    return json.dumps(document, sort_keys=True, separators=(",", ":"), allow_nan=False)


def mechanism_id(spec: InlineMechanism) -> str:
    """Return the id of a mechanism, a hash of its canonical form."""
    return "m_" + hashlib.sha256(canonical_json(spec).encode()).hexdigest()[:32]
