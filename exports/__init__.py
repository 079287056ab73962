"""Data in, bytes out: grid files and figures.

Importing this package loads no plotting library; a figure does when it is drawn.
"""

from exports.csv import write_csv
from exports.errors import ColumnError, ExportError, FormatError, PictureError
from exports.figures import FigureFormat, draw_figure
from exports.files import write_whole
from exports.npz import write_npz

__all__ = [
    "ColumnError",
    "ExportError",
    "FigureFormat",
    "FormatError",
    "PictureError",
    "draw_figure",
    "write_csv",
    "write_npz",
    "write_whole",
]
