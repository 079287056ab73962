from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.effort_result_working_mode_item import EffortResultWorkingModeItem, check_effort_result_working_mode_item

if TYPE_CHECKING:
    from ..models.obstacle import Obstacle


T = TypeVar("T", bound="EffortResult")


@_attrs_define
class EffortResult:
    """Efforts of the drives, shape (poses, drives); null rows where there is none.

    Attributes:
        analysis (Literal['effort']):
        effort (list[list[float | None]]): Greatest effort, not below 0, with load; signed with known_load alone.
        obstacles (list[Obstacle]):
        units (list[str]): Unit of each drive's effort.
        working_mode (list[EffortResultWorkingModeItem]):
        worst_force (list[list[list[float] | None]] | None): Shape (poses, drives, 3): the force that asks most of the
            drive; null without load. [N]
        worst_moment (list[list[list[float] | None]] | None): Shape (poses, drives, 3): the moment that asks most of the
            drive; null without load. [N m]
    """

    analysis: Literal["effort"]
    effort: list[list[float | None]]
    obstacles: list[Obstacle]
    units: list[str]
    working_mode: list[EffortResultWorkingModeItem]
    worst_force: list[list[list[float] | None]] | None
    worst_moment: list[list[list[float] | None]] | None

    def to_dict(self) -> dict[str, Any]:
        analysis = self.analysis

        effort = []
        for effort_item_data in self.effort:
            effort_item = []
            for effort_item_item_data in effort_item_data:
                effort_item_item: float | None
                effort_item_item = effort_item_item_data
                effort_item.append(effort_item_item)

            effort.append(effort_item)

        obstacles = []
        for obstacles_item_data in self.obstacles:
            obstacles_item = obstacles_item_data.to_dict()
            obstacles.append(obstacles_item)

        units = self.units

        working_mode = []
        for working_mode_item_data in self.working_mode:
            working_mode_item: int = working_mode_item_data
            working_mode.append(working_mode_item)

        worst_force: list[list[list[float] | None]] | None
        if isinstance(self.worst_force, list):
            worst_force = []
            for worst_force_type_0_item_data in self.worst_force:
                worst_force_type_0_item = []
                for worst_force_type_0_item_item_data in worst_force_type_0_item_data:
                    worst_force_type_0_item_item: list[float] | None
                    if isinstance(worst_force_type_0_item_item_data, list):
                        worst_force_type_0_item_item = worst_force_type_0_item_item_data

                    else:
                        worst_force_type_0_item_item = worst_force_type_0_item_item_data
                    worst_force_type_0_item.append(worst_force_type_0_item_item)

                worst_force.append(worst_force_type_0_item)

        else:
            worst_force = self.worst_force

        worst_moment: list[list[list[float] | None]] | None
        if isinstance(self.worst_moment, list):
            worst_moment = []
            for worst_moment_type_0_item_data in self.worst_moment:
                worst_moment_type_0_item = []
                for worst_moment_type_0_item_item_data in worst_moment_type_0_item_data:
                    worst_moment_type_0_item_item: list[float] | None
                    if isinstance(worst_moment_type_0_item_item_data, list):
                        worst_moment_type_0_item_item = worst_moment_type_0_item_item_data

                    else:
                        worst_moment_type_0_item_item = worst_moment_type_0_item_item_data
                    worst_moment_type_0_item.append(worst_moment_type_0_item_item)

                worst_moment.append(worst_moment_type_0_item)

        else:
            worst_moment = self.worst_moment

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "effort": effort,
                "obstacles": obstacles,
                "units": units,
                "working_mode": working_mode,
                "worst_force": worst_force,
                "worst_moment": worst_moment,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.obstacle import Obstacle  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["effort"], d.pop("analysis"))
        if analysis != "effort":
            raise ValueError(f"analysis must match const 'effort', got '{analysis}'")

        effort = []
        _effort = d.pop("effort")
        for effort_item_data in _effort:
            effort_item = []
            _effort_item = effort_item_data
            for effort_item_item_data in _effort_item:

                def _parse_effort_item_item(data: object) -> float | None:
                    if data is None:
                        return data
                    return cast(float | None, data)

                effort_item_item = _parse_effort_item_item(effort_item_item_data)

                effort_item.append(effort_item_item)

            effort.append(effort_item)

        obstacles = []
        _obstacles = d.pop("obstacles")
        for obstacles_item_data in _obstacles:
            obstacles_item = Obstacle.from_dict(obstacles_item_data)

            obstacles.append(obstacles_item)

        units = cast(list[str], d.pop("units"))

        working_mode = []
        _working_mode = d.pop("working_mode")
        for working_mode_item_data in _working_mode:
            working_mode_item = check_effort_result_working_mode_item(working_mode_item_data)

            working_mode.append(working_mode_item)

        def _parse_worst_force(data: object) -> list[list[list[float] | None]] | None:
            if data is None:
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                worst_force_type_0 = []
                _worst_force_type_0 = data
                for worst_force_type_0_item_data in _worst_force_type_0:
                    worst_force_type_0_item = []
                    _worst_force_type_0_item = worst_force_type_0_item_data
                    for worst_force_type_0_item_item_data in _worst_force_type_0_item:

                        def _parse_worst_force_type_0_item_item(data: object) -> list[float] | None:
                            if data is None:
                                return data
                            try:
                                if not isinstance(data, list):
                                    raise TypeError()
                                worst_force_type_0_item_item_type_0 = cast(list[float], data)

                                return worst_force_type_0_item_item_type_0
                            except (TypeError, ValueError, AttributeError, KeyError):
                                pass
                            return cast(list[float] | None, data)

                        worst_force_type_0_item_item = _parse_worst_force_type_0_item_item(
                            worst_force_type_0_item_item_data
                        )

                        worst_force_type_0_item.append(worst_force_type_0_item_item)

                    worst_force_type_0.append(worst_force_type_0_item)

                return worst_force_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[list[float] | None]] | None, data)

        worst_force = _parse_worst_force(d.pop("worst_force"))

        def _parse_worst_moment(data: object) -> list[list[list[float] | None]] | None:
            if data is None:
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                worst_moment_type_0 = []
                _worst_moment_type_0 = data
                for worst_moment_type_0_item_data in _worst_moment_type_0:
                    worst_moment_type_0_item = []
                    _worst_moment_type_0_item = worst_moment_type_0_item_data
                    for worst_moment_type_0_item_item_data in _worst_moment_type_0_item:

                        def _parse_worst_moment_type_0_item_item(data: object) -> list[float] | None:
                            if data is None:
                                return data
                            try:
                                if not isinstance(data, list):
                                    raise TypeError()
                                worst_moment_type_0_item_item_type_0 = cast(list[float], data)

                                return worst_moment_type_0_item_item_type_0
                            except (TypeError, ValueError, AttributeError, KeyError):
                                pass
                            return cast(list[float] | None, data)

                        worst_moment_type_0_item_item = _parse_worst_moment_type_0_item_item(
                            worst_moment_type_0_item_item_data
                        )

                        worst_moment_type_0_item.append(worst_moment_type_0_item_item)

                    worst_moment_type_0.append(worst_moment_type_0_item)

                return worst_moment_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[list[float] | None]] | None, data)

        worst_moment = _parse_worst_moment(d.pop("worst_moment"))

        effort_result = cls(
            analysis=analysis,
            effort=effort,
            obstacles=obstacles,
            units=units,
            working_mode=working_mode,
            worst_force=worst_force,
            worst_moment=worst_moment,
        )

        return effort_result
