from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="LoadSize")


@_attrs_define
class LoadSize:
    """A load whose size is known and whose direction is not.

    Attributes:
        force (float | Unset): Size of the force on the reference point. [N] Default: 0.0.
        moment (float | Unset): Size of the moment. [N m] Default: 0.0.
    """

    force: float | Unset = 0.0
    moment: float | Unset = 0.0

    def to_dict(self) -> dict[str, Any]:
        force = self.force

        moment = self.moment

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if force is not UNSET:
            field_dict["force"] = force
        if moment is not UNSET:
            field_dict["moment"] = moment

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        force = d.pop("force", UNSET)

        moment = d.pop("moment", UNSET)

        load_size = cls(
            force=force,
            moment=moment,
        )

        return load_size
