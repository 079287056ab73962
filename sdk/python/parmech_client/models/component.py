from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.bounds import Bounds
    from ..models.component_centroid import ComponentCentroid


T = TypeVar("T", bound="Component")


@_attrs_define
class Component:
    """A connected part; nodes are neighbours when their cells share a face.

    Attributes:
        bounds (list[Bounds]):
        centroid (ComponentCentroid):
        measure (float):
        nodes (int):
    """

    bounds: list[Bounds]
    centroid: ComponentCentroid
    measure: float
    nodes: int

    def to_dict(self) -> dict[str, Any]:
        bounds = []
        for bounds_item_data in self.bounds:
            bounds_item = bounds_item_data.to_dict()
            bounds.append(bounds_item)

        centroid = self.centroid.to_dict()

        measure = self.measure

        nodes = self.nodes

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "bounds": bounds,
                "centroid": centroid,
                "measure": measure,
                "nodes": nodes,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.bounds import Bounds  # noqa: PLC0415
        from ..models.component_centroid import ComponentCentroid  # noqa: PLC0415

        d = dict(src_dict)
        bounds = []
        _bounds = d.pop("bounds")
        for bounds_item_data in _bounds:
            bounds_item = Bounds.from_dict(bounds_item_data)

            bounds.append(bounds_item)

        centroid = ComponentCentroid.from_dict(d.pop("centroid"))

        measure = d.pop("measure")

        nodes = d.pop("nodes")

        component = cls(
            bounds=bounds,
            centroid=centroid,
            measure=measure,
            nodes=nodes,
        )

        return component
