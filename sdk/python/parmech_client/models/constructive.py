from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="Constructive")


@_attrs_define
class Constructive:
    """Bounds that the built mechanism sets; what is left out is not asked. [rad]

    Attributes:
        max_crank_rod_angle (float | None | Unset):
        max_rod_rod_angle (float | None | Unset):
        min_crank_rod_angle (float | None | Unset): Inside angle at the elbow, 0 folded, pi stretched.
        min_rod_rod_angle (float | None | Unset): Angle between two rods at a shared joint of the platform.
    """

    max_crank_rod_angle: float | None | Unset = UNSET
    max_rod_rod_angle: float | None | Unset = UNSET
    min_crank_rod_angle: float | None | Unset = UNSET
    min_rod_rod_angle: float | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        max_crank_rod_angle: float | None | Unset
        if isinstance(self.max_crank_rod_angle, Unset):
            max_crank_rod_angle = UNSET
        else:
            max_crank_rod_angle = self.max_crank_rod_angle

        max_rod_rod_angle: float | None | Unset
        if isinstance(self.max_rod_rod_angle, Unset):
            max_rod_rod_angle = UNSET
        else:
            max_rod_rod_angle = self.max_rod_rod_angle

        min_crank_rod_angle: float | None | Unset
        if isinstance(self.min_crank_rod_angle, Unset):
            min_crank_rod_angle = UNSET
        else:
            min_crank_rod_angle = self.min_crank_rod_angle

        min_rod_rod_angle: float | None | Unset
        if isinstance(self.min_rod_rod_angle, Unset):
            min_rod_rod_angle = UNSET
        else:
            min_rod_rod_angle = self.min_rod_rod_angle

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if max_crank_rod_angle is not UNSET:
            field_dict["max_crank_rod_angle"] = max_crank_rod_angle
        if max_rod_rod_angle is not UNSET:
            field_dict["max_rod_rod_angle"] = max_rod_rod_angle
        if min_crank_rod_angle is not UNSET:
            field_dict["min_crank_rod_angle"] = min_crank_rod_angle
        if min_rod_rod_angle is not UNSET:
            field_dict["min_rod_rod_angle"] = min_rod_rod_angle

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)

        def _parse_max_crank_rod_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_crank_rod_angle = _parse_max_crank_rod_angle(d.pop("max_crank_rod_angle", UNSET))

        def _parse_max_rod_rod_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_rod_rod_angle = _parse_max_rod_rod_angle(d.pop("max_rod_rod_angle", UNSET))

        def _parse_min_crank_rod_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        min_crank_rod_angle = _parse_min_crank_rod_angle(d.pop("min_crank_rod_angle", UNSET))

        def _parse_min_rod_rod_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        min_rod_rod_angle = _parse_min_rod_rod_angle(d.pop("min_rod_rod_angle", UNSET))

        constructive = cls(
            max_crank_rod_angle=max_crank_rod_angle,
            max_rod_rod_angle=max_rod_rod_angle,
            min_crank_rod_angle=min_crank_rod_angle,
            min_rod_rod_angle=min_rod_rod_angle,
        )

        return constructive
