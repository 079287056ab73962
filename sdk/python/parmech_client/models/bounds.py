from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

T = TypeVar("T", bound="Bounds")


@_attrs_define
class Bounds:
    """Extent along one axis, over the nodes inside.

    Attributes:
        clipped (bool): It touches the grid's end and may go on beyond.
        coordinate (str):
        max_ (float):
        min_ (float):
    """

    clipped: bool
    coordinate: str
    max_: float
    min_: float

    def to_dict(self) -> dict[str, Any]:
        clipped = self.clipped

        coordinate = self.coordinate

        max_ = self.max_

        min_ = self.min_

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "clipped": clipped,
                "coordinate": coordinate,
                "max": max_,
                "min": min_,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        clipped = d.pop("clipped")

        coordinate = d.pop("coordinate")

        max_ = d.pop("max")

        min_ = d.pop("min")

        bounds = cls(
            clipped=clipped,
            coordinate=coordinate,
            max_=max_,
            min_=min_,
        )

        return bounds
