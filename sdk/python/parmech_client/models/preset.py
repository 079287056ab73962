from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

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
    from ..models.translational_3rrrr import Translational3RRRR


T = TypeVar("T", bound="Preset")


@_attrs_define
class Preset:
    """A machine that exists or was published, ready to be asked about.

    Attributes:
        mechanism (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled | GoughStewart |
            HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | Translational3RRRR):
        name (str):
        source (str): Where its dimensions are published.
        title (str):
    """

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
        | Translational3RRRR
    )
    name: str
    source: str
    title: str

    def to_dict(self) -> dict[str, Any]:
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
        else:
            mechanism = self.mechanism.to_dict()

        name = self.name

        source = self.source

        title = self.title

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "mechanism": mechanism,
                "name": name,
                "source": source,
                "title": title,
            }
        )

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
        from ..models.translational_3rrrr import Translational3RRRR  # noqa: PLC0415

        d = dict(src_dict)

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
            if not isinstance(data, dict):
                raise TypeError()
            mechanism_type_11 = Custom.from_dict(data)

            return mechanism_type_11

        mechanism = _parse_mechanism(d.pop("mechanism"))

        name = d.pop("name")

        source = d.pop("source")

        title = d.pop("title")

        preset = cls(
            mechanism=mechanism,
            name=name,
            source=source,
            title=title,
        )

        return preset
