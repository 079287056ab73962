from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="PlatformBody")


@_attrs_define
class PlatformBody:
    """A rigid body on the platform, whose weight and inertia the drives must bear.

    Attributes:
        mass (float): [kg]
        centre_of_mass (list[float] | None | Unset): In the platform's frame; its reference point by default. [m]
        gravity (list[float] | None | Unset): In the base frame; [0, 0, -9.80665] by default. [m/s^2]
        inertia (list[list[float]] | None | Unset): About the centre of mass, in the platform's frame; none by default.
            [kg m^2]
    """

    mass: float
    centre_of_mass: list[float] | None | Unset = UNSET
    gravity: list[float] | None | Unset = UNSET
    inertia: list[list[float]] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        mass = self.mass

        centre_of_mass: list[float] | None | Unset
        if isinstance(self.centre_of_mass, Unset):
            centre_of_mass = UNSET
        elif isinstance(self.centre_of_mass, list):
            centre_of_mass = self.centre_of_mass

        else:
            centre_of_mass = self.centre_of_mass

        gravity: list[float] | None | Unset
        if isinstance(self.gravity, Unset):
            gravity = UNSET
        elif isinstance(self.gravity, list):
            gravity = self.gravity

        else:
            gravity = self.gravity

        inertia: list[list[float]] | None | Unset
        if isinstance(self.inertia, Unset):
            inertia = UNSET
        elif isinstance(self.inertia, list):
            inertia = []
            for inertia_type_0_item_data in self.inertia:
                inertia_type_0_item = inertia_type_0_item_data

                inertia.append(inertia_type_0_item)

        else:
            inertia = self.inertia

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "mass": mass,
            }
        )
        if centre_of_mass is not UNSET:
            field_dict["centre_of_mass"] = centre_of_mass
        if gravity is not UNSET:
            field_dict["gravity"] = gravity
        if inertia is not UNSET:
            field_dict["inertia"] = inertia

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        mass = d.pop("mass")

        def _parse_centre_of_mass(data: object) -> list[float] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                centre_of_mass_type_0 = cast(list[float], data)

                return centre_of_mass_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | None | Unset, data)

        centre_of_mass = _parse_centre_of_mass(d.pop("centre_of_mass", UNSET))

        def _parse_gravity(data: object) -> list[float] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                gravity_type_0 = cast(list[float], data)

                return gravity_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[float] | None | Unset, data)

        gravity = _parse_gravity(d.pop("gravity", UNSET))

        def _parse_inertia(data: object) -> list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                inertia_type_0 = []
                _inertia_type_0 = data
                for inertia_type_0_item_data in _inertia_type_0:
                    inertia_type_0_item = cast(list[float], inertia_type_0_item_data)

                    inertia_type_0.append(inertia_type_0_item)

                return inertia_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[float]] | None | Unset, data)

        inertia = _parse_inertia(d.pop("inertia", UNSET))

        platform_body = cls(
            mass=mass,
            centre_of_mass=centre_of_mass,
            gravity=gravity,
            inertia=inertia,
        )

        return platform_body
