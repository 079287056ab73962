from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="OrientationAxis")


@_attrs_define
class OrientationAxis:
    """Orientations along one turning coordinate, from `min` to `max`, `step` apart. [rad]

    Attributes:
        coordinate (str):
        max_ (float | None | Unset):
        min_ (float | None | Unset): With max: for inclusive_orientation and orientation_range.
        step (float | None | Unset): The largest there may be between orientations tried; by default 2 degrees for one
            turn, 15 for three.
    """

    coordinate: str
    max_: float | None | Unset = UNSET
    min_: float | None | Unset = UNSET
    step: float | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        coordinate = self.coordinate

        max_: float | None | Unset
        if isinstance(self.max_, Unset):
            max_ = UNSET
        else:
            max_ = self.max_

        min_: float | None | Unset
        if isinstance(self.min_, Unset):
            min_ = UNSET
        else:
            min_ = self.min_

        step: float | None | Unset
        if isinstance(self.step, Unset):
            step = UNSET
        else:
            step = self.step

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "coordinate": coordinate,
            }
        )
        if max_ is not UNSET:
            field_dict["max"] = max_
        if min_ is not UNSET:
            field_dict["min"] = min_
        if step is not UNSET:
            field_dict["step"] = step

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        coordinate = d.pop("coordinate")

        def _parse_max_(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_ = _parse_max_(d.pop("max", UNSET))

        def _parse_min_(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        min_ = _parse_min_(d.pop("min", UNSET))

        def _parse_step(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        step = _parse_step(d.pop("step", UNSET))

        orientation_axis = cls(
            coordinate=coordinate,
            max_=max_,
            min_=min_,
            step=step,
        )

        return orientation_axis
