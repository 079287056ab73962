"""Where everything stands on the page."""

from dataclasses import dataclass
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from exports.drawing import style
from exports.drawing.panels import Panel
from exports.drawing.wording import plain, wrapped

_BAR_GAP = 0.14  # [inch]
_BAR_WIDTH = 0.19  # [inch]
_HEADING_GAP = 0.12  # [inch]
_LINE_GAP = 0.06  # [inch]
_MOST_HEIGHT = 6.0  # of the drawing's box [inch]
# Labels depend on the size of the box, and the size of the box on the labels.
_ROUNDS = 3


@dataclass(frozen=True)
class _Overhang:
    """How far labels and bar stand out from the drawing's box, in inches."""

    left: float
    right: float
    bottom: float
    top: float


def arrange(figure: Figure, panel: Panel, title: str, subtitle: str) -> None:
    """Give the page its height, the panel its place and the heading its lines.

    The page is of one width. The drawing's box is as large as its labels leave room for,
    and the colour bar is as high as the box.

    Parameters
    ----------
    figure : matplotlib Figure
        The page, its panel drawn.
    panel : Panel
        What is to be placed.
    title, subtitle : str
        The heading; lines without a letter are left out.
    """
    box = Bbox.from_bounds(1.0, 1.0, 4.8, min(4.8 * panel.ratio, _MOST_HEIGHT))
    for _ in range(_ROUNDS):
        _place(figure, panel, box)
        box = _box(_overhang(figure, panel), panel.ratio)
    _place(figure, panel, box)
    over = _overhang(figure, panel)
    heading = _write_heading(figure, box.x0, title, subtitle)
    heights = [_extent(figure, text).height for text in heading]
    gaps = [_LINE_GAP] * (len(heights) - 1) + [_HEADING_GAP]
    head = sum(height + gap for height, gap in zip(heights, gaps, strict=False))
    figure.set_size_inches(style.PAGE_WIDTH, box.y1 + over.top + head + style.PAGE_EDGE)
    _place(figure, panel, box)
    _place_heading(figure, heading, heights, box.x0)


def _write_heading(figure: Figure, left: float, title: str, subtitle: str) -> list[Text]:
    width = style.PAGE_WIDTH - style.PAGE_EDGE - left
    kinds = (
        (plain(title), style.TITLE_SIZE, "bold", style.INK),
        (plain(subtitle), style.SUBTITLE_SIZE, "normal", style.FAINT_INK),
    )
    look: dict[str, Any] = {"parse_math": False, "verticalalignment": "top", "linespacing": 1.15}
    texts = []
    for words, size, weight, colour in kinds:
        if words:
            text = figure.text(0.0, 0.0, "", size=size, weight=weight, color=colour, **look)
            _break_lines(figure, text, words, width)
            texts.append(text)
    return texts


def _break_lines(figure: Figure, text: Text, words: str, width: float) -> None:
    """Break the text into lines of the given width, which letters wider than most exceed."""
    points, size = width * style.POINTS_PER_INCH, float(text.get_fontsize())
    text.set_text(wrapped(words, points, size))
    taken = _extent(figure, text).width
    if taken > width:
        text.set_text(wrapped(words, points * width / taken, size))
        text.set_fontsize(size * min(1.0, width / _extent(figure, text).width))


def _place_heading(figure: Figure, heading: list[Text], heights: list[float], left: float) -> None:
    width, height = figure.get_size_inches()
    top = height - style.PAGE_EDGE
    for text, taken in zip(heading, heights, strict=True):
        text.set_position((left / width, top / height))
        top -= taken + _LINE_GAP


def _box(over: _Overhang, ratio: float) -> Bbox:
    """Return the largest box that its labels leave room for, in the middle of the page."""
    room = style.PAGE_WIDTH - over.left - over.right - 2 * style.PAGE_EDGE
    width = min(room, _MOST_HEIGHT / ratio)
    left = style.PAGE_EDGE + over.left + (room - width) / 2
    return Bbox.from_bounds(left, style.PAGE_EDGE + over.bottom, width, width * ratio)


def _place(figure: Figure, panel: Panel, box: Bbox) -> None:
    width, height = figure.get_size_inches()
    page = (width, height, width, height)
    points = box.height * style.POINTS_PER_INCH
    panel.axes.set_position(tuple(a / b for a, b in zip(box.bounds, page, strict=True)))
    panel.axes.set_ylabel(wrapped(panel.side_label, points, style.TEXT_SIZE))
    if panel.bar is not None:
        bar = (box.x1 + _BAR_GAP, box.y0, _BAR_WIDTH, box.height)
        panel.bar.set_position(tuple(a / b for a, b in zip(bar, page, strict=True)))
        panel.bar.set_ylabel(wrapped(panel.bar_label, points, style.TEXT_SIZE))


def _overhang(figure: Figure, panel: Panel) -> _Overhang:
    drawn = [_extent(figure, axes) for axes in (panel.axes, panel.bar) if axes is not None]
    outer, box = Bbox.union(drawn), _window(figure, panel.axes)
    return _Overhang(box.x0 - outer.x0, outer.x1 - box.x1, box.y0 - outer.y0, outer.y1 - box.y1)


def _window(figure: Figure, axes: Axes) -> Bbox:
    window = axes.get_window_extent()
    return Bbox(window.get_points() / figure.dpi)


def _extent(figure: Figure, artist: Axes | Text) -> Bbox:
    """Return what an artist takes of the page, labels and all, in inches."""
    extent = artist.get_tightbbox()
    if extent is None:  # Nothing to see.
        return Bbox.null()
    return Bbox(extent.get_points() / figure.dpi)
