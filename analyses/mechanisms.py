"""From a mechanism on the wire to the mechanism of `mechanics`."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from analyses.custom import custom
from analyses.errors import AnalysisError
from analyses.geared import geared_decoupled
from analyses.gears import build_train
from mechanics.arrays import Floats
from mechanics.errors import GeometryError, WorkingModeError
from mechanics.families.delta import (
    delta_linear,
    delta_linear_4dof,
    delta_rotary,
    translational_3rrrr,
)
from mechanics.families.five_bar import five_bar
from mechanics.families.hexapods import gough_stewart, hexa_linear, hexa_rotary
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.families.spherical_3rrr import spherical_3rrr
from mechanics.mechanism import Mechanism
from mechanics.regularity import check_regular
from schemas.geared import GearedDecoupled
from schemas.mechanisms import InlineMechanism, StoredMechanism

FAMILIES: Mapping[str, Callable[..., Mechanism]] = MappingProxyType(
    {
        "five_bar": five_bar,
        "planar_3rrr": planar_3rrr,
        "translational_3rrrr": translational_3rrrr,
        "delta_rotary": delta_rotary,
        "delta_linear": delta_linear,
        "delta_linear_4dof": delta_linear_4dof,
        "hexa_linear": hexa_linear,
        "gough_stewart": gough_stewart,
        "hexa_rotary": hexa_rotary,
        "spherical_3rrr": spherical_3rrr,
        "geared_decoupled": geared_decoupled,
        "custom": custom,
    }
)
_SHARED = {"kind", "name", "actuator_limits", "working_mode", "train"}


class UnresolvedMechanismError(TypeError):
    """A stored mechanism reached an analysis before its id was resolved."""


def build(
    spec: InlineMechanism | StoredMechanism,
    working_mode: list[Any] | None = None,
    at: str = "/mechanism",
) -> Mechanism:
    """Return the mechanism, in the given working mode or its own; `at` points to it in the body.

    Raises
    ------
    AnalysisError : the dimensions make no mechanism, or there is no such working mode.
    """
    if isinstance(spec, StoredMechanism):
        raise UnresolvedMechanismError(spec.id)
    dimensions = {name: getattr(spec, name) for name in type(spec).model_fields.keys() - _SHARED}
    mode = np.array(spec.signs, dtype=float)
    try:
        mechanism = FAMILIES[spec.kind](**dimensions, limits=_limits(spec), working_mode=mode)
    except GeometryError as error:
        raise AnalysisError((_pointer(spec, error, at), str(error))) from error
    if working_mode is None:
        return _in_mode(mechanism, spec.signs, f"{at}/working_mode")
    return _in_mode(mechanism, tuple(working_mode), "/working_mode")


def check_mechanism(spec: InlineMechanism, at: str = "/mechanism") -> None:
    """Raise AnalysisError if the dimensions make no mechanism, or one that is singular always."""
    mechanism = build(spec, at=at)
    try:
        check_regular(mechanism)
    except GeometryError as error:
        raise AnalysisError((_pointer(spec, error, at), str(error))) from error
    if isinstance(spec, GearedDecoupled) and spec.train is not None:
        build_train(spec.train, f"{at}/train")


def _pointer(spec: InlineMechanism, error: GeometryError, at: str) -> str:
    named = spec.kind == "custom" and error.leg is not None
    return f"{at}/legs/{error.leg}" if named else at


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


def _in_mode(mechanism: Mechanism, signs: tuple[int, ...], pointer: str) -> Mechanism:
    try:
        return mechanism.in_working_mode(signs)
    except WorkingModeError as error:
        raise AnalysisError((pointer, str(error))) from error
