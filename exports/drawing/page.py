"""A whole figure: heading, panel, margins, and its bytes."""

import io
import threading

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from analyses.pictures import CurvePicture, Picture, WorkspacePicture
from exports.drawing import style
from exports.drawing.curves import draw_curves
from exports.drawing.layout import arrange
from exports.drawing.lines import draw_line
from exports.drawing.panels import Panel
from exports.drawing.planes import draw_plane

_PLANE = 2

# The library keeps its parameters and its text machinery in globals that threads share.
_ONE_AT_A_TIME = threading.Lock()


def render(picture: Picture, format: str) -> bytes:
    """Return the file of a figure.

    Parameters
    ----------
    picture : WorkspacePicture or CurvePicture
        What is to be drawn, its parts of fitting shapes.
    format : str
        A format that the plotting library writes: ``png`` or ``svg``.
    """
    with _ONE_AT_A_TIME, matplotlib.rc_context():
        # Whatever a user's own configuration says, the figures are the same.
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(style.PARAMETERS)
        return _bytes_of(compose(picture), format)


def compose(picture: Picture) -> Figure:
    """Return the figure of a picture, everything in its place.

    Parameters
    ----------
    picture : WorkspacePicture or CurvePicture
        What is to be drawn, its parts of fitting shapes.
    """
    figure = Figure(figsize=(style.PAGE_WIDTH, style.PAGE_WIDTH), dpi=style.DOTS_PER_INCH)
    FigureCanvasAgg(figure)
    panel = (
        draw_curves(figure, picture)
        if isinstance(picture, CurvePicture)
        else _draw_region(figure, picture)
    )
    arrange(figure, panel, picture.title, picture.subtitle)
    return figure


def _draw_region(figure: Figure, picture: WorkspacePicture) -> Panel:
    draw = draw_plane if len(picture.axes) == _PLANE else draw_line
    panel = draw(figure, picture)
    if not picture.inside.any():
        panel.axes.set_title(
            "no node of the grid lies inside",
            loc="right",
            fontsize=style.TICK_SIZE,
            fontstyle="italic",
            color=style.FAINT_INK,
            pad=5.0,
        )
    return panel


def _bytes_of(figure: Figure, format: str) -> bytes:
    # Neither the time nor the library's version belongs to the picture.
    silent = {"Date": None, "Creator": None} if format == "svg" else {"Software": None}
    buffer = io.BytesIO()
    figure.savefig(buffer, format=format, metadata=silent, facecolor="white")
    return buffer.getvalue()
