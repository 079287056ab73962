from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="PlatformSpeed")


@_attrs_define
class PlatformSpeed:
    """A velocity of the platform whose size is known and whose direction is not.

    Attributes:
        angular (float | Unset): [rad/s] Default: 0.0.
        linear (float | Unset): Of the reference point. [m/s] Default: 0.0.
    """

    angular: float | Unset = 0.0
    linear: float | Unset = 0.0

    def to_dict(self) -> dict[str, Any]:
        angular = self.angular

        linear = self.linear

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if angular is not UNSET:
            field_dict["angular"] = angular
        if linear is not UNSET:
            field_dict["linear"] = linear

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        angular = d.pop("angular", UNSET)

        linear = d.pop("linear", UNSET)

        platform_speed = cls(
            angular=angular,
            linear=linear,
        )

        return platform_speed
