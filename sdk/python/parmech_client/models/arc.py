from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="Arc")


@_attrs_define
class Arc:
    """A circular arc of a boundary; the inside is on its left. [m, rad]

    Attributes:
        centre (list[float]):
        end (float): Of its last point; below start where it turns clockwise.
        radius (float):
        start (float): Angle of its first point.
    """

    centre: list[float]
    end: float
    radius: float
    start: float

    def to_dict(self) -> dict[str, Any]:
        centre = self.centre

        end = self.end

        radius = self.radius

        start = self.start

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "centre": centre,
                "end": end,
                "radius": radius,
                "start": start,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        centre = cast(list[float], d.pop("centre"))

        end = d.pop("end")

        radius = d.pop("radius")

        start = d.pop("start")

        arc = cls(
            centre=centre,
            end=end,
            radius=radius,
            start=start,
        )

        return arc
