"""Rows of seven numbers, and the systems of five and six equations that they make.

A system is a handful of rows, tuples of numbers of one pose or path. What is written here for one
becomes vector code for as many as a register holds, where it is called in a loop over lanes: no
array, no index that changes, no branch. Rows are compared and exchanged by choosing, number by
number, and what nobody reads of a row is never computed.
"""

from typing import TypeVar

from mechanics.kernels.compiling import spliced

N = TypeVar("N", float, complex)
Row = tuple[N, N, N, N, N, N, N]
Five = tuple[complex, complex, complex, complex, complex]
Six = tuple[float, float, float, float, float, float]


@spliced
def square(z: complex) -> float:
    """Return |z|^2."""
    return z.real * z.real + z.imag * z.imag


@spliced
def times(s: float, z: complex) -> complex:
    """Return s z; the language would make s complex first, and multiply its zeros too."""
    return complex(s * z.real, s * z.imag)


@spliced
def reciprocal(z: complex) -> complex:
    """Return 1 / z; the language's own division looks at sizes first, and branches."""
    s = 1.0 / (z.real * z.real + z.imag * z.imag)
    return complex(s * z.real, -(s * z.imag))


@spliced
def less(row: Row[N], factor: N, other: Row[N]) -> Row[N]:
    """Return row - factor other."""
    return (
        row[0] - factor * other[0],
        row[1] - factor * other[1],
        row[2] - factor * other[2],
        row[3] - factor * other[3],
        row[4] - factor * other[4],
        row[5] - factor * other[5],
        row[6] - factor * other[6],
    )


@spliced
def choose(first: bool, row: Row[N], other: Row[N]) -> Row[N]:
    """Return `row` if `first`, else `other`."""
    return (
        row[0] if first else other[0],
        row[1] if first else other[1],
        row[2] if first else other[2],
        row[3] if first else other[3],
        row[4] if first else other[4],
        row[5] if first else other[5],
        row[6] if first else other[6],
    )


@spliced
def ordered(k: int, row: Row[N], other: Row[N]) -> tuple[Row[N], Row[N]]:
    """Return both rows, the one with the larger number k first."""
    kept = square(row[k]) >= square(other[k])
    return choose(kept, row, other), choose(kept, other, row)


@spliced
def solve_five(
    a: Row[complex], b: Row[complex], c: Row[complex], d: Row[complex], e: Row[complex]
) -> tuple[Five, Five]:
    """Return the solutions of five complex equations for the last two numbers of their rows.

    Gaussian elimination, the row with the largest number taken as pivot.
    """
    a, b = ordered(0, a, b)
    a, c = ordered(0, a, c)
    a, d = ordered(0, a, d)
    a, e = ordered(0, a, e)
    over_a = reciprocal(a[0])
    b, c = less(b, b[0] * over_a, a), less(c, c[0] * over_a, a)
    d, e = less(d, d[0] * over_a, a), less(e, e[0] * over_a, a)
    b, c = ordered(1, b, c)
    b, d = ordered(1, b, d)
    b, e = ordered(1, b, e)
    over_b = reciprocal(b[1])
    c, d, e = less(c, c[1] * over_b, b), less(d, d[1] * over_b, b), less(e, e[1] * over_b, b)
    c, d = ordered(2, c, d)
    c, e = ordered(2, c, e)
    over_c = reciprocal(c[2])
    d, e = less(d, d[2] * over_c, c), less(e, e[2] * over_c, c)
    d, e = ordered(3, d, e)
    over_d = reciprocal(d[3])
    e = less(e, e[3] * over_d, d)
    over = (over_a, over_b, over_c, over_d, reciprocal(e[4]))
    return back_five(5, a, b, c, d, e, over), back_five(6, a, b, c, d, e, over)


@spliced
def back_five(
    s: int,
    a: Row[complex],
    b: Row[complex],
    c: Row[complex],
    d: Row[complex],
    e: Row[complex],
    over: Five,
) -> Five:
    """Return the solution of a triangular system for number s of its rows."""
    x4 = e[s] * over[4]
    x3 = (d[s] - d[4] * x4) * over[3]
    x2 = (c[s] - c[3] * x3 - c[4] * x4) * over[2]
    x1 = (b[s] - b[2] * x2 - b[3] * x3 - b[4] * x4) * over[1]
    x0 = (a[s] - a[1] * x1 - a[2] * x2 - a[3] * x3 - a[4] * x4) * over[0]
    return x0, x1, x2, x3, x4


@spliced
def solve_six(
    a: Row[float],
    b: Row[float],
    c: Row[float],
    d: Row[float],
    e: Row[float],
    f: Row[float],
) -> Six:
    """Return the solution of six real equations for the last number of their rows."""
    a, b = ordered(0, a, b)
    a, c = ordered(0, a, c)
    a, d = ordered(0, a, d)
    a, e = ordered(0, a, e)
    a, f = ordered(0, a, f)
    g = 1.0 / a[0]
    b, c, d = less(b, b[0] * g, a), less(c, c[0] * g, a), less(d, d[0] * g, a)
    e, f = less(e, e[0] * g, a), less(f, f[0] * g, a)
    b, c = ordered(1, b, c)
    b, d = ordered(1, b, d)
    b, e = ordered(1, b, e)
    b, f = ordered(1, b, f)
    h = 1.0 / b[1]
    c, d = less(c, c[1] * h, b), less(d, d[1] * h, b)
    e, f = less(e, e[1] * h, b), less(f, f[1] * h, b)
    c, d = ordered(2, c, d)
    c, e = ordered(2, c, e)
    c, f = ordered(2, c, f)
    i = 1.0 / c[2]
    d, e, f = less(d, d[2] * i, c), less(e, e[2] * i, c), less(f, f[2] * i, c)
    d, e = ordered(3, d, e)
    d, f = ordered(3, d, f)
    j = 1.0 / d[3]
    e, f = less(e, e[3] * j, d), less(f, f[3] * j, d)
    e, f = ordered(4, e, f)
    f = less(f, f[4] / e[4], e)
    x5 = f[6] / f[5]
    x4 = (e[6] - e[5] * x5) / e[4]
    x3 = (d[6] - d[4] * x4 - d[5] * x5) * j
    x2 = (c[6] - c[3] * x3 - c[4] * x4 - c[5] * x5) * i
    x1 = (b[6] - b[2] * x2 - b[3] * x3 - b[4] * x4 - b[5] * x5) * h
    x0 = (a[6] - a[1] * x1 - a[2] * x2 - a[3] * x3 - a[4] * x4 - a[5] * x5) * g
    return x0, x1, x2, x3, x4, x5
