"""From which value to which a field is shown."""

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

_TAILS = (2.0, 98.0)  # [per cent]
# A value is far out when it lies beyond the tail by more than this many times the bulk.
_FAR_OUT = 3.0
# The same where orders of size are shown: each order beyond the bulk is far already.
_FAR_OUT_ORDERS = 0.3
# What is shown beyond the bulk when the rest is left out, in the same measure.
_KEPT_TAIL = 0.5
# A limit farther from the values than this share of their span would squeeze the colours.
_LIMIT_REACH = 0.6
# Below this share of the other side, a change of sign is not worth a colour scale of its own.
_WORTHY_SIDE = 0.1
# The mark of a limit stands this share of the span off the ends.
_MARK_ROOM = 0.03
_FLAT = 1e-9
# A positive field whose bulk spans more than this factor is told apart by orders of size.
_WIDE = 8.0
_PLAIN_EXPONENTS = range(-2, 4)


@dataclass(frozen=True)
class Scale:
    """The range of values that is told apart.

    Parameters
    ----------
    low, high : float
        Ends of the range, low < high.
    below, above : bool
        Whether there are values beyond either end.
    signed : bool
        Whether zero stands in the middle and the sign matters.
    logarithmic : bool
        Whether equal factors, not equal steps, look alike; then low > 0.
    """

    low: float
    high: float
    below: bool
    above: bool
    signed: bool
    logarithmic: bool = False

    @property
    def exponent(self) -> int:
        """The power of ten to take out of the numbers, zero where they read well as is."""
        if self.logarithmic:
            return 0
        exponent = math.floor(math.log10(max(abs(self.low), abs(self.high))))
        return 0 if exponent in _PLAIN_EXPONENTS else 3 * (exponent // 3)

    def share(self, values: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """Return where values of the range stand in it, 0 at its low and 1 at its high end."""
        low, high, shown = self.low, self.high, np.asarray(values, dtype=np.float64)
        if self.logarithmic:
            low, high, shown = math.log10(low), math.log10(high), np.log10(shown)
        return (shown - low) / (high - low)

    def widened(self, share: float) -> tuple[float, float]:
        """Return the ends of the range with room of this share of it on either side."""
        if self.logarithmic:
            factor = (self.high / self.low) ** share
            return self.low / factor, self.high * factor
        room = share * (self.high - self.low)
        return self.low - room, self.high + room

    def holds(self, value: float | None) -> bool:
        """Return whether there is a value and it lies in the range."""
        return value is not None and self.low <= value <= self.high


def scale_of(values: npt.NDArray[np.float64], limit: float | None) -> Scale | None:
    """Return the range that shows the values best, or None if none of them is finite.

    Values near a singularity grow without bound; the range leaves out such a far tail, so
    that the bulk keeps its colours. It takes in the limit where that is near.

    Parameters
    ----------
    values : array
        The field, of any shape; what is not finite does not count.
    limit : float or None
        A bound that is to be marked.
    """
    finite = values[np.isfinite(values)]
    if not finite.size:
        return None
    least, most = float(finite.min()), float(finite.max())
    logarithmic = _is_wide(finite, least)
    if logarithmic:
        positive_limit = None if limit is None or limit <= 0 else math.log10(limit)
        low, high = (10.0**end for end in _ends(np.log10(finite), positive_limit, _FAR_OUT_ORDERS))
    else:
        low, high = _ends(finite, limit, _FAR_OUT)
    signed = low < 0 < high and min(-low, high) >= _WORTHY_SIDE * max(-low, high)
    if signed:
        high = max(-low, high)
        low = -high
    return Scale(
        low,
        high,
        below=least < low or bool(np.isneginf(values).any()),
        above=most > high or bool(np.isposinf(values).any()),
        signed=signed,
        logarithmic=logarithmic,
    )


def _is_wide(finite: npt.NDArray[np.float64], least: float) -> bool:
    tail_low, tail_high = (float(tail) for tail in np.percentile(finite, _TAILS))
    return least > 0 and tail_high > _WIDE * tail_low


def _ends(
    finite: npt.NDArray[np.float64], limit: float | None, far_out: float
) -> tuple[float, float]:
    low, high = _without_tails(finite, far_out)
    if high - low <= _FLAT * max(abs(low), abs(high)):
        room = 0.05 * abs(low) or 1.0
        low, high = low - room, high + room
    return _with_limit(low, high, limit)


def _without_tails(finite: npt.NDArray[np.float64], far_out: float) -> tuple[float, float]:
    least, most = float(finite.min()), float(finite.max())
    tail_low, tail_high = (float(tail) for tail in np.percentile(finite, _TAILS))
    room = far_out * (tail_high - tail_low)
    kept = min(_KEPT_TAIL, far_out) * (tail_high - tail_low)
    low = tail_low - kept if least < tail_low - room else least
    high = tail_high + kept if most > tail_high + room else most
    # A bulk of one value alone cannot stand for the rest.
    return (low, high) if low < high else (least, most)


def _with_limit(low: float, high: float, limit: float | None) -> tuple[float, float]:
    if limit is None or not math.isfinite(limit):
        return low, high
    reach = _LIMIT_REACH * (high - low)
    if low - reach <= limit <= high + reach:
        room = _MARK_ROOM * (high - low)
        return min(low, limit - room), max(high, limit + room)
    return low, high
