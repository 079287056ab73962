from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.inverse_kinematics_request_working_mode_type_0_item import (
    InverseKinematicsRequestWorkingModeType0Item,
    check_inverse_kinematics_request_working_mode_type_0_item,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.five_bar import FiveBar
    from ..models.planar_3rrr import Planar3RRR
    from ..models.stored_mechanism import StoredMechanism


T = TypeVar("T", bound="InverseKinematicsRequest")


@_attrs_define
class InverseKinematicsRequest:
    """Ask for the drive coordinates at poses.

    Attributes:
        analysis (Literal['inverse_kinematics']):
        mechanism (FiveBar | Planar3RRR | StoredMechanism):
        poses (list[list[float]]): One row a pose, in the order of the kind's coordinates. [m, rad]
        working_mode (list[InverseKinematicsRequestWorkingModeType0Item] | Literal['all'] | None | Unset): A branch;
            "all" for every one; by default the mechanism's own.
    """

    analysis: Literal["inverse_kinematics"]
    mechanism: FiveBar | Planar3RRR | StoredMechanism
    poses: list[list[float]]
    working_mode: list[InverseKinematicsRequestWorkingModeType0Item] | Literal["all"] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.five_bar import FiveBar  # noqa: PLC0415
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

        working_mode: list[int] | Literal["all"] | None | Unset
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
        if working_mode is not UNSET:
            field_dict["working_mode"] = working_mode

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.stored_mechanism import StoredMechanism  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["inverse_kinematics"], d.pop("analysis"))
        if analysis != "inverse_kinematics":
            raise ValueError(f"analysis must match const 'inverse_kinematics', got '{analysis}'")

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

        def _parse_working_mode(
            data: object,
        ) -> list[InverseKinematicsRequestWorkingModeType0Item] | Literal["all"] | None | Unset:
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
                    working_mode_type_0_item = check_inverse_kinematics_request_working_mode_type_0_item(
                        working_mode_type_0_item_data
                    )

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            working_mode_type_1 = cast(Literal["all"], data)
            if working_mode_type_1 != "all":
                raise ValueError(f"working_mode_type_1 must match const 'all', got '{working_mode_type_1}'")
            return working_mode_type_1
            return cast(list[InverseKinematicsRequestWorkingModeType0Item] | Literal["all"] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        inverse_kinematics_request = cls(
            analysis=analysis,
            mechanism=mechanism,
            poses=poses,
            working_mode=working_mode,
        )

        return inverse_kinematics_request
