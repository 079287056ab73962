from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.singularity_result_working_mode_item import (
    SingularityResultWorkingModeItem,
    check_singularity_result_working_mode_item,
)

if TYPE_CHECKING:
    from ..models.obstacle import Obstacle


T = TypeVar("T", bound="SingularityResult")


@_attrs_define
class SingularityResult:
    """Columns of one entry per pose; null where a leg cannot reach.

    Attributes:
        analysis (Literal['singularity']):
        characteristic_length (float): Rms distance of the platform's joints from the reference point. [m]
        condition_number (list[float | None]): Of Jx with turns measured at the characteristic length; null also where
            it is infinite, at types 2 and 3.
        determinant (list[float | None]): Of Jx as it is, rows of unit screws.
        determinant_unit (str):
        free_motion (list[list[float] | None]): The twist [v, w] that the platform can make with all drives braked, at
            types 2 and 3; else null.
        obstacles (list[Obstacle]):
        pressure_angles (list[list[float | None]]): Shape (poses, drives), 0 to pi/2: between the velocity of the leg's
            joint on the platform, all other drives braked, and the line of the rod's force; of a motor, between the axis it
            turns the platform about and that of the moment it bears alone. [rad]
        type_ (list[int | None]): 0 regular; 1 a leg is stretched or folded, or a wrist's axes align; 2 the platform has
            an uncontrolled motion; 3 both.
        working_mode (list[SingularityResultWorkingModeItem]):
    """

    analysis: Literal["singularity"]
    characteristic_length: float
    condition_number: list[float | None]
    determinant: list[float | None]
    determinant_unit: str
    free_motion: list[list[float] | None]
    obstacles: list[Obstacle]
    pressure_angles: list[list[float | None]]
    type_: list[int | None]
    working_mode: list[SingularityResultWorkingModeItem]

    def to_dict(self) -> dict[str, Any]:
        analysis = self.analysis

        characteristic_length = self.characteristic_length

        condition_number = []
        for condition_number_item_data in self.condition_number:
            condition_number_item: float | None
            condition_number_item = condition_number_item_data
            condition_number.append(condition_number_item)

        determinant = []
        for determinant_item_data in self.determinant:
            determinant_item: float | None
            determinant_item = determinant_item_data
            determinant.append(determinant_item)

        determinant_unit = self.determinant_unit

        free_motion = []
        for free_motion_item_data in self.free_motion:
            free_motion_item: list[float] | None
            if isinstance(free_motion_item_data, list):
                free_motion_item = free_motion_item_data

            else:
                free_motion_item = free_motion_item_data
            free_motion.append(free_motion_item)

        obstacles = []
        for obstacles_item_data in self.obstacles:
            obstacles_item = obstacles_item_data.to_dict()
            obstacles.append(obstacles_item)

        pressure_angles = []
        for pressure_angles_item_data in self.pressure_angles:
            pressure_angles_item = []
            for pressure_angles_item_item_data in pressure_angles_item_data:
                pressure_angles_item_item: float | None
                pressure_angles_item_item = pressure_angles_item_item_data
                pressure_angles_item.append(pressure_angles_item_item)

            pressure_angles.append(pressure_angles_item)

        type_ = []
        for type_item_data in self.type_:
            type_item: int | None
            type_item = type_item_data
            type_.append(type_item)

        working_mode = []
        for working_mode_item_data in self.working_mode:
            working_mode_item: int = working_mode_item_data
            working_mode.append(working_mode_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "characteristic_length": characteristic_length,
                "condition_number": condition_number,
                "determinant": determinant,
                "determinant_unit": determinant_unit,
                "free_motion": free_motion,
                "obstacles": obstacles,
                "pressure_angles": pressure_angles,
                "type": type_,
                "working_mode": working_mode,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.obstacle import Obstacle  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["singularity"], d.pop("analysis"))
        if analysis != "singularity":
            raise ValueError(f"analysis must match const 'singularity', got '{analysis}'")

        characteristic_length = d.pop("characteristic_length")

        condition_number = []
        _condition_number = d.pop("condition_number")
        for condition_number_item_data in _condition_number:

            def _parse_condition_number_item(data: object) -> float | None:
                if data is None:
                    return data
                return cast(float | None, data)

            condition_number_item = _parse_condition_number_item(condition_number_item_data)

            condition_number.append(condition_number_item)

        determinant = []
        _determinant = d.pop("determinant")
        for determinant_item_data in _determinant:

            def _parse_determinant_item(data: object) -> float | None:
                if data is None:
                    return data
                return cast(float | None, data)

            determinant_item = _parse_determinant_item(determinant_item_data)

            determinant.append(determinant_item)

        determinant_unit = d.pop("determinant_unit")

        free_motion = []
        _free_motion = d.pop("free_motion")
        for free_motion_item_data in _free_motion:

            def _parse_free_motion_item(data: object) -> list[float] | None:
                if data is None:
                    return data
                try:
                    if not isinstance(data, list):
                        raise TypeError()
                    free_motion_item_type_0 = cast(list[float], data)

                    return free_motion_item_type_0
                except (TypeError, ValueError, AttributeError, KeyError):
                    pass
                return cast(list[float] | None, data)

            free_motion_item = _parse_free_motion_item(free_motion_item_data)

            free_motion.append(free_motion_item)

        obstacles = []
        _obstacles = d.pop("obstacles")
        for obstacles_item_data in _obstacles:
            obstacles_item = Obstacle.from_dict(obstacles_item_data)

            obstacles.append(obstacles_item)

        pressure_angles = []
        _pressure_angles = d.pop("pressure_angles")
        for pressure_angles_item_data in _pressure_angles:
            pressure_angles_item = []
            _pressure_angles_item = pressure_angles_item_data
            for pressure_angles_item_item_data in _pressure_angles_item:

                def _parse_pressure_angles_item_item(data: object) -> float | None:
                    if data is None:
                        return data
                    return cast(float | None, data)

                pressure_angles_item_item = _parse_pressure_angles_item_item(pressure_angles_item_item_data)

                pressure_angles_item.append(pressure_angles_item_item)

            pressure_angles.append(pressure_angles_item)

        type_ = []
        _type_ = d.pop("type")
        for type_item_data in _type_:

            def _parse_type_item(data: object) -> int | None:
                if data is None:
                    return data
                return cast(int | None, data)

            type_item = _parse_type_item(type_item_data)

            type_.append(type_item)

        working_mode = []
        _working_mode = d.pop("working_mode")
        for working_mode_item_data in _working_mode:
            working_mode_item = check_singularity_result_working_mode_item(working_mode_item_data)

            working_mode.append(working_mode_item)

        singularity_result = cls(
            analysis=analysis,
            characteristic_length=characteristic_length,
            condition_number=condition_number,
            determinant=determinant,
            determinant_unit=determinant_unit,
            free_motion=free_motion,
            obstacles=obstacles,
            pressure_angles=pressure_angles,
            type_=type_,
            working_mode=working_mode,
        )

        return singularity_result
