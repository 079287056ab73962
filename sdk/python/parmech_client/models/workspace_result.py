from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.workspace_result_class import WorkspaceResultClass, check_workspace_result_class
from ..models.workspace_result_type import WorkspaceResultType, check_workspace_result_type
from ..models.workspace_result_working_mode_type_0_item import (
    WorkspaceResultWorkingModeType0Item,
    check_workspace_result_working_mode_type_0_item,
)

if TYPE_CHECKING:
    from ..models.arc import Arc
    from ..models.bounds import Bounds
    from ..models.component import Component
    from ..models.excluded import Excluded
    from ..models.inscribed import Inscribed
    from ..models.measure import Measure
    from ..models.orientations_tried import OrientationsTried
    from ..models.workspace_result_centroid_type_0 import WorkspaceResultCentroidType0
    from ..models.workspace_result_fields import WorkspaceResultFields


T = TypeVar("T", bound="WorkspaceResult")


@_attrs_define
class WorkspaceResult:
    """A workspace, without its arrays: those are the job's `grid`.

    Attributes:
        analysis (Literal['workspace']):
        boundary (list[list[Arc]] | None): Closed loops, outer ones counterclockwise, holes clockwise; null unless the
            geometric method was asked for in the plane.
        bounds (list[Bounds]): Empty where nothing is inside.
        centroid (None | WorkspaceResultCentroidType0):
        class_ (WorkspaceResultClass):
        component_count (int):
        components (list[Component]): The largest 100, the largest first.
        excluded (list[Excluded]):
        fields (WorkspaceResultFields):
        inscribed (Inscribed | None): Null unless asked for.
        inside (int):
        measure (Measure): Length, area or volume of a workspace.
        nodes (int):
        orientations (list[OrientationsTried] | None): Null for constant_orientation and orientation.
        outer_bound (bool): True where measure, bounds and boundary are of a region that holds the workspace and may be
            larger: maximal by the geometric method.
        shape (list[int]):
        type_ (WorkspaceResultType):
        working_mode (list[WorkspaceResultWorkingModeType0Item] | Literal['any']):
    """

    analysis: Literal["workspace"]
    boundary: list[list[Arc]] | None
    bounds: list[Bounds]
    centroid: None | WorkspaceResultCentroidType0
    class_: WorkspaceResultClass
    component_count: int
    components: list[Component]
    excluded: list[Excluded]
    fields: WorkspaceResultFields
    inscribed: Inscribed | None
    inside: int
    measure: Measure
    nodes: int
    orientations: list[OrientationsTried] | None
    outer_bound: bool
    shape: list[int]
    type_: WorkspaceResultType
    working_mode: list[WorkspaceResultWorkingModeType0Item] | Literal["any"]

    def to_dict(self) -> dict[str, Any]:
        from ..models.inscribed import Inscribed  # noqa: PLC0415
        from ..models.workspace_result_centroid_type_0 import WorkspaceResultCentroidType0  # noqa: PLC0415

        analysis = self.analysis

        boundary: list[list[dict[str, Any]]] | None
        if isinstance(self.boundary, list):
            boundary = []
            for boundary_type_0_item_data in self.boundary:
                boundary_type_0_item = []
                for boundary_type_0_item_item_data in boundary_type_0_item_data:
                    boundary_type_0_item_item = boundary_type_0_item_item_data.to_dict()
                    boundary_type_0_item.append(boundary_type_0_item_item)

                boundary.append(boundary_type_0_item)

        else:
            boundary = self.boundary

        bounds = []
        for bounds_item_data in self.bounds:
            bounds_item = bounds_item_data.to_dict()
            bounds.append(bounds_item)

        centroid: dict[str, Any] | None
        if isinstance(self.centroid, WorkspaceResultCentroidType0):
            centroid = self.centroid.to_dict()
        else:
            centroid = self.centroid

        class_: str = self.class_

        component_count = self.component_count

        components = []
        for components_item_data in self.components:
            components_item = components_item_data.to_dict()
            components.append(components_item)

        excluded = []
        for excluded_item_data in self.excluded:
            excluded_item = excluded_item_data.to_dict()
            excluded.append(excluded_item)

        fields = self.fields.to_dict()

        inscribed: dict[str, Any] | None
        if isinstance(self.inscribed, Inscribed):
            inscribed = self.inscribed.to_dict()
        else:
            inscribed = self.inscribed

        inside = self.inside

        measure = self.measure.to_dict()

        nodes = self.nodes

        orientations: list[dict[str, Any]] | None
        if isinstance(self.orientations, list):
            orientations = []
            for orientations_type_0_item_data in self.orientations:
                orientations_type_0_item = orientations_type_0_item_data.to_dict()
                orientations.append(orientations_type_0_item)

        else:
            orientations = self.orientations

        outer_bound = self.outer_bound

        shape = self.shape

        type_: str = self.type_

        working_mode: list[int] | Literal["any"]
        if isinstance(self.working_mode, list):
            working_mode = []
            for working_mode_type_0_item_data in self.working_mode:
                working_mode_type_0_item: int = working_mode_type_0_item_data
                working_mode.append(working_mode_type_0_item)

        else:
            working_mode = self.working_mode

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "boundary": boundary,
                "bounds": bounds,
                "centroid": centroid,
                "class": class_,
                "component_count": component_count,
                "components": components,
                "excluded": excluded,
                "fields": fields,
                "inscribed": inscribed,
                "inside": inside,
                "measure": measure,
                "nodes": nodes,
                "orientations": orientations,
                "outer_bound": outer_bound,
                "shape": shape,
                "type": type_,
                "working_mode": working_mode,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.arc import Arc  # noqa: PLC0415
        from ..models.bounds import Bounds  # noqa: PLC0415
        from ..models.component import Component  # noqa: PLC0415
        from ..models.excluded import Excluded  # noqa: PLC0415
        from ..models.inscribed import Inscribed  # noqa: PLC0415
        from ..models.measure import Measure  # noqa: PLC0415
        from ..models.orientations_tried import OrientationsTried  # noqa: PLC0415
        from ..models.workspace_result_centroid_type_0 import WorkspaceResultCentroidType0  # noqa: PLC0415
        from ..models.workspace_result_fields import WorkspaceResultFields  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["workspace"], d.pop("analysis"))
        if analysis != "workspace":
            raise ValueError(f"analysis must match const 'workspace', got '{analysis}'")

        def _parse_boundary(data: object) -> list[list[Arc]] | None:
            if data is None:
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                boundary_type_0 = []
                _boundary_type_0 = data
                for boundary_type_0_item_data in _boundary_type_0:
                    boundary_type_0_item = []
                    _boundary_type_0_item = boundary_type_0_item_data
                    for boundary_type_0_item_item_data in _boundary_type_0_item:
                        boundary_type_0_item_item = Arc.from_dict(boundary_type_0_item_item_data)

                        boundary_type_0_item.append(boundary_type_0_item_item)

                    boundary_type_0.append(boundary_type_0_item)

                return boundary_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[Arc]] | None, data)

        boundary = _parse_boundary(d.pop("boundary"))

        bounds = []
        _bounds = d.pop("bounds")
        for bounds_item_data in _bounds:
            bounds_item = Bounds.from_dict(bounds_item_data)

            bounds.append(bounds_item)

        def _parse_centroid(data: object) -> None | WorkspaceResultCentroidType0:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                centroid_type_0 = WorkspaceResultCentroidType0.from_dict(data)

                return centroid_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(None | WorkspaceResultCentroidType0, data)

        centroid = _parse_centroid(d.pop("centroid"))

        class_ = check_workspace_result_class(d.pop("class"))

        component_count = d.pop("component_count")

        components = []
        _components = d.pop("components")
        for components_item_data in _components:
            components_item = Component.from_dict(components_item_data)

            components.append(components_item)

        excluded = []
        _excluded = d.pop("excluded")
        for excluded_item_data in _excluded:
            excluded_item = Excluded.from_dict(excluded_item_data)

            excluded.append(excluded_item)

        fields = WorkspaceResultFields.from_dict(d.pop("fields"))

        def _parse_inscribed(data: object) -> Inscribed | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                inscribed_type_0 = Inscribed.from_dict(data)

                return inscribed_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(Inscribed | None, data)

        inscribed = _parse_inscribed(d.pop("inscribed"))

        inside = d.pop("inside")

        measure = Measure.from_dict(d.pop("measure"))

        nodes = d.pop("nodes")

        def _parse_orientations(data: object) -> list[OrientationsTried] | None:
            if data is None:
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                orientations_type_0 = []
                _orientations_type_0 = data
                for orientations_type_0_item_data in _orientations_type_0:
                    orientations_type_0_item = OrientationsTried.from_dict(orientations_type_0_item_data)

                    orientations_type_0.append(orientations_type_0_item)

                return orientations_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[OrientationsTried] | None, data)

        orientations = _parse_orientations(d.pop("orientations"))

        outer_bound = d.pop("outer_bound")

        shape = cast(list[int], d.pop("shape"))

        type_ = check_workspace_result_type(d.pop("type"))

        def _parse_working_mode(data: object) -> list[WorkspaceResultWorkingModeType0Item] | Literal["any"]:
            try:
                if not isinstance(data, list):
                    raise TypeError()
                working_mode_type_0 = []
                _working_mode_type_0 = data
                for working_mode_type_0_item_data in _working_mode_type_0:
                    working_mode_type_0_item = check_workspace_result_working_mode_type_0_item(
                        working_mode_type_0_item_data
                    )

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            working_mode_type_1 = cast(Literal["any"], data)
            if working_mode_type_1 != "any":
                raise ValueError(f"working_mode_type_1 must match const 'any', got '{working_mode_type_1}'")
            return working_mode_type_1

        working_mode = _parse_working_mode(d.pop("working_mode"))

        workspace_result = cls(
            analysis=analysis,
            boundary=boundary,
            bounds=bounds,
            centroid=centroid,
            class_=class_,
            component_count=component_count,
            components=components,
            excluded=excluded,
            fields=fields,
            inscribed=inscribed,
            inside=inside,
            measure=measure,
            nodes=nodes,
            orientations=orientations,
            outer_bound=outer_bound,
            shape=shape,
            type_=type_,
            working_mode=working_mode,
        )

        return workspace_result
