from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="StoredMechanism")


@_attrs_define
class StoredMechanism:
    """A mechanism that was stored before.

    Attributes:
        id (str): The id that storing it answered.
        kind (Literal['stored']):
    """

    id: str
    kind: Literal["stored"]

    def to_dict(self) -> dict[str, Any]:
        id = self.id

        kind = self.kind

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "id": id,
                "kind": kind,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        id = d.pop("id")

        kind = cast(Literal["stored"], d.pop("kind"))
        if kind != "stored":
            raise ValueError(f"kind must match const 'stored', got '{kind}'")

        stored_mechanism = cls(
            id=id,
            kind=kind,
        )

        return stored_mechanism
