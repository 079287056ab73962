from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.hexa_rotary_working_mode_type_0_item import (
    HexaRotaryWorkingModeType0Item,
    check_hexa_rotary_working_mode_type_0_item,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.actuator_limit import ActuatorLimit


T = TypeVar("T", bound="HexaRotary")


@_attrs_define
class HexaRotary:
    """The 6-RUS hexapod: rods of fixed length on six cranks.

    Attributes:
        base_points (list[list[float]]): On the crank axes. [m]
        crank_axes (list[list[float]]): Of any length but 0.
        crank_length (float): [m]
        crank_zero_directions (list[list[float]]): Perpendicular to the axes.
        kind (Literal['hexa_rotary']):
        platform_points (list[list[float]]): In the platform's frame. [m]
        rod_length (float): [m]
        actuator_limits (ActuatorLimit | list[ActuatorLimit | None] | None | Unset): One for all drives, or a list with
            one (or null) per drive.
        name (None | str | Unset): A name for people.
        working_mode (list[HexaRotaryWorkingModeType0Item] | None | Unset): The default branch of the inverse solution:
            1 or -1 per drive.
    """

    base_points: list[list[float]]
    crank_axes: list[list[float]]
    crank_length: float
    crank_zero_directions: list[list[float]]
    kind: Literal["hexa_rotary"]
    platform_points: list[list[float]]
    rod_length: float
    actuator_limits: ActuatorLimit | list[ActuatorLimit | None] | None | Unset = UNSET
    name: None | str | Unset = UNSET
    working_mode: list[HexaRotaryWorkingModeType0Item] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.actuator_limit import ActuatorLimit  # noqa: PLC0415

        base_points = []
        for base_points_item_data in self.base_points:
            base_points_item = base_points_item_data

            base_points.append(base_points_item)

        crank_axes = []
        for crank_axes_item_data in self.crank_axes:
            crank_axes_item = crank_axes_item_data

            crank_axes.append(crank_axes_item)

        crank_length = self.crank_length

        crank_zero_directions = []
        for crank_zero_directions_item_data in self.crank_zero_directions:
            crank_zero_directions_item = crank_zero_directions_item_data

            crank_zero_directions.append(crank_zero_directions_item)

        kind = self.kind

        platform_points = []
        for platform_points_item_data in self.platform_points:
            platform_points_item = platform_points_item_data

            platform_points.append(platform_points_item)

        rod_length = self.rod_length

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
                "base_points": base_points,
                "crank_axes": crank_axes,
                "crank_length": crank_length,
                "crank_zero_directions": crank_zero_directions,
                "kind": kind,
                "platform_points": platform_points,
                "rod_length": rod_length,
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
        base_points = []
        _base_points = d.pop("base_points")
        for base_points_item_data in _base_points:
            base_points_item = cast(list[float], base_points_item_data)

            base_points.append(base_points_item)

        crank_axes = []
        _crank_axes = d.pop("crank_axes")
        for crank_axes_item_data in _crank_axes:
            crank_axes_item = cast(list[float], crank_axes_item_data)

            crank_axes.append(crank_axes_item)

        crank_length = d.pop("crank_length")

        crank_zero_directions = []
        _crank_zero_directions = d.pop("crank_zero_directions")
        for crank_zero_directions_item_data in _crank_zero_directions:
            crank_zero_directions_item = cast(list[float], crank_zero_directions_item_data)

            crank_zero_directions.append(crank_zero_directions_item)

        kind = cast(Literal["hexa_rotary"], d.pop("kind"))
        if kind != "hexa_rotary":
            raise ValueError(f"kind must match const 'hexa_rotary', got '{kind}'")

        platform_points = []
        _platform_points = d.pop("platform_points")
        for platform_points_item_data in _platform_points:
            platform_points_item = cast(list[float], platform_points_item_data)

            platform_points.append(platform_points_item)

        rod_length = d.pop("rod_length")

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

        def _parse_working_mode(data: object) -> list[HexaRotaryWorkingModeType0Item] | None | Unset:
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
                    working_mode_type_0_item = check_hexa_rotary_working_mode_type_0_item(working_mode_type_0_item_data)

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[HexaRotaryWorkingModeType0Item] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        hexa_rotary = cls(
            base_points=base_points,
            crank_axes=crank_axes,
            crank_length=crank_length,
            crank_zero_directions=crank_zero_directions,
            kind=kind,
            platform_points=platform_points,
            rod_length=rod_length,
            actuator_limits=actuator_limits,
            name=name,
            working_mode=working_mode,
        )

        return hexa_rotary
