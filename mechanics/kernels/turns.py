"""Sines, cosines and rotation matrices, without a call that stops the compiler vectorising."""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import kernel

# pi/2 in three parts, the first two with trailing zeros: k times them is exact (Cody and Waite).
_TWO_OVER_PI = 0.6366197723675814
_HALF_PI_1 = 1.5707962512969971
_HALF_PI_2 = 7.5497894158615964e-08
_HALF_PI_3 = 5.390302858158119e-15
_FARTHEST = 1.0e5
"""Beyond this the three parts are not enough, and the library's functions are called. [rad]"""


@kernel
def sine_and_cosine(x: float) -> tuple[float, float]:
    """Return sin and cos of |x| <= 1e5 to 1 ulp or so. [rad]

    References
    ----------
    Moshier, Cephes mathematical library: the minimax polynomials on [-pi/4, pi/4].
    """
    k = math.floor(x * _TWO_OVER_PI + 0.5)
    r = ((x - k * _HALF_PI_1) - k * _HALF_PI_2) - k * _HALF_PI_3
    z = r * r
    p = 1.58962301576546568060e-10 * z - 2.50507477628578072866e-8
    p = (p * z + 2.75573136213857242213e-6) * z - 1.98412698295895385996e-4
    p = (p * z + 8.33333333332211858878e-3) * z - 1.66666666666666307295e-1
    s = r + r * z * p
    q = -1.13585365213876817300e-11 * z + 2.08757008419747316778e-9
    q = (q * z - 2.75573141792967388112e-7) * z + 2.48015872888517045348e-5
    q = (q * z - 1.38888888888730564116e-3) * z + 4.16666666666665929218e-2
    c = 1.0 - 0.5 * z + z * z * q
    quarter = int(k) & 3
    sine = s if (quarter & 1) == 0 else c
    cosine = c if (quarter & 1) == 0 else s
    if quarter & 2:
        sine = -sine
    if quarter == 1 or quarter == 2:
        cosine = -cosine
    return sine, cosine


@kernel
def sines_and_cosines(angles: Floats, sines: Floats, cosines: Floats) -> None:
    """Write sines and cosines of angles, shape (poses,), whatever their size. [rad]"""
    far = 0
    for i in range(angles.size):
        sines[i], cosines[i] = sine_and_cosine(angles[i])
        # Counted, not branched on: a branch would stop the compiler vectorising.
        far += 0 if abs(angles[i]) <= _FARTHEST else 1
    if far > 0:
        for i in range(angles.size):
            if not abs(angles[i]) <= _FARTHEST:
                sines[i] = math.sin(angles[i])
                cosines[i] = math.cos(angles[i])


@kernel
def about_axis(angles: Floats, axis: Floats, rotations: Floats) -> None:
    """Write, shape (9, poses) row by row, the turns by `angles` about a unit axis."""
    sines = np.empty(angles.size)
    cosines = np.empty(angles.size)
    sines_and_cosines(angles, sines, cosines)
    x, y, z = axis[0], axis[1], axis[2]
    for i in range(angles.size):
        s, c = sines[i], cosines[i]
        v = 1.0 - c
        rotations[0, i] = c + v * x * x
        rotations[1, i] = v * x * y - s * z
        rotations[2, i] = v * x * z + s * y
        rotations[3, i] = v * x * y + s * z
        rotations[4, i] = c + v * y * y
        rotations[5, i] = v * y * z - s * x
        rotations[6, i] = v * x * z - s * y
        rotations[7, i] = v * y * z + s * x
        rotations[8, i] = c + v * z * z


@kernel
def about_fixed_axes(angles: Floats, rotations: Floats) -> None:
    """Write R = Rz(rz) Ry(ry) Rx(rx), shape (9, poses) row by row, of angles (3, poses)."""
    poses = angles.shape[1]
    sines = np.empty((3, poses))
    cosines = np.empty((3, poses))
    for k in range(3):
        sines_and_cosines(angles[k], sines[k], cosines[k])
    for i in range(poses):
        sx, sy, sz = sines[0, i], sines[1, i], sines[2, i]
        cx, cy, cz = cosines[0, i], cosines[1, i], cosines[2, i]
        rotations[0, i] = cz * cy
        rotations[1, i] = cz * sy * sx - sz * cx
        rotations[2, i] = cz * sy * cx + sz * sx
        rotations[3, i] = sz * cy
        rotations[4, i] = sz * sy * sx + cz * cx
        rotations[5, i] = sz * sy * cx - cz * sx
        rotations[6, i] = -sy
        rotations[7, i] = cy * sx
        rotations[8, i] = cy * cx
