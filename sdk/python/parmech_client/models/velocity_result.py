from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.velocity_result_working_mode_item import (
    VelocityResultWorkingModeItem,
    check_velocity_result_working_mode_item,
)

if TYPE_CHECKING:
    from ..models.obstacle import Obstacle


T = TypeVar("T", bound="VelocityResult")


@_attrs_define
class VelocityResult:
    """Rates at each pose; null where there is none.

    Attributes:
        actuator_rates (list[list[float | None]]): Shape (poses, drives).
        analysis (Literal['velocity']):
        obstacles (list[Obstacle]):
        passive_joints (list[list[str]]): Names of each leg's passive joints: A at the base, B at the elbow (BA its
            first axis, fixed in the driven link, BC the second), C at the platform (CD undoes BA of a parallelogram; x, y,
            z are a ball's axes in the base frame), W and V of an arc.
        passive_rates (list[list[list[float] | None]]): Shape (poses, legs, joints); relative rates about the joints'
            axes. A wrist adds none. [rad/s]
        platform_rates (list[list[float] | None]): Shape (poses, 6). [m/s, rad/s]
        units (list[str]): Unit of each drive's rate.
        working_mode (list[VelocityResultWorkingModeItem]):
    """

    actuator_rates: list[list[float | None]]
    analysis: Literal["velocity"]
    obstacles: list[Obstacle]
    passive_joints: list[list[str]]
    passive_rates: list[list[list[float] | None]]
    platform_rates: list[list[float] | None]
    units: list[str]
    working_mode: list[VelocityResultWorkingModeItem]

    def to_dict(self) -> dict[str, Any]:
        actuator_rates = []
        for actuator_rates_item_data in self.actuator_rates:
            actuator_rates_item = []
            for actuator_rates_item_item_data in actuator_rates_item_data:
                actuator_rates_item_item: float | None
                actuator_rates_item_item = actuator_rates_item_item_data
                actuator_rates_item.append(actuator_rates_item_item)

            actuator_rates.append(actuator_rates_item)

        analysis = self.analysis

        obstacles = []
        for obstacles_item_data in self.obstacles:
            obstacles_item = obstacles_item_data.to_dict()
            obstacles.append(obstacles_item)

        passive_joints = []
        for passive_joints_item_data in self.passive_joints:
            passive_joints_item = passive_joints_item_data

            passive_joints.append(passive_joints_item)

        passive_rates = []
        for passive_rates_item_data in self.passive_rates:
            passive_rates_item = []
            for passive_rates_item_item_data in passive_rates_item_data:
                passive_rates_item_item: list[float] | None
                if isinstance(passive_rates_item_item_data, list):
                    passive_rates_item_item = passive_rates_item_item_data

                else:
                    passive_rates_item_item = passive_rates_item_item_data
                passive_rates_item.append(passive_rates_item_item)

            passive_rates.append(passive_rates_item)

        platform_rates = []
        for platform_rates_item_data in self.platform_rates:
            platform_rates_item: list[float] | None
            if isinstance(platform_rates_item_data, list):
                platform_rates_item = platform_rates_item_data

            else:
                platform_rates_item = platform_rates_item_data
            platform_rates.append(platform_rates_item)

        units = self.units

        working_mode = []
        for working_mode_item_data in self.working_mode:
            working_mode_item: int = working_mode_item_data
            working_mode.append(working_mode_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "actuator_rates": actuator_rates,
                "analysis": analysis,
                "obstacles": obstacles,
                "passive_joints": passive_joints,
                "passive_rates": passive_rates,
                "platform_rates": platform_rates,
                "units": units,
                "working_mode": working_mode,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.obstacle import Obstacle  # noqa: PLC0415

        d = dict(src_dict)
        actuator_rates = []
        _actuator_rates = d.pop("actuator_rates")
        for actuator_rates_item_data in _actuator_rates:
            actuator_rates_item = []
            _actuator_rates_item = actuator_rates_item_data
            for actuator_rates_item_item_data in _actuator_rates_item:

                def _parse_actuator_rates_item_item(data: object) -> float | None:
                    if data is None:
                        return data
                    return cast(float | None, data)

                actuator_rates_item_item = _parse_actuator_rates_item_item(actuator_rates_item_item_data)

                actuator_rates_item.append(actuator_rates_item_item)

            actuator_rates.append(actuator_rates_item)

        analysis = cast(Literal["velocity"], d.pop("analysis"))
        if analysis != "velocity":
            raise ValueError(f"analysis must match const 'velocity', got '{analysis}'")

        obstacles = []
        _obstacles = d.pop("obstacles")
        for obstacles_item_data in _obstacles:
            obstacles_item = Obstacle.from_dict(obstacles_item_data)

            obstacles.append(obstacles_item)

        passive_joints = []
        _passive_joints = d.pop("passive_joints")
        for passive_joints_item_data in _passive_joints:
            passive_joints_item = cast(list[str], passive_joints_item_data)

            passive_joints.append(passive_joints_item)

        passive_rates = []
        _passive_rates = d.pop("passive_rates")
        for passive_rates_item_data in _passive_rates:
            passive_rates_item = []
            _passive_rates_item = passive_rates_item_data
            for passive_rates_item_item_data in _passive_rates_item:

                def _parse_passive_rates_item_item(data: object) -> list[float] | None:
                    if data is None:
                        return data
                    try:
                        if not isinstance(data, list):
                            raise TypeError()
                        passive_rates_item_item_type_0 = cast(list[float], data)

                        return passive_rates_item_item_type_0
                    except (TypeError, ValueError, AttributeError, KeyError):
                        pass
                    return cast(list[float] | None, data)

                passive_rates_item_item = _parse_passive_rates_item_item(passive_rates_item_item_data)

                passive_rates_item.append(passive_rates_item_item)

            passive_rates.append(passive_rates_item)

        platform_rates = []
        _platform_rates = d.pop("platform_rates")
        for platform_rates_item_data in _platform_rates:

            def _parse_platform_rates_item(data: object) -> list[float] | None:
                if data is None:
                    return data
                try:
                    if not isinstance(data, list):
                        raise TypeError()
                    platform_rates_item_type_0 = cast(list[float], data)

                    return platform_rates_item_type_0
                except (TypeError, ValueError, AttributeError, KeyError):
                    pass
                return cast(list[float] | None, data)

            platform_rates_item = _parse_platform_rates_item(platform_rates_item_data)

            platform_rates.append(platform_rates_item)

        units = cast(list[str], d.pop("units"))

        working_mode = []
        _working_mode = d.pop("working_mode")
        for working_mode_item_data in _working_mode:
            working_mode_item = check_velocity_result_working_mode_item(working_mode_item_data)

            working_mode.append(working_mode_item)

        velocity_result = cls(
            actuator_rates=actuator_rates,
            analysis=analysis,
            obstacles=obstacles,
            passive_joints=passive_joints,
            passive_rates=passive_rates,
            platform_rates=platform_rates,
            units=units,
            working_mode=working_mode,
        )

        return velocity_result
