from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

T = TypeVar("T", bound="WristGears")


@_attrs_define
class WristGears:
    """How far the motors turn for the platform, with k = k1 k2 kp.

    D1 = k (rx - ry) + k_gamma rz, D2 = k (rx + ry) + k_gamma rz, D3 = rz.

        Attributes:
            k1 (float): From the platform's bevel wheel to the intermediate ones.
            k2 (float): From the intermediate to the first bevel wheels.
            k_gamma (float): With which D1 and D2 follow a turn about z.
            kp (float): Of the gears between the wrist and the rods.
    """

    k1: float
    k2: float
    k_gamma: float
    kp: float

    def to_dict(self) -> dict[str, Any]:
        k1 = self.k1

        k2 = self.k2

        k_gamma = self.k_gamma

        kp = self.kp

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "k1": k1,
                "k2": k2,
                "k_gamma": k_gamma,
                "kp": kp,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        k1 = d.pop("k1")

        k2 = d.pop("k2")

        k_gamma = d.pop("k_gamma")

        kp = d.pop("kp")

        wrist_gears = cls(
            k1=k1,
            k2=k2,
            k_gamma=k_gamma,
            kp=kp,
        )

        return wrist_gears
