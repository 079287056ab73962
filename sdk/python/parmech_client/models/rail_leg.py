from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="RailLeg")


@_attrs_define
class RailLeg:
    """A carriage on a rail along `direction`, and a rod.

    Attributes:
        base_point (list[float]): The carriage's joint at drive coordinate 0. [m]
        direction (list[float]): Of any length but 0.
        drive (Literal['rail']):
        platform_point (list[float]): In the platform's frame. [m]
        rod_length (float): [m]
    """

    base_point: list[float]
    direction: list[float]
    drive: Literal["rail"]
    platform_point: list[float]
    rod_length: float

    def to_dict(self) -> dict[str, Any]:
        base_point = self.base_point

        direction = self.direction

        drive = self.drive

        platform_point = self.platform_point

        rod_length = self.rod_length

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "base_point": base_point,
                "direction": direction,
                "drive": drive,
                "platform_point": platform_point,
                "rod_length": rod_length,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        base_point = cast(list[float], d.pop("base_point"))

        direction = cast(list[float], d.pop("direction"))

        drive = cast(Literal["rail"], d.pop("drive"))
        if drive != "rail":
            raise ValueError(f"drive must match const 'rail', got '{drive}'")

        platform_point = cast(list[float], d.pop("platform_point"))

        rod_length = d.pop("rod_length")

        rail_leg = cls(
            base_point=base_point,
            direction=direction,
            drive=drive,
            platform_point=platform_point,
            rod_length=rod_length,
        )

        return rail_leg
