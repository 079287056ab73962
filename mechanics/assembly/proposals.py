"""Poses that a closed form or a polynomial proposes; Newton's iteration decides on them."""

from typing import NamedTuple

from mechanics.arrays import Booleans, Floats, Integers


class Proposals(NamedTuple):
    """Poses that may close the legs, one column a proposal.

    Parameters
    ----------
    cases : array, shape (proposals,): which case each belongs to.
    poses : array, shape (coordinates, proposals). [m, rad]
    certified : array, shape (cases,): whether all modes of the case are proposed. Not so where
        the platform can move while the drives stand still: modes are then no single poses.
    routes : how they were found, one a case.
    """

    cases: Integers
    poses: Floats
    certified: Booleans
    routes: tuple[str, ...]
