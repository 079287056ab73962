from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="CrankLeg")


@_attrs_define
class CrankLeg:
    """A crank that turns about `axis` through `base_point`, and a rod.

    Attributes:
        axis (list[float]): Of any length but 0.
        base_point (list[float]): On the crank's axis. [m]
        crank_length (float): [m]
        drive (Literal['crank']):
        platform_point (list[float]): In the platform's frame. [m]
        rod_length (float): [m]
        zero_direction (list[float]): Of a crank of angle 0; perpendicular to the axis.
    """

    axis: list[float]
    base_point: list[float]
    crank_length: float
    drive: Literal["crank"]
    platform_point: list[float]
    rod_length: float
    zero_direction: list[float]

    def to_dict(self) -> dict[str, Any]:
        axis = self.axis

        base_point = self.base_point

        crank_length = self.crank_length

        drive = self.drive

        platform_point = self.platform_point

        rod_length = self.rod_length

        zero_direction = self.zero_direction

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "axis": axis,
                "base_point": base_point,
                "crank_length": crank_length,
                "drive": drive,
                "platform_point": platform_point,
                "rod_length": rod_length,
                "zero_direction": zero_direction,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        axis = cast(list[float], d.pop("axis"))

        base_point = cast(list[float], d.pop("base_point"))

        crank_length = d.pop("crank_length")

        drive = cast(Literal["crank"], d.pop("drive"))
        if drive != "crank":
            raise ValueError(f"drive must match const 'crank', got '{drive}'")

        platform_point = cast(list[float], d.pop("platform_point"))

        rod_length = d.pop("rod_length")

        zero_direction = cast(list[float], d.pop("zero_direction"))

        crank_leg = cls(
            axis=axis,
            base_point=base_point,
            crank_length=crank_length,
            drive=drive,
            platform_point=platform_point,
            rod_length=rod_length,
            zero_direction=zero_direction,
        )

        return crank_leg
