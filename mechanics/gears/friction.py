"""Laws of friction between teeth."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from mechanics.arrays import Floats


class Friction(Protocol):
    """What a law of friction must answer; anything that does may stand in a `Mesh`."""

    def coefficient(self, sliding_speed: Floats) -> Floats:
        """Return the coefficient of friction at each sliding speed, of the same shape.

        Parameters
        ----------
        sliding_speed : array, at least 0; NaN where the speed of the train is not known. [m/s]
        """
        ...


@dataclass(frozen=True)
class Coulomb:
    """Friction whose coefficient is a number, whatever the speed."""

    number: float

    def coefficient(self, sliding_speed: Floats) -> Floats:
        """Return the number, in the shape of the speeds. [m/s]"""
        return np.full(np.shape(sliding_speed), self.number)
