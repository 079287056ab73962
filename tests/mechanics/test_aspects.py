"""Whether a guess has left its mode: where it can be told, and where it cannot."""

from collections import Counter

import numpy as np
import pytest

from mechanics.forward import nearby_modes
from mechanics.motions import PLANAR_TRANSLATION
from tests.mechanics.braced import held, on_struts
from tests.mechanics.platforms import hexapod
from tests.oracles.rods import Floats, rotations

BAR = on_struts(PLANAR_TRANSLATION, [[0.0, 0.0], [3.0, 0.0]], np.zeros((2, 2)))
HEXAPOD = hexapod()
POSE = np.array([0.05, -0.1, 0.6, 0.2, -0.1, 0.3])


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_guess_beside_a_mode_has_not_left_it(side: float) -> None:
    (found,) = nearby_modes(BAR, np.array([[4.0, 5.0]]), np.array([[0.5, side]]))
    assert found.left is False


def test_a_singular_guess_has_no_mode_to_leave() -> None:
    (found,) = nearby_modes(BAR, np.array([[2.0, 2.0]]), np.array([[1.5, 1e-12]]))
    assert found.converged
    assert found.left is None


def test_a_double_mode_is_on_no_side() -> None:
    """The struts lie in one line, 1 + 2 = 3 m; the iteration halves its error at each step."""
    found = nearby_modes(BAR, np.array([[1.0, 2.0]]), np.array([[1.0, 1e-3]]))
    assert found[0].left is None


def test_what_did_not_converge_or_cannot_be_is_not_told() -> None:
    rows = np.array([[1.0, 1.0], [np.nan, 5.0], [4.0, 5.0]])
    found = nearby_modes(BAR, rows, np.tile([1.0, 0.5], (3, 1)))
    assert [one.left for one in found] == [None, None, False]


def test_guesses_of_a_hexapod_on_the_other_side_are_marked() -> None:
    """Struts reach anywhere: left is what has another sign of det Jx at its two ends."""
    random = np.random.default_rng(0)
    low, high = [-0.3, -0.3, -0.9, -1.5, -1.5, -1.5], [0.3, 0.3, 0.9, 1.5, 1.5, 1.5]
    guesses = random.uniform(low, high, (400, 6))
    seen: Counter[bool | None] = Counter()
    found = nearby_modes(HEXAPOD, np.repeat(held(HEXAPOD, POSE), 400, axis=0), guesses)
    for guess, one in zip(guesses, found, strict=True):
        before, after = determinant(guess), determinant(one.mode.pose)
        if one.converged and min(abs(before), abs(after)) > 1e-4:
            assert one.left is (before * after < 0.0)
            seen[one.left] += 1
    assert seen[True] > 10
    assert seen[False] > 100


def determinant(pose: Floats) -> float:
    half = 0.5 * pose[3:]
    turns = [[np.cos(h), *(np.sin(h) * axis)] for h, axis in zip(half, np.eye(3), strict=True)]
    x, y, z = rotations(np.array(turns))
    arms = HEXAPOD.legs.platform_point @ (z @ y @ x).T
    rods = pose[:3] + arms - HEXAPOD.legs.base_point
    rods /= np.linalg.norm(rods, axis=1, keepdims=True)
    return float(np.linalg.det(np.hstack([rods, np.cross(arms, rods)])))
