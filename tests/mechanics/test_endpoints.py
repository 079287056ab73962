"""What ends of paths are taken for: none may hide that a real mode is without its path."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import pytest

from mechanics.assembly.normal_form import normal_form
from mechanics.assembly.rods import Rods
from mechanics.assembly.starts import PATHS, stored
from mechanics.kernels.endpoints import classify, e_times_e, from_frames
from mechanics.kernels.homotopy import track
from mechanics.kernels.path_steps import ARRIVED, AT_INFINITY, CAREFUL, LOST
from mechanics.kernels.quadrics import in_all_frames
from tests.oracles import rods

Complexes = npt.NDArray[np.complex128]
Integers = npt.NDArray[np.int64]

REAL, SMALL, SMALL_PARTNER, FAR, FAR_PARTNER = 0, 2, 3, 4, 5
"""Rows of `ends`: two real ones, a conjugate pair with |h| = 0.02, and one with |h| = 0.6."""


class Followed(NamedTuple):
    solutions: Complexes
    outcomes: Integers


def with_size(h: float, random: np.random.Generator) -> Complexes:
    """Return a solution whose e, of length 1, has |e.e| = h."""
    a, b = np.linalg.qr(random.normal(size=(4, 2)))[0].T
    e = np.sqrt(0.5 * (1.0 + h)) * a + 1j * np.sqrt(0.5 * (1.0 - h)) * b
    rest = random.normal(size=(2, 2))
    solution: Complexes = np.r_[e, rest[0] + 1j * rest[1]]
    return solution


def ends() -> Followed:
    """Return ends that add up: real ones, conjugate pairs, and a pair that was given up."""
    random = np.random.default_rng(0)
    solutions = [with_size(1.0, random).real.astype(complex) for _ in range(2)]
    for h in (0.02, 0.6, 1e-9):
        one = with_size(h, random)
        solutions += [one, one.conj()]
    outcomes = np.full(len(solutions), ARRIVED)
    outcomes[-2:] = AT_INFINITY
    return Followed(np.array(solutions), outcomes)


def doubted(of: Followed, final: bool = False) -> list[int]:
    doubtful, _, _, _ = classify(of.solutions, of.outcomes, 1e-6, final)
    return np.flatnonzero(doubtful).tolist()


@pytest.mark.parametrize("final", [False, True])
def test_ends_that_add_up_are_not_doubted(final: bool) -> None:
    assert doubted(ends(), final) == []


@pytest.mark.parametrize("final", [False, True])
@pytest.mark.parametrize(("lone", "partner"), [(SMALL, SMALL_PARTNER), (FAR, FAR_PARTNER)])
def test_an_end_without_its_conjugate_is_doubted_though_a_path_was_given_up(
    lone: int, partner: int, final: bool
) -> None:
    """Its path may have left that of a real mode, whose other path went to infinity."""
    of = ends()
    of.solutions[partner] = of.solutions[-1]
    of.outcomes[partner] = AT_INFINITY
    assert lone in doubted(of, final)


@pytest.mark.parametrize("final", [False, True])
def test_an_odd_number_of_real_modes_is_doubted(final: bool) -> None:
    of = ends()
    of.outcomes[REAL] = AT_INFINITY
    assert REAL in doubted(of, final)


def test_ends_that_fell_together_are_doubted_at_infinity_too() -> None:
    of = ends()
    of.outcomes[-2:] = ARRIVED
    of.solutions[-1] = of.solutions[-2]
    assert doubted(of) == [len(of.outcomes) - 2, len(of.outcomes) - 1]
    assert doubted(of, final=True) == []


def test_a_lost_path_is_doubted() -> None:
    of = ends()
    of.outcomes[FAR:] = LOST
    assert doubted(of) == [4, 5, 6, 7]


def followed(kind: str) -> Followed:
    """Return where the paths end that lead to a random platform."""
    of, start = rods.draw(kind, np.random.default_rng(3)), stored()[0]
    form = normal_form(Rods(of.base, of.platform, of.lengths))
    points, frames = np.empty_like(start.points), np.empty_like(start.frames)
    outcomes = np.empty(PATHS, dtype=np.int64)
    given = (start.coefficients, in_all_frames(form.coefficients), start.points, start.frames)
    track(*given, np.arange(PATHS), CAREFUL, points, frames, outcomes)
    return Followed(from_frames(points, frames), outcomes)


# Faugere, Lazard, 1995, The combinatorial classes of parallel manipulators, Mechanism and Machine
# Theory 30, pp. 765-776.
FINITE = {"general": 40, "planar": 40, "6-4": 32, "6-3": 16, "4-4": 16, "3-3": 16}


@pytest.mark.parametrize("kind", list(FINITE))
def test_the_paths_to_poses_are_as_many_as_the_class_has_modes(kind: str) -> None:
    of = followed(kind)
    sizes = np.array([abs(e_times_e(solution)) for solution in of.solutions])
    assert np.count_nonzero((of.outcomes == ARRIVED) & (sizes > 1e-7)) == FINITE[kind]
    assert doubted(of, final=True) == []


@pytest.mark.parametrize("kind", list(FINITE))
def test_no_real_mode_can_be_given_up_unseen(kind: str) -> None:
    of = followed(kind)
    real = classify(of.solutions, of.outcomes, 1e-6, True)[2]
    assert real.any()
    for k in np.flatnonzero(real):
        outcomes = of.outcomes.copy()
        outcomes[k] = AT_INFINITY
        assert k in doubted(of._replace(outcomes=outcomes), final=True)
