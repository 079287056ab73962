from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..models.obstacle_reason import ObstacleReason, check_obstacle_reason

T = TypeVar("T", bound="Obstacle")


@_attrs_define
class Obstacle:
    """Why a pose is not held: the leg, what was measured and the limit that it breaks.

    Attributes:
        leg (int | None): The leg, from 0, or the motor, counted on; null where all together fail.
        limit (float | None):
        pose (int): Row of the request's poses, from 0.
        reason (ObstacleReason): reach: value is the rod that would be needed, limit the leg's own [m]; actuator_limits:
            the drive and its limit; singularity: det Jx, or the drive's Jpsi, is 0.
        value (float | None):
    """

    leg: int | None
    limit: float | None
    pose: int
    reason: ObstacleReason
    value: float | None

    def to_dict(self) -> dict[str, Any]:
        leg: int | None
        leg = self.leg

        limit: float | None
        limit = self.limit

        pose = self.pose

        reason: str = self.reason

        value: float | None
        value = self.value

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "leg": leg,
                "limit": limit,
                "pose": pose,
                "reason": reason,
                "value": value,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)

        def _parse_leg(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        leg = _parse_leg(d.pop("leg"))

        def _parse_limit(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        limit = _parse_limit(d.pop("limit"))

        pose = d.pop("pose")

        reason = check_obstacle_reason(d.pop("reason"))

        def _parse_value(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        value = _parse_value(d.pop("value"))

        obstacle = cls(
            leg=leg,
            limit=limit,
            pose=pose,
            reason=reason,
            value=value,
        )

        return obstacle
