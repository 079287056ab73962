from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.motor_torque_result_contact import MotorTorqueResultContact, check_motor_torque_result_contact
from ..models.motor_torque_result_sense_item_item_type_0 import (
    MotorTorqueResultSenseItemItemType0,
    check_motor_torque_result_sense_item_item_type_0,
)
from ..models.motor_torque_result_working_mode_item import (
    MotorTorqueResultWorkingModeItem,
    check_motor_torque_result_working_mode_item,
)

if TYPE_CHECKING:
    from ..models.obstacle import Obstacle


T = TypeVar("T", bound="MotorTorqueResult")


@_attrs_define
class MotorTorqueResult:
    """Torques of the motors, columns D1, D2, D3; null where there is none.

    Friction in a train multiplies what passes it, so a motor's torque is its frictionless one
    times the factor of its train in its sense, and a load of open direction is worst in the same
    direction as without friction. D3 turns the wrist itself, and is told without friction.

        Attributes:
            analysis (Literal['friction_torque']):
            back_driving_factor (list[float | None]): The same while the load drives it back.
            contact (MotorTorqueResultContact):
            driving_factor (list[float | None]): Of each motor, torque over that without friction while it drives; null if
                its train locks.
            frictionless_torque (list[list[float | None]]): Without friction, likewise. [N m]
            obstacles (list[Obstacle]):
            self_locking (list[bool]): Of each motor, whether no load on the platform drives it back.
            sense (list[list[MotorTorqueResultSenseItemItemType0 | None]]): Whether each motor drives or is driven back,
                shape (poses, 3); null under angular_velocity where there is no torque, and where the wrist's axes align (ry a
                right angle), so that no rates of the motors make every turn.
            torque (list[list[float | None]]): With friction, shape (poses, 3); null also where the motor's train locks in
                its sense, or the sense is null. Under load the greatest over its directions. [N m]
            working_mode (list[MotorTorqueResultWorkingModeItem]):
            worst_force (list[list[list[float] | None]] | None): Shape (poses, 3, 3): the force that asks most of the motor;
                null without a load. [N]
            worst_moment (list[list[list[float] | None]] | None): Shape (poses, 3, 3): the moment that asks most of the
                motor; null without a load. [N m]
    """

    analysis: Literal["friction_torque"]
    back_driving_factor: list[float | None]
    contact: MotorTorqueResultContact
    driving_factor: list[float | None]
    frictionless_torque: list[list[float | None]]
    obstacles: list[Obstacle]
    self_locking: list[bool]
    sense: list[list[MotorTorqueResultSenseItemItemType0 | None]]
    torque: list[list[float | None]]
    working_mode: list[MotorTorqueResultWorkingModeItem]
    worst_force: list[list[list[float] | None]] | None
    worst_moment: list[list[list[float] | None]] | None

    def to_dict(self) -> dict[str, Any]:
        analysis = self.analysis

        back_driving_factor = []
        for back_driving_factor_item_data in self.back_driving_factor:
            back_driving_factor_item: float | None
            back_driving_factor_item = back_driving_factor_item_data
            back_driving_factor.append(back_driving_factor_item)

        contact: str = self.contact

        driving_factor = []
        for driving_factor_item_data in self.driving_factor:
            driving_factor_item: float | None
            driving_factor_item = driving_factor_item_data
            driving_factor.append(driving_factor_item)

        frictionless_torque = []
        for frictionless_torque_item_data in self.frictionless_torque:
            frictionless_torque_item = []
            for frictionless_torque_item_item_data in frictionless_torque_item_data:
                frictionless_torque_item_item: float | None
                frictionless_torque_item_item = frictionless_torque_item_item_data
                frictionless_torque_item.append(frictionless_torque_item_item)

            frictionless_torque.append(frictionless_torque_item)

        obstacles = []
        for obstacles_item_data in self.obstacles:
            obstacles_item = obstacles_item_data.to_dict()
            obstacles.append(obstacles_item)

        self_locking = self.self_locking

        sense = []
        for sense_item_data in self.sense:
            sense_item = []
            for sense_item_item_data in sense_item_data:
                sense_item_item: None | str
                if isinstance(sense_item_item_data, str):
                    sense_item_item = sense_item_item_data
                else:
                    sense_item_item = sense_item_item_data
                sense_item.append(sense_item_item)

            sense.append(sense_item)

        torque = []
        for torque_item_data in self.torque:
            torque_item = []
            for torque_item_item_data in torque_item_data:
                torque_item_item: float | None
                torque_item_item = torque_item_item_data
                torque_item.append(torque_item_item)

            torque.append(torque_item)

        working_mode = []
        for working_mode_item_data in self.working_mode:
            working_mode_item: int = working_mode_item_data
            working_mode.append(working_mode_item)

        worst_force: list[list[list[float] | None]] | None
        if isinstance(self.worst_force, list):
            worst_force = []
            for worst_force_type_0_item_data in self.worst_force:
                worst_force_type_0_item = []
                for worst_force_type_0_item_item_data in worst_force_type_0_item_data:
                    worst_force_type_0_item_item: list[float] | None
                    if isinstance(worst_force_type_0_item_item_data, list):
                        worst_force_type_0_item_item = worst_force_type_0_item_item_data

                    else:
                        worst_force_type_0_item_item = worst_force_type_0_item_item_data
                    worst_force_type_0_item.append(worst_force_type_0_item_item)

                worst_force.append(worst_force_type_0_item)

        else:
            worst_force = self.worst_force

        worst_moment: list[list[list[float] | None]] | None
        if isinstance(self.worst_moment, list):
            worst_moment = []
            for worst_moment_type_0_item_data in self.worst_moment:
                worst_moment_type_0_item = []
                for worst_moment_type_0_item_item_data in worst_moment_type_0_item_data:
                    worst_moment_type_0_item_item: list[float] | None
                    if isinstance(worst_moment_type_0_item_item_data, list):
                        worst_moment_type_0_item_item = worst_moment_type_0_item_item_data

                    else:
                        worst_moment_type_0_item_item = worst_moment_type_0_item_item_data
                    worst_moment_type_0_item.append(worst_moment_type_0_item_item)

                worst_moment.append(worst_moment_type_0_item)

        else:
            worst_moment = self.worst_moment

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "back_driving_factor": back_driving_factor,
                "contact": contact,
                "driving_factor": driving_factor,
                "frictionless_torque": frictionless_torque,
                "obstacles": obstacles,
                "self_locking": self_locking,
                "sense": sense,
                "torque": torque,
                "working_mode": working_mode,
                "worst_force": worst_force,
                "worst_moment": worst_moment,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.obstacle import Obstacle  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["friction_torque"], d.pop("analysis"))
        if analysis != "friction_torque":
            raise ValueError(f"analysis must match const 'friction_torque', got '{analysis}'")

        back_driving_factor = []
        _back_driving_factor = d.pop("back_driving_factor")
        for back_driving_factor_item_data in _back_driving_factor:

            def _parse_back_driving_factor_item(data: object) -> float | None:
                if data is None:
                    return data
                return cast(float | None, data)

            back_driving_factor_item = _parse_back_driving_factor_item(back_driving_factor_item_data)

            back_driving_factor.append(back_driving_factor_item)

        contact = check_motor_torque_result_contact(d.pop("contact"))

        driving_factor = []
        _driving_factor = d.pop("driving_factor")
        for driving_factor_item_data in _driving_factor:

            def _parse_driving_factor_item(data: object) -> float | None:
                if data is None:
                    return data
                return cast(float | None, data)

            driving_factor_item = _parse_driving_factor_item(driving_factor_item_data)

            driving_factor.append(driving_factor_item)

        frictionless_torque = []
        _frictionless_torque = d.pop("frictionless_torque")
        for frictionless_torque_item_data in _frictionless_torque:
            frictionless_torque_item = []
            _frictionless_torque_item = frictionless_torque_item_data
            for frictionless_torque_item_item_data in _frictionless_torque_item:

                def _parse_frictionless_torque_item_item(data: object) -> float | None:
                    if data is None:
                        return data
                    return cast(float | None, data)

                frictionless_torque_item_item = _parse_frictionless_torque_item_item(frictionless_torque_item_item_data)

                frictionless_torque_item.append(frictionless_torque_item_item)

            frictionless_torque.append(frictionless_torque_item)

        obstacles = []
        _obstacles = d.pop("obstacles")
        for obstacles_item_data in _obstacles:
            obstacles_item = Obstacle.from_dict(obstacles_item_data)

            obstacles.append(obstacles_item)

        self_locking = cast(list[bool], d.pop("self_locking"))

        sense = []
        _sense = d.pop("sense")
        for sense_item_data in _sense:
            sense_item = []
            _sense_item = sense_item_data
            for sense_item_item_data in _sense_item:

                def _parse_sense_item_item(data: object) -> MotorTorqueResultSenseItemItemType0 | None:
                    if data is None:
                        return data
                    try:
                        if not isinstance(data, str):
                            raise TypeError()
                        sense_item_item_type_0 = check_motor_torque_result_sense_item_item_type_0(data)

                        return sense_item_item_type_0
                    except (TypeError, ValueError, AttributeError, KeyError):
                        pass
                    return cast(MotorTorqueResultSenseItemItemType0 | None, data)

                sense_item_item = _parse_sense_item_item(sense_item_item_data)

                sense_item.append(sense_item_item)

            sense.append(sense_item)

        torque = []
        _torque = d.pop("torque")
        for torque_item_data in _torque:
            torque_item = []
            _torque_item = torque_item_data
            for torque_item_item_data in _torque_item:

                def _parse_torque_item_item(data: object) -> float | None:
                    if data is None:
                        return data
                    return cast(float | None, data)

                torque_item_item = _parse_torque_item_item(torque_item_item_data)

                torque_item.append(torque_item_item)

            torque.append(torque_item)

        working_mode = []
        _working_mode = d.pop("working_mode")
        for working_mode_item_data in _working_mode:
            working_mode_item = check_motor_torque_result_working_mode_item(working_mode_item_data)

            working_mode.append(working_mode_item)

        def _parse_worst_force(data: object) -> list[list[list[float] | None]] | None:
            if data is None:
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                worst_force_type_0 = []
                _worst_force_type_0 = data
                for worst_force_type_0_item_data in _worst_force_type_0:
                    worst_force_type_0_item = []
                    _worst_force_type_0_item = worst_force_type_0_item_data
                    for worst_force_type_0_item_item_data in _worst_force_type_0_item:

                        def _parse_worst_force_type_0_item_item(data: object) -> list[float] | None:
                            if data is None:
                                return data
                            try:
                                if not isinstance(data, list):
                                    raise TypeError()
                                worst_force_type_0_item_item_type_0 = cast(list[float], data)

                                return worst_force_type_0_item_item_type_0
                            except (TypeError, ValueError, AttributeError, KeyError):
                                pass
                            return cast(list[float] | None, data)

                        worst_force_type_0_item_item = _parse_worst_force_type_0_item_item(
                            worst_force_type_0_item_item_data
                        )

                        worst_force_type_0_item.append(worst_force_type_0_item_item)

                    worst_force_type_0.append(worst_force_type_0_item)

                return worst_force_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[list[float] | None]] | None, data)

        worst_force = _parse_worst_force(d.pop("worst_force"))

        def _parse_worst_moment(data: object) -> list[list[list[float] | None]] | None:
            if data is None:
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                worst_moment_type_0 = []
                _worst_moment_type_0 = data
                for worst_moment_type_0_item_data in _worst_moment_type_0:
                    worst_moment_type_0_item = []
                    _worst_moment_type_0_item = worst_moment_type_0_item_data
                    for worst_moment_type_0_item_item_data in _worst_moment_type_0_item:

                        def _parse_worst_moment_type_0_item_item(data: object) -> list[float] | None:
                            if data is None:
                                return data
                            try:
                                if not isinstance(data, list):
                                    raise TypeError()
                                worst_moment_type_0_item_item_type_0 = cast(list[float], data)

                                return worst_moment_type_0_item_item_type_0
                            except (TypeError, ValueError, AttributeError, KeyError):
                                pass
                            return cast(list[float] | None, data)

                        worst_moment_type_0_item_item = _parse_worst_moment_type_0_item_item(
                            worst_moment_type_0_item_item_data
                        )

                        worst_moment_type_0_item.append(worst_moment_type_0_item_item)

                    worst_moment_type_0.append(worst_moment_type_0_item)

                return worst_moment_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[list[float] | None]] | None, data)

        worst_moment = _parse_worst_moment(d.pop("worst_moment"))

        motor_torque_result = cls(
            analysis=analysis,
            back_driving_factor=back_driving_factor,
            contact=contact,
            driving_factor=driving_factor,
            frictionless_torque=frictionless_torque,
            obstacles=obstacles,
            self_locking=self_locking,
            sense=sense,
            torque=torque,
            working_mode=working_mode,
            worst_force=worst_force,
            worst_moment=worst_moment,
        )

        return motor_torque_result
