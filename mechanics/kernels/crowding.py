"""Whether poses stand apart."""

from mechanics.arrays import Floats
from mechanics.kernels.compiling import kernel


@kernel
def crowded(positions: Floats, rotations: Floats, size: float, apart: float) -> bool:
    """Return whether any two poses are nearer than `apart`, positions over a size.

    Parameters
    ----------
    positions, rotations : arrays, shapes (poses, 3) and (poses, 3, 3).
    """
    for k in range(positions.shape[0]):
        for n in range(k):
            if nearer(positions[k], positions[n], apart * size) and nearer(
                rotations[k].ravel(), rotations[n].ravel(), apart
            ):
                return True
    return False


@kernel
def nearer(a: Floats, b: Floats, apart: float) -> bool:
    """Return whether no two numbers differ by as much."""
    most = 0.0
    for i in range(a.size):
        most = max(most, abs(a[i] - b[i]))
    return most < apart
