from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.velocity_request_working_mode_type_0_item import (
    VelocityRequestWorkingModeType0Item,
    check_velocity_request_working_mode_type_0_item,
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


T = TypeVar("T", bound="VelocityRequest")


@_attrs_define
class VelocityRequest:
    """Ask for drive rates under a platform's rates, or the other way round; give one of the two.

    Attributes:
        analysis (Literal['velocity']):
        mechanism (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled | GoughStewart |
            HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | StoredMechanism | Translational3RRRR):
        poses (list[list[float]]): One row a pose, in the order of the kind's coordinates. [m, rad]
        actuator_rates (list[list[float]] | None | Unset): One row per pose, one number per drive. [rad/s or m/s]
        platform_rates (list[list[float]] | None | Unset): [vx, vy, vz, wx, wy, wz] per pose: linear velocity of the
            reference point, angular velocity, in the base frame; 0 where the motion has none. [m/s, rad/s]
        working_mode (list[VelocityRequestWorkingModeType0Item] | None | Unset):
    """

    analysis: Literal["velocity"]
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
    actuator_rates: list[list[float]] | None | Unset = UNSET
    platform_rates: list[list[float]] | None | Unset = UNSET
    working_mode: list[VelocityRequestWorkingModeType0Item] | None | Unset = UNSET

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

        actuator_rates: list[list[float]] | None | Unset
        if isinstance(self.actuator_rates, Unset):
            actuator_rates = UNSET
        elif isinstance(self.actuator_rates, list):
            actuator_rates = []
            for actuator_rates_type_0_item_data in self.actuator_rates:
                actuator_rates_type_0_item = actuator_rates_type_0_item_data

                actuator_rates.append(actuator_rates_type_0_item)

        else:
            actuator_rates = self.actuator_rates

        platform_rates: list[list[float]] | None | Unset
        if isinstance(self.platform_rates, Unset):
            platform_rates = UNSET
        elif isinstance(self.platform_rates, list):
            platform_rates = []
            for platform_rates_type_0_item_data in self.platform_rates:
                platform_rates_type_0_item = platform_rates_type_0_item_data

                platform_rates.append(platform_rates_type_0_item)

        else:
            platform_rates = self.platform_rates

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
        if actuator_rates is not UNSET:
            field_dict["actuator_rates"] = actuator_rates
        if platform_rates is not UNSET:
            field_dict["platform_rates"] = platform_rates
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
        analysis = cast(Literal["velocity"], d.pop("analysis"))
        if analysis != "velocity":
            raise ValueError(f"analysis must match const 'velocity', got '{analysis}'")

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

        def _parse_actuator_rates(data: object) -> list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                actuator_rates_type_0 = []
                _actuator_rates_type_0 = data
                for actuator_rates_type_0_item_data in _actuator_rates_type_0:
                    actuator_rates_type_0_item = cast(list[float], actuator_rates_type_0_item_data)

                    actuator_rates_type_0.append(actuator_rates_type_0_item)

                return actuator_rates_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[float]] | None | Unset, data)

        actuator_rates = _parse_actuator_rates(d.pop("actuator_rates", UNSET))

        def _parse_platform_rates(data: object) -> list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                platform_rates_type_0 = []
                _platform_rates_type_0 = data
                for platform_rates_type_0_item_data in _platform_rates_type_0:
                    platform_rates_type_0_item = cast(list[float], platform_rates_type_0_item_data)

                    platform_rates_type_0.append(platform_rates_type_0_item)

                return platform_rates_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[float]] | None | Unset, data)

        platform_rates = _parse_platform_rates(d.pop("platform_rates", UNSET))

        def _parse_working_mode(data: object) -> list[VelocityRequestWorkingModeType0Item] | None | Unset:
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
                    working_mode_type_0_item = check_velocity_request_working_mode_type_0_item(
                        working_mode_type_0_item_data
                    )

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[VelocityRequestWorkingModeType0Item] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        velocity_request = cls(
            analysis=analysis,
            mechanism=mechanism,
            poses=poses,
            actuator_rates=actuator_rates,
            platform_rates=platform_rates,
            working_mode=working_mode,
        )

        return velocity_request
