"""Assembly modes of many rows of drive coordinates: columns, and one row's as objects."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from mechanics.arrays import Booleans, Floats, Integers
from mechanics.mechanism import WorkingMode


@dataclass(frozen=True)
class AssemblyMode:
    """One place of the platform at which the legs close.

    Parameters
    ----------
    pose : array, shape (coordinates,). [m, rad]
    working_mode : the signs with which the inverse solution gives the drives back.
    determinant : of Jx as it is; modes of one sign are on one side of singularities of type 2,
        and one that is 0 is two modes in one. [m to the number of turns]
    side : the sign of det Jx; 0 where a mode is two in one, or there is no determinant.
    residual : the greatest error of a rod's length over the mechanism's greatest length.
    """

    pose: Floats
    working_mode: WorkingMode
    determinant: float
    side: int
    residual: float


class Modes(NamedTuple):
    """Assembly modes of many cases, one column a mode.

    Parameters
    ----------
    cases : array, shape (modes,): the case each belongs to.
    poses : array, shape (coordinates, modes). [m, rad]
    working_modes : array, shape (drives, modes): the signs with which the inverse solution gives
        the drives back; +1 where both do, or none, as at a stretched or folded leg.
    determinants : array, shape (modes,), of Jx as it is. [m to the number of turns]
    sides : array, shape (modes,): as `AssemblyMode` tells them.
    residuals : array, shape (modes,), as in `mechanics.assembly.guess`.
    """

    cases: Integers
    poses: Floats
    working_modes: Integers
    determinants: Floats
    sides: Integers
    residuals: Floats

    def take(self, chosen: Integers | Booleans) -> "Modes":
        """Return the chosen modes, in their order."""
        return Modes._make(column[..., chosen] for column in self)

    def mode(self, column: int) -> AssemblyMode:
        """Return one mode."""
        return AssemblyMode(
            self.poses[:, column].copy(),
            tuple(self.working_modes[:, column].tolist()),
            float(self.determinants[column]),
            int(self.sides[column]),
            float(self.residuals[column]),
        )


@dataclass(frozen=True)
class Assembly:
    """All that is found for one row of drive coordinates.

    Parameters
    ----------
    modes : by falling determinant; none where the drives are out of reach.
    route : how they were found: `closed form`, `one angle`, `tetrahedra`, a route of
        `mechanics.assembly.spatial`, or `mechanics.forward.IMPOSSIBLE`.
    certified : whether these are all. Not so where the platform can move while the drives stand
        still, and where the route itself cannot tell.
    """

    modes: tuple[AssemblyMode, ...]
    route: str
    certified: bool


@dataclass(frozen=True)
class Assemblies:
    """What is found for many rows, each an `Assembly` when it is asked for.

    Parameters
    ----------
    modes : cases are rows, ascending; within one by falling determinant.
    routes : one a row.
    certified : array, shape (rows,).
    """

    modes: Modes
    routes: tuple[str, ...]
    certified: Booleans

    @property
    def counts(self) -> Integers:
        """How many modes each row has, shape (rows,)."""
        counts: Integers = np.bincount(self.modes.cases, minlength=len(self))
        return counts

    def __len__(self) -> int:
        """How many rows there are."""
        return len(self.routes)

    def __getitem__(self, row: int) -> Assembly:
        """Return what is found for one row."""
        number = range(len(self))[row]
        first, last = np.searchsorted(self.modes.cases, [number, number + 1]).tolist()
        modes = tuple(self.modes.mode(column) for column in range(first, last))
        return Assembly(modes, self.routes[number], bool(self.certified[number]))

    def __iter__(self) -> Iterator[Assembly]:
        """Return row after row."""
        return (self[row] for row in range(len(self)))


@dataclass(frozen=True)
class NearbyMode:
    """Where Newton's iteration from a guess has led; `mode` holds the drives only if converged.

    `left` says whether the guess has left its mode; None where that cannot be told.
    """

    mode: AssemblyMode
    converged: bool
    iterations: int
    left: bool | None


@dataclass(frozen=True)
class NearbyModes:
    """Where many guesses have led, each a `NearbyMode` when it is asked for.

    Parameters
    ----------
    modes : one column a guess.
    converged, iterations : arrays, shape (guesses,).
    left : array, shape (guesses,): as `mechanics.assembly.aspects` tells it.
    """

    modes: Modes
    converged: Booleans
    iterations: Integers
    left: Integers

    def __len__(self) -> int:
        """How many guesses there are."""
        return int(self.converged.size)

    def __getitem__(self, row: int) -> NearbyMode:
        """Return where one guess has led."""
        number = range(len(self))[row]
        left = int(self.left[number])
        return NearbyMode(
            self.modes.mode(number),
            bool(self.converged[number]),
            int(self.iterations[number]),
            None if left < 0 else bool(left),
        )

    def __iter__(self) -> Iterator[NearbyMode]:
        """Return guess after guess."""
        return (self[row] for row in range(len(self)))
