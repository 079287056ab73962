from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.mesh_curve import MeshCurve
    from ..models.mesh_geometry import MeshGeometry


T = TypeVar("T", bound="GearStage")


@_attrs_define
class GearStage:
    """One mesh of the train, from the output on.

    Torques with friction are null from the first mesh on that locks.

        Attributes:
            contact_position (float | None): From the pitch point, above 0 in recess while the motor drives; null for means.
                [m]
            curve (MeshCurve | None): Null unless curve_points was given.
            efficiency (float): Power out over power in of this mesh; 0 if it locks.
            excess (float | None): Of input_torque over frictionless_input_torque, less 1: what friction in this mesh and
                those before it has made; below 0 when the load drives back.
            frictionless_input_torque (float): [N m]
            frictionless_output_torque (float): [N m]
            geometry (MeshGeometry): The line of action of a mesh; of bevel wheels, that of their equivalent spur pair.

                Radii are of input and output wheel, below 0 for a ring with teeth inside.
            input_arm (float | None): Of the tooth force about the input wheel's centre, below 0 past it; null for means.
                [m]
            input_torque (float | None): At the input wheel, with friction. [N m]
            loss (float): Share of the power into this mesh that is lost, 0 to 1.
            output_arm (float | None): Of the tooth force about the output wheel's centre, below 0 past it; null for means.
                [m]
            output_torque (float | None): On the output wheel, with friction. [N m]
            power_loss (float | None): Null without output_speed, or if locked. [W]
            ratio (float): Input torque over output torque without friction.
            self_locking (bool): Whether this mesh locks: driving, no finite input torque moves it; back-driving, the load
                alone cannot, and an input torque of the other sign would have to help.
            sliding_speed (float | None): Between the teeth at the contact; null for means or without output_speed. [m/s]
    """

    contact_position: float | None
    curve: MeshCurve | None
    efficiency: float
    excess: float | None
    frictionless_input_torque: float
    frictionless_output_torque: float
    geometry: MeshGeometry
    input_arm: float | None
    input_torque: float | None
    loss: float
    output_arm: float | None
    output_torque: float | None
    power_loss: float | None
    ratio: float
    self_locking: bool
    sliding_speed: float | None

    def to_dict(self) -> dict[str, Any]:
        from ..models.mesh_curve import MeshCurve  # noqa: PLC0415

        contact_position: float | None
        contact_position = self.contact_position

        curve: dict[str, Any] | None
        if isinstance(self.curve, MeshCurve):
            curve = self.curve.to_dict()
        else:
            curve = self.curve

        efficiency = self.efficiency

        excess: float | None
        excess = self.excess

        frictionless_input_torque = self.frictionless_input_torque

        frictionless_output_torque = self.frictionless_output_torque

        geometry = self.geometry.to_dict()

        input_arm: float | None
        input_arm = self.input_arm

        input_torque: float | None
        input_torque = self.input_torque

        loss = self.loss

        output_arm: float | None
        output_arm = self.output_arm

        output_torque: float | None
        output_torque = self.output_torque

        power_loss: float | None
        power_loss = self.power_loss

        ratio = self.ratio

        self_locking = self.self_locking

        sliding_speed: float | None
        sliding_speed = self.sliding_speed

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "contact_position": contact_position,
                "curve": curve,
                "efficiency": efficiency,
                "excess": excess,
                "frictionless_input_torque": frictionless_input_torque,
                "frictionless_output_torque": frictionless_output_torque,
                "geometry": geometry,
                "input_arm": input_arm,
                "input_torque": input_torque,
                "loss": loss,
                "output_arm": output_arm,
                "output_torque": output_torque,
                "power_loss": power_loss,
                "ratio": ratio,
                "self_locking": self_locking,
                "sliding_speed": sliding_speed,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.mesh_curve import MeshCurve  # noqa: PLC0415
        from ..models.mesh_geometry import MeshGeometry  # noqa: PLC0415

        d = dict(src_dict)

        def _parse_contact_position(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        contact_position = _parse_contact_position(d.pop("contact_position"))

        def _parse_curve(data: object) -> MeshCurve | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                curve_type_0 = MeshCurve.from_dict(data)

                return curve_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(MeshCurve | None, data)

        curve = _parse_curve(d.pop("curve"))

        efficiency = d.pop("efficiency")

        def _parse_excess(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        excess = _parse_excess(d.pop("excess"))

        frictionless_input_torque = d.pop("frictionless_input_torque")

        frictionless_output_torque = d.pop("frictionless_output_torque")

        geometry = MeshGeometry.from_dict(d.pop("geometry"))

        def _parse_input_arm(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        input_arm = _parse_input_arm(d.pop("input_arm"))

        def _parse_input_torque(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        input_torque = _parse_input_torque(d.pop("input_torque"))

        loss = d.pop("loss")

        def _parse_output_arm(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        output_arm = _parse_output_arm(d.pop("output_arm"))

        def _parse_output_torque(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        output_torque = _parse_output_torque(d.pop("output_torque"))

        def _parse_power_loss(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        power_loss = _parse_power_loss(d.pop("power_loss"))

        ratio = d.pop("ratio")

        self_locking = d.pop("self_locking")

        def _parse_sliding_speed(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        sliding_speed = _parse_sliding_speed(d.pop("sliding_speed"))

        gear_stage = cls(
            contact_position=contact_position,
            curve=curve,
            efficiency=efficiency,
            excess=excess,
            frictionless_input_torque=frictionless_input_torque,
            frictionless_output_torque=frictionless_output_torque,
            geometry=geometry,
            input_arm=input_arm,
            input_torque=input_torque,
            loss=loss,
            output_arm=output_arm,
            output_torque=output_torque,
            power_loss=power_loss,
            ratio=ratio,
            self_locking=self_locking,
            sliding_speed=sliding_speed,
        )

        return gear_stage
