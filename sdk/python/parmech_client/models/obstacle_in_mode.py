from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..models.obstacle_in_mode_reason import ObstacleInModeReason, check_obstacle_in_mode_reason

T = TypeVar("T", bound="ObstacleInMode")


@_attrs_define
class ObstacleInMode:
    """An obstacle in one of several working modes.

    Attributes:
        leg (int | None): The leg, from 0, or the motor, counted on; null where all together fail.
        limit (float | None):
        mode (int): Index into working_modes.
        pose (int): Row of the request's poses, from 0.
        reason (ObstacleInModeReason): reach: value is the rod that would be needed, limit the leg's own [m];
            actuator_limits: the drive and its limit; singularity: det Jx, or the drive's Jpsi, is 0.
        value (float | None):
    """

    leg: int | None
    limit: float | None
    mode: int
    pose: int
    reason: ObstacleInModeReason
    value: float | None

    def to_dict(self) -> dict[str, Any]:
        leg: int | None
        leg = self.leg

        limit: float | None
        limit = self.limit

        mode = self.mode

        pose = self.pose

        reason: str = self.reason

        value: float | None
        value = self.value

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "leg": leg,
                "limit": limit,
                "mode": mode,
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

        mode = d.pop("mode")

        pose = d.pop("pose")

        reason = check_obstacle_in_mode_reason(d.pop("reason"))

        def _parse_value(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        value = _parse_value(d.pop("value"))

        obstacle_in_mode = cls(
            leg=leg,
            limit=limit,
            mode=mode,
            pose=pose,
            reason=reason,
            value=value,
        )

        return obstacle_in_mode
