from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

from ..models.estimate_mode import EstimateMode, check_estimate_mode

T = TypeVar("T", bound="Estimate")


@_attrs_define
class Estimate:
    """The price of a request, before anyone pays.

    Attributes:
        bytes_ (int): Size of the result, arrays included. [B]
        mode (EstimateMode): How POST /v1/analyses would answer.
        nodes (int): Poses, grid nodes or meshes to be examined.
        seconds (float): Computing on one core. [s]
    """

    bytes_: int
    mode: EstimateMode
    nodes: int
    seconds: float

    def to_dict(self) -> dict[str, Any]:
        bytes_ = self.bytes_

        mode: str = self.mode

        nodes = self.nodes

        seconds = self.seconds

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "bytes": bytes_,
                "mode": mode,
                "nodes": nodes,
                "seconds": seconds,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        bytes_ = d.pop("bytes")

        mode = check_estimate_mode(d.pop("mode"))

        nodes = d.pop("nodes")

        seconds = d.pop("seconds")

        estimate = cls(
            bytes_=bytes_,
            mode=mode,
            nodes=nodes,
            seconds=seconds,
        )

        return estimate
