from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.friction_torque_request_contact import FrictionTorqueRequestContact, check_friction_torque_request_contact
from ..models.friction_torque_request_sense import FrictionTorqueRequestSense, check_friction_torque_request_sense
from ..models.friction_torque_request_working_mode_type_0_item import (
    FrictionTorqueRequestWorkingModeType0Item,
    check_friction_torque_request_working_mode_type_0_item,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.custom import Custom
    from ..models.delta_linear import DeltaLinear
    from ..models.delta_linear_4_dof import DeltaLinear4Dof
    from ..models.delta_rotary import DeltaRotary
    from ..models.design_mesh import DesignMesh
    from ..models.explicit_mesh import ExplicitMesh
    from ..models.five_bar import FiveBar
    from ..models.geared_decoupled import GearedDecoupled
    from ..models.gough_stewart import GoughStewart
    from ..models.hexa_linear import HexaLinear
    from ..models.hexa_rotary import HexaRotary
    from ..models.known_load import KnownLoad
    from ..models.load_size import LoadSize
    from ..models.planar_3rrr import Planar3RRR
    from ..models.spherical_3rrr import Spherical3RRR
    from ..models.stored_mechanism import StoredMechanism
    from ..models.translational_3rrrr import Translational3RRRR


T = TypeVar("T", bound="FrictionTorqueRequest")


@_attrs_define
class FrictionTorqueRequest:
    """Ask for the torques along a train of meshes, or those of a mechanism's geared motors.

    Of a `train` under an `output_torque` torques are sizes: both flanks of a tooth are alike, so
    the direction of turning is free. Of a `mechanism` at `poses`, under a `load` or a `known_load`
    as in `effort`, they have signs unless the load's direction is open.

        Attributes:
            analysis (Literal['friction_torque']):
            contact (FrictionTorqueRequestContact): Where the teeth of every mesh touch: `pitch`, the pitch point, without
                loss; `approach_end` and `recess_end`, where a pair of teeth meets and parts while the motor drives; `worst`,
                the one of both that loses more, one pair carrying all; `explicit`, each mesh's own contact or contact_position;
                `mean` over the cycle, pairs in contact carrying equal normal forces, cycles of different meshes not keeping
                step.
            angular_velocity (list[float] | list[list[float]] | None | Unset): How the platform turns, for all poses or one
                row per pose: each motor then has its own sense, driven back where its torque is against its rate. Not with a
                load of open direction, against which every motor may drive. [rad/s]
            curve_points (int | None | Unset): Answer the cycle of every mesh at about this many phases.
            known_load (KnownLoad | None | Unset):
            load (LoadSize | None | Unset):
            mechanism (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled | GoughStewart |
                HexaLinear | HexaRotary | None | Planar3RRR | Spherical3RRR | StoredMechanism | Translational3RRRR | Unset): In
                place of a train: geared_decoupled, with a train of its own.
            output_speed (float | None | Unset): Of the output, for sliding speeds and powers. [rad/s]
            output_torque (float | None | Unset): Of the load on a train's output. [N m]
            poses (list[list[float]] | None | Unset):
            sense (FrictionTorqueRequestSense | Unset): Whether the motor drives the output against its load, or the load
                drives the motor, which must then hold the input torque. Of all motors of a mechanism, unless angular_velocity
                says more. Default: 'driving'.
            train (list[DesignMesh | ExplicitMesh] | None | Unset):
            working_mode (list[FrictionTorqueRequestWorkingModeType0Item] | None | Unset): Of the mechanism; by default its
                own.
    """

    analysis: Literal["friction_torque"]
    contact: FrictionTorqueRequestContact
    angular_velocity: list[float] | list[list[float]] | None | Unset = UNSET
    curve_points: int | None | Unset = UNSET
    known_load: KnownLoad | None | Unset = UNSET
    load: LoadSize | None | Unset = UNSET
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
        | None
        | Planar3RRR
        | Spherical3RRR
        | StoredMechanism
        | Translational3RRRR
        | Unset
    ) = UNSET
    output_speed: float | None | Unset = UNSET
    output_torque: float | None | Unset = UNSET
    poses: list[list[float]] | None | Unset = UNSET
    sense: FrictionTorqueRequestSense | Unset = "driving"
    train: list[DesignMesh | ExplicitMesh] | None | Unset = UNSET
    working_mode: list[FrictionTorqueRequestWorkingModeType0Item] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.custom import Custom  # noqa: PLC0415
        from ..models.delta_linear import DeltaLinear  # noqa: PLC0415
        from ..models.delta_linear_4_dof import DeltaLinear4Dof  # noqa: PLC0415
        from ..models.delta_rotary import DeltaRotary  # noqa: PLC0415
        from ..models.explicit_mesh import ExplicitMesh  # noqa: PLC0415
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.geared_decoupled import GearedDecoupled  # noqa: PLC0415
        from ..models.gough_stewart import GoughStewart  # noqa: PLC0415
        from ..models.hexa_linear import HexaLinear  # noqa: PLC0415
        from ..models.hexa_rotary import HexaRotary  # noqa: PLC0415
        from ..models.known_load import KnownLoad  # noqa: PLC0415
        from ..models.load_size import LoadSize  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.spherical_3rrr import Spherical3RRR  # noqa: PLC0415
        from ..models.stored_mechanism import StoredMechanism  # noqa: PLC0415
        from ..models.translational_3rrrr import Translational3RRRR  # noqa: PLC0415

        analysis = self.analysis

        contact: str = self.contact

        angular_velocity: list[float] | list[list[float]] | None | Unset
        if isinstance(self.angular_velocity, Unset):
            angular_velocity = UNSET
        elif isinstance(self.angular_velocity, list):
            angular_velocity = self.angular_velocity

        elif isinstance(self.angular_velocity, list):
            angular_velocity = []
            for angular_velocity_type_0_type_1_item_data in self.angular_velocity:
                angular_velocity_type_0_type_1_item = angular_velocity_type_0_type_1_item_data

                angular_velocity.append(angular_velocity_type_0_type_1_item)

        else:
            angular_velocity = self.angular_velocity

        curve_points: int | None | Unset
        if isinstance(self.curve_points, Unset):
            curve_points = UNSET
        else:
            curve_points = self.curve_points

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

        mechanism: dict[str, Any] | None | Unset
        if isinstance(self.mechanism, Unset):
            mechanism = UNSET
        elif isinstance(self.mechanism, FiveBar):
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
        elif isinstance(self.mechanism, StoredMechanism):
            mechanism = self.mechanism.to_dict()
        else:
            mechanism = self.mechanism

        output_speed: float | None | Unset
        if isinstance(self.output_speed, Unset):
            output_speed = UNSET
        else:
            output_speed = self.output_speed

        output_torque: float | None | Unset
        if isinstance(self.output_torque, Unset):
            output_torque = UNSET
        else:
            output_torque = self.output_torque

        poses: list[list[float]] | None | Unset
        if isinstance(self.poses, Unset):
            poses = UNSET
        elif isinstance(self.poses, list):
            poses = []
            for poses_type_0_item_data in self.poses:
                poses_type_0_item = poses_type_0_item_data

                poses.append(poses_type_0_item)

        else:
            poses = self.poses

        sense: str | Unset = UNSET
        if not isinstance(self.sense, Unset):
            sense = self.sense

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
                "analysis": analysis,
                "contact": contact,
            }
        )
        if angular_velocity is not UNSET:
            field_dict["angular_velocity"] = angular_velocity
        if curve_points is not UNSET:
            field_dict["curve_points"] = curve_points
        if known_load is not UNSET:
            field_dict["known_load"] = known_load
        if load is not UNSET:
            field_dict["load"] = load
        if mechanism is not UNSET:
            field_dict["mechanism"] = mechanism
        if output_speed is not UNSET:
            field_dict["output_speed"] = output_speed
        if output_torque is not UNSET:
            field_dict["output_torque"] = output_torque
        if poses is not UNSET:
            field_dict["poses"] = poses
        if sense is not UNSET:
            field_dict["sense"] = sense
        if train is not UNSET:
            field_dict["train"] = train
        if working_mode is not UNSET:
            field_dict["working_mode"] = working_mode

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.custom import Custom  # noqa: PLC0415
        from ..models.delta_linear import DeltaLinear  # noqa: PLC0415
        from ..models.delta_linear_4_dof import DeltaLinear4Dof  # noqa: PLC0415
        from ..models.delta_rotary import DeltaRotary  # noqa: PLC0415
        from ..models.design_mesh import DesignMesh  # noqa: PLC0415
        from ..models.explicit_mesh import ExplicitMesh  # noqa: PLC0415
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.geared_decoupled import GearedDecoupled  # noqa: PLC0415
        from ..models.gough_stewart import GoughStewart  # noqa: PLC0415
        from ..models.hexa_linear import HexaLinear  # noqa: PLC0415
        from ..models.hexa_rotary import HexaRotary  # noqa: PLC0415
        from ..models.known_load import KnownLoad  # noqa: PLC0415
        from ..models.load_size import LoadSize  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.spherical_3rrr import Spherical3RRR  # noqa: PLC0415
        from ..models.stored_mechanism import StoredMechanism  # noqa: PLC0415
        from ..models.translational_3rrrr import Translational3RRRR  # noqa: PLC0415

        d = dict(src_dict)
        analysis = cast(Literal["friction_torque"], d.pop("analysis"))
        if analysis != "friction_torque":
            raise ValueError(f"analysis must match const 'friction_torque', got '{analysis}'")

        contact = check_friction_torque_request_contact(d.pop("contact"))

        def _parse_angular_velocity(data: object) -> list[float] | list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                angular_velocity_type_0_type_0 = cast(list[float], data)

                return angular_velocity_type_0_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, list):
                    raise TypeError()
                angular_velocity_type_0_type_1 = []
                _angular_velocity_type_0_type_1 = data
                for angular_velocity_type_0_type_1_item_data in _angular_velocity_type_0_type_1:
                    angular_velocity_type_0_type_1_item = cast(list[float], angular_velocity_type_0_type_1_item_data)

                    angular_velocity_type_0_type_1.append(angular_velocity_type_0_type_1_item)

                return angular_velocity_type_0_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | list[list[float]] | None | Unset, data)

        angular_velocity = _parse_angular_velocity(d.pop("angular_velocity", UNSET))

        def _parse_curve_points(data: object) -> int | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(int | None | Unset, data)

        curve_points = _parse_curve_points(d.pop("curve_points", UNSET))

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
            | None
            | Planar3RRR
            | Spherical3RRR
            | StoredMechanism
            | Translational3RRRR
            | Unset
        ):
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_0 = FiveBar.from_dict(data)

                return mechanism_type_0_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_1 = Planar3RRR.from_dict(data)

                return mechanism_type_0_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_2 = Translational3RRRR.from_dict(data)

                return mechanism_type_0_type_2
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_3 = DeltaRotary.from_dict(data)

                return mechanism_type_0_type_3
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_4 = DeltaLinear.from_dict(data)

                return mechanism_type_0_type_4
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_5 = DeltaLinear4Dof.from_dict(data)

                return mechanism_type_0_type_5
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_6 = HexaLinear.from_dict(data)

                return mechanism_type_0_type_6
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_7 = GoughStewart.from_dict(data)

                return mechanism_type_0_type_7
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_8 = HexaRotary.from_dict(data)

                return mechanism_type_0_type_8
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_9 = Spherical3RRR.from_dict(data)

                return mechanism_type_0_type_9
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_10 = GearedDecoupled.from_dict(data)

                return mechanism_type_0_type_10
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_11 = Custom.from_dict(data)

                return mechanism_type_0_type_11
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0_type_12 = StoredMechanism.from_dict(data)

                return mechanism_type_0_type_12
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(
                Custom
                | DeltaLinear
                | DeltaLinear4Dof
                | DeltaRotary
                | FiveBar
                | GearedDecoupled
                | GoughStewart
                | HexaLinear
                | HexaRotary
                | None
                | Planar3RRR
                | Spherical3RRR
                | StoredMechanism
                | Translational3RRRR
                | Unset,
                data,
            )

        mechanism = _parse_mechanism(d.pop("mechanism", UNSET))

        def _parse_output_speed(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        output_speed = _parse_output_speed(d.pop("output_speed", UNSET))

        def _parse_output_torque(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        output_torque = _parse_output_torque(d.pop("output_torque", UNSET))

        def _parse_poses(data: object) -> list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                poses_type_0 = []
                _poses_type_0 = data
                for poses_type_0_item_data in _poses_type_0:
                    poses_type_0_item = cast(list[float], poses_type_0_item_data)

                    poses_type_0.append(poses_type_0_item)

                return poses_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[float]] | None | Unset, data)

        poses = _parse_poses(d.pop("poses", UNSET))

        _sense = d.pop("sense", UNSET)
        sense: FrictionTorqueRequestSense | Unset
        if isinstance(_sense, Unset):
            sense = UNSET
        else:
            sense = check_friction_torque_request_sense(_sense)

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

        def _parse_working_mode(data: object) -> list[FrictionTorqueRequestWorkingModeType0Item] | None | Unset:
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
                    working_mode_type_0_item = check_friction_torque_request_working_mode_type_0_item(
                        working_mode_type_0_item_data
                    )

                    working_mode_type_0.append(working_mode_type_0_item)

                return working_mode_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[FrictionTorqueRequestWorkingModeType0Item] | None | Unset, data)

        working_mode = _parse_working_mode(d.pop("working_mode", UNSET))

        friction_torque_request = cls(
            analysis=analysis,
            contact=contact,
            angular_velocity=angular_velocity,
            curve_points=curve_points,
            known_load=known_load,
            load=load,
            mechanism=mechanism,
            output_speed=output_speed,
            output_torque=output_torque,
            poses=poses,
            sense=sense,
            train=train,
            working_mode=working_mode,
        )

        return friction_torque_request
