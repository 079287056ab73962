"""Whole batches run through scratch arrays that stay in the nearest cache.

The same formulas as a `Configuration` goes through, some poses at a time; the last stretch is
filled up with copies of its last pose, so that every loop has its full length.
"""

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.cofactors import expand
from mechanics.kernels.cofactors_six import LANES
from mechanics.kernels.compiling import inlined, kernel
from mechanics.kernels.efforts import invert, worst_into
from mechanics.kernels.jacobians import project, rod_wrench
from mechanics.kernels.legs import (
    Vector,
    arm,
    crank_angle,
    crank_equation,
    crank_rod,
    crank_turn,
    numbers,
    rail_coordinate,
    rail_rod,
    span,
    strut_length,
    strut_rod,
)
from mechanics.kernels.placing import place_into
from mechanics.legs import CRANK, RAIL, Legs


@kernel
def actuators(
    motion: tuple[Floats, int, Floats], legs: Legs, poses: Floats, values: Floats
) -> None:
    """Write the drive coordinates, shape (legs, poses), of poses, shape (coordinates, poses)."""
    twists, turning, axis = motion
    size, total = values.shape
    block, turns = np.empty((6, LANES)), np.empty((6, LANES))
    positions, rotations = np.empty((3, LANES)), np.empty((9, LANES))
    found = np.empty(LANES)
    for first in range(0, total, LANES):
        count = min(LANES, total - first)
        _load(poses, first, block)
        place_into(twists, turning, axis, block, turns, positions, rotations)
        for k in range(size):
            _drive_coordinates(legs, k, positions, rotations, found)
            for i in range(count):
                values[k, first + i] = found[i]


@inlined
def _load(poses: Floats, first: int, block: Floats) -> None:
    """Copy the poses from `first` on, the last of them again and again if there are too few."""
    coordinates, total = poses.shape
    if first + LANES <= total:
        for k in range(coordinates):
            for i in range(LANES):
                block[k, i] = poses[k, first + i]
    else:
        for k in range(coordinates):
            for i in range(LANES):
                block[k, i] = poses[k, min(first + i, total - 1)]


@inlined
def _drive_coordinates(
    legs: Legs, k: int, positions: Floats, rotations: Floats, value: Floats
) -> None:
    """Write one leg's drive coordinates in one pass, without keeping what lies between."""
    leg = numbers(legs, k)
    if legs.drive[k] == CRANK:
        for i in range(LANES):
            x, y, z = span(leg, _column(positions, i), arm(leg, rotations, i))
            P, Q, S, root = crank_equation(leg, x, y, z)
            c, s = crank_turn(P, Q, S, root, leg.working_mode)
            value[i] = crank_angle(c, s)
    elif legs.drive[k] == RAIL:
        for i in range(LANES):
            x, y, z = span(leg, _column(positions, i), arm(leg, rotations, i))
            value[i] = rail_coordinate(leg, x, y, z)
    else:
        for i in range(LANES):
            x, y, z = span(leg, _column(positions, i), arm(leg, rotations, i))
            value[i] = strut_length(x, y, z)


@kernel
def worst_efforts(
    motion: tuple[Floats, int, Floats],
    legs: Legs,
    poses: Floats,
    translations: int,
    force: float,
    moment: float,
    known: Floats,
) -> Floats:
    """Return the greatest efforts, shape (drives, poses), under loads of given size.

    `known`, shape (coordinates, poses or 1), is a load on top, in the motion's coordinates.
    """
    twists, turning, axis = motion
    size, total = legs.drive.size, poses.shape[1]
    loaded = bool(np.any(known))
    efforts = np.empty((size, total))
    block, turns, load = np.empty((6, LANES)), np.empty((6, LANES)), np.empty((size, LANES))
    positions, rotations = np.empty((3, LANES)), np.empty((9, LANES))
    wrenches, rates = np.empty((6, LANES)), np.empty((6, LANES))
    matrices, adjugates = np.empty((6, 6, LANES)), np.empty((6, 6, LANES))
    determinants, minors = np.empty(LANES), np.empty((20, LANES))
    sums, found, inverses = np.empty((3, LANES)), np.empty(LANES), np.empty(LANES)
    for first in range(0, total, LANES):
        count = min(LANES, total - first)
        _load(poses, first, block)
        if loaded:
            _load(known, first, load)
        place_into(twists, turning, axis, block, turns, positions, rotations)
        for k in range(size):
            _wrenches(legs, k, positions, rotations, wrenches, rates)
            project(twists, wrenches, matrices, k)
        expand(size, matrices, adjugates, determinants, minors)
        invert(determinants, inverses)
        for k in range(size):
            worst_into(
                adjugates,
                inverses,
                rates,
                k,
                translations,
                force,
                moment,
                load,
                loaded,
                sums,
                found,
            )
            for i in range(count):
                efforts[k, first + i] = found[i]
    return efforts


@inlined
def _wrenches(
    legs: Legs, k: int, positions: Floats, rotations: Floats, wrenches: Floats, rates: Floats
) -> None:
    """Write one leg's rod wrenches, shape (6, poses), and its row of Jpsi."""
    leg = numbers(legs, k)
    if legs.drive[k] == CRANK:
        for i in range(LANES):
            rho = arm(leg, rotations, i)
            d = span(leg, _column(positions, i), rho)
            P, Q, S, root = crank_equation(leg, d[0], d[1], d[2])
            c, s = crank_turn(P, Q, S, root, leg.working_mode)
            u, v, w, rates[k, i] = crank_rod(leg, d, c, s)
            _store(wrenches, i, rod_wrench((u, v, w), rho))
    elif legs.drive[k] == RAIL:
        for i in range(LANES):
            rho = arm(leg, rotations, i)
            d = span(leg, _column(positions, i), rho)
            q = rail_coordinate(leg, d[0], d[1], d[2])
            u, v, w, rates[k, i] = rail_rod(leg, d, q)
            _store(wrenches, i, rod_wrench((u, v, w), rho))
    else:
        for i in range(LANES):
            rho = arm(leg, rotations, i)
            d = span(leg, _column(positions, i), rho)
            u, v, w, rates[k, i] = strut_rod(d, strut_length(d[0], d[1], d[2]))
            _store(wrenches, i, rod_wrench((u, v, w), rho))


@kernel
def _store(
    wrenches: Floats, i: int, wrench: tuple[float, float, float, float, float, float]
) -> None:
    wrenches[0, i] = wrench[0]
    wrenches[1, i] = wrench[1]
    wrenches[2, i] = wrench[2]
    wrenches[3, i] = wrench[3]
    wrenches[4, i] = wrench[4]
    wrenches[5, i] = wrench[5]


@inlined
def _column(vectors: Floats, i: int) -> Vector:
    return vectors[0, i], vectors[1, i], vectors[2, i]
