"""Figures of workspaces and of curves."""

from typing import Literal, get_args

from analyses.pictures import CurvePicture, Picture, WorkspacePicture
from exports.errors import FormatError, PictureError

FigureFormat = Literal["png", "svg"]

_AXES_ALLOWED = (1, 2)


def draw_figure(picture: Picture, format: FigureFormat = "png") -> bytes:
    """Return a figure of a workspace or of curves, fit for print and for the screen.

    A workspace's region is filled or, where there is a field, coloured by it, with a colour bar in
    the field's unit that marks its limit. Two axes of the same unit have the same scale, and
    the mechanism is drawn over the region. A single axis gives a strip, or a line plot of
    the field over the shaded region. Curves have a legend. The same picture gives the same bytes.

    Parameters
    ----------
    picture : WorkspacePicture or CurvePicture
        What is to be drawn.
    format : "png" or "svg"
        1440 pixels wide, or vectors with the field as an image and all text as outlines.

    Returns
    -------
    bytes
        The file.

    Raises
    ------
    FormatError : no figure is offered in `format`.
    PictureError : the parts of the picture do not fit together.
    """
    if format not in get_args(FigureFormat):
        raise FormatError(format, get_args(FigureFormat))
    if isinstance(picture, CurvePicture):
        _check_curves(picture)
    else:
        _check_region(picture)
    # Matplotlib takes long to load, and most processes never draw.
    from exports.drawing.page import render

    return render(picture, format)


def _check_region(picture: WorkspacePicture) -> None:
    if len(picture.axes) not in _AXES_ALLOWED:
        raise PictureError("axes", "1 or 2 of them", len(picture.axes))
    shape = tuple(len(axis.nodes) for axis in picture.axes)
    if 0 in shape:
        raise PictureError("axes", "at least one node each", shape)
    if picture.inside.shape != shape:
        raise PictureError("inside", f"shape {shape}", picture.inside.shape)
    if picture.field is not None and picture.field.values.shape != shape:
        raise PictureError("field", f"shape {shape}", picture.field.values.shape)


def _check_curves(picture: CurvePicture) -> None:
    if not picture.curves:
        raise PictureError("curves", "one at least", 0)
    for curve in picture.curves:
        if curve.x.shape != curve.y.shape or curve.x.ndim != 1:
            raise PictureError(f"curve {curve.label!r}", f"shape {curve.x.shape}", curve.y.shape)
