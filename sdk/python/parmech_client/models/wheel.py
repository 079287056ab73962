from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="Wheel")


@_attrs_define
class Wheel:
    """One wheel by its design data.

    Attributes:
        teeth (int): Number of teeth.
        profile_shift (float | Unset): Over the module. Default: 0.0.
    """

    teeth: int
    profile_shift: float | Unset = 0.0

    def to_dict(self) -> dict[str, Any]:
        teeth = self.teeth

        profile_shift = self.profile_shift

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "teeth": teeth,
            }
        )
        if profile_shift is not UNSET:
            field_dict["profile_shift"] = profile_shift

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        teeth = d.pop("teeth")

        profile_shift = d.pop("profile_shift", UNSET)

        wheel = cls(
            teeth=teeth,
            profile_shift=profile_shift,
        )

        return wheel
