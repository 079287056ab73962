"""Regions along one coordinate."""

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analyses.pictures import PictureField, WorkspacePicture
from exports.drawing import style
from exports.drawing.panels import Panel
from exports.drawing.scales import Scale, scale_of
from exports.drawing.views import node_step, scanned_span
from exports.drawing.wording import labelled, limit_off_scale, number

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]

_PLOT_RATIO = 0.52
_STRIP_RATIO = 0.13
# So few values are shown one by one.
_FEW_NODES = 60


def draw_line(figure: Figure, picture: WorkspacePicture) -> Panel:
    """Draw a picture with one axis and return it for the page to place.

    A field is plotted over the shaded region; without one, the region is a strip.

    Parameters
    ----------
    figure : matplotlib Figure
        Where to draw.
    picture : WorkspacePicture
        What to draw.
    """
    axes = figure.add_axes((0.1, 0.1, 0.8, 0.8))
    (axis,) = picture.axes
    step = node_step(axis)
    axes.set_xlim(scanned_span(axis, step))
    axes.set_xlabel(labelled(axis.label, axis.unit))
    _shade(axes, axis.nodes, step, picture.inside)
    field = picture.field
    valued = np.zeros_like(picture.inside)
    if field is not None:
        valued = picture.inside & ~np.isnan(field.values)
    scale = None if field is None else scale_of(field.values[valued], field.limit)
    if field is None or scale is None:
        axes.set_ylim(0.0, 1.0)
        axes.tick_params(left=False, right=False, labelleft=False)
        return Panel(axes, None, _STRIP_RATIO, "")
    _plot(axes, axis.nodes, np.where(valued, field.values, np.nan), scale)
    _mark_limit(axes, field, scale)
    return Panel(axes, None, _PLOT_RATIO, labelled(field.label, field.unit))


def _shade(axes: Axes, nodes: Floats, step: float, inside: Bools) -> None:
    changes = np.flatnonzero(np.diff(np.pad(inside, 1).astype(np.int8)))
    starts, stops = changes[::2], changes[1::2]
    spans = list(zip(nodes[starts] - step / 2, (stops - starts) * step, strict=True))
    axes.broken_barh(
        spans,
        (0.0, 1.0),
        transform=axes.get_xaxis_transform(),
        facecolor=style.SHADE,
        edgecolor=style.REGION_EDGE,
        linewidth=0.8,
        zorder=1,
    )


def _plot(axes: Axes, nodes: Floats, values: Floats, scale: Scale) -> None:
    axes.plot(nodes, values, color=style.REGION_EDGE, linewidth=2.0, zorder=4)
    alone = np.isnan(np.pad(values, 1, constant_values=np.nan))
    shown = np.isfinite(values) & (
        (alone[:-2] & alone[2:]) | np.full(len(nodes), len(nodes) <= _FEW_NODES)
    )
    axes.plot(
        nodes[shown],
        values[shown],
        linestyle="none",
        marker="o",
        markersize=4.5,
        markerfacecolor="white",
        markeredgecolor=style.REGION_EDGE,
        markeredgewidth=1.3,
        zorder=5,
    )
    if scale.logarithmic:
        axes.set_yscale("log")
    axes.set_ylim(scale.widened(0.06))


def _mark_limit(axes: Axes, field: PictureField, scale: Scale) -> None:
    if field.limit is None:
        return
    held = scale.holds(field.limit)
    if held:
        axes.axhline(
            field.limit, color=style.LIMIT_INK, linewidth=1.6, linestyle=(0, (5, 3)), zorder=3
        )
    axes.annotate(
        f"limit {number(field.limit, 0)}" if held else limit_off_scale(field.limit, field.unit),
        (1.0, field.limit) if held else (1.0, 1.0),
        xytext=(5.0, 0.0) if held else (0.0, 5.0),
        xycoords=axes.get_yaxis_transform() if held else "axes fraction",
        textcoords="offset points",
        horizontalalignment="left" if held else "right",
        verticalalignment="center" if held else "bottom",
        color=style.LIMIT_INK,
        fontsize=style.TICK_SIZE,
    )
