from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="StrutLeg")


@_attrs_define
class StrutLeg:
    """A telescopic strut; its drive coordinate is its length.

    Attributes:
        base_point (list[float]): [m]
        drive (Literal['strut']):
        platform_point (list[float]): In the platform's frame. [m]
    """

    base_point: list[float]
    drive: Literal["strut"]
    platform_point: list[float]

    def to_dict(self) -> dict[str, Any]:
        base_point = self.base_point

        drive = self.drive

        platform_point = self.platform_point

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "base_point": base_point,
                "drive": drive,
                "platform_point": platform_point,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        base_point = cast(list[float], d.pop("base_point"))

        drive = cast(Literal["strut"], d.pop("drive"))
        if drive != "strut":
            raise ValueError(f"drive must match const 'strut', got '{drive}'")

        platform_point = cast(list[float], d.pop("platform_point"))

        strut_leg = cls(
            base_point=base_point,
            drive=drive,
            platform_point=platform_point,
        )

        return strut_leg
