from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="ExplicitMesh")


@_attrs_define
class ExplicitMesh:
    """Two wheels by points in their plane: centres, pitch point and contact.

    The line of action passes through pitch point and contact. A pitch point that is not between
    the centres makes the wheel whose centre is farther from it a ring with teeth inside.

        Attributes:
            contact (list[float]): Where a pair of teeth touches, one end of the line of action. [m]
            friction_coefficient (float): Coefficient of friction between the teeth, the same at every sliding speed
                (Coulomb).
            input_centre (list[float]): Of the wheel nearer to the motor. [m]
            kind (Literal['explicit']):
            output_centre (list[float]): Of the wheel nearer to the output. [m]
            pitch_point (list[float]): On the line of centres. [m]
            base_pitch (float | None | Unset): From one pair of teeth to the next along the line of action; needed for means
                and curves. [m]
            opposite_contact (list[float] | None | Unset): The other end of the line of action, beyond the pitch point; by
                default the mirror image of contact, or where the involute ends if that is nearer. [m]
    """

    contact: list[float]
    friction_coefficient: float
    input_centre: list[float]
    kind: Literal["explicit"]
    output_centre: list[float]
    pitch_point: list[float]
    base_pitch: float | None | Unset = UNSET
    opposite_contact: list[float] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        contact = self.contact

        friction_coefficient = self.friction_coefficient

        input_centre = self.input_centre

        kind = self.kind

        output_centre = self.output_centre

        pitch_point = self.pitch_point

        base_pitch: float | None | Unset
        if isinstance(self.base_pitch, Unset):
            base_pitch = UNSET
        else:
            base_pitch = self.base_pitch

        opposite_contact: list[float] | None | Unset
        if isinstance(self.opposite_contact, Unset):
            opposite_contact = UNSET
        elif isinstance(self.opposite_contact, list):
            opposite_contact = self.opposite_contact

        else:
            opposite_contact = self.opposite_contact

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "contact": contact,
                "friction_coefficient": friction_coefficient,
                "input_centre": input_centre,
                "kind": kind,
                "output_centre": output_centre,
                "pitch_point": pitch_point,
            }
        )
        if base_pitch is not UNSET:
            field_dict["base_pitch"] = base_pitch
        if opposite_contact is not UNSET:
            field_dict["opposite_contact"] = opposite_contact

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        contact = cast(list[float], d.pop("contact"))

        friction_coefficient = d.pop("friction_coefficient")

        input_centre = cast(list[float], d.pop("input_centre"))

        kind = cast(Literal["explicit"], d.pop("kind"))
        if kind != "explicit":
            raise ValueError(f"kind must match const 'explicit', got '{kind}'")

        output_centre = cast(list[float], d.pop("output_centre"))

        pitch_point = cast(list[float], d.pop("pitch_point"))

        def _parse_base_pitch(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        base_pitch = _parse_base_pitch(d.pop("base_pitch", UNSET))

        def _parse_opposite_contact(data: object) -> list[float] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                opposite_contact_type_0 = cast(list[float], data)

                return opposite_contact_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | None | Unset, data)

        opposite_contact = _parse_opposite_contact(d.pop("opposite_contact", UNSET))

        explicit_mesh = cls(
            contact=contact,
            friction_coefficient=friction_coefficient,
            input_centre=input_centre,
            kind=kind,
            output_centre=output_centre,
            pitch_point=pitch_point,
            base_pitch=base_pitch,
            opposite_contact=opposite_contact,
        )

        return explicit_mesh
