from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="KnownLoad")


@_attrs_define
class KnownLoad:
    """A load of known direction, in the base frame: one for all poses, or one row per pose.

    Attributes:
        force (list[float] | list[list[float]] | None | Unset): On the reference point; none by default. [N]
        moment (list[float] | list[list[float]] | None | Unset): About the reference point; none by default. [N m]
    """

    force: list[float] | list[list[float]] | None | Unset = UNSET
    moment: list[float] | list[list[float]] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        force: list[float] | list[list[float]] | None | Unset
        if isinstance(self.force, Unset):
            force = UNSET
        elif isinstance(self.force, list):
            force = self.force

        elif isinstance(self.force, list):
            force = []
            for force_type_0_type_1_item_data in self.force:
                force_type_0_type_1_item = force_type_0_type_1_item_data

                force.append(force_type_0_type_1_item)

        else:
            force = self.force

        moment: list[float] | list[list[float]] | None | Unset
        if isinstance(self.moment, Unset):
            moment = UNSET
        elif isinstance(self.moment, list):
            moment = self.moment

        elif isinstance(self.moment, list):
            moment = []
            for moment_type_0_type_1_item_data in self.moment:
                moment_type_0_type_1_item = moment_type_0_type_1_item_data

                moment.append(moment_type_0_type_1_item)

        else:
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

        def _parse_force(data: object) -> list[float] | list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                force_type_0_type_0 = cast(list[float], data)

                return force_type_0_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, list):
                    raise TypeError()
                force_type_0_type_1 = []
                _force_type_0_type_1 = data
                for force_type_0_type_1_item_data in _force_type_0_type_1:
                    force_type_0_type_1_item = cast(list[float], force_type_0_type_1_item_data)

                    force_type_0_type_1.append(force_type_0_type_1_item)

                return force_type_0_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | list[list[float]] | None | Unset, data)

        force = _parse_force(d.pop("force", UNSET))

        def _parse_moment(data: object) -> list[float] | list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                moment_type_0_type_0 = cast(list[float], data)

                return moment_type_0_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, list):
                    raise TypeError()
                moment_type_0_type_1 = []
                _moment_type_0_type_1 = data
                for moment_type_0_type_1_item_data in _moment_type_0_type_1:
                    moment_type_0_type_1_item = cast(list[float], moment_type_0_type_1_item_data)

                    moment_type_0_type_1.append(moment_type_0_type_1_item)

                return moment_type_0_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | list[list[float]] | None | Unset, data)

        moment = _parse_moment(d.pop("moment", UNSET))

        known_load = cls(
            force=force,
            moment=moment,
        )

        return known_load
