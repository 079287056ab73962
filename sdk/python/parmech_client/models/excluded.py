from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..models.excluded_reason import ExcludedReason, check_excluded_reason

T = TypeVar("T", bound="Excluded")


@_attrs_define
class Excluded:
    """How many nodes one condition excluded on one leg, or on two of them together.

    Attributes:
        code (int): What the grid's `reason` array says for these nodes.
        leg (int | None): Null where all legs together make the condition.
        nodes (int):
        other_leg (int | None): The other one of two whose rods come too near or make the angle; else null.
        reason (ExcludedReason):
    """

    code: int
    leg: int | None
    nodes: int
    other_leg: int | None
    reason: ExcludedReason

    def to_dict(self) -> dict[str, Any]:
        code = self.code

        leg: int | None
        leg = self.leg

        nodes = self.nodes

        other_leg: int | None
        other_leg = self.other_leg

        reason: str = self.reason

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "code": code,
                "leg": leg,
                "nodes": nodes,
                "other_leg": other_leg,
                "reason": reason,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        code = d.pop("code")

        def _parse_leg(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        leg = _parse_leg(d.pop("leg"))

        nodes = d.pop("nodes")

        def _parse_other_leg(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        other_leg = _parse_other_leg(d.pop("other_leg"))

        reason = check_excluded_reason(d.pop("reason"))

        excluded = cls(
            code=code,
            leg=leg,
            nodes=nodes,
            other_leg=other_leg,
            reason=reason,
        )

        return excluded
