"""Newton's iteration from a guess: where it leads, how fast, and that it says so if nowhere."""

import numpy as np
import pytest

from mechanics.errors import ActuatorsError, PoseError
from mechanics.forward import nearby_modes
from mechanics.motions import PLANAR_TRANSLATION
from tests.mechanics.braced import held, on_struts
from tests.mechanics.platforms import hexapod

BAR = on_struts(PLANAR_TRANSLATION, [[0.0, 0.0], [3.0, 0.0]], np.zeros((2, 2)))
HEXAPOD = hexapod()
POSE = np.array([0.05, -0.1, 0.6, 0.2, -0.1, 0.3])


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_mode_on_the_side_of_the_guess(side: float) -> None:
    (found,) = nearby_modes(BAR, np.array([[4.0, 5.0]]), np.array([[0.5, side]]))
    assert found.converged
    np.testing.assert_allclose(found.mode.pose, [0.0, 4.0 * side], atol=1e-14)


def test_the_error_is_squared_by_every_step() -> None:
    lengths = held(HEXAPOD, POSE)
    guess = POSE[None] + 0.01
    errors = [
        np.abs(nearby_modes(HEXAPOD, lengths, guess, count)[0].mode.pose - POSE).max()
        for count in range(4)
    ]
    assert errors[0] == pytest.approx(0.01)
    assert errors[1] < 5.0 * errors[0] ** 2
    assert errors[2] < 5.0 * errors[1] ** 2
    assert errors[3] < 1e-14


def test_a_guess_far_off_and_turned_leads_to_a_mode() -> None:
    """Full steps alone would leave: they are shortened."""
    lengths = held(HEXAPOD, POSE)
    (found,) = nearby_modes(HEXAPOD, lengths, np.array([[0.8, 0.4, 1.5, 1.0, 0.5, -0.5]]))
    assert found.converged
    np.testing.assert_allclose(held(HEXAPOD, found.mode.pose), lengths, atol=1e-13)


def test_out_of_reach_is_not_converged() -> None:
    """The two struts lack 1 m, of the 3 m between their feet."""
    (found,) = nearby_modes(BAR, np.array([[1.0, 1.0]]), np.array([[1.0, 0.5]]))
    assert not found.converged
    assert 0.5 / 3.0 <= found.mode.residual < 0.2


def test_too_few_steps_are_not_converged() -> None:
    (found,) = nearby_modes(BAR, np.array([[4.0, 5.0]]), np.array([[0.5, 1.0]]), iterations=1)
    assert (found.converged, found.iterations) == (False, 1)


@pytest.mark.parametrize("length", [0.0, -1.0, np.nan, np.inf])
def test_impossible_drives_are_not_converged(length: float) -> None:
    found = nearby_modes(BAR, np.array([[length, 5.0], [4.0, 5.0]]), np.ones((2, 2)))
    assert [one.converged for one in found] == [False, True]


def test_a_guess_does_not_depend_on_its_company() -> None:
    poses = POSE + np.random.default_rng(0).uniform(-0.1, 0.1, (50, 6))
    lengths, guesses = held(HEXAPOD, *poses), poses + 0.05
    together = nearby_modes(HEXAPOD, lengths, guesses)
    assert all(one.converged for one in together)
    for one, row, guess in zip(together, lengths, guesses, strict=True):
        (alone,) = nearby_modes(HEXAPOD, row[None], guess[None])
        np.testing.assert_array_equal(alone.mode.pose, one.mode.pose)


def test_an_exact_guess_takes_no_step() -> None:
    (found,) = nearby_modes(BAR, np.array([[4.0, 5.0]]), np.array([[0.0, 4.0]]))
    assert (found.converged, found.iterations) == (True, 0)


def test_a_singular_guess_is_left() -> None:
    """Both struts lie in one line there, and the linear system says nothing across it."""
    (found,) = nearby_modes(BAR, np.array([[2.0, 2.0]]), np.array([[1.5, 1e-12]]))
    assert found.converged


@pytest.mark.parametrize("shape", [(1, 3), (2,), (1, 1)])
def test_actuators_of_another_shape_are_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(ActuatorsError, match=r"shape \(rows, 2\)"):
        nearby_modes(BAR, np.ones(shape), np.ones((1, 2)))


def test_guesses_of_another_shape_are_refused() -> None:
    with pytest.raises(PoseError):
        nearby_modes(BAR, np.ones((1, 2)), np.ones((1, 3)))
    with pytest.raises(ActuatorsError, match=r"shape \(3, 2\)"):
        nearby_modes(BAR, np.ones((1, 2)), np.ones((3, 2)))
