from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

from ..models.design_mesh_face import DesignMeshFace, check_design_mesh_face
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.wheel import Wheel


T = TypeVar("T", bound="DesignMesh")


@_attrs_define
class DesignMesh:
    """Two wheels with external involute teeth by their design data, as one rack cuts them.

    Bevel wheels are taken by the equivalent spur pair at the mean diameter.

        Attributes:
            friction_coefficient (float): Coefficient of friction between the teeth, the same at every sliding speed
                (Coulomb).
            input_ (Wheel): One wheel by its design data.
            kind (Literal['design']):
            module (float): Of bevel wheels, the one at the mean diameter. [m]
            output (Wheel): One wheel by its design data.
            addendum_coefficient (float | Unset): Height of the rack's teeth over the module. Default: 1.0.
            centre_distance (float | None | Unset): Of spur wheels; by default the one without backlash. [m]
            contact_position (float | None | Unset): A place on the line of action for explicit contact: from the pitch
                point, above 0 where the contact goes while the motor drives. [m]
            face (DesignMeshFace | Unset):  Default: 'spur'.
            pressure_angle (float | Unset): Of the rack; 20 degrees by default. [rad] Default: 0.3490658503988659.
            shaft_angle (float | None | Unset): Between the axes of bevel wheels; by default a right angle. [rad]
    """

    friction_coefficient: float
    input_: Wheel
    kind: Literal["design"]
    module: float
    output: Wheel
    addendum_coefficient: float | Unset = 1.0
    centre_distance: float | None | Unset = UNSET
    contact_position: float | None | Unset = UNSET
    face: DesignMeshFace | Unset = "spur"
    pressure_angle: float | Unset = 0.3490658503988659
    shaft_angle: float | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        friction_coefficient = self.friction_coefficient

        input_ = self.input_.to_dict()

        kind = self.kind

        module = self.module

        output = self.output.to_dict()

        addendum_coefficient = self.addendum_coefficient

        centre_distance: float | None | Unset
        if isinstance(self.centre_distance, Unset):
            centre_distance = UNSET
        else:
            centre_distance = self.centre_distance

        contact_position: float | None | Unset
        if isinstance(self.contact_position, Unset):
            contact_position = UNSET
        else:
            contact_position = self.contact_position

        face: str | Unset = UNSET
        if not isinstance(self.face, Unset):
            face = self.face

        pressure_angle = self.pressure_angle

        shaft_angle: float | None | Unset
        if isinstance(self.shaft_angle, Unset):
            shaft_angle = UNSET
        else:
            shaft_angle = self.shaft_angle

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "friction_coefficient": friction_coefficient,
                "input": input_,
                "kind": kind,
                "module": module,
                "output": output,
            }
        )
        if addendum_coefficient is not UNSET:
            field_dict["addendum_coefficient"] = addendum_coefficient
        if centre_distance is not UNSET:
            field_dict["centre_distance"] = centre_distance
        if contact_position is not UNSET:
            field_dict["contact_position"] = contact_position
        if face is not UNSET:
            field_dict["face"] = face
        if pressure_angle is not UNSET:
            field_dict["pressure_angle"] = pressure_angle
        if shaft_angle is not UNSET:
            field_dict["shaft_angle"] = shaft_angle

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.wheel import Wheel  # noqa: PLC0415

        d = dict(src_dict)
        friction_coefficient = d.pop("friction_coefficient")

        input_ = Wheel.from_dict(d.pop("input"))

        kind = cast(Literal["design"], d.pop("kind"))
        if kind != "design":
            raise ValueError(f"kind must match const 'design', got '{kind}'")

        module = d.pop("module")

        output = Wheel.from_dict(d.pop("output"))

        addendum_coefficient = d.pop("addendum_coefficient", UNSET)

        def _parse_centre_distance(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        centre_distance = _parse_centre_distance(d.pop("centre_distance", UNSET))

        def _parse_contact_position(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        contact_position = _parse_contact_position(d.pop("contact_position", UNSET))

        _face = d.pop("face", UNSET)
        face: DesignMeshFace | Unset
        if isinstance(_face, Unset):
            face = UNSET
        else:
            face = check_design_mesh_face(_face)

        pressure_angle = d.pop("pressure_angle", UNSET)

        def _parse_shaft_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        shaft_angle = _parse_shaft_angle(d.pop("shaft_angle", UNSET))

        design_mesh = cls(
            friction_coefficient=friction_coefficient,
            input_=input_,
            kind=kind,
            module=module,
            output=output,
            addendum_coefficient=addendum_coefficient,
            centre_distance=centre_distance,
            contact_position=contact_position,
            face=face,
            pressure_angle=pressure_angle,
            shaft_angle=shaft_angle,
        )

        return design_mesh
