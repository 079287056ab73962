"""Least distances between straight segments."""

import math

from mechanics.arrays import Floats, Integers
from mechanics.kernels.compiling import kernel
from mechanics.kernels.legs import Vector


@kernel
def minus(a: Vector, b: Vector) -> Vector:
    """Return a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@kernel
def beyond(a: Vector, share: float, b: Vector) -> Vector:
    """Return a + share b."""
    return a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]


@kernel
def dot(a: Vector, b: Vector) -> float:
    """Return the product a b."""
    product: float = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    return product


@kernel
def cross(a: Vector, b: Vector) -> Vector:
    """Return a x b."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@kernel
def square_to_point(start: Vector, along: Vector, point: Vector) -> float:
    """Return the squared distance of a point from the segment start .. start + along. [m^2]"""
    away, length = minus(point, start), dot(along, along)
    share = dot(away, along) / length if length > 0.0 else 0.0
    share = 0.0 if share < 0.0 else 1.0 if share > 1.0 else share
    left = beyond(away, -share, along)
    return dot(left, left)


@kernel
def square_between(p: Vector, d: Vector, q: Vector, e: Vector) -> float:
    """Return the squared distance of the segments p .. p + d and q .. q + e; NaN stays. [m^2]

    The least is at an end of one of them, or between the feet of the lines' common normal if
    both lie inside. The feet by cross products: their error grows as the lines become parallel,
    but only along the lines, where it no longer matters.
    """
    square = square_to_point(q, e, p)
    square = min(square, square_to_point(q, e, beyond(p, 1.0, d)))
    square = min(square, square_to_point(p, d, q))
    square = min(square, square_to_point(p, d, beyond(q, 1.0, e)))
    away, normal = minus(q, p), cross(d, e)
    size = dot(normal, normal)
    if size > 0.0:
        share = dot(cross(away, e), normal) / size
        other = dot(cross(away, d), normal) / size
        if 0.0 < share < 1.0 and 0.0 < other < 1.0:
            left = beyond(beyond(away, other, e), -share, d)
            square = min(square, dot(left, left))
    return square


@kernel
def distances(
    first: Integers, second: Integers, starts: Floats, ends: Floats, values: Floats
) -> None:
    """Write the least distances of pairs of segments, shape (pairs, poses). [m]

    Parameters
    ----------
    first, second : arrays, shape (pairs,), which segments.
    starts, ends : arrays, shape (segments, 3, poses); a distance is NaN where they are. [m]
    """
    for pair in range(first.size):
        one, two = first[pair], second[pair]
        for i in range(values.shape[1]):
            p = starts[one, 0, i], starts[one, 1, i], starts[one, 2, i]
            q = starts[two, 0, i], starts[two, 1, i], starts[two, 2, i]
            d = minus((ends[one, 0, i], ends[one, 1, i], ends[one, 2, i]), p)
            e = minus((ends[two, 0, i], ends[two, 1, i], ends[two, 2, i]), q)
            if math.isnan(dot(p, d) + dot(q, e)):
                values[pair, i] = math.nan
            else:
                values[pair, i] = math.sqrt(square_between(p, d, q, e))
