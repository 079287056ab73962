from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.assembly_mode_side_type_0 import AssemblyModeSideType0, check_assembly_mode_side_type_0
from ..models.assembly_mode_working_mode_item import AssemblyModeWorkingModeItem, check_assembly_mode_working_mode_item

T = TypeVar("T", bound="AssemblyMode")


@_attrs_define
class AssemblyMode:
    """A pose at which the legs close.

    Attributes:
        determinant (float): Of Jx as it is. [m to the number of turns]
        pose (list[float]): In the order of the kind's coordinates. [m, rad]
        residual (float): The greatest error of a rod's length over the mechanism's greatest length.
        side (AssemblyModeSideType0 | Literal[0]): The sign of det Jx: modes of one sign may be reached from each other
            without a type 2 singularity, modes of two signs cannot; 0: singular, two modes in one.
        working_mode (list[AssemblyModeWorkingModeItem]): The branch in which the inverse gives these drives back.
    """

    determinant: float
    pose: list[float]
    residual: float
    side: AssemblyModeSideType0 | Literal[0]
    working_mode: list[AssemblyModeWorkingModeItem]

    def to_dict(self) -> dict[str, Any]:
        determinant = self.determinant

        pose = self.pose

        residual = self.residual

        side: int | Literal[0]
        if isinstance(self.side, int):
            side = self.side
        else:
            side = self.side

        working_mode = []
        for working_mode_item_data in self.working_mode:
            working_mode_item: int = working_mode_item_data
            working_mode.append(working_mode_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "determinant": determinant,
                "pose": pose,
                "residual": residual,
                "side": side,
                "working_mode": working_mode,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        determinant = d.pop("determinant")

        pose = cast(list[float], d.pop("pose"))

        residual = d.pop("residual")

        def _parse_side(data: object) -> AssemblyModeSideType0 | Literal[0]:
            try:
                if not isinstance(data, int):
                    raise TypeError()
                side_type_0 = check_assembly_mode_side_type_0(data)

                return side_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            side_type_1 = cast(Literal[0], data)
            if side_type_1 != 0:
                raise ValueError(f"side_type_1 must match const 0, got '{side_type_1}'")
            return side_type_1

        side = _parse_side(d.pop("side"))

        working_mode = []
        _working_mode = d.pop("working_mode")
        for working_mode_item_data in _working_mode:
            working_mode_item = check_assembly_mode_working_mode_item(working_mode_item_data)

            working_mode.append(working_mode_item)

        assembly_mode = cls(
            determinant=determinant,
            pose=pose,
            residual=residual,
            side=side,
            working_mode=working_mode,
        )

        return assembly_mode
