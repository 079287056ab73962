from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.geared_decoupled_working_mode_type_0_item import (
    GearedDecoupledWorkingModeType0Item,
    check_geared_decoupled_working_mode_type_0_item,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.actuator_limit import ActuatorLimit
    from ..models.design_mesh import DesignMesh
    from ..models.explicit_mesh import ExplicitMesh
    from ..models.wrist_gears import WristGears


T = TypeVar("T", bound="GearedDecoupled")


@_attrs_define
class GearedDecoupled:
    """The geared decoupled mechanism: three rails move a wrist, three motors turn the platform.

    Upright rails at 90, 210 and 330 degrees; drives are the carriages' heights, then the motors
    D1, D2, D3. The pose is that of the tool's point, which is tool_offset along the platform's x
    from the wrist's centre. Working mode 1 takes the upper of a rail's two roots; a motor has 1.

        Attributes:
            carriage_arm (float): From a rail inward to the carriage's joint. [m]
            kind (Literal['geared_decoupled']):
            platform_radius (float): Circle of the platform's joints. [m]
            rail_radius (float): Circle of the rails. [m]
            rod_length (float): [m]
            tool_offset (float): Of the tool's point from the wrist's centre, along the platform's x. [m]
            wrist (WristGears): How far the motors turn for the platform, with k = k1 k2 kp.

                D1 = k (rx - ry) + k_gamma rz, D2 = k (rx + ry) + k_gamma rz, D3 = rz.
            actuator_limits (ActuatorLimit | list[ActuatorLimit | None] | None | Unset): One for all drives, or a list with
                one (or null) per drive.
            name (None | str | Unset): A name for people.
            train (list[DesignMesh | ExplicitMesh] | None | Unset): Meshes between the platform and D1, and likewise D2,
                from the platform to the motor, for friction_torque: they give what friction adds, and wrist the ratio.
            working_mode (list[GearedDecoupledWorkingModeType0Item] | None | Unset): The default branch of the inverse
                solution: 1 or -1 per drive.
    """

    carriage_arm: float
    kind: Literal["geared_decoupled"]
    platform_radius: float
    rail_radius: float
    rod_length: float
    tool_offset: float
    wrist: WristGears
    actuator_limits: ActuatorLimit | list[ActuatorLimit | None] | None | Unset = UNSET
    name: None | str | Unset = UNSET
    train: list[DesignMesh | ExplicitMesh] | None | Unset = UNSET
    working_mode: list[GearedDecoupledWorkingModeType0Item] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.actuator_limit import ActuatorLimit  # noqa: PLC0415
        from ..models.explicit_mesh import ExplicitMesh  # noqa: PLC0415

        carriage_arm = self.carriage_arm

        kind = self.kind

        platform_radius = self.platform_radius

        rail_radius = self.rail_radius

        rod_length = self.rod_length

        tool_offset = self.tool_offset

        wrist = self.wrist.to_dict()

        actuator_limits: dict[str, Any] | list[dict[str, Any] | None] | None | Unset
        if isinstance(self.actuator_limits, Unset):
            actuator_limits = UNSET
        elif isinstance(self.actuator_limits, list):
            actuator_limits = []
            for actuator_limits_type_0_item_data in self.actuator_limits:
                actuator_limits_type_0_item: dict[str, Any] | None
                if isinstance(actuator_limits_type_0_item_data, ActuatorLimit):
                    actuator_limits_type_0_item = actuator_limits_type_0_item_data.to_dict()
                else:
                    actuator_limits_type_0_item = actuator_limits_type_0_item_data
                actuator_limits.append(actuator_limits_type_0_item)

        elif isinstance(self.actuator_limits, ActuatorLimit):
            actuator_limits = self.actuator_limits.to_dict()
        else:
            actuator_limits = self.actuator_limits

        name: None | str | Unset
        if isinstance(self.name, Unset):
            name = UNSET
        else:
            name = self.name

        train: list[dict[str, Any]] | None | Unset
        if isinstance(self.train, Unset):
            train = UNSET
        elif isinstance(self.train, list):
            train = []
            for train_type_0_item_data in self.train:
                train_type_0_item: dict[str, Any]
                if isinstance(train_type_0_item_data, ExplicitMesh):
                    train_type_0_item = train_type_0_item_data.to_dict()
                else:
                    train_type_0_item = train_type_0_item_data.to_dict()

                train.append(train_type_0_item)

        else:
            train = self.train

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
                "carriage_arm": carriage_arm,
                "kind": kind,
                "platform_radius": platform_radius,
                "rail_radius": rail_radius,
                "rod_length": rod_length,
                "tool_offset": tool_offset,
                "wrist": wrist,
            }
        )
        if actuator_limits is not UNSET:
            field_dict["actuator_limits"] = actuator_limits
        if name is not UNSET:
            field_dict["name"] = name
        if train is not UNSET:
            field_dict["train"] = train
        if working_mode is not UNSET:
            field_dict["working_mode"] = working_mode

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.actuator_limit import ActuatorLimit  # noqa: PLC0415
        from ..models.design_mesh import DesignMesh  # noqa: PLC0415
        from ..models.explicit_mesh import ExplicitMesh  # noqa: PLC0415
        from ..models.wrist_gears import WristGears  # noqa: PLC0415

        d = dict(src_dict)
        carriage_arm = d.pop("carriage_arm")

        kind = cast(Literal["geared_decoupled"], d.pop("kind"))
        if kind != "geared_decoupled":
            raise ValueError(f"kind must match const 'geared_decoupled', got '{kind}'")

        platform_radius = d.pop("platform_radius")

        rail_radius = d.pop("rail_radius")

        rod_length = d.pop("rod_length")

        tool_offset = d.pop("tool_offset")

        wrist = WristGears.from_dict(d.pop("wrist"))

        def _parse_actuator_limits(data: object) -> ActuatorLimit | list[ActuatorLimit | None] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                actuator_limits_type_0 = []
                _actuator_limits_type_0 = data
                for actuator_limits_type_0_item_data in _actuator_limits_type_0:

                    def _parse_actuator_limits_type_0_item(data: object) -> ActuatorLimit | None:
                        if data is None:
                            return data
                        try:
                            if not isinstance(data, dict):
                                raise TypeError()
                            actuator_limits_type_0_item_type_0 = ActuatorLimit.from_dict(data)

                            return actuator_limits_type_0_item_type_0
                        except (TypeError, ValueError, AttributeError, KeyError):
                            pass
                        return cast(ActuatorLimit | None, data)

                    actuator_limits_type_0_item = _parse_actuator_limits_type_0_item(actuator_limits_type_0_item_data)

                    actuator_limits_type_0.append(actuator_limits_type_0_item)

                return actuator_limits_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                actuator_limits_type_1 = ActuatorLimit.from_dict(data)

                return actuator_limits_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(ActuatorLimit | list[ActuatorLimit | None] | None | Unset, data)

        actuator_limits = _parse_actuator_limits(d.pop("actuator_limits", UNSET))

        def _parse_name(data: object) -> None | str | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(None | str | Unset, data)

        name = _parse_name(d.pop("name", UNSET))

        def _parse_train(data: object) -> list[DesignMesh | ExplicitMesh] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                train_type_0 = []
                _train_type_0 = data
                for train_type_0_item_data in _train_type_0:

                    def _parse_train_type_0_item(data: object) -> DesignMesh | ExplicitMesh:
                        try:
                            if not isinstance(data, dict):
                                raise TypeError()
                            train_type_0_item_type_0 = ExplicitMesh.from_dict(data)

                            return train_type_0_item_type_0
                        except (TypeError, ValueError, AttributeError, KeyError):
                            pass
                        if not isinstance(data, dict):
                            raise TypeError()
                        train_type_0_item_type_1 = DesignMesh.from_dict(data)

                        return train_type_0_item_type_1

                    train_type_0_item = _parse_train_type_0_item(train_type_0_item_data)

                    train_type_0.append(train_type_0_item)

                return train_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[DesignMesh | ExplicitMesh] | None | Unset, data)

        train = _parse_train(d.pop("train", UNSET))

        def _parse_working_mode(data: object) -> list[GearedDecoupledWorkingModeType0Item] | None | Unset:
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
                    working_mode_type_0_item = check_geared_decoupled_working_mode_type_0_item(
                        working_mode_type_0_item_data
                    )

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[GearedDecoupledWorkingModeType0Item] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        geared_decoupled = cls(
            carriage_arm=carriage_arm,
            kind=kind,
            platform_radius=platform_radius,
            rail_radius=rail_radius,
            rod_length=rod_length,
            tool_offset=tool_offset,
            wrist=wrist,
            actuator_limits=actuator_limits,
            name=name,
            train=train,
            working_mode=working_mode,
        )

        return geared_decoupled
