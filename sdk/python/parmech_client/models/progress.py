from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

T = TypeVar("T", bound="Progress")


@_attrs_define
class Progress:
    """How far a job has come, in poses, grid nodes or meshes.

    Attributes:
        done (int):
        fraction (float):
        total (int):
    """

    done: int
    fraction: float
    total: int

    def to_dict(self) -> dict[str, Any]:
        done = self.done

        fraction = self.fraction

        total = self.total

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "done": done,
                "fraction": fraction,
                "total": total,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        done = d.pop("done")

        fraction = d.pop("fraction")

        total = d.pop("total")

        progress = cls(
            done=done,
            fraction=fraction,
            total=total,
        )

        return progress
