"""Drive coordinates of poses given one a row."""

from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism


def actuators(mechanism: Mechanism, rows: Floats) -> Floats:
    """Return the drive coordinates, shape (poses, legs), of poses given one a row."""
    return Configuration(mechanism, mechanism.columns(rows)).actuators.T
