from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

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


T = TypeVar("T", bound="ForwardKinematicsRequest")


@_attrs_define
class ForwardKinematicsRequest:
    """Ask for the poses at drive positions: all of them, or the one reached from a guess.

    Attributes:
        actuators (list[list[float]]): One row a question, one drive coordinate per drive. A row beyond actuator limits
            is answered all the same, and stands among the obstacles. [rad, m]
        analysis (Literal['forward_kinematics']):
        mechanism (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled | GoughStewart |
            HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | StoredMechanism | Translational3RRRR):
        guess (list[float] | list[list[float]] | None | Unset): A pose, or one per row, from which Newton's iteration
            starts; the answer is then where it led, and no other mode. Of the turns that a wrist makes no notice is taken:
            the motors tell them.
    """

    actuators: list[list[float]]
    analysis: Literal["forward_kinematics"]
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
    guess: list[float] | list[list[float]] | None | Unset = UNSET

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

        actuators = []
        for actuators_item_data in self.actuators:
            actuators_item = actuators_item_data

            actuators.append(actuators_item)

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

        guess: list[float] | list[list[float]] | None | Unset
        if isinstance(self.guess, Unset):
            guess = UNSET
        elif isinstance(self.guess, list):
            guess = self.guess

        elif isinstance(self.guess, list):
            guess = []
            for guess_type_0_type_1_item_data in self.guess:
                guess_type_0_type_1_item = guess_type_0_type_1_item_data

                guess.append(guess_type_0_type_1_item)

        else:
            guess = self.guess

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "actuators": actuators,
                "analysis": analysis,
                "mechanism": mechanism,
            }
        )
        if guess is not UNSET:
            field_dict["guess"] = guess

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
        actuators = []
        _actuators = d.pop("actuators")
        for actuators_item_data in _actuators:
            actuators_item = cast(list[float], actuators_item_data)

            actuators.append(actuators_item)

        analysis = cast(Literal["forward_kinematics"], d.pop("analysis"))
        if analysis != "forward_kinematics":
            raise ValueError(f"analysis must match const 'forward_kinematics', got '{analysis}'")

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

        def _parse_guess(data: object) -> list[float] | list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                guess_type_0_type_0 = cast(list[float], data)

                return guess_type_0_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, list):
                    raise TypeError()
                guess_type_0_type_1 = []
                _guess_type_0_type_1 = data
                for guess_type_0_type_1_item_data in _guess_type_0_type_1:
                    guess_type_0_type_1_item = cast(list[float], guess_type_0_type_1_item_data)

                    guess_type_0_type_1.append(guess_type_0_type_1_item)

                return guess_type_0_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | list[list[float]] | None | Unset, data)

        guess = _parse_guess(d.pop("guess", UNSET))

        forward_kinematics_request = cls(
            actuators=actuators,
            analysis=analysis,
            mechanism=mechanism,
            guess=guess,
        )

        return forward_kinematics_request
