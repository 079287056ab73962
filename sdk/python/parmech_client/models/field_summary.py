from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.field_summary_at_max_type_0 import FieldSummaryAtMaxType0
    from ..models.histogram import Histogram


T = TypeVar("T", bound="FieldSummary")


@_attrs_define
class FieldSummary:
    """A field over the nodes inside.

    Attributes:
        at_max (FieldSummaryAtMaxType0 | None): The pose at which it is greatest.
        histogram (Histogram | None): Over the nodes inside, and the legs; null unless asked for.
        max_ (float | None):
        min_ (float | None):
        unit (str):
    """

    at_max: FieldSummaryAtMaxType0 | None
    histogram: Histogram | None
    max_: float | None
    min_: float | None
    unit: str

    def to_dict(self) -> dict[str, Any]:
        from ..models.field_summary_at_max_type_0 import FieldSummaryAtMaxType0  # noqa: PLC0415
        from ..models.histogram import Histogram  # noqa: PLC0415

        at_max: dict[str, Any] | None
        if isinstance(self.at_max, FieldSummaryAtMaxType0):
            at_max = self.at_max.to_dict()
        else:
            at_max = self.at_max

        histogram: dict[str, Any] | None
        if isinstance(self.histogram, Histogram):
            histogram = self.histogram.to_dict()
        else:
            histogram = self.histogram

        max_: float | None
        max_ = self.max_

        min_: float | None
        min_ = self.min_

        unit = self.unit

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "at_max": at_max,
                "histogram": histogram,
                "max": max_,
                "min": min_,
                "unit": unit,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.field_summary_at_max_type_0 import FieldSummaryAtMaxType0  # noqa: PLC0415
        from ..models.histogram import Histogram  # noqa: PLC0415

        d = dict(src_dict)

        def _parse_at_max(data: object) -> FieldSummaryAtMaxType0 | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                at_max_type_0 = FieldSummaryAtMaxType0.from_dict(data)

                return at_max_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(FieldSummaryAtMaxType0 | None, data)

        at_max = _parse_at_max(d.pop("at_max"))

        def _parse_histogram(data: object) -> Histogram | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                histogram_type_0 = Histogram.from_dict(data)

                return histogram_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(Histogram | None, data)

        histogram = _parse_histogram(d.pop("histogram"))

        def _parse_max_(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        max_ = _parse_max_(d.pop("max"))

        def _parse_min_(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        min_ = _parse_min_(d.pop("min"))

        unit = d.pop("unit")

        field_summary = cls(
            at_max=at_max,
            histogram=histogram,
            max_=max_,
            min_=min_,
            unit=unit,
        )

        return field_summary
