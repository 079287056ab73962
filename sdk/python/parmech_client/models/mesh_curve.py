from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="MeshCurve")


@_attrs_define
class MeshCurve:
    """The cycle of a mesh; at jumps a phase stands twice, before and after.

    Attributes:
        input_torque (list[float | None]): Under the stage's output_torque; null where the teeth lock. [N m]
        pairs (list[int]): Pairs of teeth in contact.
        phase (list[float]): Part of the cycle since a pair of teeth came into contact, 0 to 1.
        torque_factor (list[float | None]): Input torque over that without friction, at one output torque; null where
            the teeth lock.
    """

    input_torque: list[float | None]
    pairs: list[int]
    phase: list[float]
    torque_factor: list[float | None]

    def to_dict(self) -> dict[str, Any]:
        input_torque = []
        for input_torque_item_data in self.input_torque:
            input_torque_item: float | None
            input_torque_item = input_torque_item_data
            input_torque.append(input_torque_item)

        pairs = self.pairs

        phase = self.phase

        torque_factor = []
        for torque_factor_item_data in self.torque_factor:
            torque_factor_item: float | None
            torque_factor_item = torque_factor_item_data
            torque_factor.append(torque_factor_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "input_torque": input_torque,
                "pairs": pairs,
                "phase": phase,
                "torque_factor": torque_factor,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        input_torque = []
        _input_torque = d.pop("input_torque")
        for input_torque_item_data in _input_torque:

            def _parse_input_torque_item(data: object) -> float | None:
                if data is None:
                    return data
                return cast(float | None, data)

            input_torque_item = _parse_input_torque_item(input_torque_item_data)

            input_torque.append(input_torque_item)

        pairs = cast(list[int], d.pop("pairs"))

        phase = cast(list[float], d.pop("phase"))

        torque_factor = []
        _torque_factor = d.pop("torque_factor")
        for torque_factor_item_data in _torque_factor:

            def _parse_torque_factor_item(data: object) -> float | None:
                if data is None:
                    return data
                return cast(float | None, data)

            torque_factor_item = _parse_torque_factor_item(torque_factor_item_data)

            torque_factor.append(torque_factor_item)

        mesh_curve = cls(
            input_torque=input_torque,
            pairs=pairs,
            phase=phase,
            torque_factor=torque_factor,
        )

        return mesh_curve
