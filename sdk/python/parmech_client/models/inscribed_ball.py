from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.inscribed_ball_centre import InscribedBallCentre


T = TypeVar("T", bound="InscribedBall")


@_attrs_define
class InscribedBall:
    """The largest interval, disc or ball about a node, all of whose neighbours are inside too.

    Attributes:
        centre (InscribedBallCentre):
        radius (float):
        unit (str):
    """

    centre: InscribedBallCentre
    radius: float
    unit: str

    def to_dict(self) -> dict[str, Any]:
        centre = self.centre.to_dict()

        radius = self.radius

        unit = self.unit

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "centre": centre,
                "radius": radius,
                "unit": unit,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.inscribed_ball_centre import InscribedBallCentre  # noqa: PLC0415

        d = dict(src_dict)
        centre = InscribedBallCentre.from_dict(d.pop("centre"))

        radius = d.pop("radius")

        unit = d.pop("unit")

        inscribed_ball = cls(
            centre=centre,
            radius=radius,
            unit=unit,
        )

        return inscribed_ball
