from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

T = TypeVar("T", bound="GridAxis")


@_attrs_define
class GridAxis:
    """Nodes at `min + i step` while they are not above `max`. [m or rad]

    Attributes:
        coordinate (str):
        max_ (float):
        min_ (float):
        step (float):
    """

    coordinate: str
    max_: float
    min_: float
    step: float

    def to_dict(self) -> dict[str, Any]:
        coordinate = self.coordinate

        max_ = self.max_

        min_ = self.min_

        step = self.step

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "coordinate": coordinate,
                "max": max_,
                "min": min_,
                "step": step,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        coordinate = d.pop("coordinate")

        max_ = d.pop("max")

        min_ = d.pop("min")

        step = d.pop("step")

        grid_axis = cls(
            coordinate=coordinate,
            max_=max_,
            min_=min_,
            step=step,
        )

        return grid_axis
