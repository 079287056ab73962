from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="Readiness")


@_attrs_define
class Readiness:
    """Everything that a job needs is there.

    Attributes:
        database (Literal['current']):
        status (Literal['ready']):
        worker_heartbeat_age (float): Since a worker's last sign of life. [s]
    """

    database: Literal["current"]
    status: Literal["ready"]
    worker_heartbeat_age: float

    def to_dict(self) -> dict[str, Any]:
        database = self.database

        status = self.status

        worker_heartbeat_age = self.worker_heartbeat_age

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "database": database,
                "status": status,
                "worker_heartbeat_age": worker_heartbeat_age,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        database = cast(Literal["current"], d.pop("database"))
        if database != "current":
            raise ValueError(f"database must match const 'current', got '{database}'")

        status = cast(Literal["ready"], d.pop("status"))
        if status != "ready":
            raise ValueError(f"status must match const 'ready', got '{status}'")

        worker_heartbeat_age = d.pop("worker_heartbeat_age")

        readiness = cls(
            database=database,
            status=status,
            worker_heartbeat_age=worker_heartbeat_age,
        )

        return readiness
