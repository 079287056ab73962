from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define

if TYPE_CHECKING:
    from ..models.inscribed_ball import InscribedBall
    from ..models.inscribed_box import InscribedBox


T = TypeVar("T", bound="Inscribed")


@_attrs_define
class Inscribed:
    """What fits into the workspace, between nodes that are inside.

    Attributes:
        ball (InscribedBall | None): Null where none has room, or metres and radians are mixed.
        box (InscribedBox | None): Null where none has room.
    """

    ball: InscribedBall | None
    box: InscribedBox | None

    def to_dict(self) -> dict[str, Any]:
        from ..models.inscribed_ball import InscribedBall  # noqa: PLC0415
        from ..models.inscribed_box import InscribedBox  # noqa: PLC0415

        ball: dict[str, Any] | None
        if isinstance(self.ball, InscribedBall):
            ball = self.ball.to_dict()
        else:
            ball = self.ball

        box: dict[str, Any] | None
        if isinstance(self.box, InscribedBox):
            box = self.box.to_dict()
        else:
            box = self.box

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "ball": ball,
                "box": box,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.inscribed_ball import InscribedBall  # noqa: PLC0415
        from ..models.inscribed_box import InscribedBox  # noqa: PLC0415

        d = dict(src_dict)

        def _parse_ball(data: object) -> InscribedBall | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                ball_type_0 = InscribedBall.from_dict(data)

                return ball_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(InscribedBall | None, data)

        ball = _parse_ball(d.pop("ball"))

        def _parse_box(data: object) -> InscribedBox | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                box_type_0 = InscribedBox.from_dict(data)

                return box_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(InscribedBox | None, data)

        box = _parse_box(d.pop("box"))

        inscribed = cls(
            ball=ball,
            box=box,
        )

        return inscribed
