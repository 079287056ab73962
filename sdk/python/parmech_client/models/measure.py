from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

T = TypeVar("T", bound="Measure")


@_attrs_define
class Measure:
    """Length, area or volume of a workspace.

    Attributes:
        error_bound (float): How far off the value may be.
        rigorous (bool): False where nodes were counted: what is thinner than a step is not seen.
        unit (str):
        value (float):
    """

    error_bound: float
    rigorous: bool
    unit: str
    value: float

    def to_dict(self) -> dict[str, Any]:
        error_bound = self.error_bound

        rigorous = self.rigorous

        unit = self.unit

        value = self.value

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "error_bound": error_bound,
                "rigorous": rigorous,
                "unit": unit,
                "value": value,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        error_bound = d.pop("error_bound")

        rigorous = d.pop("rigorous")

        unit = d.pop("unit")

        value = d.pop("value")

        measure = cls(
            error_bound=error_bound,
            rigorous=rigorous,
            unit=unit,
            value=value,
        )

        return measure
