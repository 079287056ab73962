from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

T = TypeVar("T", bound="Links")


@_attrs_define
class Links:
    """Where to go on from a job.

    Attributes:
        cancel (str):
        events (str):
        figure (None | str):
        grid (None | str): Null for analyses without a grid.
        result (str):
        self_ (str):
    """

    cancel: str
    events: str
    figure: None | str
    grid: None | str
    result: str
    self_: str

    def to_dict(self) -> dict[str, Any]:
        cancel = self.cancel

        events = self.events

        figure: None | str
        figure = self.figure

        grid: None | str
        grid = self.grid

        result = self.result

        self_ = self.self_

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "cancel": cancel,
                "events": events,
                "figure": figure,
                "grid": grid,
                "result": result,
                "self": self_,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        cancel = d.pop("cancel")

        events = d.pop("events")

        def _parse_figure(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        figure = _parse_figure(d.pop("figure"))

        def _parse_grid(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        grid = _parse_grid(d.pop("grid"))

        result = d.pop("result")

        self_ = d.pop("self")

        links = cls(
            cancel=cancel,
            events=events,
            figure=figure,
            grid=grid,
            result=result,
            self_=self_,
        )

        return links
