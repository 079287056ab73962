"""Colour bars."""

from typing import Literal

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure
from matplotlib.ticker import Locator, LogLocator, MaxNLocator

from analyses.pictures import PictureField
from exports.drawing import style
from exports.drawing.scales import Scale
from exports.drawing.wording import limit_off_scale, number, numbers

_TICKS = 6
# Below this span of a logarithmic bar 2 and 5 are written between the powers of ten.
_FEW_DECADES = 1e3
# Height of the point at an end beyond which there are values, in parts of the bar.
_END = 0.035
# A number nearer to the limit than this share of the bar would run into its mark.
_CLEARANCE = 0.07


def draw_bar(figure: Figure, colours: ScalarMappable, scale: Scale, field: PictureField) -> Axes:
    """Draw the colour bar of a field, its limit marked, and return its axes.

    A limit off the scale is written above the bar.

    Parameters
    ----------
    figure : matplotlib Figure
        Where to draw; the page places the bar.
    colours : matplotlib ScalarMappable
        What turns values into colours.
    scale : Scale
        The range of values.
    field : PictureField
        Gives the limit and its unit.
    """
    axes = figure.add_axes((0.9, 0.1, 0.05, 0.8))
    bar = figure.colorbar(colours, cax=axes, extend=_ends(scale), extendfrac=_END)
    bar.outline.set_linewidth(0.8)
    axes.tick_params(which="both", direction="out", length=3.5, pad=4.0)
    axes.minorticks_off()
    ticks = _ticks(scale, field.limit)
    if scale.logarithmic:
        texts = [number(tick, 0) for tick in ticks]
    else:
        texts = numbers(ticks, scale.exponent)
    places = list(ticks)
    if field.limit is not None and scale.holds(field.limit):
        places, texts = [*places, field.limit], [*texts, _limit_text(field.limit, scale)]
    bar.set_ticks(places, labels=texts)
    if field.limit is not None:
        _mark_limit(axes, scale, field.limit, field.unit)
    return axes


def _ends(scale: Scale) -> Literal["neither", "min", "max", "both"]:
    if scale.below:
        return "both" if scale.above else "min"
    return "max" if scale.above else "neither"


def _limit_text(limit: float, scale: Scale) -> str:
    return f"limit {number(limit, scale.exponent)}"


def _ticks(scale: Scale, limit: float | None) -> npt.NDArray[np.float64]:
    locator: Locator = MaxNLocator(nbins=_TICKS, steps=[1, 2, 2.5, 5, 10])
    if scale.logarithmic:
        few = scale.high / scale.low < _FEW_DECADES
        locator = LogLocator(subs=(1.0, 2.0, 5.0) if few else (1.0,))
    ticks = np.asarray(locator.tick_values(scale.low, scale.high), dtype=np.float64)
    low, high = scale.widened(1e-9)
    ticks = ticks[(ticks >= low) & (ticks <= high)]
    if limit is None or not scale.holds(limit):
        return ticks
    return ticks[np.abs(scale.share(ticks) - scale.share(np.array(limit))) > _CLEARANCE]


def _mark_limit(axes: Axes, scale: Scale, limit: float, unit: str) -> None:
    if scale.holds(limit):
        axes.axhline(limit, color="white", linewidth=3.0, zorder=5)
        axes.axhline(limit, color=style.LIMIT_INK, linewidth=1.6, zorder=6)
        text = axes.get_yticklabels()[-1]
        text.set_color(style.LIMIT_INK)
        return
    axes.annotate(
        limit_off_scale(limit, unit),
        (1.0, 1.0 + _END if scale.above else 1.0),
        xytext=(0.0, 6.0),
        xycoords="axes fraction",
        textcoords="offset points",
        horizontalalignment="right",
        color=style.LIMIT_INK,
        fontsize=style.TICK_SIZE,
    )
