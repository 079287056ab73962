from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

T = TypeVar("T", bound="OrientationsTried")


@_attrs_define
class OrientationsTried:
    """The orientations along one turning coordinate at which the conditions were tried. [rad]

    Attributes:
        coordinate (str):
        count (int):
        max_ (float):
        min_ (float):
        step (float):
    """

    coordinate: str
    count: int
    max_: float
    min_: float
    step: float

    def to_dict(self) -> dict[str, Any]:
        coordinate = self.coordinate

        count = self.count

        max_ = self.max_

        min_ = self.min_

        step = self.step

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "coordinate": coordinate,
                "count": count,
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

        count = d.pop("count")

        max_ = d.pop("max")

        min_ = d.pop("min")

        step = d.pop("step")

        orientations_tried = cls(
            coordinate=coordinate,
            count=count,
            max_=max_,
            min_=min_,
            step=step,
        )

        return orientations_tried
