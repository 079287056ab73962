"""Words and numbers as they are printed in a figure."""

import textwrap
from typing import Final

import numpy as np
import numpy.typing as npt

MINUS: Final = "\N{MINUS SIGN}"

# Mean width of a letter, in parts of the size of the type.
_LETTER_WIDTH = 0.44
_MOST_LINES = 3


def plain(text: str) -> str:
    """Return the text on one line, without characters that cannot be printed."""
    printable = (letter if letter.isprintable() else " " for letter in text)
    return " ".join("".join(printable).split())


def wrapped(text: str, width: float, size: float) -> str:
    """Return the text broken into lines of about `width`, three of them at most.

    Parameters
    ----------
    text : str
        What is to be broken, on one line.
    width : float
        Length of a line. [point]
    size : float
        Size of the type. [point]
    """
    letters = max(8, int(width / (_LETTER_WIDTH * size)))
    # An equation stays on one line.
    text = text.replace(" = ", "\u00a0=\u00a0")
    return "\n".join(textwrap.wrap(text, letters, max_lines=_MOST_LINES, placeholder=" …"))


def labelled(label: str, unit: str, exponent: int = 0) -> str:
    """Return the label of an axis with its unit, and the power of ten taken out of its numbers.

    A single letter is a quantity and set in italics.
    """
    name = _literal(label)
    if len(name) == 1 and name.isascii() and name.isalpha():
        name = f"${name}$"
    times = "" if unit else r"\times "
    power = f"${times}10^{{{exponent}}}$" if exponent else ""
    measure = " ".join(part for part in (power, _literal(unit)) if part)
    return f"{name} ({measure})" if measure else name


def numbers(values: npt.NDArray[np.float64], exponent: int) -> list[str]:
    """Return evenly spaced values as texts with as many digits as tell them apart.

    Parameters
    ----------
    values : array, shape (values,)
        What is to be written, ascending.
    exponent : int
        The power of ten that is taken out.
    """
    if not len(values):
        return []
    shown = values / 10.0**exponent
    step = float(np.diff(shown).min()) if len(shown) > 1 else float(abs(shown).max())
    digits = next(
        (n for n in range(9) if abs(round(step, n) - step) <= 1e-6 * step),
        9,
    )
    # The sign of a zero says nothing.
    return [f"{value + 0.0:.{digits}f}".replace("-", MINUS) for value in np.round(shown, digits)]


def number(value: float, exponent: int) -> str:
    """Return one value to four digits."""
    return f"{value / 10.0**exponent:.4g}".replace("-", MINUS)


def limit_off_scale(limit: float, unit: str) -> str:
    """Return what is written where a limit has no place on its scale."""
    return f"limit {number(limit, 0)} {_literal(unit)}".rstrip()


def _literal(text: str) -> str:
    return plain(text).replace("$", r"\$")
