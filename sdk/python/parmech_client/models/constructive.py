from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="Constructive")


@_attrs_define
class Constructive:
    """Bounds that the built mechanism sets; what is left out is not asked.

    Attributes:
        base_joint_axes (list[list[float]] | None | Unset): One per leg: the rod's direction, from base to platform,
            with that joint at rest, in the base frame while all drives stand at 0; a crank turns it along. Of any length
            but 0. There is no default: no leg has a direction in which its joint must rest.
        max_base_joint_angle (float | None | Unset): Cone of the joint at each rod's moving end B (a strut's end on the
            base): greatest angle of the rod off base_joint_axes, which it needs. Not for arcs. [rad]
        max_crank_rod_angle (float | None | Unset):
        max_platform_joint_angle (float | None | Unset): Cone of the joint at each rod's end on the platform: greatest
            angle of the rod off platform_joint_axes, which it needs. Not for arcs. [rad]
        max_rod_rod_angle (float | None | Unset):
        min_crank_rod_angle (float | None | Unset): Inside angle at the elbow, 0 folded, pi stretched. [rad]
        min_rod_distance (float | None | Unset): Least distance between the centre lines of two rods, so the sum of
            their radii; for all pairs that share no joint. Of a parallelogram its middle line is meant; not for arcs. [m]
        min_rod_rod_angle (float | None | Unset): Angle between two rods at a shared joint of the platform. [rad]
        platform_joint_axes (list[list[float]] | None | Unset): One per leg: the rod's direction, from base to platform,
            with that joint at rest, in the platform's frame, or under a wrist in that of what the rods carry, which does
            not turn. Of any length but 0; no default.
    """

    base_joint_axes: list[list[float]] | None | Unset = UNSET
    max_base_joint_angle: float | None | Unset = UNSET
    max_crank_rod_angle: float | None | Unset = UNSET
    max_platform_joint_angle: float | None | Unset = UNSET
    max_rod_rod_angle: float | None | Unset = UNSET
    min_crank_rod_angle: float | None | Unset = UNSET
    min_rod_distance: float | None | Unset = UNSET
    min_rod_rod_angle: float | None | Unset = UNSET
    platform_joint_axes: list[list[float]] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        base_joint_axes: list[list[float]] | None | Unset
        if isinstance(self.base_joint_axes, Unset):
            base_joint_axes = UNSET
        elif isinstance(self.base_joint_axes, list):
            base_joint_axes = []
            for base_joint_axes_type_0_item_data in self.base_joint_axes:
                base_joint_axes_type_0_item = base_joint_axes_type_0_item_data

                base_joint_axes.append(base_joint_axes_type_0_item)

        else:
            base_joint_axes = self.base_joint_axes

        max_base_joint_angle: float | None | Unset
        if isinstance(self.max_base_joint_angle, Unset):
            max_base_joint_angle = UNSET
        else:
            max_base_joint_angle = self.max_base_joint_angle

        max_crank_rod_angle: float | None | Unset
        if isinstance(self.max_crank_rod_angle, Unset):
            max_crank_rod_angle = UNSET
        else:
            max_crank_rod_angle = self.max_crank_rod_angle

        max_platform_joint_angle: float | None | Unset
        if isinstance(self.max_platform_joint_angle, Unset):
            max_platform_joint_angle = UNSET
        else:
            max_platform_joint_angle = self.max_platform_joint_angle

        max_rod_rod_angle: float | None | Unset
        if isinstance(self.max_rod_rod_angle, Unset):
            max_rod_rod_angle = UNSET
        else:
            max_rod_rod_angle = self.max_rod_rod_angle

        min_crank_rod_angle: float | None | Unset
        if isinstance(self.min_crank_rod_angle, Unset):
            min_crank_rod_angle = UNSET
        else:
            min_crank_rod_angle = self.min_crank_rod_angle

        min_rod_distance: float | None | Unset
        if isinstance(self.min_rod_distance, Unset):
            min_rod_distance = UNSET
        else:
            min_rod_distance = self.min_rod_distance

        min_rod_rod_angle: float | None | Unset
        if isinstance(self.min_rod_rod_angle, Unset):
            min_rod_rod_angle = UNSET
        else:
            min_rod_rod_angle = self.min_rod_rod_angle

        platform_joint_axes: list[list[float]] | None | Unset
        if isinstance(self.platform_joint_axes, Unset):
            platform_joint_axes = UNSET
        elif isinstance(self.platform_joint_axes, list):
            platform_joint_axes = []
            for platform_joint_axes_type_0_item_data in self.platform_joint_axes:
                platform_joint_axes_type_0_item = platform_joint_axes_type_0_item_data

                platform_joint_axes.append(platform_joint_axes_type_0_item)

        else:
            platform_joint_axes = self.platform_joint_axes

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if base_joint_axes is not UNSET:
            field_dict["base_joint_axes"] = base_joint_axes
        if max_base_joint_angle is not UNSET:
            field_dict["max_base_joint_angle"] = max_base_joint_angle
        if max_crank_rod_angle is not UNSET:
            field_dict["max_crank_rod_angle"] = max_crank_rod_angle
        if max_platform_joint_angle is not UNSET:
            field_dict["max_platform_joint_angle"] = max_platform_joint_angle
        if max_rod_rod_angle is not UNSET:
            field_dict["max_rod_rod_angle"] = max_rod_rod_angle
        if min_crank_rod_angle is not UNSET:
            field_dict["min_crank_rod_angle"] = min_crank_rod_angle
        if min_rod_distance is not UNSET:
            field_dict["min_rod_distance"] = min_rod_distance
        if min_rod_rod_angle is not UNSET:
            field_dict["min_rod_rod_angle"] = min_rod_rod_angle
        if platform_joint_axes is not UNSET:
            field_dict["platform_joint_axes"] = platform_joint_axes

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)

        def _parse_base_joint_axes(data: object) -> list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                base_joint_axes_type_0 = []
                _base_joint_axes_type_0 = data
                for base_joint_axes_type_0_item_data in _base_joint_axes_type_0:
                    base_joint_axes_type_0_item = cast(list[float], base_joint_axes_type_0_item_data)

                    base_joint_axes_type_0.append(base_joint_axes_type_0_item)

                return base_joint_axes_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[float]] | None | Unset, data)

        base_joint_axes = _parse_base_joint_axes(d.pop("base_joint_axes", UNSET))

        def _parse_max_base_joint_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_base_joint_angle = _parse_max_base_joint_angle(d.pop("max_base_joint_angle", UNSET))

        def _parse_max_crank_rod_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_crank_rod_angle = _parse_max_crank_rod_angle(d.pop("max_crank_rod_angle", UNSET))

        def _parse_max_platform_joint_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_platform_joint_angle = _parse_max_platform_joint_angle(d.pop("max_platform_joint_angle", UNSET))

        def _parse_max_rod_rod_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        max_rod_rod_angle = _parse_max_rod_rod_angle(d.pop("max_rod_rod_angle", UNSET))

        def _parse_min_crank_rod_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        min_crank_rod_angle = _parse_min_crank_rod_angle(d.pop("min_crank_rod_angle", UNSET))

        def _parse_min_rod_distance(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        min_rod_distance = _parse_min_rod_distance(d.pop("min_rod_distance", UNSET))

        def _parse_min_rod_rod_angle(data: object) -> float | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | None | Unset, data)

        min_rod_rod_angle = _parse_min_rod_rod_angle(d.pop("min_rod_rod_angle", UNSET))

        def _parse_platform_joint_axes(data: object) -> list[list[float]] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                platform_joint_axes_type_0 = []
                _platform_joint_axes_type_0 = data
                for platform_joint_axes_type_0_item_data in _platform_joint_axes_type_0:
                    platform_joint_axes_type_0_item = cast(list[float], platform_joint_axes_type_0_item_data)

                    platform_joint_axes_type_0.append(platform_joint_axes_type_0_item)

                return platform_joint_axes_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[list[float]] | None | Unset, data)

        platform_joint_axes = _parse_platform_joint_axes(d.pop("platform_joint_axes", UNSET))

        constructive = cls(
            base_joint_axes=base_joint_axes,
            max_base_joint_angle=max_base_joint_angle,
            max_crank_rod_angle=max_crank_rod_angle,
            max_platform_joint_angle=max_platform_joint_angle,
            max_rod_rod_angle=max_rod_rod_angle,
            min_crank_rod_angle=min_crank_rod_angle,
            min_rod_distance=min_rod_distance,
            min_rod_rod_angle=min_rod_rod_angle,
            platform_joint_axes=platform_joint_axes,
        )

        return constructive
