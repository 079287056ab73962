from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="Histogram")


@_attrs_define
class Histogram:
    """How many finite values lie between successive edges; the last bin has its upper edge too.

    Attributes:
        counts (list[int]):
        edges (list[float]): From the least value to the greatest, equally spaced.
        undefined (int): Values that are not there or not finite.
    """

    counts: list[int]
    edges: list[float]
    undefined: int

    def to_dict(self) -> dict[str, Any]:
        counts = self.counts

        edges = self.edges

        undefined = self.undefined

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "counts": counts,
                "edges": edges,
                "undefined": undefined,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        counts = cast(list[int], d.pop("counts"))

        edges = cast(list[float], d.pop("edges"))

        undefined = d.pop("undefined")

        histogram = cls(
            counts=counts,
            edges=edges,
            undefined=undefined,
        )

        return histogram
