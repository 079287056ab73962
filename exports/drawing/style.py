"""The look that all figures share."""

from typing import Any, Final

from matplotlib.typing import RcKeyType

# Sizes are in points on a page 7.2 inches wide, which 200 dots an inch make 1440 pixels.
DOTS_PER_INCH: Final = 200
PAGE_WIDTH: Final = 7.2  # [inch]
PAGE_EDGE: Final = 0.14  # [inch]
POINTS_PER_INCH: Final = 72.0

TITLE_SIZE: Final = 15.0
SUBTITLE_SIZE: Final = 12.0
TEXT_SIZE: Final = 12.5
TICK_SIZE: Final = 11.5

INK: Final = "#1a1a1a"
FAINT_INK: Final = "#5c5c5c"
LIMIT_INK: Final = "#c1121f"
REGION_FILL: Final = "#b7d3ea"
SHADE: Final = "#d8e7f4"
REGION_EDGE: Final = "#1d4e79"
# Inside the region, but without a value of the field.
VOID_FILL: Final = "#d9d9d9"
SCANNED_FILL: Final = "#f6f6f6"
SCANNED_EDGE: Final = "#b8b8b8"
LINK_INK: Final = "#16202b"
PLATFORM_FILL: Final = (1.0, 1.0, 1.0, 0.6)
GROUND_FILL: Final = "#e4e4e4"

SEQUENTIAL: Final = "viridis"
DIVERGING: Final = "RdBu_r"

# Both families come with the plotting library, so a figure is the same on every machine;
# the second has the letters that the first lacks.
PARAMETERS: Final[dict[RcKeyType, Any]] = {
    "font.family": ["STIXGeneral", "DejaVu Sans"],
    "mathtext.fontset": "stix",
    "font.size": TEXT_SIZE,
    "axes.labelsize": TEXT_SIZE,
    "axes.linewidth": 0.8,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.labelpad": 5.0,
    "axes.formatter.use_mathtext": True,
    "axes.formatter.useoffset": False,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.labelsize": TICK_SIZE,
    "ytick.labelsize": TICK_SIZE,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.top": True,
    "ytick.right": True,
    "xtick.major.size": 4.5,
    "ytick.major.size": 4.5,
    "xtick.major.pad": 5.0,
    "ytick.major.pad": 5.0,
    "lines.solid_capstyle": "round",
    "lines.solid_joinstyle": "round",
    # Identifiers in a vector file hang on this instead of on chance.
    "svg.hashsalt": "workspace",
    "svg.fonttype": "path",
    "agg.path.chunksize": 20000,
}
