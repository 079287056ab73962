"""Sines, cosines and rotation matrices, without a call that stops the compiler vectorising."""

import math

from mechanics.arrays import Floats
from mechanics.kernels.arithmetic import multiply_add
from mechanics.kernels.compiling import inlined, kernel

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
    k = math.floor(multiply_add(x, _TWO_OVER_PI, 0.5))
    r = multiply_add(-k, _HALF_PI_2, multiply_add(-k, _HALF_PI_1, x))
    r = multiply_add(-k, _HALF_PI_3, r)
    z = r * r
    p = multiply_add(1.58962301576546568060e-10, z, -2.50507477628578072866e-8)
    p = multiply_add(p, z, 2.75573136213857242213e-6)
    p = multiply_add(p, z, -1.98412698295895385996e-4)
    p = multiply_add(p, z, 8.33333333332211858878e-3)
    p = multiply_add(p, z, -1.66666666666666307295e-1)
    s = multiply_add(r * z, p, r)
    q = multiply_add(-1.13585365213876817300e-11, z, 2.08757008419747316778e-9)
    q = multiply_add(q, z, -2.75573141792967388112e-7)
    q = multiply_add(q, z, 2.48015872888517045348e-5)
    q = multiply_add(q, z, -1.38888888888730564116e-3)
    q = multiply_add(q, z, 4.16666666666665929218e-2)
    c = multiply_add(z * z, q, multiply_add(-0.5, z, 1.0))
    quarter = int(k) & 3
    sine = s if (quarter & 1) == 0 else c
    cosine = c if (quarter & 1) == 0 else s
    if quarter & 2:
        sine = -sine
    if quarter == 1 or quarter == 2:
        cosine = -cosine
    return sine, cosine


@inlined
def sines_and_cosines(angles: Floats, row: int, turns: Floats, k: int) -> None:
    """Write the sines and cosines of a row of angles, of any size, to rows k and k + 1. [rad]"""
    far = 0
    for i in range(turns.shape[1]):
        turns[k, i], turns[k + 1, i] = sine_and_cosine(angles[row, i])
        # Counted, not branched on: a branch would stop the compiler vectorising.
        far += 0 if abs(angles[row, i]) <= _FARTHEST else 1
    if far > 0:
        for i in range(turns.shape[1]):
            if not abs(angles[row, i]) <= _FARTHEST:
                turns[k, i] = math.sin(angles[row, i])
                turns[k + 1, i] = math.cos(angles[row, i])


@inlined
def about_axis(angles: Floats, row: int, axis: Floats, turns: Floats, rotations: Floats) -> None:
    """Write, shape (9, poses) row by row, the turns by a row of angles about a unit axis."""
    sines_and_cosines(angles, row, turns, 0)
    x, y, z = axis[0], axis[1], axis[2]
    for i in range(turns.shape[1]):
        s, c = turns[0, i], turns[1, i]
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


@inlined
def about_fixed_axes(angles: Floats, row: int, turns: Floats, rotations: Floats) -> None:
    """Write R = Rz(rz) Ry(ry) Rx(rx), shape (9, poses) row by row, of three rows of angles."""
    for k in range(3):
        sines_and_cosines(angles, row + k, turns, 2 * k)
    for i in range(turns.shape[1]):
        sx, sy, sz = turns[0, i], turns[2, i], turns[4, i]
        cx, cy, cz = turns[1, i], turns[3, i], turns[5, i]
        rotations[0, i] = cz * cy
        rotations[1, i] = cz * sy * sx - sz * cx
        rotations[2, i] = cz * sy * cx + sz * sx
        rotations[3, i] = sz * cy
        rotations[4, i] = sz * sy * sx + cz * cx
        rotations[5, i] = sz * sy * cx - cz * sx
        rotations[6, i] = -sy
        rotations[7, i] = cy * sx
        rotations[8, i] = cy * cx
