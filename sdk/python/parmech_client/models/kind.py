from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

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
    from ..models.kind_json_schema import KindJsonSchema
    from ..models.planar_3rrr import Planar3RRR
    from ..models.preset import Preset
    from ..models.spherical_3rrr import Spherical3RRR
    from ..models.translational_3rrrr import Translational3RRRR


T = TypeVar("T", bound="Kind")


@_attrs_define
class Kind:
    """A mechanism family.

    Attributes:
        analyses (list[str]):
        coordinate_units (list[str]):
        coordinates (list[str]): In the order of a pose's numbers.
        drives (list[str]): Those of the legs, then a wrist's motors.
        example (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled | GoughStewart |
            HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | Translational3RRRR):
        json_schema (KindJsonSchema): JSON Schema of the inline mechanism.
        kind (str):
        motion (str):
        presets (list[Preset]):
        title (str):
    """

    analyses: list[str]
    coordinate_units: list[str]
    coordinates: list[str]
    drives: list[str]
    example: (
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
    json_schema: KindJsonSchema
    kind: str
    motion: str
    presets: list[Preset]
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

        analyses = self.analyses

        coordinate_units = self.coordinate_units

        coordinates = self.coordinates

        drives = self.drives

        example: dict[str, Any]
        if isinstance(self.example, FiveBar):
            example = self.example.to_dict()
        elif isinstance(self.example, Planar3RRR):
            example = self.example.to_dict()
        elif isinstance(self.example, Translational3RRRR):
            example = self.example.to_dict()
        elif isinstance(self.example, DeltaRotary):
            example = self.example.to_dict()
        elif isinstance(self.example, DeltaLinear):
            example = self.example.to_dict()
        elif isinstance(self.example, DeltaLinear4Dof):
            example = self.example.to_dict()
        elif isinstance(self.example, HexaLinear):
            example = self.example.to_dict()
        elif isinstance(self.example, GoughStewart):
            example = self.example.to_dict()
        elif isinstance(self.example, HexaRotary):
            example = self.example.to_dict()
        elif isinstance(self.example, Spherical3RRR):
            example = self.example.to_dict()
        elif isinstance(self.example, GearedDecoupled):
            example = self.example.to_dict()
        else:
            example = self.example.to_dict()

        json_schema = self.json_schema.to_dict()

        kind = self.kind

        motion = self.motion

        presets = []
        for presets_item_data in self.presets:
            presets_item = presets_item_data.to_dict()
            presets.append(presets_item)

        title = self.title

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analyses": analyses,
                "coordinate_units": coordinate_units,
                "coordinates": coordinates,
                "drives": drives,
                "example": example,
                "json_schema": json_schema,
                "kind": kind,
                "motion": motion,
                "presets": presets,
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
        from ..models.kind_json_schema import KindJsonSchema  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415
        from ..models.preset import Preset  # noqa: PLC0415
        from ..models.spherical_3rrr import Spherical3RRR  # noqa: PLC0415
        from ..models.translational_3rrrr import Translational3RRRR  # noqa: PLC0415

        d = dict(src_dict)
        analyses = cast(list[str], d.pop("analyses"))

        coordinate_units = cast(list[str], d.pop("coordinate_units"))

        coordinates = cast(list[str], d.pop("coordinates"))

        drives = cast(list[str], d.pop("drives"))

        def _parse_example(
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
                example_type_0 = FiveBar.from_dict(data)

                return example_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_1 = Planar3RRR.from_dict(data)

                return example_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_2 = Translational3RRRR.from_dict(data)

                return example_type_2
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_3 = DeltaRotary.from_dict(data)

                return example_type_3
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_4 = DeltaLinear.from_dict(data)

                return example_type_4
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_5 = DeltaLinear4Dof.from_dict(data)

                return example_type_5
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_6 = HexaLinear.from_dict(data)

                return example_type_6
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_7 = GoughStewart.from_dict(data)

                return example_type_7
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_8 = HexaRotary.from_dict(data)

                return example_type_8
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_9 = Spherical3RRR.from_dict(data)

                return example_type_9
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                example_type_10 = GearedDecoupled.from_dict(data)

                return example_type_10
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            if not isinstance(data, dict):
                raise TypeError()
            example_type_11 = Custom.from_dict(data)

            return example_type_11

        example = _parse_example(d.pop("example"))

        json_schema = KindJsonSchema.from_dict(d.pop("json_schema"))

        kind = d.pop("kind")

        motion = d.pop("motion")

        presets = []
        _presets = d.pop("presets")
        for presets_item_data in _presets:
            presets_item = Preset.from_dict(presets_item_data)

            presets.append(presets_item)

        title = d.pop("title")

        kind = cls(
            analyses=analyses,
            coordinate_units=coordinate_units,
            coordinates=coordinates,
            drives=drives,
            example=example,
            json_schema=json_schema,
            kind=kind,
            motion=motion,
            presets=presets,
            title=title,
        )

        return kind
