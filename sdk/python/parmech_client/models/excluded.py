from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..models.excluded_reason import ExcludedReason, check_excluded_reason

T = TypeVar("T", bound="Excluded")


@_attrs_define
class Excluded:
    """How many nodes one condition excluded on one leg, of a pair of rods its first one's.

    Attributes:
        code (int): What the grid's `reason` array says for these nodes.
        leg (int | None): Null where all legs together make the condition.
        nodes (int):
        reason (ExcludedReason):
    """

    code: int
    leg: int | None
    nodes: int
    reason: ExcludedReason

    def to_dict(self) -> dict[str, Any]:
        code = self.code

        leg: int | None
        leg = self.leg

        nodes = self.nodes

        reason: str = self.reason

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "code": code,
                "leg": leg,
                "nodes": nodes,
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

        reason = check_excluded_reason(d.pop("reason"))

        excluded = cls(
            code=code,
            leg=leg,
            nodes=nodes,
            reason=reason,
        )

        return excluded
