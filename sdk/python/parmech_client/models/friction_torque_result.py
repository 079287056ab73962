from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.friction_torque_result_contact import FrictionTorqueResultContact, check_friction_torque_result_contact
from ..models.friction_torque_result_sense import FrictionTorqueResultSense, check_friction_torque_result_sense

if TYPE_CHECKING:
    from ..models.gear_stage import GearStage


T = TypeVar("T", bound="FrictionTorqueResult")


@_attrs_define
class FrictionTorqueResult:
    """Torques along the train; null where it locks.

    Attributes:
        analysis (Literal['friction_torque']):
        contact (FrictionTorqueResultContact):
        efficiency (float): Power out over power in; 0 if the train locks.
        excess (float | None): Of input_torque over frictionless_input_torque, less 1; null if locked.
        frictionless_input_torque (float): At the motor, without friction. [N m]
        input_torque (float | None): At the motor, with friction: needed to drive, or to hold the load that drives back;
            null if the train locks. [N m]
        loss (float): Share of the power in that is lost, 0 to 1.
        power_loss (float | None): Null without output_speed, or if locked. [W]
        ratio (float): Motor torque over output torque without friction.
        self_locking (bool): Whether the train locks in this sense at this contact: one of its meshes does, or all
            together multiply the torque beyond every number.
        sense (FrictionTorqueResultSense):
        stages (list[GearStage]): Mesh by mesh, from the output to the motor.
    """

    analysis: Literal["friction_torque"]
    contact: FrictionTorqueResultContact
    efficiency: float
    excess: float | None
    frictionless_input_torque: float
    input_torque: float | None
    loss: float
    power_loss: float | None
    ratio: float
    self_locking: bool
    sense: FrictionTorqueResultSense
    stages: list[GearStage]

    def to_dict(self) -> dict[str, Any]:
        analysis = self.analysis

        contact: str = self.contact

        efficiency = self.efficiency

        excess: float | None
        excess = self.excess

        frictionless_input_torque = self.frictionless_input_torque

        input_torque: float | None
        input_torque = self.input_torque

        loss = self.loss

        power_loss: float | None
        power_loss = self.power_loss

        ratio = self.ratio

        self_locking = self.self_locking

        sense: str = self.sense

        stages = []
        for stages_item_data in self.stages:
            stages_item = stages_item_data.to_dict()
            stages.append(stages_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "contact": contact,
                "efficiency": efficiency,
                "excess": excess,
                "frictionless_input_torque": frictionless_input_torque,
                "input_torque": input_torque,
                "loss": loss,
                "power_loss": power_loss,
                "ratio": ratio,
                "self_locking": self_locking,
                "sense": sense,
                "stages": stages,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.gear_stage import GearStage  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["friction_torque"], d.pop("analysis"))
        if analysis != "friction_torque":
            raise ValueError(f"analysis must match const 'friction_torque', got '{analysis}'")

        contact = check_friction_torque_result_contact(d.pop("contact"))

        efficiency = d.pop("efficiency")

        def _parse_excess(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        excess = _parse_excess(d.pop("excess"))

        frictionless_input_torque = d.pop("frictionless_input_torque")

        def _parse_input_torque(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        input_torque = _parse_input_torque(d.pop("input_torque"))

        loss = d.pop("loss")

        def _parse_power_loss(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        power_loss = _parse_power_loss(d.pop("power_loss"))

        ratio = d.pop("ratio")

        self_locking = d.pop("self_locking")

        sense = check_friction_torque_result_sense(d.pop("sense"))

        stages = []
        _stages = d.pop("stages")
        for stages_item_data in _stages:
            stages_item = GearStage.from_dict(stages_item_data)

            stages.append(stages_item)

        friction_torque_result = cls(
            analysis=analysis,
            contact=contact,
            efficiency=efficiency,
            excess=excess,
            frictionless_input_torque=frictionless_input_torque,
            input_torque=input_torque,
            loss=loss,
            power_loss=power_loss,
            ratio=ratio,
            self_locking=self_locking,
            sense=sense,
            stages=stages,
        )

        return friction_torque_result
