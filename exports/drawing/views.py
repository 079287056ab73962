"""Which part of a plane or line is shown."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from analyses.pictures import PictureAxis, WorkspacePicture
from exports.drawing import style
from exports.drawing.skeletons import SYMBOL_ROOM, skeleton_points

Span = tuple[float, float]

# The largest box of a drawing, before its labels are known. [point]
_BOX = np.array([5.6, 5.8]) * style.POINTS_PER_INCH
_GRID_ROOM = 6.0  # [point]
# Height over width; beyond these, white room is added on both sides.
_RATIOS = (0.3, 3.0)
_UNEQUAL_RATIO = 0.75
_ROUNDS = 8


@dataclass(frozen=True)
class View:
    """The window of a drawing and, within it, what was scanned.

    Parameters
    ----------
    x, y : (float, float)
        Ends of the window.
    scanned : ((float, float), (float, float))
        Ends of the grid along both axes, half a step beyond its outer nodes.
    equal : bool
        Whether both axes have the same unit, and hence the same scale.
    """

    x: Span
    y: Span
    scanned: tuple[Span, Span]
    equal: bool

    @property
    def ratio(self) -> float:
        """Height over width of the window on the page."""
        if not self.equal:
            return _UNEQUAL_RATIO
        return (self.y[1] - self.y[0]) / (self.x[1] - self.x[0])


def node_step(axis: PictureAxis, other: PictureAxis | None = None) -> float:
    """Return the distance between the nodes of an axis.

    A single node takes the step of the `other` axis, or 1 where that has none either.
    """
    if len(axis.nodes) > 1:
        return float(axis.nodes[-1] - axis.nodes[0]) / (len(axis.nodes) - 1)
    if other is not None and len(other.nodes) > 1 and other.unit == axis.unit:
        return node_step(other)
    return 1.0


def scanned_span(axis: PictureAxis, step: float) -> Span:
    """Return the ends of the grid, half a step beyond its outer nodes."""
    return float(axis.nodes[0]) - step / 2, float(axis.nodes[-1]) + step / 2


def view_of(picture: WorkspacePicture) -> View:
    """Return the window that shows the whole grid and all of the mechanism with its symbols.

    Parameters
    ----------
    picture : WorkspacePicture
        A picture with two axes.
    """
    first, second = picture.axes
    scanned = (
        scanned_span(first, node_step(first, second)),
        scanned_span(second, node_step(second, first)),
    )
    equal = first.unit == second.unit
    # Boxes with one row an axis: lower end, upper end; and the room around each, in points.
    boxes = [(np.array(scanned), _GRID_ROOM)]
    if equal and picture.skeleton is not None:
        points = skeleton_points(picture.skeleton)
        if len(points):
            boxes.append((np.stack([points.min(axis=0), points.max(axis=0)], axis=1), SYMBOL_ROOM))
    window = _window(boxes, equal)
    return View(tuple(window[0].tolist()), tuple(window[1].tolist()), scanned, equal)


def _window(
    boxes: list[tuple[npt.NDArray[np.float64], float]], equal: bool
) -> npt.NDArray[np.float64]:
    """Return the ends of the window, one row an axis.

    Room in points depends on the scale, and the scale on the room.
    """
    room = np.zeros(2)
    window = np.empty((2, 2))
    for _ in range(_ROUNDS):
        lower = np.min([box[:, 0] - room * points for box, points in boxes], axis=0)
        upper = np.max([box[:, 1] + room * points for box, points in boxes], axis=0)
        window = np.stack([lower, upper], axis=1)
        if equal:
            window = _within_ratios(window)
        room = (window[:, 1] - window[:, 0]) / _BOX
        if equal:
            room[:] = room.max()
    return window


def _within_ratios(window: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    width, height = window[:, 1] - window[:, 0]
    least = np.array([height / _RATIOS[1], width * _RATIOS[0]])
    missing = np.maximum(least - (width, height), 0.0) / 2
    widened: npt.NDArray[np.float64] = window + np.stack([-missing, missing], axis=1)
    return widened
