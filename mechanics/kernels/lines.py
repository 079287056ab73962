"""Whole lines of a grid: where along a line the verdict on a leg can change, in closed form.

Along a line one translation changes, so that what a leg can reach is bounded by roots of
quadratics. Between two of these roots the verdict is the same at all nodes: one node decides for
all of them, and the two nodes beside a root decide for themselves, by the very formulas that a
block of poses goes through. Where rounding could blur a root, every node decides for itself.
"""

import math

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.legs import (
    Numbers,
    Vector,
    arm,
    crank_equation,
    numbers,
    rail_coordinate,
    rail_equation,
    span,
    strut_length,
)
from mechanics.kernels.placing import move_into, turn_into
from mechanics.legs import CRANK, RAIL, Legs

REACH = 0
LIMITS = 1
NOTHING = 2
"""A test that every leg passes."""

BLUR = 1e-9
"""A root of less than this share of its terms may be there or not."""
STRAIGHT = 1e-16
"""The cosine of an axis that is perpendicular to a line, or its sine if it is parallel."""
MOST_ENDS = 4


@inlined
def holds(test: int, drive: int, leg: Numbers, d: Vector) -> bool:
    """Return whether a leg passes a test at one span d."""
    if test == REACH:
        if drive == CRANK:
            _, _, S, root = crank_equation(leg, d[0], d[1], d[2])
            return bool(root - abs(S) >= 0.0)
        if drive == RAIL:
            return bool(rail_equation(leg, d[0], d[1], d[2])[1] >= 0.0)
        return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > 0.0
    if test == NOTHING:
        return True
    q = rail_coordinate(leg, d[0], d[1], d[2]) if drive == RAIL else strut_length(d[0], d[1], d[2])
    return bool(q - leg.lower_limit >= 0.0 and leg.upper_limit - q >= 0.0)


@inlined
def ends(test: int, drive: int, leg: Numbers, j: int, d: Vector, found: Floats) -> int:
    """Write where along t, with d_j + t in the place of d_j, the verdict on a leg may change. [m]

    Returns how many places there are; -1: it is not known where they are.
    """
    if test == REACH:
        if drive == CRANK:
            return _crank_ends(leg, j, d, found)
        if drive == RAIL:
            return _rail_ends(leg, j, d, found)
        return _sphere_ends(j, d, 0.0, found, 0)
    count = 0
    if test == NOTHING:
        return count
    for bound in (leg.lower_limit, leg.upper_limit):
        if count < 0 or not abs(bound) < math.inf:
            continue
        if drive == RAIL:
            # The drive stands at its stop where c is a rod's length from the carriage there.
            s = leg.axis
            e = (d[0] - bound * s[0], d[1] - bound * s[1], d[2] - bound * s[2])
            count = _sphere_ends(j, e, leg.rod_length, found, count)
        elif bound >= 0.0:
            count = _sphere_ends(j, d, bound, found, count)
    return count


@inlined
def _sphere_ends(j: int, d: Vector, radius: float, found: Floats, count: int) -> int:
    """Add the roots of |d| = radius."""
    across = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - d[j] * d[j]
    return _roots(d[j], radius * radius - across, radius * radius + across, found, count)


@kernel
def _roots(b: float, square: float, scale: float, found: Floats, count: int) -> int:
    """Add the roots of (t + b)^2 = square, unless rounding decides whether there are any."""
    if abs(square) <= BLUR * scale:
        return -1
    if square < 0.0:
        return count
    half = math.sqrt(square)
    found[count] = -b - half
    found[count + 1] = -b + half
    return count + 2


@inlined
def _rail_ends(leg: Numbers, j: int, d: Vector, found: Floats) -> int:
    """Write where c is a rod's length from the rail."""
    s, L = leg.axis, leg.rod_length
    along, left = rail_equation(leg, d[0], d[1], d[2])
    share = s[(j + 1) % 3] * s[(j + 1) % 3] + s[(j + 2) % 3] * s[(j + 2) % 3]
    if share == 0.0:
        # Along the rail the distance stays.
        return 0 if abs(left) > BLUR * L * L else -1
    if share <= BLUR:
        return -1
    b = (d[j] - along * s[j]) / share
    return _roots(b, b * b + left / share, b * b + (L * L + abs(left)) / share, found, 0)


@inlined
def _crank_ends(leg: Numbers, j: int, d: Vector, found: Floats) -> int:
    """Write where c enters or leaves the torus about the crank's axis."""
    a, r, L = leg.axis, leg.crank_length, leg.rod_length
    height = d[0] * a[0] + d[1] * a[1] + d[2] * a[2]
    square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
    share = a[(j + 1) % 3] * a[(j + 1) % 3] + a[(j + 2) % 3] * a[(j + 2) % 3]
    if abs(a[j]) <= STRAIGHT:
        left = L * L - height * height
        if abs(left) <= BLUR * L * L:
            return -1
        if left < 0.0:
            return 0
        g = math.sqrt(left)
        across = square - height * height - d[j] * d[j]
        count = _roots(d[j], (r + g) ** 2 - across, (r + g) ** 2 + abs(across), found, 0)
        if count < 0:
            return -1
        return _roots(d[j], (r - g) ** 2 - across, (r - g) ** 2 + abs(across), found, count)
    if share <= STRAIGHT * STRAIGHT:
        radius = math.sqrt(max(0.0, square - d[j] * d[j]))
        near, far = (radius - r) ** 2, (radius + r) ** 2
        count = _roots(d[j], L * L - near, L * L + near, found, 0)
        return _roots(d[j], L * L - far, L * L + far, found, count) if count >= 0 else -1
    return -1


@kernel
def walk(
    tests: Integers,
    members: Integers,
    legs: Legs,
    motion: tuple[Floats, int, Floats],
    grid: tuple[Floats, Floats, Integers, Integers, Floats],
    start: int,
    stop: int,
) -> tuple[Bytes, Integers]:
    """Return codes and lengths of the runs of the flat nodes start..stop.

    A node's code is 1 + the first of the tests that fails there, or 0; `members` are the tests'
    legs. The last axis must be a translation; `grid` is what `grid_poses` takes.
    """
    minima, steps, shape, columns, _ = grid
    line = shape[-1]
    first = start // line
    count = (stop - 1) // line - first + 1
    positions, rotations = _place_lines(motion, grid, first, count)
    starts, codes = np.empty(count + 1, np.int64), np.zeros(count, np.uint8)
    for c in range(count):
        starts[c] = max(start, (first + c) * line)
    starts[count] = stop
    axis = (columns[-1], line, minima[-1], steps[-1])
    for p in range(tests.size):
        if tests[p] == NOTHING:
            continue
        k = members[p]
        asked = (tests[p], p + 1, legs.drive[k])
        starts, codes = _divided(asked, numbers(legs, k), axis, positions, rotations, starts, codes)
    return codes, starts[1:] - starts[:-1]


@kernel
def _place_lines(
    motion: tuple[Floats, int, Floats],
    grid: tuple[Floats, Floats, Integers, Integers, Floats],
    first: int,
    count: int,
) -> tuple[Floats, Floats]:
    """Return where the platform is at the first node of each line: (3, lines), (9, lines or 1)."""
    twists, turning, axis = motion
    minima, steps, shape, columns, fixed = grid
    turned = False
    for column in columns:
        turned = turned or not np.any(twists[:3, column])
    positions, rotations = np.empty((3, count)), np.empty((9, count if turned else 1))
    pose, at = np.empty((fixed.size, 1)), np.empty((3, 1))
    turns, rotation = np.empty((6, 1)), np.empty((9, 1))
    pose[:, 0] = fixed
    indices = np.zeros(shape.size, np.int64)
    rest = first
    for a in range(shape.size - 2, -1, -1):
        indices[a] = rest % shape[a]
        rest //= shape[a]
    for c in range(count):
        for a in range(shape.size):
            pose[columns[a], 0] = minima[a] + indices[a] * steps[a]
        move_into(twists, pose, at)
        positions[0, c], positions[1, c], positions[2, c] = at[0, 0], at[1, 0], at[2, 0]
        if c < rotations.shape[1]:
            turn_into(fixed.size, turning, axis, pose, turns, rotation)
            rotations[:, c] = rotation[:, 0]
        # The next line, counted like an odometer: no division.
        a = shape.size - 2
        while a >= 0:
            indices[a] += 1
            if indices[a] < shape[a]:
                break
            indices[a] = 0
            a -= 1
    return positions, rotations


@kernel
def _divided(
    asked: tuple[int, int, int],
    leg: Numbers,
    axis: tuple[int, int, float, float],
    positions: Floats,
    rotations: Floats,
    starts: Integers,
    codes: Bytes,
) -> tuple[Integers, Bytes]:
    """Return the runs with those of code 0 divided by one leg's test."""
    room = codes.size + codes.size // 2 + 64
    while True:
        divided, marks = np.empty(room, np.int64), np.empty(room, np.uint8)
        written = _divide(asked, leg, axis, positions, rotations, starts, codes, divided, marks)
        if written >= 0:
            return divided[: written + 1], marks[:written]
        room *= 2


@kernel
def _divide(
    asked: tuple[int, int, int],
    leg: Numbers,
    axis: tuple[int, int, float, float],
    positions: Floats,
    rotations: Floats,
    starts: Integers,
    codes: Bytes,
    divided: Integers,
    marks: Bytes,
) -> int:
    """Write the runs with those of code 0 divided; return how many there are, -1: no room.

    `starts` and `divided` have one number more than there are runs; no run leaves its line.
    """
    test, _, drive = asked
    j, line, _, step = axis
    places = np.empty(MOST_ENDS)
    written = 0
    first, c = starts[0] // line * line, 0
    rho = arm(leg, rotations, 0)
    for run in range(codes.size):
        if written + 1 >= marks.size:
            return -1
        while starts[run] >= first + line:
            first += line
            c += 1
        if codes[run] != 0:
            divided[written], marks[written] = starts[run], codes[run]
            written += 1
            continue
        p = (positions[0, c], positions[1, c], positions[2, c])
        if rotations.shape[1] > 1:
            rho = arm(leg, rotations, c)
        count = ends(test, drive, leg, j, span(leg, p, rho), places)
        _sort(places, count, step)
        stretch = (starts[run] - first, starts[run + 1] - first, first)
        held = (p, rho, count)
        written = _split(asked, leg, axis, held, places, stretch, divided, marks, written)
        if written < 0:
            return -1
    divided[written] = starts[codes.size]
    return written


@inlined
def _split(
    asked: tuple[int, int, int],
    leg: Numbers,
    axis: tuple[int, int, float, float],
    held: tuple[Vector, Vector, int],
    places: Floats,
    stretch: tuple[int, int, int],
    divided: Integers,
    marks: Bytes,
    written: int,
) -> int:
    """Write the runs of one stretch of a line; return how many there are in all, -1: no room."""
    test, code, drive = asked
    j, _, minimum, step = axis
    p, rho, count = held
    node, last, first = stretch
    former, q = -1, 0
    while node < last:
        # Up to the next place all nodes are as this one; the two beside it are themselves.
        reach = last if count >= 0 else node + 1
        while q < count and places[q] < node - 1.0:
            q += 1
        if q < count and places[q] < last:
            reach = max(node + 1, math.floor(places[q]))
        t = minimum + node * step
        at = (t if j == 0 else p[0], t if j == 1 else p[1], t if j == 2 else p[2])
        mark = 0 if holds(test, drive, leg, span(leg, at, rho)) else code
        if mark != former and written >= 0:
            if written + 1 < marks.size:
                divided[written], marks[written] = first + node, mark
            written = written + 1 if written + 1 < marks.size else -1
            former = mark
        node = reach
    return written


@inlined
def _sort(places: Floats, count: int, step: float) -> None:
    """Put places in order, in steps."""
    for p in range(count):
        place = places[p] / step
        q = p
        while q > 0 and places[q - 1] > place:
            places[q] = places[q - 1]
            q -= 1
        places[q] = place
