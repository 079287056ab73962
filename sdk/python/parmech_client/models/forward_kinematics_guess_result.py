from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.assembly_mode import AssemblyMode
    from ..models.iteration import Iteration
    from ..models.obstacle import Obstacle


T = TypeVar("T", bound="ForwardKinematicsGuessResult")


@_attrs_define
class ForwardKinematicsGuessResult:
    """The assembly mode reached from a guess.

    Attributes:
        analysis (Literal['forward_kinematics']):
        assembly_modes (list[list[AssemblyMode]]): Per row the mode reached; empty where the iteration did not converge.
        determinant_unit (str):
        newton (list[Iteration]):
        obstacles (list[Obstacle]): Which given drives are beyond their actuator limits; `pose` is the row of actuators.
    """

    analysis: Literal["forward_kinematics"]
    assembly_modes: list[list[AssemblyMode]]
    determinant_unit: str
    newton: list[Iteration]
    obstacles: list[Obstacle]

    def to_dict(self) -> dict[str, Any]:
        analysis = self.analysis

        assembly_modes = []
        for assembly_modes_item_data in self.assembly_modes:
            assembly_modes_item = []
            for assembly_modes_item_item_data in assembly_modes_item_data:
                assembly_modes_item_item = assembly_modes_item_item_data.to_dict()
                assembly_modes_item.append(assembly_modes_item_item)

            assembly_modes.append(assembly_modes_item)

        determinant_unit = self.determinant_unit

        newton = []
        for newton_item_data in self.newton:
            newton_item = newton_item_data.to_dict()
            newton.append(newton_item)

        obstacles = []
        for obstacles_item_data in self.obstacles:
            obstacles_item = obstacles_item_data.to_dict()
            obstacles.append(obstacles_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "assembly_modes": assembly_modes,
                "determinant_unit": determinant_unit,
                "newton": newton,
                "obstacles": obstacles,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.assembly_mode import AssemblyMode  # noqa: PLC0415
        from ..models.iteration import Iteration  # noqa: PLC0415
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

        determinant_unit = d.pop("determinant_unit")

        newton = []
        _newton = d.pop("newton")
        for newton_item_data in _newton:
            newton_item = Iteration.from_dict(newton_item_data)

            newton.append(newton_item)

        obstacles = []
        _obstacles = d.pop("obstacles")
        for obstacles_item_data in _obstacles:
            obstacles_item = Obstacle.from_dict(obstacles_item_data)

            obstacles.append(obstacles_item)

        forward_kinematics_guess_result = cls(
            analysis=analysis,
            assembly_modes=assembly_modes,
            determinant_unit=determinant_unit,
            newton=newton,
            obstacles=obstacles,
        )

        return forward_kinematics_guess_result
