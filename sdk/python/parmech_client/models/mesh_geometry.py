from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="MeshGeometry")


@_attrs_define
class MeshGeometry:
    """The line of action of a mesh; of bevel wheels, that of their equivalent spur pair.

    Radii are of input and output wheel, below 0 for a ring with teeth inside.

        Attributes:
            approach (float): Used length of the line of action before the pitch point. [m]
            base_radii (list[float]): [m]
            contact_ratio (float | None): Mean number of pairs in contact; null without a base pitch.
            pitch_radii (list[float]): At work. [m]
            pressure_angle (float): At work. [rad]
            recess (float): Used length of the line of action after the pitch point. [m]
            tip_radii (list[float] | None): Null for an explicit mesh. [m]
            tip_thickness (list[float] | None): Of the teeth, along their tip circles; null for an explicit mesh. [m]
    """

    approach: float
    base_radii: list[float]
    contact_ratio: float | None
    pitch_radii: list[float]
    pressure_angle: float
    recess: float
    tip_radii: list[float] | None
    tip_thickness: list[float] | None

    def to_dict(self) -> dict[str, Any]:
        approach = self.approach

        base_radii = self.base_radii

        contact_ratio: float | None
        contact_ratio = self.contact_ratio

        pitch_radii = self.pitch_radii

        pressure_angle = self.pressure_angle

        recess = self.recess

        tip_radii: list[float] | None
        if isinstance(self.tip_radii, list):
            tip_radii = self.tip_radii

        else:
            tip_radii = self.tip_radii

        tip_thickness: list[float] | None
        if isinstance(self.tip_thickness, list):
            tip_thickness = self.tip_thickness

        else:
            tip_thickness = self.tip_thickness

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "approach": approach,
                "base_radii": base_radii,
                "contact_ratio": contact_ratio,
                "pitch_radii": pitch_radii,
                "pressure_angle": pressure_angle,
                "recess": recess,
                "tip_radii": tip_radii,
                "tip_thickness": tip_thickness,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        approach = d.pop("approach")

        base_radii = cast(list[float], d.pop("base_radii"))

        def _parse_contact_ratio(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        contact_ratio = _parse_contact_ratio(d.pop("contact_ratio"))

        pitch_radii = cast(list[float], d.pop("pitch_radii"))

        pressure_angle = d.pop("pressure_angle")

        recess = d.pop("recess")

        def _parse_tip_radii(data: object) -> list[float] | None:
            if data is None:
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                tip_radii_type_0 = cast(list[float], data)

                return tip_radii_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | None, data)

        tip_radii = _parse_tip_radii(d.pop("tip_radii"))

        def _parse_tip_thickness(data: object) -> list[float] | None:
            if data is None:
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                tip_thickness_type_0 = cast(list[float], data)

                return tip_thickness_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | None, data)

        tip_thickness = _parse_tip_thickness(d.pop("tip_thickness"))

        mesh_geometry = cls(
            approach=approach,
            base_radii=base_radii,
            contact_ratio=contact_ratio,
            pitch_radii=pitch_radii,
            pressure_angle=pressure_angle,
            recess=recess,
            tip_radii=tip_radii,
            tip_thickness=tip_thickness,
        )

        return mesh_geometry
