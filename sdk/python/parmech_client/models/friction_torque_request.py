from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.friction_torque_request_contact import FrictionTorqueRequestContact, check_friction_torque_request_contact
from ..models.friction_torque_request_sense import FrictionTorqueRequestSense, check_friction_torque_request_sense
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.design_mesh import DesignMesh
    from ..models.explicit_mesh import ExplicitMesh


T = TypeVar("T", bound="FrictionTorqueRequest")


@_attrs_define
class FrictionTorqueRequest:
    """Ask for the torques along a train of meshes under a torque on its output.

    Torques are sizes: both flanks of a tooth are alike, so the direction of turning is free.

        Attributes:
            analysis (Literal['friction_torque']):
            contact (FrictionTorqueRequestContact): Where the teeth of every mesh touch: `pitch`, the pitch point, without
                loss; `approach_end` and `recess_end`, where a pair of teeth meets and parts while the motor drives; `worst`,
                the one of both that loses more, one pair carrying all; `explicit`, each mesh's own contact or contact_position;
                `mean` over the cycle, pairs in contact carrying equal normal forces, cycles of different meshes not keeping
                step.
            output_torque (float): Of the load on the output. [N m]
            train (list[DesignMesh | ExplicitMesh]): Meshes from the output to the motor.
            curve_points (int | None | Unset): Answer the cycle of every mesh at about this many phases.
            output_speed (float | None | Unset): Of the output, for sliding speeds and powers. [rad/s]
            sense (FrictionTorqueRequestSense | Unset): Whether the motor drives the output against its load, or the load
                drives the motor, which must then hold the input torque. Default: 'driving'.
    """

    analysis: Literal["friction_torque"]
    contact: FrictionTorqueRequestContact
    output_torque: float
    train: list[DesignMesh | ExplicitMesh]
    curve_points: int | None | Unset = UNSET
    output_speed: float | None | Unset = UNSET
    sense: FrictionTorqueRequestSense | Unset = "driving"

    def to_dict(self) -> dict[str, Any]:
        from ..models.explicit_mesh import ExplicitMesh  # noqa: PLC0415

        analysis = self.analysis

        contact: str = self.contact

        output_torque = self.output_torque

        train = []
        for train_item_data in self.train:
            train_item: dict[str, Any]
            if isinstance(train_item_data, ExplicitMesh):
                train_item = train_item_data.to_dict()
            else:
                train_item = train_item_data.to_dict()

            train.append(train_item)

        curve_points: int | None | Unset
        if isinstance(self.curve_points, Unset):
            curve_points = UNSET
        else:
            curve_points = self.curve_points

        output_speed: float | None | Unset
        if isinstance(self.output_speed, Unset):
            output_speed = UNSET
        else:
            output_speed = self.output_speed

        sense: str | Unset = UNSET
        if not isinstance(self.sense, Unset):
            sense = self.sense

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "contact": contact,
                "output_torque": output_torque,
                "train": train,
            }
        )
        if curve_points is not UNSET:
            field_dict["curve_points"] = curve_points
        if output_speed is not UNSET:
            field_dict["output_speed"] = output_speed
        if sense is not UNSET:
            field_dict["sense"] = sense

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.design_mesh import DesignMesh  # noqa: PLC0415
        from ..models.explicit_mesh import ExplicitMesh  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["friction_torque"], d.pop("analysis"))
        if analysis != "friction_torque":
            raise ValueError(f"analysis must match const 'friction_torque', got '{analysis}'")

        contact = check_friction_torque_request_contact(d.pop("contact"))

        output_torque = d.pop("output_torque")

        train = []
        _train = d.pop("train")
        for train_item_data in _train:

            def _parse_train_item(data: object) -> DesignMesh | ExplicitMesh:
                try:
                    if not isinstance(data, dict):
                        raise TypeError()
                    train_item_type_0 = ExplicitMesh.from_dict(data)

                    return train_item_type_0
                except (TypeError, ValueError, AttributeError, KeyError):
                    pass
                if not isinstance(data, dict):
                    raise TypeError()
                train_item_type_1 = DesignMesh.from_dict(data)

                return train_item_type_1

            train_item = _parse_train_item(train_item_data)

            train.append(train_item)

        def _parse_curve_points(data: object) -> int | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(int | None | Unset, data)

        curve_points = _parse_curve_points(d.pop("curve_points", UNSET))

        def _parse_output_speed(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        output_speed = _parse_output_speed(d.pop("output_speed", UNSET))

        _sense = d.pop("sense", UNSET)
        sense: FrictionTorqueRequestSense | Unset
        if isinstance(_sense, Unset):
            sense = UNSET
        else:
            sense = check_friction_torque_request_sense(_sense)

        friction_torque_request = cls(
            analysis=analysis,
            contact=contact,
            output_torque=output_torque,
            train=train,
            curve_points=curve_points,
            output_speed=output_speed,
            sense=sense,
        )

        return friction_torque_request
