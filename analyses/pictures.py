"""What a picture shows, before anyone draws it."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt


@dataclass(frozen=True)
class PictureAxis:
    """One axis of a picture.

    Parameters
    ----------
    label : str
        Name of the coordinate, as printed along the axis.
    unit : str
        Unit of the nodes; empty where they have none.
    nodes : array, shape (nodes,)
        Evenly spaced, ascending coordinates of the grid's nodes. [m or rad]
    """

    label: str
    unit: str
    nodes: npt.NDArray[np.float64]


@dataclass(frozen=True)
class PictureField:
    """A value at every node, shown by colour in a plane and by height on a line.

    Parameters
    ----------
    label : str
        Name of the field, as printed along its scale.
    unit : str
        Unit of the values and of the limit; empty where they have none.
    values : array, shape of the picture's nodes
        The field; NaN where it has no value, as outside the region. [unit]
    limit : float or None
        A bound on the field that is to be marked. [unit]
    """

    label: str
    unit: str
    values: npt.NDArray[np.float64]
    limit: float | None


@dataclass(frozen=True)
class Skeleton:
    """The mechanism drawn in one pose, projected to the picture's plane.

    Parameters
    ----------
    legs : tuple of array, each of shape (points, 2)
        One polyline a leg: base joint, elbow, platform joint. [m]
    platform : array, shape (points, 2)
        Corners of the closed polygon of the platform, or its single point. [m]
    """

    legs: tuple[npt.NDArray[np.float64], ...]
    platform: npt.NDArray[np.float64]


@dataclass(frozen=True)
class WorkspacePicture:
    """A workspace, or a section of one, along one coordinate or over two.

    Parameters
    ----------
    title : str
        First line of the heading.
    subtitle : str
        Second line of the heading; may be empty.
    axes : tuple of PictureAxis
        One or two axes, the horizontal one first.
    inside : array of bool, shape of the axes' nodes
        Whether each node lies in the workspace; ``inside[i, j]`` belongs to
        ``axes[0].nodes[i]`` and ``axes[1].nodes[j]``.
    field : PictureField or None
        What is shown inside the region; None fills it plainly.
    skeleton : Skeleton or None
        The mechanism drawn over the region; only a picture with two axes shows it.
    """

    title: str
    subtitle: str
    axes: tuple[PictureAxis, ...]
    inside: npt.NDArray[np.bool_]
    field: PictureField | None
    skeleton: Skeleton | None


@dataclass(frozen=True)
class PictureCurve:
    """One curve of a picture.

    Parameters
    ----------
    label : str
        What the curve is of.
    x, y : array, shape (points,)
        Its points in order; where y is NaN the curve has a gap. [units of the picture]
    level : float
        Its mean, drawn as a line of its own; NaN for none. [unit of y]
    """

    label: str
    x: npt.NDArray[np.float64]
    y: npt.NDArray[np.float64]
    level: float


@dataclass(frozen=True)
class CurvePicture:
    """Curves over one variable.

    Parameters
    ----------
    title, subtitle : str
        Lines of the heading; the second may be empty.
    x_label, x_unit, y_label, y_unit : str
        What is printed along the axes; units are empty where there are none.
    curves : tuple of PictureCurve
        One at least.
    """

    title: str
    subtitle: str
    x_label: str
    x_unit: str
    y_label: str
    y_unit: str
    curves: tuple[PictureCurve, ...]


Picture = WorkspacePicture | CurvePicture
