from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.assembly_mode import AssemblyMode
    from ..models.obstacle import Obstacle


T = TypeVar("T", bound="ForwardKinematicsResult")


@_attrs_define
class ForwardKinematicsResult:
    """All assembly modes, each once.

    Attributes:
        analysis (Literal['forward_kinematics']):
        assembly_modes (list[list[AssemblyMode]]): Per row, by falling determinant; empty where the drives are out of
            reach. Where the platform can move while the drives stand still, samples of its path, if any.
        certified (list[bool]): Whether these are all: not known where the platform can move while the drives stand
            still, nor of multistart.
        determinant_unit (str):
        obstacles (list[Obstacle]): Which given drives are beyond their actuator limits; `pose` is the row of actuators.
        route (list[str]): How they were found: closed form, one angle (the roots of a polynomial), tetrahedra; of six
            rods homotopy, retracked, restarted or multistart; impossible drives.
    """

    analysis: Literal["forward_kinematics"]
    assembly_modes: list[list[AssemblyMode]]
    certified: list[bool]
    determinant_unit: str
    obstacles: list[Obstacle]
    route: list[str]

    def to_dict(self) -> dict[str, Any]:
        analysis = self.analysis

        assembly_modes = []
        for assembly_modes_item_data in self.assembly_modes:
            assembly_modes_item = []
            for assembly_modes_item_item_data in assembly_modes_item_data:
                assembly_modes_item_item = assembly_modes_item_item_data.to_dict()
                assembly_modes_item.append(assembly_modes_item_item)

            assembly_modes.append(assembly_modes_item)

        certified = self.certified

        determinant_unit = self.determinant_unit

        obstacles = []
        for obstacles_item_data in self.obstacles:
            obstacles_item = obstacles_item_data.to_dict()
            obstacles.append(obstacles_item)

        route = self.route

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "assembly_modes": assembly_modes,
                "certified": certified,
                "determinant_unit": determinant_unit,
                "obstacles": obstacles,
                "route": route,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.assembly_mode import AssemblyMode  # noqa: PLC0415
        from ..models.obstacle import Obstacle  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["forward_kinematics"], d.pop("analysis"))
        if analysis != "forward_kinematics":
            raise ValueError(f"analysis must match const 'forward_kinematics', got '{analysis}'")

        assembly_modes = []
        _assembly_modes = d.pop("assembly_modes")
        for assembly_modes_item_data in _assembly_modes:
            assembly_modes_item = []
            _assembly_modes_item = assembly_modes_item_data
            for assembly_modes_item_item_data in _assembly_modes_item:
                assembly_modes_item_item = AssemblyMode.from_dict(assembly_modes_item_item_data)

                assembly_modes_item.append(assembly_modes_item_item)

            assembly_modes.append(assembly_modes_item)

        certified = cast(list[bool], d.pop("certified"))

        determinant_unit = d.pop("determinant_unit")

        obstacles = []
        _obstacles = d.pop("obstacles")
        for obstacles_item_data in _obstacles:
            obstacles_item = Obstacle.from_dict(obstacles_item_data)

            obstacles.append(obstacles_item)

        route = cast(list[str], d.pop("route"))

        forward_kinematics_result = cls(
            analysis=analysis,
            assembly_modes=assembly_modes,
            certified=certified,
            determinant_unit=determinant_unit,
            obstacles=obstacles,
            route=route,
        )

        return forward_kinematics_result
