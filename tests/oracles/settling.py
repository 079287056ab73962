"""Where the multibody engine's platform comes to rest, started near a pose."""

import exudyn
import numpy as np

from tests.oracles.engine import Engine, _settings
from tests.oracles.machines import Floats, Machine


class Resting(Engine):
    """A machine whose drives stand as given while its platform starts somewhere near."""

    def place(self) -> Floats:
        """Return the rotation, row by row, and the position at which the joints close."""
        system = self._system
        system.Assemble()
        if not system.SolveStatic(_settings()):
            raise ArithmeticError("the engine found no equilibrium")
        kind = exudyn.OutputVariableType
        position = system.GetObjectOutputBody(self._platform, kind.Position)
        rotation = system.GetObjectOutputBody(self._platform, kind.RotationMatrix)
        return np.concatenate([np.array(rotation).ravel(), np.array(position)])


def rest(machine: Machine, start: Floats, actuators: Floats) -> Floats:
    """Return where the platform comes to rest from a start, shape (12,)."""
    return Resting(machine, start, actuators).place()
