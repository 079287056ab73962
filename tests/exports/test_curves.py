"""Figures of curves."""

import dataclasses

import numpy as np
import pytest

from analyses.pictures import CurvePicture, PictureCurve
from exports import FigureFormat, FormatError, PictureError, draw_figure


def curve(label: str = "mesh 0", level: float = 0.5) -> PictureCurve:
    x = np.array([0.0, 0.4, 0.4, 1.0])
    return PictureCurve(label, x, np.array([1.0, 0.8, 0.2, 0.0]), level)


def picture(*curves: PictureCurve) -> CurvePicture:
    return CurvePicture("Title", "subtitle", "Phase", "", "Loss", "%", curves or (curve(),))


@pytest.mark.parametrize("format", ["png", "svg"])
def test_the_same_curves_are_the_same_bytes(format: FigureFormat) -> None:
    assert draw_figure(picture(), format) == draw_figure(picture(), format)


def test_every_curve_is_named_while_they_are_few() -> None:
    few = draw_figure(picture(*(curve(f"mesh {n}") for n in range(9))), "svg")
    one = draw_figure(picture(), "svg")
    assert few.count(b"<use") > one.count(b"<use")


@pytest.mark.parametrize("count", [10, 11, 100])
def test_many_curves_are_drawn(count: int) -> None:
    assert draw_figure(picture(*(curve(f"mesh {n}") for n in range(count))))


@pytest.mark.parametrize(
    "values",
    [[0.0] * 4, [np.nan] * 4, [1.0, np.nan, 2.0, np.nan], [5.0] * 4, [1e-300, 0.0, 1e300, 1.0]],
)
def test_flat_broken_and_missing_curves_are_drawn(values: list[float]) -> None:
    odd = dataclasses.replace(curve(), y=np.array(values), level=values[0])
    assert draw_figure(picture(odd))


def test_points_that_do_not_pair_are_refused() -> None:
    with pytest.raises(PictureError, match="mesh 0"):
        draw_figure(picture(dataclasses.replace(curve(), y=np.zeros(3))))


def test_no_curve_is_refused() -> None:
    with pytest.raises(PictureError, match="one at least"):
        draw_figure(dataclasses.replace(picture(), curves=()))


def test_other_formats_are_refused() -> None:
    with pytest.raises(FormatError):
        draw_figure(picture(), "pdf")  # type: ignore[arg-type]
