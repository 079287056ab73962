"""Six rods under a platform as five polynomial equations in five complex unknowns.

The pose is a quaternion e of four complex numbers, scaled as one likes, and with h = e.e and
M = h R(e) the vectors P = h p and Q = h R' p: that they belong together says `P e = e Q`. With
S = P + Q, D = P - Q, v = (e1, e2, e3) and e scaled to e0 = 1 this is

    D + S x v = 0,                                                                   (1-3)

the longest rod, of length 1 between the two origins, says p.p = 1, or

    |S + D|^2 / 4 - h^2 = 0,                                                           (4)

and the five other rods less this one are linear in P and Q: b.Q - a.P = a'M b + k h with
k = (L^2 - 1 - |a|^2 - |b|^2) / 2. Four of these five give

    S1, S2, D1, D2 = quadrics of e + m (S3, D3),

and what is left over is one more such row that vanishes,

    q(e) + kappa (S3, D3) = 0.                                                         (5)

Unknowns: e1, e2, e3, S3, D3. A row of coefficients is the ten of the quadric's symmetric matrix
(00, 01, 02, 03, 11, 12, 13, 22, 23, 33) and two for S3 and D3; there are five such rows, 60
numbers. Where joints lie in a plane, with normal z, m and kappa vanish: nothing else changes.
"""

from mechanics.arrays import Floats
from mechanics.kernels.compiling import spliced
from mechanics.kernels.rows import Five, Row, solve_five, times

Four = tuple[complex, complex, complex, complex]
Form = tuple[complex, complex, complex, complex]
"""Half the derivatives of a row by e1, e2 and e3, and its value."""

COEFFICIENTS = 60
"""Five rows of twelve."""


@spliced
def at(w: Floats, row: int, lane: int) -> complex:
    """Return the complex number that two rows of `w`, shape (rows, lanes), hold."""
    return complex(w[row, lane], w[row + 1, lane])


@spliced
def general_form(w: Floats, first: int, lane: int, x: Five) -> Form:
    """Return a row of complex coefficients, from row `first` of `w` on, at x."""
    c0, c1, c2 = at(w, first, lane), at(w, first + 2, lane), at(w, first + 4, lane)
    c3, c4, c5 = at(w, first + 6, lane), at(w, first + 8, lane), at(w, first + 10, lane)
    c6, c7, c8 = at(w, first + 12, lane), at(w, first + 14, lane), at(w, first + 16, lane)
    c9, m, n = at(w, first + 18, lane), at(w, first + 20, lane), at(w, first + 22, lane)
    b0 = c0 + c1 * x[0] + c2 * x[1] + c3 * x[2]
    b1 = c1 + c4 * x[0] + c5 * x[1] + c6 * x[2]
    b2 = c2 + c5 * x[0] + c7 * x[1] + c8 * x[2]
    b3 = c3 + c6 * x[0] + c8 * x[1] + c9 * x[2]
    return b1, b2, b3, b0 + x[0] * b1 + x[1] * b2 + x[2] * b3 + m * x[3] + n * x[4]


@spliced
def real_form(w: Floats, first: int, lane: int, x: Five) -> Form:
    """Return a row of real coefficients, from row `first` of `w` on, at x."""
    c0, c1, c2, c3 = w[first, lane], w[first + 1, lane], w[first + 2, lane], w[first + 3, lane]
    c4, c5, c6 = w[first + 4, lane], w[first + 5, lane], w[first + 6, lane]
    c7, c8, c9 = w[first + 7, lane], w[first + 8, lane], w[first + 9, lane]
    b0 = c0 + (times(c1, x[0]) + times(c2, x[1]) + times(c3, x[2]))
    b1 = c1 + (times(c4, x[0]) + times(c5, x[1]) + times(c6, x[2]))
    b2 = c2 + (times(c5, x[0]) + times(c7, x[1]) + times(c8, x[2]))
    b3 = c3 + (times(c6, x[0]) + times(c8, x[1]) + times(c9, x[2]))
    free = times(w[first + 10, lane], x[3]) + times(w[first + 11, lane], x[4])
    return b1, b2, b3, b0 + x[0] * b1 + x[1] * b2 + x[2] * b3 + free


@spliced
def form_between(
    w: Floats, start: int, target: int, lane: int, x: Five, t: float
) -> tuple[Form, complex]:
    """Return the row (1 - t) start + t target at x, and its derivative by t."""
    s, r = 1.0 - t, general_form(w, start, lane, x)
    g = real_form(w, target, lane, x)
    mixed = (
        times(s, r[0]) + times(t, g[0]),
        times(s, r[1]) + times(t, g[1]),
        times(s, r[2]) + times(t, g[2]),
        times(s, r[3]) + times(t, g[3]),
    )
    return mixed, g[3] - r[3]


@spliced
def linear_between(
    w: Floats, start: int, target: int, lane: int, t: float
) -> tuple[complex, complex]:
    """Return a row's two coefficients of S3 and D3 at t."""
    s = 1.0 - t
    m, n = at(w, start + 20, lane), at(w, start + 22, lane)
    return (
        complex(s * m.real + t * w[target + 10, lane], s * m.imag),
        complex(s * n.real + t * w[target + 11, lane], s * n.imag),
    )


@spliced
def column(s1: complex, s2: complex, d1: complex, d2: complex, x: Five, P: Four) -> Four:
    """Return how (1-4) change when S1, S2, D1, D2 change at these rates; P is S + D."""
    return (
        d1 + s2 * x[2],
        d2 - s1 * x[2],
        s1 * x[1] - s2 * x[0],
        times(0.5, P[0] * (s1 + d1) + P[1] * (s2 + d2)),
    )


@spliced
def quadric_column(k: int, s1: Form, s2: Form, d1: Form, d2: Form, x: Five, P: Four) -> Four:
    """Return how (1-4) change with e_(k+1) through the quadrics."""
    c = column(s1[k], s2[k], d1[k], d2[k], x, P)
    return c[0] + c[0], c[1] + c[1], c[2] + c[2], c[3] + c[3]


@spliced
def newton_step(
    w: Floats, start: int, target: int, lane: int, x: Five, t: float
) -> tuple[Five, Five]:
    """Return the step to x from its improvement by Newton, and minus the path's velocity dx/dt.

    `start` and `target` are the rows of `w` where 60 complex and 60 real coefficients begin.
    """
    s1, s1t = form_between(w, start, target, lane, x, t)
    s2, s2t = form_between(w, start + 24, target + 12, lane, x, t)
    d1, d1t = form_between(w, start + 48, target + 24, lane, x, t)
    d2, d2t = form_between(w, start + 72, target + 36, lane, x, t)
    q, qt = form_between(w, start + 96, target + 48, lane, x, t)
    S1, S2, S3, D1, D2, D3 = s1[3], s2[3], x[3], d1[3], d2[3], x[4]
    h = 1.0 + (x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
    P = (S1 + D1, S2 + D2, S3 + D3, times(4.0, h))
    # Columns of the Jacobian: by e1, e2, e3 (also S x dv and h), S3, D3; then values, and by t.
    a = quadric_column(0, s1, s2, d1, d2, x, P)
    b = quadric_column(1, s1, s2, d1, d2, x, P)
    c = quadric_column(2, s1, s2, d1, d2, x, P)
    m1, n1 = linear_between(w, start, target, lane, t)
    m2, n2 = linear_between(w, start + 24, target + 12, lane, t)
    m3, n3 = linear_between(w, start + 48, target + 24, lane, t)
    m4, n4 = linear_between(w, start + 72, target + 36, lane, t)
    m5, n5 = linear_between(w, start + 96, target + 48, lane, t)
    m = column(m1, m2, m3, m4, x, P)
    n = column(n1, n2, n3, n4, x, P)
    r = column(s1t, s2t, d1t, d2t, x, P)
    half = times(0.5, P[2])
    G = times(0.25, P[0] * P[0] + P[1] * P[1] + P[2] * P[2]) - h * h
    F1, F2, F3 = D1 + S2 * x[2] - S3 * x[1], D2 + S3 * x[0] - S1 * x[2], D3 + S1 * x[1] - S2 * x[0]
    one: Row[complex] = (a[0], b[0] - S3, c[0] + S2, m[0] - x[1], n[0], F1, r[0])
    two: Row[complex] = (a[1] + S3, b[1], c[1] - S1, m[1] + x[0], n[1], F2, r[1])
    three: Row[complex] = (a[2] - S2, b[2] + S1, c[2], m[2], n[2] + 1.0, F3, r[2])
    four: Row[complex] = (
        a[3] - P[3] * x[0],
        b[3] - P[3] * x[1],
        c[3] - P[3] * x[2],
        m[3] + half,
        n[3] + half,
        G,
        r[3],
    )
    five: Row[complex] = (q[0] + q[0], q[1] + q[1], q[2] + q[2], m5, n5, q[3], qt)
    return solve_five(one, two, three, four, five)
