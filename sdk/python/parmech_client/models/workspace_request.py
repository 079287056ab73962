from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.workspace_request_class import WorkspaceRequestClass, check_workspace_request_class
from ..models.workspace_request_component import WorkspaceRequestComponent, check_workspace_request_component
from ..models.workspace_request_fields_item import WorkspaceRequestFieldsItem, check_workspace_request_fields_item
from ..models.workspace_request_method import WorkspaceRequestMethod, check_workspace_request_method
from ..models.workspace_request_type import WorkspaceRequestType, check_workspace_request_type
from ..models.workspace_request_working_mode_type_0_item import (
    WorkspaceRequestWorkingModeType0Item,
    check_workspace_request_working_mode_type_0_item,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.constructive import Constructive
    from ..models.custom import Custom
    from ..models.delta_linear import DeltaLinear
    from ..models.delta_linear_4_dof import DeltaLinear4Dof
    from ..models.delta_rotary import DeltaRotary
    from ..models.effective import Effective
    from ..models.five_bar import FiveBar
    from ..models.geared_decoupled import GearedDecoupled
    from ..models.gough_stewart import GoughStewart
    from ..models.grid_axis import GridAxis
    from ..models.hexa_linear import HexaLinear
    from ..models.hexa_rotary import HexaRotary
    from ..models.orientation_axis import OrientationAxis
    from ..models.planar_3rrr import Planar3RRR
    from ..models.spherical_3rrr import Spherical3RRR
    from ..models.stored_mechanism import StoredMechanism
    from ..models.translational_3rrrr import Translational3RRRR
    from ..models.workspace_request_fixed import WorkspaceRequestFixed


T = TypeVar("T", bound="WorkspaceRequest")


@_attrs_define
class WorkspaceRequest:
    """Ask which nodes of a grid belong to a workspace of a class and a type.

    `class` says which conditions a pose must meet: `theoretical` the inverse problem alone;
    `constructive` also the actuator limits and what `constructive` bounds; `effective` also
    what `effective` bounds. Blocks of a higher class than the one asked are allowed, so that
    one body serves all three, and are not applied.

    `type` says at which orientations the conditions must hold together: constant_orientation at
    the one in `fixed`; orientation: these are on the grid, and the position is fixed, or on the
    grid too, as in any slice through the space of poses; maximal at some, full at every one;
    inclusive_orientation at some, orientation_range at every one of `orientation_range`. Of one
    turn all angles count; of three, all angles of the last, if only reach, actuator limits and
    angles between crank and rod are asked, with a grid of the others, else a grid of all three,
    which the result tells. The position of a spherical mechanism is where its platform's z axis
    points, and its one turn is the `spin` about that.

        Attributes:
            analysis (Literal['workspace']):
            class_ (WorkspaceRequestClass):
            grid (list[GridAxis]):
            mechanism (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled | GoughStewart |
                HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | StoredMechanism | Translational3RRRR):
            type_ (WorkspaceRequestType):
            component (WorkspaceRequestComponent | Unset): home: only what the platform can reach from the pose `home`
                without det Jx changing its sign; neighbouring nodes share a cell's face. Default: 'all'.
            constructive (Constructive | None | Unset):
            effective (Effective | None | Unset):
            fields (list[WorkspaceRequestFieldsItem] | Unset): Numbers to keep for every node inside.
            fixed (WorkspaceRequestFixed | Unset): The value of every coordinate that is not on the grid.
            histograms (bool | Unset): Whether to count how often each field has which values. Default: False.
            home (list[float] | None | Unset): A pose of the mechanism; the nearest node stands for it.
            inscribed (bool | Unset): Whether to look for the largest ball and the largest box along the axes that lie
                inside, on up to three axes. Default: False.
            method (WorkspaceRequestMethod | Unset): geometric: the measure is that of the intersection of the legs'
                regions, of the whole of it, wherever the grid ends; in the plane so are bounds and centroid, and its boundary
                is told in arcs. For reach and actuator limits, over all translations. Default: 'grid'.
            orientation_range (list[OrientationAxis] | Unset): The turns, for the types that need many orientations; for
                maximal and full only their steps, since they mean the whole turn.
            working_mode (list[WorkspaceRequestWorkingModeType0Item] | Literal['any'] | None | Unset): any: the union over
                all working modes; fields are those of the first mode, of +1 before -1 leg by leg, that a node belongs in.
    """

    analysis: Literal["workspace"]
    class_: WorkspaceRequestClass
    grid: list[GridAxis]
    mechanism: (
        Custom
        | DeltaLinear
        | DeltaLinear4Dof
        | DeltaRotary
        | FiveBar
        | GearedDecoupled
        | GoughStewart
        | HexaLinear
        | HexaRotary
        | Planar3RRR
        | Spherical3RRR
        | StoredMechanism
        | Translational3RRRR
    )
    type_: WorkspaceRequestType
    component: WorkspaceRequestComponent | Unset = "all"
    constructive: Constructive | None | Unset = UNSET
    effective: Effective | None | Unset = UNSET
    fields: list[WorkspaceRequestFieldsItem] | Unset = UNSET
    fixed: WorkspaceRequestFixed | Unset = UNSET
    histograms: bool | Unset = False
    home: list[float] | None | Unset = UNSET
    inscribed: bool | Unset = False
    method: WorkspaceRequestMethod | Unset = "grid"
    orientation_range: list[OrientationAxis] | Unset = UNSET
    working_mode: list[WorkspaceRequestWorkingModeType0Item] | Literal["any"] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.constructive import Constructive  # noqa: PLC0415
        from ..models.custom import Custom  # noqa: PLC0415
        from ..models.delta_linear import DeltaLinear  # noqa: PLC0415
        from ..models.delta_linear_4_dof import DeltaLinear4Dof  # noqa: PLC0415
        from ..models.delta_rotary import DeltaRotary  # noqa: PLC0415
        from ..models.effective import Effective  # noqa: PLC0415
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.geared_decoupled import GearedDecoupled  # noqa: PLC0415
        from ..models.gough_stewart import GoughStewart  # noqa: PLC0415
        from ..models.hexa_linear import HexaLinear  # noqa: PLC0415
        from ..models.hexa_rotary import HexaRotary  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.spherical_3rrr import Spherical3RRR  # noqa: PLC0415
        from ..models.translational_3rrrr import Translational3RRRR  # noqa: PLC0415

        analysis = self.analysis

        class_: str = self.class_

        grid = []
        for grid_item_data in self.grid:
            grid_item = grid_item_data.to_dict()
            grid.append(grid_item)

        mechanism: dict[str, Any]
        if isinstance(self.mechanism, FiveBar):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, Planar3RRR):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, Translational3RRRR):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, DeltaRotary):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, DeltaLinear):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, DeltaLinear4Dof):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, HexaLinear):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, GoughStewart):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, HexaRotary):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, Spherical3RRR):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, GearedDecoupled):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, Custom):
            mechanism = self.mechanism.to_dict()
        else:
            mechanism = self.mechanism.to_dict()

        type_: str = self.type_

        component: str | Unset = UNSET
        if not isinstance(self.component, Unset):
            component = self.component

        constructive: dict[str, Any] | None | Unset
        if isinstance(self.constructive, Unset):
            constructive = UNSET
        elif isinstance(self.constructive, Constructive):
            constructive = self.constructive.to_dict()
        else:
            constructive = self.constructive

        effective: dict[str, Any] | None | Unset
        if isinstance(self.effective, Unset):
            effective = UNSET
        elif isinstance(self.effective, Effective):
            effective = self.effective.to_dict()
        else:
            effective = self.effective

        fields: list[str] | Unset = UNSET
        if not isinstance(self.fields, Unset):
            fields = []
            for fields_item_data in self.fields:
                fields_item: str = fields_item_data
                fields.append(fields_item)

        fixed: dict[str, Any] | Unset = UNSET
        if not isinstance(self.fixed, Unset):
            fixed = self.fixed.to_dict()

        histograms = self.histograms

        home: list[float] | None | Unset
        if isinstance(self.home, Unset):
            home = UNSET
        elif isinstance(self.home, list):
            home = self.home

        else:
            home = self.home

        inscribed = self.inscribed

        method: str | Unset = UNSET
        if not isinstance(self.method, Unset):
            method = self.method

        orientation_range: list[dict[str, Any]] | Unset = UNSET
        if not isinstance(self.orientation_range, Unset):
            orientation_range = []
            for orientation_range_item_data in self.orientation_range:
                orientation_range_item = orientation_range_item_data.to_dict()
                orientation_range.append(orientation_range_item)

        working_mode: list[int] | Literal["any"] | None | Unset
        if isinstance(self.working_mode, Unset):
            working_mode = UNSET
        elif isinstance(self.working_mode, list):
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
                "class": class_,
                "grid": grid,
                "mechanism": mechanism,
                "type": type_,
            }
        )
        if component is not UNSET:
            field_dict["component"] = component
        if constructive is not UNSET:
            field_dict["constructive"] = constructive
        if effective is not UNSET:
            field_dict["effective"] = effective
        if fields is not UNSET:
            field_dict["fields"] = fields
        if fixed is not UNSET:
            field_dict["fixed"] = fixed
        if histograms is not UNSET:
            field_dict["histograms"] = histograms
        if home is not UNSET:
            field_dict["home"] = home
        if inscribed is not UNSET:
            field_dict["inscribed"] = inscribed
        if method is not UNSET:
            field_dict["method"] = method
        if orientation_range is not UNSET:
            field_dict["orientation_range"] = orientation_range
        if working_mode is not UNSET:
            field_dict["working_mode"] = working_mode

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.constructive import Constructive  # noqa: PLC0415
        from ..models.custom import Custom  # noqa: PLC0415
        from ..models.delta_linear import DeltaLinear  # noqa: PLC0415
        from ..models.delta_linear_4_dof import DeltaLinear4Dof  # noqa: PLC0415
        from ..models.delta_rotary import DeltaRotary  # noqa: PLC0415
        from ..models.effective import Effective  # noqa: PLC0415
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.geared_decoupled import GearedDecoupled  # noqa: PLC0415
        from ..models.gough_stewart import GoughStewart  # noqa: PLC0415
        from ..models.grid_axis import GridAxis  # noqa: PLC0415
        from ..models.hexa_linear import HexaLinear  # noqa: PLC0415
        from ..models.hexa_rotary import HexaRotary  # noqa: PLC0415
        from ..models.orientation_axis import OrientationAxis  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.spherical_3rrr import Spherical3RRR  # noqa: PLC0415
        from ..models.stored_mechanism import StoredMechanism  # noqa: PLC0415
        from ..models.translational_3rrrr import Translational3RRRR  # noqa: PLC0415
        from ..models.workspace_request_fixed import WorkspaceRequestFixed  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["workspace"], d.pop("analysis"))
        if analysis != "workspace":
            raise ValueError(f"analysis must match const 'workspace', got '{analysis}'")

        class_ = check_workspace_request_class(d.pop("class"))

        grid = []
        _grid = d.pop("grid")
        for grid_item_data in _grid:
            grid_item = GridAxis.from_dict(grid_item_data)

            grid.append(grid_item)

        def _parse_mechanism(
            data: object,
        ) -> (
            Custom
            | DeltaLinear
            | DeltaLinear4Dof
            | DeltaRotary
            | FiveBar
            | GearedDecoupled
            | GoughStewart
            | HexaLinear
            | HexaRotary
            | Planar3RRR
            | Spherical3RRR
            | StoredMechanism
            | Translational3RRRR
        ):
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0 = FiveBar.from_dict(data)

                return mechanism_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_1 = Planar3RRR.from_dict(data)

                return mechanism_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_2 = Translational3RRRR.from_dict(data)

                return mechanism_type_2
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_3 = DeltaRotary.from_dict(data)

                return mechanism_type_3
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_4 = DeltaLinear.from_dict(data)

                return mechanism_type_4
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_5 = DeltaLinear4Dof.from_dict(data)

                return mechanism_type_5
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_6 = HexaLinear.from_dict(data)

                return mechanism_type_6
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_7 = GoughStewart.from_dict(data)

                return mechanism_type_7
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_8 = HexaRotary.from_dict(data)

                return mechanism_type_8
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_9 = Spherical3RRR.from_dict(data)

                return mechanism_type_9
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_10 = GearedDecoupled.from_dict(data)

                return mechanism_type_10
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_11 = Custom.from_dict(data)

                return mechanism_type_11
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            if not isinstance(data, dict):
                raise TypeError()
            mechanism_type_12 = StoredMechanism.from_dict(data)

            return mechanism_type_12

        mechanism = _parse_mechanism(d.pop("mechanism"))

        type_ = check_workspace_request_type(d.pop("type"))

        _component = d.pop("component", UNSET)
        component: WorkspaceRequestComponent | Unset
        if isinstance(_component, Unset):
            component = UNSET
        else:
            component = check_workspace_request_component(_component)

        def _parse_constructive(data: object) -> Constructive | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                constructive_type_0 = Constructive.from_dict(data)

                return constructive_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(Constructive | None | Unset, data)

        constructive = _parse_constructive(d.pop("constructive", UNSET))

        def _parse_effective(data: object) -> Effective | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                effective_type_0 = Effective.from_dict(data)

                return effective_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(Effective | None | Unset, data)

        effective = _parse_effective(d.pop("effective", UNSET))

        _fields = d.pop("fields", UNSET)
        fields: list[WorkspaceRequestFieldsItem] | Unset = UNSET
        if _fields is not UNSET:
            fields = []
            for fields_item_data in _fields:
                fields_item = check_workspace_request_fields_item(fields_item_data)

                fields.append(fields_item)

        _fixed = d.pop("fixed", UNSET)
        fixed: WorkspaceRequestFixed | Unset
        if isinstance(_fixed, Unset):
            fixed = UNSET
        else:
            fixed = WorkspaceRequestFixed.from_dict(_fixed)

        histograms = d.pop("histograms", UNSET)

        def _parse_home(data: object) -> list[float] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                home_type_0 = cast(list[float], data)

                return home_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | None | Unset, data)

        home = _parse_home(d.pop("home", UNSET))

        inscribed = d.pop("inscribed", UNSET)

        _method = d.pop("method", UNSET)
        method: WorkspaceRequestMethod | Unset
        if isinstance(_method, Unset):
            method = UNSET
        else:
            method = check_workspace_request_method(_method)

        _orientation_range = d.pop("orientation_range", UNSET)
        orientation_range: list[OrientationAxis] | Unset = UNSET
        if _orientation_range is not UNSET:
            orientation_range = []
            for orientation_range_item_data in _orientation_range:
                orientation_range_item = OrientationAxis.from_dict(orientation_range_item_data)

                orientation_range.append(orientation_range_item)

        def _parse_working_mode(
            data: object,
        ) -> list[WorkspaceRequestWorkingModeType0Item] | Literal["any"] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                working_mode_type_0 = []
                _working_mode_type_0 = data
                for working_mode_type_0_item_data in _working_mode_type_0:
                    working_mode_type_0_item = check_workspace_request_working_mode_type_0_item(
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
            return cast(list[WorkspaceRequestWorkingModeType0Item] | Literal["any"] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        workspace_request = cls(
            analysis=analysis,
            class_=class_,
            grid=grid,
            mechanism=mechanism,
            type_=type_,
            component=component,
            constructive=constructive,
            effective=effective,
            fields=fields,
            fixed=fixed,
            histograms=histograms,
            home=home,
            inscribed=inscribed,
            method=method,
            orientation_range=orientation_range,
            working_mode=working_mode,
        )

        return workspace_request
