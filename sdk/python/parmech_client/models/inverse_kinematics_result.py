from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.inverse_kinematics_result_working_mode_item import (
    InverseKinematicsResultWorkingModeItem,
    check_inverse_kinematics_result_working_mode_item,
)

if TYPE_CHECKING:
    from ..models.obstacle import Obstacle


T = TypeVar("T", bound="InverseKinematicsResult")


@_attrs_define
class InverseKinematicsResult:
    """Drive coordinates in one working mode.

    Attributes:
        actuators (list[list[float | None]]): Shape (poses, drives); crank angles in (-pi, pi]; null where the leg
            cannot.
        analysis (Literal['inverse_kinematics']):
        obstacles (list[Obstacle]):
        reachable (list[bool]): All legs reach, within their actuator limits.
        units (list[str]): Unit of each drive's coordinate.
        working_mode (list[InverseKinematicsResultWorkingModeItem]):
    """

    actuators: list[list[float | None]]
    analysis: Literal["inverse_kinematics"]
    obstacles: list[Obstacle]
    reachable: list[bool]
    units: list[str]
    working_mode: list[InverseKinematicsResultWorkingModeItem]

    def to_dict(self) -> dict[str, Any]:
        actuators = []
        for actuators_item_data in self.actuators:
            actuators_item = []
            for actuators_item_item_data in actuators_item_data:
                actuators_item_item: float | None
                actuators_item_item = actuators_item_item_data
                actuators_item.append(actuators_item_item)

            actuators.append(actuators_item)

        analysis = self.analysis

        obstacles = []
        for obstacles_item_data in self.obstacles:
            obstacles_item = obstacles_item_data.to_dict()
            obstacles.append(obstacles_item)

        reachable = self.reachable

        units = self.units

        working_mode = []
        for working_mode_item_data in self.working_mode:
            working_mode_item: int = working_mode_item_data
            working_mode.append(working_mode_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "actuators": actuators,
                "analysis": analysis,
                "obstacles": obstacles,
                "reachable": reachable,
                "units": units,
                "working_mode": working_mode,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.obstacle import Obstacle  # noqa: PLC0415

        d = dict(src_dict)
        actuators = []
        _actuators = d.pop("actuators")
        for actuators_item_data in _actuators:
            actuators_item = []
            _actuators_item = actuators_item_data
            for actuators_item_item_data in _actuators_item:

                def _parse_actuators_item_item(data: object) -> float | None:
                    if data is None:
                        return data
                    return cast(float | None, data)

                actuators_item_item = _parse_actuators_item_item(actuators_item_item_data)

                actuators_item.append(actuators_item_item)

            actuators.append(actuators_item)

        analysis = cast(Literal["inverse_kinematics"], d.pop("analysis"))
        if analysis != "inverse_kinematics":
            raise ValueError(f"analysis must match const 'inverse_kinematics', got '{analysis}'")

        obstacles = []
        _obstacles = d.pop("obstacles")
        for obstacles_item_data in _obstacles:
            obstacles_item = Obstacle.from_dict(obstacles_item_data)

            obstacles.append(obstacles_item)

        reachable = cast(list[bool], d.pop("reachable"))

        units = cast(list[str], d.pop("units"))

        working_mode = []
        _working_mode = d.pop("working_mode")
        for working_mode_item_data in _working_mode:
            working_mode_item = check_inverse_kinematics_result_working_mode_item(working_mode_item_data)

            working_mode.append(working_mode_item)

        inverse_kinematics_result = cls(
            actuators=actuators,
            analysis=analysis,
            obstacles=obstacles,
            reachable=reachable,
            units=units,
            working_mode=working_mode,
        )

        return inverse_kinematics_result
