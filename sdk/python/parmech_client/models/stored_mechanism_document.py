from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.five_bar import FiveBar
    from ..models.planar_3rrr import Planar3RRR


T = TypeVar("T", bound="StoredMechanismDocument")


@_attrs_define
class StoredMechanismDocument:
    """A mechanism that is kept under its id.

    Attributes:
        created (datetime.datetime):
        id (str):
        mechanism (FiveBar | Planar3RRR):
    """

    created: datetime.datetime
    id: str
    mechanism: FiveBar | Planar3RRR

    def to_dict(self) -> dict[str, Any]:
        from ..models.five_bar import FiveBar  # noqa: PLC0415

        created = self.created.isoformat()

        id = self.id

        mechanism: dict[str, Any]
        if isinstance(self.mechanism, FiveBar):
            mechanism = self.mechanism.to_dict()
        else:
            mechanism = self.mechanism.to_dict()

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "created": created,
                "id": id,
                "mechanism": mechanism,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415

        d = dict(src_dict)
        created = datetime.datetime.fromisoformat(d.pop("created"))

        id = d.pop("id")

        def _parse_mechanism(data: object) -> FiveBar | Planar3RRR:
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mechanism_type_0 = FiveBar.from_dict(data)

                return mechanism_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            if not isinstance(data, dict):
                raise TypeError()
            mechanism_type_1 = Planar3RRR.from_dict(data)

            return mechanism_type_1

        mechanism = _parse_mechanism(d.pop("mechanism"))

        stored_mechanism_document = cls(
            created=created,
            id=id,
            mechanism=mechanism,
        )

        return stored_mechanism_document
