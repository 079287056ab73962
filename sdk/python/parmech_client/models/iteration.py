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
        left_mode (bool | None): Whether every motion of the mechanism from the guess to the pose reached passes a
            singularity: det Jx has two signs (type 2), or a leg two working modes (type 1). At the guess the drives are
            taken next to those given, as the inverse gives them there. false: no such sign; two singularities on the way
            cancel out. null: not converged, a leg does not reach to the guess, or one of the two is singular.
        pose (list[float | None]): The best that was met, converged or not.
        residual (float | None):
    """

    converged: bool
    iterations: int
    left_mode: bool | None
    pose: list[float | None]
    residual: float | None

    def to_dict(self) -> dict[str, Any]:
        converged = self.converged

        iterations = self.iterations

        left_mode: bool | None
        left_mode = self.left_mode

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
                "left_mode": left_mode,
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

        def _parse_left_mode(data: object) -> bool | None:
            if data is None:
                return data
            return cast(bool | None, data)

        left_mode = _parse_left_mode(d.pop("left_mode"))

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
            left_mode=left_mode,
            pose=pose,
            residual=residual,
        )

        return iteration
