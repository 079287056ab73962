"""Curves over one variable."""

from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from analyses.pictures import CurvePicture
from exports.drawing import style
from exports.drawing.panels import Panel
from exports.drawing.wording import labelled

_RATIO = 0.62
# More curves than this are told apart by a few entries of the legend.
_MOST_NAMED = 10
_ROOM = 0.06
_LEVEL: dict[str, Any] = {"linewidth": 1.1, "linestyle": (0, (5, 3))}
_DARKEST, _BRIGHTEST = 0.0, 0.82


def draw_curves(figure: Figure, picture: CurvePicture) -> Panel:
    """Draw curves with a dashed line at the level of each, and return them for the page to place.

    Parameters
    ----------
    figure : matplotlib Figure
        Where to draw.
    picture : CurvePicture
        What to draw.
    """
    axes = figure.add_axes((0.1, 0.1, 0.8, 0.8))
    colours = matplotlib.colormaps[style.SEQUENTIAL](
        np.linspace(_DARKEST, _BRIGHTEST, len(picture.curves))
    )
    for curve, colour in zip(picture.curves, colours, strict=True):
        axes.plot(curve.x, curve.y, color=colour, linewidth=1.8, label=curve.label, zorder=4)
        axes.axhline(curve.level, color=colour, zorder=3, **_LEVEL)
    axes.set_xlabel(labelled(picture.x_label, picture.x_unit))
    _set_limits(axes, picture)
    _name(axes)
    return Panel(axes, None, _RATIO, labelled(picture.y_label, picture.y_unit))


def _set_limits(axes: Axes, picture: CurvePicture) -> None:
    x = np.concatenate([curve.x for curve in picture.curves])
    y = np.concatenate([[*curve.y, curve.level] for curve in picture.curves])
    y = y[np.isfinite(y)]
    axes.set_xlim(x.min(), x.max())
    if not y.size:
        axes.tick_params(left=False, right=False, labelleft=False)
        return
    # Flat curves, as without friction, keep some height around them.
    room = _ROOM * float(np.ptp(y)) or 0.5 * (abs(float(y[0])) or 1.0)
    axes.set_ylim(y.min() - room, y.max() + room)


def _name(axes: Axes) -> None:
    handles, labels = axes.get_legend_handles_labels()
    kept = np.unique(np.linspace(0, len(handles) - 1, _MOST_NAMED).round().astype(int))
    axes.legend(
        [*(handles[number] for number in kept), Line2D([], [], **_LEVEL, color=style.FAINT_INK)],
        [*(labels[number] for number in kept), "mean"],
        loc="upper left",
        bbox_to_anchor=(1.01, 1.02),
        frameon=False,
        fontsize=style.TICK_SIZE,
        handlelength=1.4,
        borderaxespad=0.0,
    )
