from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.inscribed_box_max import InscribedBoxMax
    from ..models.inscribed_box_min import InscribedBoxMin


T = TypeVar("T", bound="InscribedBox")


@_attrs_define
class InscribedBox:
    """The largest box, by measure, all of whose nodes are inside; its corners are nodes.

    Attributes:
        max_ (InscribedBoxMax):
        measure (float):
        min_ (InscribedBoxMin):
        unit (str):
    """

    max_: InscribedBoxMax
    measure: float
    min_: InscribedBoxMin
    unit: str

    def to_dict(self) -> dict[str, Any]:
        max_ = self.max_.to_dict()

        measure = self.measure

        min_ = self.min_.to_dict()

        unit = self.unit

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "max": max_,
                "measure": measure,
                "min": min_,
                "unit": unit,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.inscribed_box_max import InscribedBoxMax  # noqa: PLC0415
        from ..models.inscribed_box_min import InscribedBoxMin  # noqa: PLC0415

        d = dict(src_dict)
        max_ = InscribedBoxMax.from_dict(d.pop("max"))

        measure = d.pop("measure")

        min_ = InscribedBoxMin.from_dict(d.pop("min"))

        unit = d.pop("unit")

        inscribed_box = cls(
            max_=max_,
            measure=measure,
            min_=min_,
            unit=unit,
        )

        return inscribed_box
