from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="OrientationsTried")


@_attrs_define
class OrientationsTried:
    """The orientations along one turning coordinate at which the conditions were tried. [rad]

    Attributes:
        all_angles (bool): Whether all angles count, not those a step apart: arcs in closed form, or with ends to 1e-9
            rad.
        coordinate (str):
        count (int | None): Null for all angles.
        max_ (float):
        min_ (float):
        step (float): Between those tried; of all angles, between those at which conditions without closed forms are
            looked at before the ends of their arcs are sought.
    """

    all_angles: bool
    coordinate: str
    count: int | None
    max_: float
    min_: float
    step: float

    def to_dict(self) -> dict[str, Any]:
        all_angles = self.all_angles

        coordinate = self.coordinate

        count: int | None
        count = self.count

        max_ = self.max_

        min_ = self.min_

        step = self.step

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "all_angles": all_angles,
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
        all_angles = d.pop("all_angles")

        coordinate = d.pop("coordinate")

        def _parse_count(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        count = _parse_count(d.pop("count"))

        max_ = d.pop("max")

        min_ = d.pop("min")

        step = d.pop("step")

        orientations_tried = cls(
            all_angles=all_angles,
            coordinate=coordinate,
            count=count,
            max_=max_,
            min_=min_,
            step=step,
        )

        return orientations_tried
