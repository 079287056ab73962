from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.five_bar import FiveBar
    from ..models.planar_3rrr import Planar3RRR


T = TypeVar("T", bound="Preset")


@_attrs_define
class Preset:
    """A machine that exists or was published, ready to be asked about.

    Attributes:
        mechanism (FiveBar | Planar3RRR):
        name (str):
        source (str): Where its dimensions are published.
        title (str):
    """

    mechanism: FiveBar | Planar3RRR
    name: str
    source: str
    title: str

    def to_dict(self) -> dict[str, Any]:
        from ..models.five_bar import FiveBar  # noqa: PLC0415

        mechanism: dict[str, Any]
        if isinstance(self.mechanism, FiveBar):
            mechanism = self.mechanism.to_dict()
        else:
            mechanism = self.mechanism.to_dict()

        name = self.name

        source = self.source

        title = self.title

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "mechanism": mechanism,
                "name": name,
                "source": source,
                "title": title,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.five_bar import FiveBar  # noqa: PLC0415
        from ..models.planar_3rrr import Planar3RRR  # noqa: PLC0415

        d = dict(src_dict)

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

        name = d.pop("name")

        source = d.pop("source")

        title = d.pop("title")

        preset = cls(
            mechanism=mechanism,
            name=name,
            source=source,
            title=title,
        )

        return preset
