"""Mechanisms, drawn over their workspace."""

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.markers import MarkerStyle
from matplotlib.patches import Polygon
from matplotlib.path import Path
from matplotlib.patheffects import AbstractPathEffect, withStroke

from analyses.pictures import Skeleton
from exports.drawing import style

Points = npt.NDArray[np.float64]

# Room that joints and ground symbols take around their points. [point]
SYMBOL_ROOM = 21.0

_JOINT_SIZE = 8.0
_GROUND_SIZE = 25.0  # width of the ground
_PEDESTAL = Path([(0.0, 0.0), (-0.3, -0.5), (0.3, -0.5), (0.0, 0.0)])
_CORNERS_OF_A_FACE = 3
_POINTS_OF_A_LINK = 2


def draw_skeleton(axes: Axes, skeleton: Skeleton) -> None:
    """Draw the links, joints, ground symbols and platform of a mechanism.

    The first link of a leg with an elbow, its crank, is drawn heavier than the rod. What is
    not finite, as of a leg that does not reach, is left out.

    Parameters
    ----------
    axes : matplotlib Axes
        Where to draw.
    skeleton : Skeleton
        The mechanism in one pose. [m]
    """
    legs = [leg for leg in (_finite(leg) for leg in skeleton.legs) if len(leg)]
    platform = _finite(skeleton.platform)
    _draw_platform(axes, platform)
    for leg in legs:
        _draw_ground(axes, leg[0])
    for leg in legs:
        _draw_links(axes, leg)
    for points in (*legs, platform):
        _draw_joints(axes, points)


def skeleton_points(skeleton: Skeleton) -> Points:
    """Return all finite points of the skeleton, shape (points, 2), in metres."""
    return np.concatenate([_finite(part) for part in (*skeleton.legs, skeleton.platform)])


def _finite(points: Points) -> Points:
    points = np.asarray(points, dtype=np.float64).reshape(-1, 2)
    return points[np.isfinite(points).all(axis=1)]


def _draw_platform(axes: Axes, platform: Points) -> None:
    if len(platform) < _CORNERS_OF_A_FACE:
        axes.plot(*platform.T, color=style.LINK_INK, linewidth=3.2, zorder=6)
        return
    face = Polygon(
        platform,
        closed=True,
        facecolor=style.PLATFORM_FILL,
        edgecolor=style.LINK_INK,
        linewidth=2.0,
        joinstyle="round",
        zorder=6,
    )
    face.set_path_effects(_casing(2.0))
    axes.add_patch(face)


def _draw_links(axes: Axes, leg: Points) -> None:
    for first in range(len(leg) - 1):
        crank = first == 0 and len(leg) > _POINTS_OF_A_LINK
        width = 3.6 if crank else 2.2
        axes.plot(
            *leg[first : first + 2].T,
            color=style.LINK_INK,
            linewidth=width,
            path_effects=_casing(width),
            zorder=7,
        )


def _casing(width: float) -> list[AbstractPathEffect]:
    """Return the bright edge that sets a line off from dark colours."""
    return [withStroke(linewidth=width + 1.8, foreground="white")]


def _draw_joints(axes: Axes, points: Points) -> None:
    axes.plot(
        *points.T,
        linestyle="none",
        marker="o",
        markersize=_JOINT_SIZE,
        markerfacecolor="white",
        markeredgecolor=style.LINK_INK,
        markeredgewidth=1.6,
        zorder=9,
    )


def _draw_ground(axes: Axes, joint: Points) -> None:
    """Draw a pedestal on hatched ground, its tip in the joint."""
    for path, fill, width in (
        (_hatched_ground(), "none", 1.1),
        (_PEDESTAL, style.GROUND_FILL, 1.4),
    ):
        axes.plot(
            *joint,
            marker=MarkerStyle(path),
            # The library takes the farthest point of a marker for half its size.
            markersize=2 * _GROUND_SIZE * float(np.abs(path.vertices).max()),
            markerfacecolor=fill,
            markeredgecolor=style.LINK_INK,
            markeredgewidth=width,
            zorder=8,
        )


def _hatched_ground() -> Path:
    pegs = np.linspace(-0.36, 0.5, 6)
    strokes = [((-0.5, -0.5), (0.5, -0.5)), *(((x, -0.5), (x - 0.14, -0.66)) for x in pegs)]
    points = [point for stroke in strokes for point in stroke]
    return Path(points, [Path.MOVETO, Path.LINETO] * len(strokes))
