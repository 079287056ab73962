from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="Iteration")


@_attrs_define
class Iteration:
    """Where Newton's iteration led, and how.

    Attributes:
        converged (bool):
        iterations (int):
        pose (list[float | None]): The best that was met, converged or not.
        residual (float | None):
    """

    converged: bool
    iterations: int
    pose: list[float | None]
    residual: float | None

    def to_dict(self) -> dict[str, Any]:
        converged = self.converged

        iterations = self.iterations

        pose = []
        for pose_item_data in self.pose:
            pose_item: float | None
            pose_item = pose_item_data
            pose.append(pose_item)

        residual: float | None
        residual = self.residual

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "converged": converged,
                "iterations": iterations,
                "pose": pose,
                "residual": residual,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        converged = d.pop("converged")

        iterations = d.pop("iterations")

        pose = []
        _pose = d.pop("pose")
        for pose_item_data in _pose:

            def _parse_pose_item(data: object) -> float | None:
                if data is None:
                    return data
                return cast(float | None, data)

            pose_item = _parse_pose_item(pose_item_data)

            pose.append(pose_item)

        def _parse_residual(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        residual = _parse_residual(d.pop("residual"))

        iteration = cls(
            converged=converged,
            iterations=iterations,
            pose=pose,
            residual=residual,
        )

        return iteration
