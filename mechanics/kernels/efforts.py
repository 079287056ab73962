"""Drive efforts T = -J^-T P, and their greatest over all directions of a load of given size."""

import math

import numpy as np

from mechanics.arrays import Floats
from mechanics.kernels.compiling import inlined, kernel


@inlined
def invert(determinants: Floats, inverses: Floats) -> None:
    """Write 1 / det, shape (poses,); NaN where det Jx = 0."""
    for i in range(determinants.size):
        inverses[i] = 1.0 / determinants[i] if determinants[i] != 0.0 else math.nan


@kernel
def effort_rows(
    adjugates: Floats, determinants: Floats, drive_rates: Floats, twists: Floats, rows: Floats
) -> None:
    """Write the rows of J^-T as wrenches, shape (drives, 6, poses): force part, moment part.

    J^-T = Jpsi Jx^-T: finite where Jpsi = 0 (type 1), not finite where det Jx = 0 (type 2).
    """
    count, coordinates, poses = adjugates.shape
    scales, inverses = np.empty(poses), np.empty(poses)
    invert(determinants, inverses)
    rows[:] = 0.0
    for k in range(count):
        for i in range(poses):
            scales[i] = drive_rates[k, i] * inverses[i]
        for j in range(coordinates):
            for t in range(6):
                unit = twists[t, j]
                if unit != 0.0:
                    for i in range(poses):
                        rows[k, t, i] += unit * adjugates[k, j, i] * scales[i]


@inlined
def worst_into(
    cofactors: Floats,
    inverses: Floats,
    rates: Floats,
    k: int,
    translations: int,
    force: float,
    moment: float,
    known: Floats,
    loaded: bool,
    sums: Floats,
    efforts: Floats,
) -> None:
    """Write the greatest efforts of drive k, shape (poses,): F |a| + M |b| + |known|; NaN: none.

    The motion's twists are orthonormal, so the force and the moment part of a row of J^-T are as
    large as its cofactors of translations and of turns say; `known` is in the same coordinates.
    `inverses` are those of the determinants; `loaded` says whether there is any known load.
    """
    size, count = known.shape
    for i in range(count):
        sums[0, i] = 0.0
        sums[1, i] = 0.0
        sums[2, i] = 0.0
    for j in range(size):
        part = 0 if j < translations else 1
        for i in range(count):
            sums[part, i] += cofactors[k, j, i] * cofactors[k, j, i]
    if loaded:
        for j in range(size):
            for i in range(count):
                sums[2, i] += cofactors[k, j, i] * known[j, i]
    for i in range(count):
        sizes = force * math.sqrt(sums[0, i]) + moment * math.sqrt(sums[1, i])
        effort = abs(rates[k, i] * inverses[i]) * (sizes + abs(sums[2, i]))
        efforts[i] = effort if effort < math.inf else math.nan


@kernel
def worst_efforts(
    cofactors: Floats,
    determinants: Floats,
    rates: Floats,
    translations: int,
    force: float,
    moment: float,
    known: Floats,
) -> Floats:
    """Return the greatest efforts, shape (drives, poses), of ready cofactors (see worst_into)."""
    efforts = np.empty_like(rates)
    sums, inverses = np.empty((3, determinants.size)), np.empty(determinants.size)
    loaded = bool(np.any(known))
    invert(determinants, inverses)
    for k in range(rates.shape[0]):
        worst_into(
            cofactors,
            inverses,
            rates,
            k,
            translations,
            force,
            moment,
            known,
            loaded,
            sums,
            efforts[k],
        )
    return efforts


@kernel
def known_efforts(cofactors: Floats, determinants: Floats, rates: Floats, known: Floats) -> Floats:
    """Return the signed efforts -J^-T P, shape (drives, poses), of loads (coordinates, poses)."""
    signed = np.zeros_like(rates)
    inverses = np.empty(determinants.size)
    invert(determinants, inverses)
    for k in range(rates.shape[0]):
        for j in range(known.shape[0]):
            for i in range(determinants.size):
                signed[k, i] -= cofactors[k, j, i] * known[j, i]
        for i in range(determinants.size):
            signed[k, i] *= rates[k, i] * inverses[i]
            if not abs(signed[k, i]) < math.inf:
                signed[k, i] = math.nan
    return signed
