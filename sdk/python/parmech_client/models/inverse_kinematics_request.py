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
    from ..models.custom import Custom
    from ..models.delta_linear import DeltaLinear
    from ..models.delta_linear_4_dof import DeltaLinear4Dof
    from ..models.delta_rotary import DeltaRotary
    from ..models.five_bar import FiveBar
    from ..models.geared_decoupled import GearedDecoupled
    from ..models.gough_stewart import GoughStewart
    from ..models.hexa_linear import HexaLinear
    from ..models.hexa_rotary import HexaRotary
    from ..models.planar_3rrr import Planar3RRR
    from ..models.spherical_3rrr import Spherical3RRR
    from ..models.stored_mechanism import StoredMechanism
    from ..models.translational_3rrrr import Translational3RRRR


T = TypeVar("T", bound="InverseKinematicsRequest")


@_attrs_define
class InverseKinematicsRequest:
    """Ask for the drive coordinates at poses.

    Attributes:
        analysis (Literal['inverse_kinematics']):
        mechanism (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled | GoughStewart |
            HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | StoredMechanism | Translational3RRRR):
        poses (list[list[float]]): One row a pose, in the order of the kind's coordinates. [m, rad]
        directions (list[list[list[float]]] | None | Unset): In place of rx, ry, rz, so that poses are positions only:
            the unit vectors of the platform's x and y axes in the base frame, a pair a pose. Angles are then the usual
            ones, rx and rz in (-pi, pi], ry in [-pi/2, pi/2].
        working_mode (list[InverseKinematicsRequestWorkingModeType0Item] | Literal['all'] | None | Unset): A branch;
            "all" for every one; by default the mechanism's own.
    """

    analysis: Literal["inverse_kinematics"]
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
    poses: list[list[float]]
    directions: list[list[list[float]]] | None | Unset = UNSET
    working_mode: list[InverseKinematicsRequestWorkingModeType0Item] | Literal["all"] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.custom import Custom  # noqa: PLC0415
        from ..models.delta_linear import DeltaLinear  # noqa: PLC0415
        from ..models.delta_linear_4_dof import DeltaLinear4Dof  # noqa: PLC0415
        from ..models.delta_rotary import DeltaRotary  # noqa: PLC0415
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.geared_decoupled import GearedDecoupled  # noqa: PLC0415
        from ..models.gough_stewart import GoughStewart  # noqa: PLC0415
        from ..models.hexa_linear import HexaLinear  # noqa: PLC0415
        from ..models.hexa_rotary import HexaRotary  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.spherical_3rrr import Spherical3RRR  # noqa: PLC0415
        from ..models.translational_3rrrr import Translational3RRRR  # noqa: PLC0415

        analysis = self.analysis

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

        poses = []
        for poses_item_data in self.poses:
            poses_item = poses_item_data

            poses.append(poses_item)

        directions: list[list[list[float]]] | None | Unset
        if isinstance(self.directions, Unset):
            directions = UNSET
        elif isinstance(self.directions, list):
            directions = []
            for directions_type_0_item_data in self.directions:
                directions_type_0_item = []
                for directions_type_0_item_item_data in directions_type_0_item_data:
                    directions_type_0_item_item = directions_type_0_item_item_data

                    directions_type_0_item.append(directions_type_0_item_item)

                directions.append(directions_type_0_item)

        else:
            directions = self.directions

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
        if directions is not UNSET:
            field_dict["directions"] = directions
        if working_mode is not UNSET:
            field_dict["working_mode"] = working_mode

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.custom import Custom  # noqa: PLC0415
        from ..models.delta_linear import DeltaLinear  # noqa: PLC0415
        from ..models.delta_linear_4_dof import DeltaLinear4Dof  # noqa: PLC0415
        from ..models.delta_rotary import DeltaRotary  # noqa: PLC0415
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.geared_decoupled import GearedDecoupled  # noqa: PLC0415
        from ..models.gough_stewart import GoughStewart  # noqa: PLC0415
        from ..models.hexa_linear import HexaLinear  # noqa: PLC0415
        from ..models.hexa_rotary import HexaRotary  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.spherical_3rrr import Spherical3RRR  # noqa: PLC0415
        from ..models.stored_mechanism import StoredMechanism  # noqa: PLC0415
        from ..models.translational_3rrrr import Translational3RRRR  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["inverse_kinematics"], d.pop("analysis"))
        if analysis != "inverse_kinematics":
            raise ValueError(f"analysis must match const 'inverse_kinematics', got '{analysis}'")

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

        poses = []
        _poses = d.pop("poses")
        for poses_item_data in _poses:
            poses_item = cast(list[float], poses_item_data)

            poses.append(poses_item)

        def _parse_directions(data: object) -> list[list[list[float]]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                directions_type_0 = []
                _directions_type_0 = data
                for directions_type_0_item_data in _directions_type_0:
                    directions_type_0_item = []
                    _directions_type_0_item = directions_type_0_item_data
                    for directions_type_0_item_item_data in _directions_type_0_item:
                        directions_type_0_item_item = cast(list[float], directions_type_0_item_item_data)

                        directions_type_0_item.append(directions_type_0_item_item)

                    directions_type_0.append(directions_type_0_item)

                return directions_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[list[float]]] | None | Unset, data)

        directions = _parse_directions(d.pop("directions", UNSET))

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
            directions=directions,
            working_mode=working_mode,
        )

        return inverse_kinematics_request
