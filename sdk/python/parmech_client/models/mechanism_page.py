from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.stored_mechanism_document import StoredMechanismDocument


T = TypeVar("T", bound="MechanismPage")


@_attrs_define
class MechanismPage:
    """Stored mechanisms, the newest first.

    Attributes:
        items (list[StoredMechanismDocument]):
        next_page_token (None | str):
    """

    items: list[StoredMechanismDocument]
    next_page_token: None | str

    def to_dict(self) -> dict[str, Any]:
        items = []
        for items_item_data in self.items:
            items_item = items_item_data.to_dict()
            items.append(items_item)

        next_page_token: None | str
        next_page_token = self.next_page_token

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "items": items,
                "next_page_token": next_page_token,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.stored_mechanism_document import StoredMechanismDocument  # noqa: PLC0415

        d = dict(src_dict)
        items = []
        _items = d.pop("items")
        for items_item_data in _items:
            items_item = StoredMechanismDocument.from_dict(items_item_data)

            items.append(items_item)

        def _parse_next_page_token(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        next_page_token = _parse_next_page_token(d.pop("next_page_token"))

        mechanism_page = cls(
            items=items,
            next_page_token=next_page_token,
        )

        return mechanism_page
