from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.load_size import LoadSize
    from ..models.platform_speed import PlatformSpeed


T = TypeVar("T", bound="Effective")


@_attrs_define
class Effective:
    """Bounds on the quality of motion; what is left out is not asked.

    Attributes:
        load (LoadSize | None | Unset): The load of max_effort and of the effort fields.
        max_actuator_speed (float | list[float] | None | Unset): Greatest speed of any drive at platform_speed, which it
            needs: one, or one per drive. [rad/s or m/s]
        max_condition_number (float | None | Unset): Of Jx with turns measured at the characteristic length.
        max_effort (float | list[float] | None | Unset): Greatest effort of any drive under load: one, or one per drive.
            [N m or N]
        max_pressure_angle (float | None | Unset): Between the velocity of each leg's joint on the platform, all other
            drives braked, and the line of its rod's force; never above pi/2. [rad]
        min_abs_determinant (float | None | Unset): Of det Jx as it is. [m to the number of turns]
        platform_speed (None | PlatformSpeed | Unset): How fast the platform moves and turns, each in its own worst
            direction; what the motion lacks has no share.
    """

    load: LoadSize | None | Unset = UNSET
    max_actuator_speed: float | list[float] | None | Unset = UNSET
    max_condition_number: float | None | Unset = UNSET
    max_effort: float | list[float] | None | Unset = UNSET
    max_pressure_angle: float | None | Unset = UNSET
    min_abs_determinant: float | None | Unset = UNSET
    platform_speed: None | PlatformSpeed | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.load_size import LoadSize  # noqa: PLC0415
        from ..models.platform_speed import PlatformSpeed  # noqa: PLC0415

        load: dict[str, Any] | None | Unset
        if isinstance(self.load, Unset):
            load = UNSET
        elif isinstance(self.load, LoadSize):
            load = self.load.to_dict()
        else:
            load = self.load

        max_actuator_speed: float | list[float] | None | Unset
        if isinstance(self.max_actuator_speed, Unset):
            max_actuator_speed = UNSET
        elif isinstance(self.max_actuator_speed, list):
            max_actuator_speed = self.max_actuator_speed

        else:
            max_actuator_speed = self.max_actuator_speed

        max_condition_number: float | None | Unset
        if isinstance(self.max_condition_number, Unset):
            max_condition_number = UNSET
        else:
            max_condition_number = self.max_condition_number

        max_effort: float | list[float] | None | Unset
        if isinstance(self.max_effort, Unset):
            max_effort = UNSET
        elif isinstance(self.max_effort, list):
            max_effort = self.max_effort

        else:
            max_effort = self.max_effort

        max_pressure_angle: float | None | Unset
        if isinstance(self.max_pressure_angle, Unset):
            max_pressure_angle = UNSET
        else:
            max_pressure_angle = self.max_pressure_angle

        min_abs_determinant: float | None | Unset
        if isinstance(self.min_abs_determinant, Unset):
            min_abs_determinant = UNSET
        else:
            min_abs_determinant = self.min_abs_determinant

        platform_speed: dict[str, Any] | None | Unset
        if isinstance(self.platform_speed, Unset):
            platform_speed = UNSET
        elif isinstance(self.platform_speed, PlatformSpeed):
            platform_speed = self.platform_speed.to_dict()
        else:
            platform_speed = self.platform_speed

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if load is not UNSET:
            field_dict["load"] = load
        if max_actuator_speed is not UNSET:
            field_dict["max_actuator_speed"] = max_actuator_speed
        if max_condition_number is not UNSET:
            field_dict["max_condition_number"] = max_condition_number
        if max_effort is not UNSET:
            field_dict["max_effort"] = max_effort
        if max_pressure_angle is not UNSET:
            field_dict["max_pressure_angle"] = max_pressure_angle
        if min_abs_determinant is not UNSET:
            field_dict["min_abs_determinant"] = min_abs_determinant
        if platform_speed is not UNSET:
            field_dict["platform_speed"] = platform_speed

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.load_size import LoadSize  # noqa: PLC0415
        from ..models.platform_speed import PlatformSpeed  # noqa: PLC0415

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

        def _parse_max_actuator_speed(data: object) -> float | list[float] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                max_actuator_speed_type_1 = cast(list[float], data)

                return max_actuator_speed_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(float | list[float] | None | Unset, data)

        max_actuator_speed = _parse_max_actuator_speed(d.pop("max_actuator_speed", UNSET))

        def _parse_max_condition_number(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_condition_number = _parse_max_condition_number(d.pop("max_condition_number", UNSET))

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

        def _parse_max_pressure_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_pressure_angle = _parse_max_pressure_angle(d.pop("max_pressure_angle", UNSET))

        def _parse_min_abs_determinant(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        min_abs_determinant = _parse_min_abs_determinant(d.pop("min_abs_determinant", UNSET))

        def _parse_platform_speed(data: object) -> None | PlatformSpeed | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                platform_speed_type_0 = PlatformSpeed.from_dict(data)

                return platform_speed_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(None | PlatformSpeed | Unset, data)

        platform_speed = _parse_platform_speed(d.pop("platform_speed", UNSET))

        effective = cls(
            load=load,
            max_actuator_speed=max_actuator_speed,
            max_condition_number=max_condition_number,
            max_effort=max_effort,
            max_pressure_angle=max_pressure_angle,
            min_abs_determinant=min_abs_determinant,
            platform_speed=platform_speed,
        )

        return effective
