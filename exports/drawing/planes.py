"""Regions over two coordinates."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from analyses.pictures import WorkspacePicture
from exports.drawing import style
from exports.drawing.bars import draw_bar
from exports.drawing.panels import Panel
from exports.drawing.regions import NodeGrid
from exports.drawing.scales import scale_of
from exports.drawing.skeletons import draw_skeleton
from exports.drawing.views import View, view_of
from exports.drawing.wording import labelled


def draw_plane(figure: Figure, picture: WorkspacePicture) -> Panel:
    """Draw a picture with two axes and return it for the page to place.

    Parameters
    ----------
    figure : matplotlib Figure
        Where to draw.
    picture : WorkspacePicture
        What to draw.
    """
    axes = figure.add_axes((0.1, 0.1, 0.7, 0.8))
    view = view_of(picture)
    _draw_scanned(axes, view)
    bar, bar_label = _draw_region(figure, axes, picture)
    if picture.skeleton is not None and view.equal:
        draw_skeleton(axes, picture.skeleton)
    axes.set(xlim=view.x, ylim=view.y)
    axes.set_xlabel(labelled(picture.axes[0].label, picture.axes[0].unit))
    side_label = labelled(picture.axes[1].label, picture.axes[1].unit)
    return Panel(axes, bar, view.ratio, side_label, bar_label)


def _draw_scanned(axes: Axes, view: View) -> None:
    (left, right), (bottom, top) = view.scanned
    axes.add_patch(
        Rectangle(
            (left, bottom),
            right - left,
            top - bottom,
            facecolor=style.SCANNED_FILL,
            edgecolor=style.SCANNED_EDGE,
            linewidth=0.7,
            linestyle=(0, (4, 3)),
            zorder=0.5,
        )
    )


def _draw_region(figure: Figure, axes: Axes, picture: WorkspacePicture) -> tuple[Axes | None, str]:
    """Return the colour bar and its label, where there is a field to show."""
    if not picture.inside.any():
        return None, ""
    grid = NodeGrid(*picture.axes)
    field = picture.field
    if field is None:
        grid.fill(axes, picture.inside, style.REGION_FILL)
        return None, ""
    grid.fill(axes, picture.inside, style.VOID_FILL)
    valued = picture.inside & ~np.isnan(field.values)
    scale = scale_of(field.values[valued], field.limit)
    if scale is None:
        return None, ""
    level = field.limit if scale.holds(field.limit) else None
    colours = grid.colour(axes, valued, field.values, scale, level)
    bar = draw_bar(figure, colours, scale, field)
    return bar, labelled(field.label, field.unit, scale.exponent)
