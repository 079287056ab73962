"""What forty paths ended in: real and complex modes, multiple ones, and ends where h = 0.

The count is certified by numbers, not by intervals: every path ended, no two in one simple root,
and with each root there is its conjugate, as the equations are real. Those with h = 0 are never
real, so real modes are even in number, each double one counted twice.
"""

from typing import NamedTuple

from mechanics.arrays import Booleans, Complexes, Floats, Integers
from mechanics.kernels import endpoints


class Endpoints(NamedTuple):
    """Where the paths ended.

    Parameters
    ----------
    solutions : array, shape (paths, 6): e, of length 1, S3 and D3.
    doubtful : which paths do not count: lost, fallen together, without their conjugate, or all
        that lead to no real root if those are odd in number.
    multiple : which ends are roots that several paths share.
    real : which ends are simple real roots.
    nearly_real : which ends are worth trying as real modes.
    """

    solutions: Complexes
    doubtful: Booleans
    multiple: Booleans
    real: Booleans
    nearly_real: Booleans

    @property
    def nearly_real_parts(self) -> Floats:
        """The solutions worth trying, without what is not real."""
        return endpoints.real_parts(self.solutions, self.nearly_real)


def endpoints_of(
    points: Floats, frames: Integers, outcomes: Integers, tolerance: float, final: bool
) -> Endpoints:
    """Return where the paths that `track` followed ended; what is no number is lost.

    Parameters
    ----------
    points, frames, outcomes : as `track` writes them.
    tolerance : solutions nearer than this are one.
    final : whether paths that fell together have been followed with care already.
    """
    endpoints.write_off(points, outcomes)
    solutions = endpoints.from_frames(points, frames)
    return Endpoints(solutions, *endpoints.classify(solutions, outcomes, tolerance, final))
