from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.effort_request_working_mode_type_0_item import (
    EffortRequestWorkingModeType0Item,
    check_effort_request_working_mode_type_0_item,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.five_bar import FiveBar
    from ..models.known_load import KnownLoad
    from ..models.load_size import LoadSize
    from ..models.planar_3rrr import Planar3RRR
    from ..models.stored_mechanism import StoredMechanism


T = TypeVar("T", bound="EffortRequest")


@_attrs_define
class EffortRequest:
    """Ask for drive efforts at poses; `load`, `known_load` or both must be given.

    With `load` the answer is the greatest effort over all directions of its force and its
    moment (each in its own worst direction), on top of `known_load`; with `known_load` alone
    it is the signed effort.

        Attributes:
            analysis (Literal['effort']):
            mechanism (FiveBar | Planar3RRR | StoredMechanism):
            poses (list[list[float]]): One row a pose, in the order of the kind's coordinates. [m, rad]
            known_load (KnownLoad | None | Unset):
            load (LoadSize | None | Unset):
            working_mode (list[EffortRequestWorkingModeType0Item] | None | Unset): A branch of the inverse solution; by
                default the mechanism's own.
    """

    analysis: Literal["effort"]
    mechanism: FiveBar | Planar3RRR | StoredMechanism
    poses: list[list[float]]
    known_load: KnownLoad | None | Unset = UNSET
    load: LoadSize | None | Unset = UNSET
    working_mode: list[EffortRequestWorkingModeType0Item] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.known_load import KnownLoad  # noqa: PLC0415
        from ..models.load_size import LoadSize  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415

        analysis = self.analysis

        mechanism: dict[str, Any]
        if isinstance(self.mechanism, FiveBar):
            mechanism = self.mechanism.to_dict()
        elif isinstance(self.mechanism, Planar3RRR):
            mechanism = self.mechanism.to_dict()
        else:
            mechanism = self.mechanism.to_dict()

        poses = []
        for poses_item_data in self.poses:
            poses_item = poses_item_data

            poses.append(poses_item)

        known_load: dict[str, Any] | None | Unset
        if isinstance(self.known_load, Unset):
            known_load = UNSET
        elif isinstance(self.known_load, KnownLoad):
            known_load = self.known_load.to_dict()
        else:
            known_load = self.known_load

        load: dict[str, Any] | None | Unset
        if isinstance(self.load, Unset):
            load = UNSET
        elif isinstance(self.load, LoadSize):
            load = self.load.to_dict()
        else:
            load = self.load

        working_mode: list[int] | None | Unset
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
                "mechanism": mechanism,
                "poses": poses,
            }
        )
        if known_load is not UNSET:
            field_dict["known_load"] = known_load
        if load is not UNSET:
            field_dict["load"] = load
        if working_mode is not UNSET:
            field_dict["working_mode"] = working_mode

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.known_load import KnownLoad  # noqa: PLC0415
        from ..models.load_size import LoadSize  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.stored_mechanism import StoredMechanism  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["effort"], d.pop("analysis"))
        if analysis != "effort":
            raise ValueError(f"analysis must match const 'effort', got '{analysis}'")

        def _parse_mechanism(data: object) -> FiveBar | Planar3RRR | StoredMechanism:
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
            if not isinstance(data, dict):
                raise TypeError()
            mechanism_type_2 = StoredMechanism.from_dict(data)

            return mechanism_type_2

        mechanism = _parse_mechanism(d.pop("mechanism"))

        poses = []
        _poses = d.pop("poses")
        for poses_item_data in _poses:
            poses_item = cast(list[float], poses_item_data)

            poses.append(poses_item)

        def _parse_known_load(data: object) -> KnownLoad | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                known_load_type_0 = KnownLoad.from_dict(data)

                return known_load_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(KnownLoad | None | Unset, data)

        known_load = _parse_known_load(d.pop("known_load", UNSET))

        def _parse_load(data: object) -> LoadSize | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                load_type_0 = LoadSize.from_dict(data)

                return load_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(LoadSize | None | Unset, data)

        load = _parse_load(d.pop("load", UNSET))

        def _parse_working_mode(data: object) -> list[EffortRequestWorkingModeType0Item] | None | Unset:
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
                    working_mode_type_0_item = check_effort_request_working_mode_type_0_item(
                        working_mode_type_0_item_data
                    )

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[EffortRequestWorkingModeType0Item] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        effort_request = cls(
            analysis=analysis,
            mechanism=mechanism,
            poses=poses,
            known_load=known_load,
            load=load,
            working_mode=working_mode,
        )

        return effort_request
