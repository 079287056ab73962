from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

from ..models.job_error_kind import JobErrorKind, check_job_error_kind

if TYPE_CHECKING:
    from ..models.field_fault import FieldFault


T = TypeVar("T", bound="JobError")


@_attrs_define
class JobError:
    """Why a job failed.

    Attributes:
        detail (str):
        errors (list[FieldFault]):
        kind (JobErrorKind):
    """

    detail: str
    errors: list[FieldFault]
    kind: JobErrorKind

    def to_dict(self) -> dict[str, Any]:
        detail = self.detail

        errors = []
        for errors_item_data in self.errors:
            errors_item = errors_item_data.to_dict()
            errors.append(errors_item)

        kind: str = self.kind

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "detail": detail,
                "errors": errors,
                "kind": kind,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.field_fault import FieldFault  # noqa: PLC0415

        d = dict(src_dict)
        detail = d.pop("detail")

        errors = []
        _errors = d.pop("errors")
        for errors_item_data in _errors:
            errors_item = FieldFault.from_dict(errors_item_data)

            errors.append(errors_item)

        kind = check_job_error_kind(d.pop("kind"))

        job_error = cls(
            detail=detail,
            errors=errors,
            kind=kind,
        )

        return job_error
