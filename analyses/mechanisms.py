"""From a mechanism on the wire to the mechanism of `mechanics`."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from analyses.errors import AnalysisError
from mechanics.arrays import Floats
from mechanics.errors import GeometryError
from mechanics.families.five_bar import five_bar
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.mechanism import Mechanism
from schemas.mechanisms import InlineMechanism, StoredMechanism

FAMILIES: Mapping[str, Callable[..., Mechanism]] = MappingProxyType(
    {"five_bar": five_bar, "planar_3rrr": planar_3rrr}
)
_SHARED = {"kind", "name", "actuator_limits", "working_mode"}


class UnresolvedMechanismError(TypeError):
    """A stored mechanism reached an analysis before its id was resolved."""


def build(
    spec: InlineMechanism | StoredMechanism, working_mode: list[Any] | None = None
) -> Mechanism:
    """Return the mechanism, in the given working mode or its own.

    Raises
    ------
    AnalysisError : the dimensions make no mechanism, or the mode has another number of signs.
    """
    if isinstance(spec, StoredMechanism):
        raise UnresolvedMechanismError(spec.id)
    dimensions = spec.model_dump(exclude=_SHARED)
    try:
        mechanism = FAMILIES[spec.kind](
            **dimensions, limits=_limits(spec), working_mode=np.array(spec.signs, dtype=float)
        )
    except GeometryError as error:
        raise AnalysisError(("/mechanism", str(error))) from error
    return mechanism if working_mode is None else _in_mode(mechanism, working_mode)


def check_mechanism(spec: InlineMechanism) -> None:
    """Raise AnalysisError if the dimensions make no mechanism."""
    build(spec)


def _limits(spec: InlineMechanism) -> Floats:
    return np.array(
        [
            (
                -np.inf if limit is None or limit.min is None else limit.min,
                np.inf if limit is None or limit.max is None else limit.max,
            )
            for limit in spec.limits
        ]
    )


def _in_mode(mechanism: Mechanism, working_mode: list[Any]) -> Mechanism:
    if len(working_mode) != mechanism.leg_count:
        raise AnalysisError(
            (
                "/working_mode",
                f"must have {mechanism.leg_count} signs, one per leg; given {len(working_mode)}",
            )
        )
    return mechanism.in_working_mode(tuple(working_mode))
