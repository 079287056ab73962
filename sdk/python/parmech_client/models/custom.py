from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.custom_motion import CustomMotion, check_custom_motion
from ..models.custom_working_mode_type_0_item import CustomWorkingModeType0Item, check_custom_working_mode_type_0_item
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.actuator_limit import ActuatorLimit
    from ..models.crank_leg import CrankLeg
    from ..models.rail_leg import RailLeg
    from ..models.strut_leg import StrutLeg


T = TypeVar("T", bound="Custom")


@_attrs_define
class Custom:
    """The user's own legs under a platform of one of the six motions.

    Attributes:
        kind (Literal['custom']):
        legs (list[CrankLeg | RailLeg | StrutLeg]): As many as the motion has coordinates. Points are three numbers
            always.
        motion (CustomMotion): Which coordinates the platform has.
        actuator_limits (ActuatorLimit | list[ActuatorLimit | None] | None | Unset): One for all drives, or a list with
            one (or null) per drive.
        axis (list[float] | None | Unset): Of the turn of a schoenflies motion.
        name (None | str | Unset): A name for people.
        working_mode (list[CustomWorkingModeType0Item] | None | Unset): The default branch of the inverse solution: 1 or
            -1 per drive.
    """

    kind: Literal["custom"]
    legs: list[CrankLeg | RailLeg | StrutLeg]
    motion: CustomMotion
    actuator_limits: ActuatorLimit | list[ActuatorLimit | None] | None | Unset = UNSET
    axis: list[float] | None | Unset = UNSET
    name: None | str | Unset = UNSET
    working_mode: list[CustomWorkingModeType0Item] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.actuator_limit import ActuatorLimit  # noqa: PLC0415
        from ..models.crank_leg import CrankLeg  # noqa: PLC0415
        from ..models.rail_leg import RailLeg  # noqa: PLC0415

        kind = self.kind

        legs = []
        for legs_item_data in self.legs:
            legs_item: dict[str, Any]
            if isinstance(legs_item_data, CrankLeg):
                legs_item = legs_item_data.to_dict()
            elif isinstance(legs_item_data, RailLeg):
                legs_item = legs_item_data.to_dict()
            else:
                legs_item = legs_item_data.to_dict()

            legs.append(legs_item)

        motion: str = self.motion

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

        axis: list[float] | None | Unset
        if isinstance(self.axis, Unset):
            axis = UNSET
        elif isinstance(self.axis, list):
            axis = self.axis

        else:
            axis = self.axis

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
                "kind": kind,
                "legs": legs,
                "motion": motion,
            }
        )
        if actuator_limits is not UNSET:
            field_dict["actuator_limits"] = actuator_limits
        if axis is not UNSET:
            field_dict["axis"] = axis
        if name is not UNSET:
            field_dict["name"] = name
        if working_mode is not UNSET:
            field_dict["working_mode"] = working_mode

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.actuator_limit import ActuatorLimit  # noqa: PLC0415
        from ..models.crank_leg import CrankLeg  # noqa: PLC0415
        from ..models.rail_leg import RailLeg  # noqa: PLC0415
        from ..models.strut_leg import StrutLeg  # noqa: PLC0415

        d = dict(src_dict)
        kind = cast(Literal["custom"], d.pop("kind"))
        if kind != "custom":
            raise ValueError(f"kind must match const 'custom', got '{kind}'")

        legs = []
        _legs = d.pop("legs")
        for legs_item_data in _legs:

            def _parse_legs_item(data: object) -> CrankLeg | RailLeg | StrutLeg:
                try:
                    if not isinstance(data, dict):
                        raise TypeError()
                    legs_item_type_0 = CrankLeg.from_dict(data)

                    return legs_item_type_0
                except (TypeError, ValueError, AttributeError, KeyError):
                    pass
                try:
                    if not isinstance(data, dict):
                        raise TypeError()
                    legs_item_type_1 = RailLeg.from_dict(data)

                    return legs_item_type_1
                except (TypeError, ValueError, AttributeError, KeyError):
                    pass
                if not isinstance(data, dict):
                    raise TypeError()
                legs_item_type_2 = StrutLeg.from_dict(data)

                return legs_item_type_2

            legs_item = _parse_legs_item(legs_item_data)

            legs.append(legs_item)

        motion = check_custom_motion(d.pop("motion"))

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

        def _parse_axis(data: object) -> list[float] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                axis_type_0 = cast(list[float], data)

                return axis_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | None | Unset, data)

        axis = _parse_axis(d.pop("axis", UNSET))

        def _parse_name(data: object) -> None | str | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(None | str | Unset, data)

        name = _parse_name(d.pop("name", UNSET))

        def _parse_working_mode(data: object) -> list[CustomWorkingModeType0Item] | None | Unset:
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
                    working_mode_type_0_item = check_custom_working_mode_type_0_item(working_mode_type_0_item_data)

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[CustomWorkingModeType0Item] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        custom = cls(
            kind=kind,
            legs=legs,
            motion=motion,
            actuator_limits=actuator_limits,
            axis=axis,
            name=name,
            working_mode=working_mode,
        )

        return custom
