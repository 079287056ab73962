"""Figures of workspaces."""

import dataclasses
import io
import itertools
import subprocess
import sys
import threading
import xml.etree.ElementTree as ET
from collections.abc import Callable

import matplotlib
import matplotlib.image
import numpy as np
import numpy.typing as npt
import pytest
from matplotlib.figure import Figure

from analyses.pictures import PictureAxis, PictureField, Skeleton, WorkspacePicture
from exports import FigureFormat, FormatError, PictureError, draw_figure
from exports.drawing import page, style

PictureMaker = Callable[..., WorkspacePicture]

WIDTH = 1440


def pixels(png: bytes) -> npt.NDArray[np.float64]:
    return np.asarray(matplotlib.image.imread(io.BytesIO(png), format="png"), dtype=np.float64)


def composed(picture: WorkspacePicture) -> Figure:
    """Return the figure as the file will show it, its layout done."""
    with matplotlib.rc_context():
        matplotlib.rcParams.update(style.PARAMETERS)
        figure = page.compose(picture)
        figure.draw_without_rendering()
    return figure


def line_picture(*, with_field: bool) -> WorkspacePicture:
    nodes = np.linspace(-1.0, 1.0, 21)
    inside = np.abs(nodes) < 0.7
    field = PictureField("Effort", "N", np.where(inside, nodes**2, np.nan), 0.3)
    axis = PictureAxis("rz", "rad", nodes)
    return WorkspacePicture("Spin", "", (axis,), inside, field if with_field else None, None)


@pytest.mark.parametrize("format", ["png", "svg"])
def test_the_same_picture_gives_the_same_bytes(
    make_picture: PictureMaker, format: FigureFormat
) -> None:
    assert draw_figure(make_picture(), format) == draw_figure(make_picture(), format)


def test_threads_do_not_disturb_each_other(make_picture: PictureMaker) -> None:
    picture, drawn = make_picture(nodes=(9, 9)), []
    threads = [
        threading.Thread(target=lambda: drawn.append(draw_figure(picture, "svg"))) for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert drawn == [draw_figure(picture, "svg")] * 4


def test_a_users_own_configuration_changes_nothing(make_picture: PictureMaker) -> None:
    expected = draw_figure(make_picture())
    with matplotlib.rc_context({"font.size": 30.0, "axes.grid": True, "savefig.dpi": 50}):
        assert draw_figure(make_picture()) == expected
        assert matplotlib.rcParams["font.size"] == 30.0


def test_svg_is_well_formed_and_undated(make_picture: PictureMaker) -> None:
    svg = draw_figure(make_picture(title="a -- b & <c> \x01 $d$ \\frac{"), "svg")
    assert ET.fromstring(svg).tag.endswith("svg")
    assert b"<dc:date>" not in svg


@pytest.mark.parametrize(
    ("size", "nodes"),
    [
        ((0.4, 0.4), (5, 5)),
        ((0.1, 1.5), (21, 61)),
        ((1.5, 0.1), (61, 21)),
        ((9e-4, 6e-4), (31, 31)),
    ],
    ids=["coarse", "tall", "wide", "minute"],
)
@pytest.mark.parametrize("with_field", [True, False])
def test_nothing_is_cut_off(
    make_picture: PictureMaker, size: tuple[float, float], nodes: tuple[int, int], with_field: bool
) -> None:
    image = pixels(
        draw_figure(
            make_picture(size=size, nodes=nodes, with_field=with_field, with_skeleton=False)
        )
    )[..., :3]
    rim = np.concatenate([image[:8].reshape(-1, 3), image[-8:].reshape(-1, 3)])
    sides = np.concatenate([image[:, :8].reshape(-1, 3), image[:, -8:].reshape(-1, 3)])
    assert image.shape[1] == WIDTH
    assert rim.min() == 1.0
    assert sides.min() == 1.0


def test_scale_is_the_same_along_both_axes(make_picture: PictureMaker) -> None:
    axes = composed(make_picture()).axes[0]
    origin, across, up = axes.transData.transform([(0, 0), (0.1, 0), (0, 0.1)])
    assert across[0] - origin[0] == pytest.approx(up[1] - origin[1], rel=1e-9)


def test_the_mechanism_lies_within_the_view(make_picture: PictureMaker) -> None:
    picture = make_picture()
    axes = composed(picture).axes[0]
    for leg in picture.skeleton.legs if picture.skeleton else ():
        inner = axes.transAxes.inverted().transform(axes.transData.transform(leg))
        assert inner.min() > 0.02
        assert inner.max() < 0.98


def test_colour_bar_is_as_high_as_the_drawing(make_picture: PictureMaker) -> None:
    drawing, bar = composed(make_picture()).axes
    assert drawing.get_position().y0 == pytest.approx(bar.get_position().y0)
    assert drawing.get_position().y1 == pytest.approx(bar.get_position().y1)


def test_colour_bar_carries_the_unit(make_picture: PictureMaker) -> None:
    bar = composed(make_picture()).axes[1]
    assert bar.get_ylabel() == "Largest drive torque (N·m)"


def test_a_limit_is_marked_on_the_colour_bar(make_picture: PictureMaker) -> None:
    bar = composed(make_picture(limit=1.2)).axes[1]
    texts = [tick for tick in bar.get_yticklabels() if tick.get_text() == "limit 1.2"]
    assert [text.get_color() for text in texts] == [style.LIMIT_INK]


def test_a_far_limit_is_written_above_the_colour_bar(make_picture: PictureMaker) -> None:
    bar = composed(make_picture(limit=500.0)).axes[1]
    assert "limit 500 N·m" in [text.get_text() for text in bar.texts]


def test_numbers_along_the_colour_bar_do_not_touch(make_picture: PictureMaker) -> None:
    bar = composed(make_picture(limit=1.22, size=(1.5, 0.2))).axes[1]
    boxes = sorted((text.get_window_extent() for text in bar.get_yticklabels()), key=lambda b: b.y0)
    assert all(low.y1 <= high.y0 for low, high in itertools.pairwise(boxes))


def test_an_empty_region_says_so(make_picture: PictureMaker) -> None:
    picture = make_picture()
    picture = dataclasses.replace(picture, inside=np.zeros_like(picture.inside))
    figure = composed(picture)
    assert len(figure.axes) == 1
    assert "no node" in figure.axes[0].get_title(loc="right")


def test_horizontal_axis_is_the_first(make_picture: PictureMaker) -> None:
    picture = make_picture(with_field=False, with_skeleton=False)
    inside = np.zeros_like(picture.inside)
    inside[-8:, :8] = True
    axes = composed(dataclasses.replace(picture, inside=inside)).axes[0]
    box = axes.patches[-1].get_path().get_extents()
    assert box.x0 > 0.0 > box.y1


@pytest.mark.parametrize("with_field", [True, False])
@pytest.mark.parametrize("format", ["png", "svg"])
def test_a_single_axis_is_drawn(format: FigureFormat, with_field: bool) -> None:
    assert draw_figure(line_picture(with_field=with_field), format)


@pytest.mark.parametrize("nodes", [(1, 1), (1, 7), (7, 1)])
def test_an_axis_of_one_node_is_drawn(nodes: tuple[int, int]) -> None:
    axes = tuple(
        PictureAxis(name, "m", np.linspace(0.0, 0.1, n))
        for name, n in zip("xy", nodes, strict=True)
    )
    field = PictureField("Effort", "N", np.ones(nodes), 2.0)
    picture = WorkspacePicture("", "", axes, np.ones(nodes, bool), field, None)
    assert draw_figure(picture)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_field_without_a_number_leaves_the_plain_region(
    make_picture: PictureMaker, value: float
) -> None:
    picture = make_picture()
    assert picture.field is not None
    field = dataclasses.replace(picture.field, values=np.full(picture.inside.shape, value))
    assert len(composed(dataclasses.replace(picture, field=field)).axes) == 1


def test_a_ragged_region_is_drawn_node_by_node(make_picture: PictureMaker) -> None:
    picture = make_picture(nodes=(301, 301), with_skeleton=False)
    inside = np.indices((301, 301)).sum(axis=0) % 2 == 0
    field = PictureField("Effort", "N", np.where(inside, 1.0, np.nan), None)
    ragged = dataclasses.replace(picture, inside=inside, field=field)
    assert len(draw_figure(ragged, "svg")) < 4 * 2**20


@pytest.mark.parametrize(
    "skeleton",
    [
        Skeleton((), np.zeros((0, 2))),
        Skeleton((np.full((3, 2), np.nan),), np.zeros((1, 2))),
        Skeleton((np.array([[0.0, 0.0], [0.1, 0.1]]),), np.eye(3)[:, :2]),
    ],
    ids=["nothing", "a leg that does not reach", "a strut and a platform"],
)
def test_any_skeleton_is_drawn(make_picture: PictureMaker, skeleton: Skeleton) -> None:
    assert draw_figure(dataclasses.replace(make_picture(), skeleton=skeleton))


@pytest.mark.parametrize("title", ["", "$x^{", "Пятизвенник", "W" * 500, "\x00\n"])
def test_any_title_is_drawn(make_picture: PictureMaker, title: str) -> None:
    assert draw_figure(make_picture(title=title))


def test_another_format_is_refused(make_picture: PictureMaker) -> None:
    with pytest.raises(FormatError) as caught:
        draw_figure(make_picture(), "pdf")  # type: ignore[arg-type]
    assert caught.value.allowed == ("png", "svg")


def test_parts_that_do_not_fit_are_refused(make_picture: PictureMaker) -> None:
    picture = make_picture()
    with pytest.raises(PictureError) as caught:
        draw_figure(dataclasses.replace(picture, inside=picture.inside.T))
    assert caught.value.part == "inside"


def test_importing_the_package_loads_no_plotting_library() -> None:
    program = "import sys, exports; sys.exit('matplotlib' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
