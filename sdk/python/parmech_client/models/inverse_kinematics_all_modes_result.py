from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.inverse_kinematics_all_modes_result_working_modes_item_item import (
    InverseKinematicsAllModesResultWorkingModesItemItem,
    check_inverse_kinematics_all_modes_result_working_modes_item_item,
)

if TYPE_CHECKING:
    from ..models.obstacle_in_mode import ObstacleInMode


T = TypeVar("T", bound="InverseKinematicsAllModesResult")


@_attrs_define
class InverseKinematicsAllModesResult:
    """Drive coordinates in every working mode; columns gain a leading axis, one per mode.

    Attributes:
        actuators (list[list[list[float | None]]]):
        analysis (Literal['inverse_kinematics']):
        obstacles (list[ObstacleInMode]):
        reachable (list[list[bool]]):
        units (list[str]):
        working_modes (list[list[InverseKinematicsAllModesResultWorkingModesItemItem]]):
    """

    actuators: list[list[list[float | None]]]
    analysis: Literal["inverse_kinematics"]
    obstacles: list[ObstacleInMode]
    reachable: list[list[bool]]
    units: list[str]
    working_modes: list[list[InverseKinematicsAllModesResultWorkingModesItemItem]]

    def to_dict(self) -> dict[str, Any]:
        actuators = []
        for actuators_item_data in self.actuators:
            actuators_item = []
            for actuators_item_item_data in actuators_item_data:
                actuators_item_item = []
                for actuators_item_item_item_data in actuators_item_item_data:
                    actuators_item_item_item: float | None
                    actuators_item_item_item = actuators_item_item_item_data
                    actuators_item_item.append(actuators_item_item_item)

                actuators_item.append(actuators_item_item)

            actuators.append(actuators_item)

        analysis = self.analysis

        obstacles = []
        for obstacles_item_data in self.obstacles:
            obstacles_item = obstacles_item_data.to_dict()
            obstacles.append(obstacles_item)

        reachable = []
        for reachable_item_data in self.reachable:
            reachable_item = reachable_item_data

            reachable.append(reachable_item)

        units = self.units

        working_modes = []
        for working_modes_item_data in self.working_modes:
            working_modes_item = []
            for working_modes_item_item_data in working_modes_item_data:
                working_modes_item_item: int = working_modes_item_item_data
                working_modes_item.append(working_modes_item_item)

            working_modes.append(working_modes_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "actuators": actuators,
                "analysis": analysis,
                "obstacles": obstacles,
                "reachable": reachable,
                "units": units,
                "working_modes": working_modes,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.obstacle_in_mode import ObstacleInMode  # noqa: PLC0415

        d = dict(src_dict)
        actuators = []
        _actuators = d.pop("actuators")
        for actuators_item_data in _actuators:
            actuators_item = []
            _actuators_item = actuators_item_data
            for actuators_item_item_data in _actuators_item:
                actuators_item_item = []
                _actuators_item_item = actuators_item_item_data
                for actuators_item_item_item_data in _actuators_item_item:

                    def _parse_actuators_item_item_item(data: object) -> float | None:
                        if data is None:
                            return data
                        return cast(float | None, data)

                    actuators_item_item_item = _parse_actuators_item_item_item(actuators_item_item_item_data)

                    actuators_item_item.append(actuators_item_item_item)

                actuators_item.append(actuators_item_item)

            actuators.append(actuators_item)

        analysis = cast(Literal["inverse_kinematics"], d.pop("analysis"))
        if analysis != "inverse_kinematics":
            raise ValueError(f"analysis must match const 'inverse_kinematics', got '{analysis}'")

        obstacles = []
        _obstacles = d.pop("obstacles")
        for obstacles_item_data in _obstacles:
            obstacles_item = ObstacleInMode.from_dict(obstacles_item_data)

            obstacles.append(obstacles_item)

        reachable = []
        _reachable = d.pop("reachable")
        for reachable_item_data in _reachable:
            reachable_item = cast(list[bool], reachable_item_data)

            reachable.append(reachable_item)

        units = cast(list[str], d.pop("units"))

        working_modes = []
        _working_modes = d.pop("working_modes")
        for working_modes_item_data in _working_modes:
            working_modes_item = []
            _working_modes_item = working_modes_item_data
            for working_modes_item_item_data in _working_modes_item:
                working_modes_item_item = check_inverse_kinematics_all_modes_result_working_modes_item_item(
                    working_modes_item_item_data
                )

                working_modes_item.append(working_modes_item_item)

            working_modes.append(working_modes_item)

        inverse_kinematics_all_modes_result = cls(
            actuators=actuators,
            analysis=analysis,
            obstacles=obstacles,
            reachable=reachable,
            units=units,
            working_modes=working_modes,
        )

        return inverse_kinematics_all_modes_result
