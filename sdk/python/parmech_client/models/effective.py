from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.load_size import LoadSize


T = TypeVar("T", bound="Effective")


@_attrs_define
class Effective:
    """Bounds on the quality of motion; what is left out is not asked.

    Attributes:
        load (LoadSize | None | Unset): The load of max_effort and of the effort fields.
        max_effort (float | list[float] | None | Unset): Greatest effort of any drive under load: one, or one per leg.
            [N m or N]
    """

    load: LoadSize | None | Unset = UNSET
    max_effort: float | list[float] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.load_size import LoadSize  # noqa: PLC0415

        load: dict[str, Any] | None | Unset
        if isinstance(self.load, Unset):
            load = UNSET
        elif isinstance(self.load, LoadSize):
            load = self.load.to_dict()
        else:
            load = self.load

        max_effort: float | list[float] | None | Unset
        if isinstance(self.max_effort, Unset):
            max_effort = UNSET
        elif isinstance(self.max_effort, list):
            max_effort = self.max_effort

        else:
            max_effort = self.max_effort

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if load is not UNSET:
            field_dict["load"] = load
        if max_effort is not UNSET:
            field_dict["max_effort"] = max_effort

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.load_size import LoadSize  # noqa: PLC0415

        d = dict(src_dict)

        def _parse_load(data: object) -> LoadSize | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                load_type_0 = LoadSize.from_dict(data)

                return load_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(LoadSize | None | Unset, data)

        load = _parse_load(d.pop("load", UNSET))

        def _parse_max_effort(data: object) -> float | list[float] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                max_effort_type_1 = cast(list[float], data)

                return max_effort_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(float | list[float] | None | Unset, data)

        max_effort = _parse_max_effort(d.pop("max_effort", UNSET))

        effective = cls(
            load=load,
            max_effort=max_effort,
        )

        return effective
