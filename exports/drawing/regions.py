"""Regions and fields on the nodes of a plane grid."""

from typing import Any

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, LogNorm, Normalize
from matplotlib.image import AxesImage
from matplotlib.patches import PathPatch
from scipy.ndimage import distance_transform_edt

from analyses.pictures import PictureAxis
from exports.drawing import style
from exports.drawing.outlines import boundary_length, outline_of
from exports.drawing.scales import Scale
from exports.drawing.views import node_step

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]

# A longer boundary is finer than the page and is drawn node by node, without a line.
_LONGEST_OUTLINE = 60_000


class NodeGrid:
    """The nodes of a plane grid, and one more around it, so that regions close at its edge.

    Parameters
    ----------
    first, second : PictureAxis
        The horizontal and the upright axis.
    """

    def __init__(self, first: PictureAxis, second: PictureAxis) -> None:
        self._steps = node_step(first, second), node_step(second, first)
        self._x = _one_more_around(first.nodes, self._steps[0])
        self._y = _one_more_around(second.nodes, self._steps[1])

    def fill(self, axes: Axes, inside: Bools, colour: str) -> None:
        """Fill a region of one node at least, and draw its boundary."""
        known = np.pad(inside, 1)
        if boundary_length(known) > _LONGEST_OUTLINE:
            shown = np.ma.masked_equal(known.T.astype(np.uint8), 0)
            self._image(axes, shown, ListedColormap([colour])).set_zorder(1.0)
            return
        outline = outline_of(self._x, self._y, known)
        axes.add_patch(PathPatch(outline, facecolor=colour, edgecolor="none", zorder=1.0))
        axes.add_patch(
            PathPatch(outline, fill=False, edgecolor=style.REGION_EDGE, linewidth=1.2, zorder=4.0)
        )

    def colour(
        self, axes: Axes, valued: Bools, values: Floats, scale: Scale, level: float | None
    ) -> ScalarMappable:
        """Colour a region by a field that is taken as linear between the nodes.

        Parameters
        ----------
        axes : matplotlib Axes
            Where to draw.
        valued : array of bool
            The nodes at which the field has a value; one of them at least.
        values : array
            The field on the nodes.
        scale : Scale
            The range of values.
        level : float or None
            A value in the range whose line is to be drawn.
        """
        known = np.pad(valued, 1)
        field = np.pad(np.clip(values, scale.low, scale.high), 1).T
        colours = style.DIVERGING if scale.signed else style.SEQUENTIAL
        if boundary_length(known) > _LONGEST_OUTLINE:
            field = np.ma.array(field, mask=~known.T)
            image = self._image(axes, field, colours)
        else:
            field = _spread(field, known.T)
            clip = PathPatch(outline_of(self._x, self._y, known), transform=axes.transData)
            image = self._image(axes, field, colours)
            image.set(interpolation="bilinear", clip_path=clip)
            if level is not None:
                self._line(axes, field, level, clip)
        norm = LogNorm if scale.logarithmic else Normalize
        image.set(norm=norm(scale.low, scale.high), zorder=2.0)
        return image

    def _image(
        self, axes: Axes, values: npt.NDArray[Any], colours: str | ListedColormap
    ) -> AxesImage:
        across, up = self._steps[0] / 2, self._steps[1] / 2
        extent = (
            float(self._x[0]) - across,
            float(self._x[-1]) + across,
            float(self._y[0]) - up,
            float(self._y[-1]) + up,
        )
        return axes.imshow(
            values,
            cmap=colours,
            extent=extent,
            origin="lower",
            aspect="auto",
            interpolation="nearest",
        )

    def _line(self, axes: Axes, field: Floats, level: float, clip: PathPatch) -> None:
        if not field.min() < level < field.max():
            return
        line = axes.contour(
            self._x,
            self._y,
            field,
            levels=[level],
            colors=style.LIMIT_INK,
            linewidths=1.6,
            zorder=3.0,
        )
        line.set_clip_path(clip)


def _one_more_around(nodes: Floats, step: float) -> Floats:
    return np.concatenate([[nodes[0] - step], nodes, [nodes[-1] + step]])


def _spread(field: Floats, known: Bools) -> Floats:
    """Return the field with the value of the nearest node where it has none.

    The colours then reach the boundary, which runs between the nodes.
    """
    nearest = distance_transform_edt(~known, return_distances=False, return_indices=True)
    return np.asarray(field[tuple(nearest)], dtype=np.float64)
