from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.translational_3rrrr_working_mode_type_0_item import (
    Translational3RRRRWorkingModeType0Item,
    check_translational_3rrrr_working_mode_type_0_item,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.actuator_limit import ActuatorLimit


T = TypeVar("T", bound="Translational3RRRR")


@_attrs_define
class Translational3RRRR:
    """Three translations from three cranks about x, y and z; all rods end in one point.

    The crank about x passes through base_radius (0, 1, 0), that about y through (0, 0, 1) and
    that about z through (1, 0, 0); a crank of angle 0 points along the axis after its own.

        Attributes:
            base_radius (float): Of the drives from the origin. [m]
            kind (Literal['translational_3rrrr']):
            link_length (float): Of every crank and every rod. [m]
            actuator_limits (ActuatorLimit | list[ActuatorLimit | None] | None | Unset): One for all drives, or a list with
                one (or null) per drive.
            name (None | str | Unset): A name for people.
            working_mode (list[Translational3RRRRWorkingModeType0Item] | None | Unset): The default branch of the inverse
                solution: 1 or -1 per drive.
    """

    base_radius: float
    kind: Literal["translational_3rrrr"]
    link_length: float
    actuator_limits: ActuatorLimit | list[ActuatorLimit | None] | None | Unset = UNSET
    name: None | str | Unset = UNSET
    working_mode: list[Translational3RRRRWorkingModeType0Item] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.actuator_limit import ActuatorLimit  # noqa: PLC0415

        base_radius = self.base_radius

        kind = self.kind

        link_length = self.link_length

        actuator_limits: dict[str, Any] | list[dict[str, Any] | None] | None | Unset
        if isinstance(self.actuator_limits, Unset):
            actuator_limits = UNSET
        elif isinstance(self.actuator_limits, list):
            actuator_limits = []
            for actuator_limits_type_0_item_data in self.actuator_limits:
                actuator_limits_type_0_item: dict[str, Any] | None
                if isinstance(actuator_limits_type_0_item_data, ActuatorLimit):
                    actuator_limits_type_0_item = actuator_limits_type_0_item_data.to_dict()
                else:
                    actuator_limits_type_0_item = actuator_limits_type_0_item_data
                actuator_limits.append(actuator_limits_type_0_item)

        elif isinstance(self.actuator_limits, ActuatorLimit):
            actuator_limits = self.actuator_limits.to_dict()
        else:
            actuator_limits = self.actuator_limits

        name: None | str | Unset
        if isinstance(self.name, Unset):
            name = UNSET
        else:
            name = self.name

        working_mode: list[int] | None | Unset
        if isinstance(self.working_mode, Unset):
            working_mode = UNSET
        elif isinstance(self.working_mode, list):
            working_mode = []
            for working_mode_type_0_item_data in self.working_mode:
                working_mode_type_0_item: int = working_mode_type_0_item_data
                working_mode.append(working_mode_type_0_item)

        else:
            working_mode = self.working_mode

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "base_radius": base_radius,
                "kind": kind,
                "link_length": link_length,
            }
        )
        if actuator_limits is not UNSET:
            field_dict["actuator_limits"] = actuator_limits
        if name is not UNSET:
            field_dict["name"] = name
        if working_mode is not UNSET:
            field_dict["working_mode"] = working_mode

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.actuator_limit import ActuatorLimit  # noqa: PLC0415

        d = dict(src_dict)
        base_radius = d.pop("base_radius")

        kind = cast(Literal["translational_3rrrr"], d.pop("kind"))
        if kind != "translational_3rrrr":
            raise ValueError(f"kind must match const 'translational_3rrrr', got '{kind}'")

        link_length = d.pop("link_length")

        def _parse_actuator_limits(data: object) -> ActuatorLimit | list[ActuatorLimit | None] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                actuator_limits_type_0 = []
                _actuator_limits_type_0 = data
                for actuator_limits_type_0_item_data in _actuator_limits_type_0:

                    def _parse_actuator_limits_type_0_item(data: object) -> ActuatorLimit | None:
                        if data is None:
                            return data
                        try:
                            if not isinstance(data, dict):
                                raise TypeError()
                            actuator_limits_type_0_item_type_0 = ActuatorLimit.from_dict(data)

                            return actuator_limits_type_0_item_type_0
                        except (TypeError, ValueError, AttributeError, KeyError):
                            pass
                        return cast(ActuatorLimit | None, data)

                    actuator_limits_type_0_item = _parse_actuator_limits_type_0_item(actuator_limits_type_0_item_data)

                    actuator_limits_type_0.append(actuator_limits_type_0_item)

                return actuator_limits_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                actuator_limits_type_1 = ActuatorLimit.from_dict(data)

                return actuator_limits_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(ActuatorLimit | list[ActuatorLimit | None] | None | Unset, data)

        actuator_limits = _parse_actuator_limits(d.pop("actuator_limits", UNSET))

        def _parse_name(data: object) -> None | str | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(None | str | Unset, data)

        name = _parse_name(d.pop("name", UNSET))

        def _parse_working_mode(data: object) -> list[Translational3RRRRWorkingModeType0Item] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                working_mode_type_0 = []
                _working_mode_type_0 = data
                for working_mode_type_0_item_data in _working_mode_type_0:
                    working_mode_type_0_item = check_translational_3rrrr_working_mode_type_0_item(
                        working_mode_type_0_item_data
                    )

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[Translational3RRRRWorkingModeType0Item] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        translational_3rrrr = cls(
            base_radius=base_radius,
            kind=kind,
            link_length=link_length,
            actuator_limits=actuator_limits,
            name=name,
            working_mode=working_mode,
        )

        return translational_3rrrr
