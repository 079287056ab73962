"""Pictures of the spatial mechanisms of 2019 and 2022, from above and isometric."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import PathPatch
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import pathpatch_2d_to_3d
from scipy.ndimage import gaussian_filter

from examples import bodies
from examples.drawing import FAINT, Floats, Grid, arrays, page, plane, region_path, save
from examples.serving import Json, fetch, preset, run_job

COLOURS = colormaps["viridis"]
# The grid's own steps are smoothed away over so many nodes along x, y and z.
_SMOOTHING = (2.0, 2.0, 0.7)
_SLICES = 70
_HALF_WAY = 0.5
# The direction from which all three axes are foreshortened alike. [deg]
_ISOMETRIC = {"elev": 35.264, "azim": -45.0}


@dataclass(frozen=True)
class Solid:
    """A region of space: how far each node is inside, from 0 to 1."""

    axes: tuple[Floats, Floats, Floats]
    membership: Floats

    @property
    def heights(self) -> tuple[float, float]:
        """The lowest and the highest level with a node inside."""
        held = self.axes[2][(self.membership > _HALF_WAY).any(axis=(0, 1))]
        return float(held[0]), float(held[-1])

    def section(self, height: float) -> Floats:
        """Return the membership at a height, between two levels of nodes in proportion."""
        levels = self.axes[2]
        place = float(np.interp(height, levels, np.arange(len(levels))))
        lower = min(int(place), len(levels) - 2)
        share = place - lower
        section: Floats = (1 - share) * self.membership[:, :, lower]
        return section + share * self.membership[:, :, lower + 1]


def delta(client: httpx.Client, out: Path) -> None:
    """Draw figure 4 of 2019: the 4-DOF Delta's workspace, its platform level."""
    mechanism = preset(client, "delta_linear_4dof", "delta_linear_4dof_2019")
    solid = _solid(client, "4-DOF Delta, figure 4", bodies.delta(mechanism))
    _draw(solid, [0.0, 0.05, 0.1, 0.15, 0.4, 0.44], out / "2019_figure_4.png")


def geared(client: httpx.Client, out: Path) -> None:
    """Draw figure 5 of 2022: the geared mechanism's workspace, from above and isometric."""
    run_job(client, "geared, printed grid", bodies.geared())
    solid = _solid(client, "geared, figure 5", bodies.geared_closer())
    _draw(solid, [-0.25, -0.2, -0.1, 0.0, 0.05, 0.08], out / "2022_figure_5.png")


def _solid(client: httpx.Client, name: str, request: Json) -> Solid:
    """Return the workspace with a rim of empty nodes, and nothing else around it."""
    grid: Grid = arrays(fetch(client, run_job(client, name, request), "grid"))
    ends = tuple(
        slice(max(int(held.min()) - 8, 0), int(held.max()) + 9)
        for held in np.nonzero(grid["inside"])
    )
    x, y, z = (grid[f"axis_{name}"][end] for name, end in zip("xyz", ends, strict=True))
    inside = grid["inside"][ends].astype(np.float32)
    return Solid((x, y, z), gaussian_filter(inside, _SMOOTHING))


def _draw(solid: Solid, heights: Sequence[float], path: Path) -> None:
    figure = page(8.0, 4.0)
    above = figure.add_subplot(1, 2, 1)
    how = {"projection": "3d", "computed_zorder": False, "proj_type": "ortho"}
    relief = figure.add_subplot(1, 2, 2, **how)
    norm = Normalize(*solid.heights)
    _draw_from_above(above, solid, heights, norm)
    assert isinstance(relief, Axes3D)
    _draw_relief(relief, solid, norm)
    save(figure, path)


def _draw_from_above(axes: Axes, solid: Solid, heights: Sequence[float], norm: Normalize) -> None:
    x, y, _ = solid.axes
    silhouette = region_path(x, y, solid.membership.max(axis=2))
    assert silhouette is not None
    axes.add_patch(PathPatch(silhouette, facecolor="#eef3f8", edgecolor=FAINT, linewidth=1.6))
    labels = []
    for height in heights:
        section = region_path(x, y, solid.section(height))
        if section is not None:
            edge, name = COLOURS(norm(height)), f"{height:.2f}".replace("-", "−")
            axes.add_patch(PathPatch(section, fill=False, edgecolor=edge, linewidth=1.4))
            labels.append(Line2D([], [], color=edge, label=name))
    look: dict[str, Any] = {"loc": "upper left", "bbox_to_anchor": (1.0, 1.0)}
    axes.legend(handles=labels[::-1], title="$z$, m", **look)
    axes.set(xlim=(x[0], x[-1]), ylim=(y[0], y[-1]))
    axes.set_title("from above: silhouette and sections")
    plane(axes)


def _draw_relief(axes: Axes3D, solid: Solid, norm: Normalize) -> None:
    """Draw slices from the lowest to the highest, each over those below it."""
    x, y, _ = solid.axes
    low, high = solid.heights
    for order, height in enumerate(np.linspace(low, high, _SLICES)):
        section = region_path(x, y, solid.section(height))
        if section is None:
            continue
        colour = np.array(COLOURS(norm(height)))
        edge = np.append(0.75 * colour[:3], 1.0)
        patch = PathPatch(section, facecolor=colour, edgecolor=edge, linewidth=0.5, zorder=order)
        axes.add_patch(patch)
        pathpatch_2d_to_3d(patch, z=height)
    axes.set(xlim=(x[0], x[-1]), ylim=(y[0], y[-1]), zlim=(low, high))
    axes.set_box_aspect((np.ptp(x), np.ptp(y), high - low), zoom=0.76)
    axes.view_init(**_ISOMETRIC)
    axes.set(xlabel="$x$, m", ylabel="$y$, m", zlabel="$z$, m")
    axes.set_title("isometric")
