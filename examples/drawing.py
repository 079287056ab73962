"""How the examples draw what a server told them."""

import io
from collections.abc import Sequence
from pathlib import Path as File
from typing import Any

import matplotlib
import numpy as np
import numpy.typing as npt
from contourpy import FillType, contour_generator
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from PIL import Image

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]
Grid = dict[str, npt.NDArray[Any]]

INK, FAINT, FILL, EDGE, RED, ORANGE = (
    "#1a1a1a",
    "#6b6b6b",
    "#b7d3ea",
    "#1d4e79",
    "#c1121f",
    "#d9730d",
)
_HALF_WAY = 0.5
# As many as a palette can have.
_COLOURS = 256
_MOST_PIXELS = 1100

matplotlib.rcParams.update(
    {
        "font.family": ["STIXGeneral", "DejaVu Sans"],
        "mathtext.fontset": "stix",
        "font.size": 11,
        "axes.titlesize": 11,
        "axes.labelsize": 11,
        "axes.linewidth": 0.7,
        "xtick.direction": "in",
        "ytick.direction": "in",
        "xtick.top": True,
        "ytick.right": True,
        "legend.fontsize": 10,
        "legend.frameon": False,
    }
)


def page(width: float, height: float) -> Figure:
    """Return an empty figure of a size in inches."""
    figure = Figure(figsize=(width, height), dpi=160, layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def save(figure: Figure, path: File) -> None:
    """Write a figure as a small PNG file."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", facecolor="white", metadata={"Software": None})
    save_png(buffer.getvalue(), path)


def save_png(content: bytes, path: File) -> None:
    """Write a PNG file, 1100 pixels wide at most, with a palette: a fraction of its size."""
    with Image.open(io.BytesIO(content)) as image:
        small = image.convert("RGB")
        small.thumbnail((_MOST_PIXELS, 2 * _MOST_PIXELS))
        few = small.quantize(_COLOURS, kmeans=2)
        few.save(path, optimize=True)


def arrays(content: bytes) -> Grid:
    """Return the arrays of a grid file."""
    with np.load(io.BytesIO(content)) as archive:
        return {name: archive[name] for name in archive.files}


def plane(axes: Axes, xlabel: str = "$x$, m", ylabel: str = "$y$, m") -> None:
    """Give axes the same scale both ways, and labels."""
    axes.set_aspect("equal")
    axes.set(xlabel=xlabel, ylabel=ylabel)


def region_path(x: Floats, y: Floats, membership: npt.NDArray[Any]) -> Path | None:
    """Return the outline, with holes, of where the membership is above a half; None if nowhere.

    Parameters
    ----------
    x, y : array, shape (nodes,)
        Nodes of both axes.
    membership : array, shape (nodes of x, nodes of y)
        1 inside, 0 outside, or something between.
    """
    # One more row of nodes around closes what touches the grid's edge.
    around = np.pad(membership.astype(np.float64), 1)
    generator = contour_generator(_longer(x), _longer(y), around.T, fill_type=FillType.OuterCode)
    filled: Any = generator.filled(_HALF_WAY, np.inf)
    points, codes = filled
    return Path(np.concatenate(points), np.concatenate(codes)) if points else None


def _longer(nodes: Floats) -> Floats:
    step = nodes[1] - nodes[0]
    return np.concatenate([[nodes[0] - step], nodes, [nodes[-1] + step]])


def draw_region(axes: Axes, grid: Grid, scale: float = 1.0, **look: Any) -> None:  # noqa: ANN401
    """Draw a region of the plane: filled with an edge unless `look` says otherwise."""
    path = region_path(scale * grid["axis_x"], scale * grid["axis_y"], grid["inside"])
    style = {"facecolor": FILL, "edgecolor": EDGE, "linewidth": 1.1} | look
    if path is not None:
        axes.add_patch(PathPatch(path, **style))


def draw_legs(
    axes: Axes, legs: Sequence[Floats], platform: Floats | None = None, scale: float = 1.0
) -> None:
    """Draw a mechanism over a plane.

    Parameters
    ----------
    axes : matplotlib Axes
        Where to draw.
    legs : sequence of array, each of shape (points, 2)
        From base to platform. [m]
    platform : array, shape (points, 2), optional
        Its corners. [m]
    scale : float
        What a metre is on these axes.
    """
    if platform is not None:
        axes.fill(*(scale * platform).T, facecolor="#ffffffb0", edgecolor=INK, linewidth=1.4)
    for leg in legs:
        crank, rod = scale * leg[:2], scale * leg[1:]
        axes.plot(*crank.T, color=INK, linewidth=2.4, solid_capstyle="round")
        axes.plot(*rod.T, color=INK, linewidth=1.3, solid_capstyle="round")
        axes.plot(*(scale * leg).T, "o", color=INK, markerfacecolor="white", markersize=4.5)
        axes.plot(*(scale * leg[:1]).T, linestyle="none", marker="^", markersize=8, color=INK)
