"""What the page has to place."""

from dataclasses import dataclass

from matplotlib.axes import Axes


@dataclass(frozen=True)
class Panel:
    """A drawing and the colour bar beside it, both drawn but not yet placed.

    Parameters
    ----------
    axes : matplotlib Axes
        The drawing.
    bar : matplotlib Axes or None
        Its colour bar.
    ratio : float
        Height of the drawing's box over its width.
    side_label : str
        What is written along the drawing's upright side; the page breaks it into lines.
    bar_label : str
        What is written along the bar.
    """

    axes: Axes
    bar: Axes | None
    ratio: float
    side_label: str
    bar_label: str = ""
