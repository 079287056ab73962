"""Where a platform is at a pose, and which twists it can follow."""

import math

import numpy as np
import pytest

from mechanics.motions import PLANAR, PLANAR_TRANSLATION, Motion


def test_coordinates_of_the_five_bar() -> None:
    assert PLANAR_TRANSLATION.coordinates == ("x", "y")


def test_coordinates_of_the_3rrr() -> None:
    assert PLANAR.coordinates == ("x", "y", "phi")


def test_what_turns_and_what_moves() -> None:
    assert (tuple(PLANAR.translations), tuple(PLANAR.turns)) == (("x", "y"), ("phi",))


def test_nothing_of_the_five_bar_turns() -> None:
    assert tuple(PLANAR_TRANSLATION.turns) == ()


@pytest.mark.parametrize("motion", [PLANAR_TRANSLATION, PLANAR])
def test_unit_twists_move_the_point_first(motion: Motion) -> None:
    expected = np.eye(6)[:, [0, 1, 5][: len(motion.coordinates)]]
    np.testing.assert_array_equal(motion.twists, expected)


def test_position_is_the_first_coordinates() -> None:
    positions, _ = PLANAR.place(np.array([[1.0], [2.0], [0.7]]))
    np.testing.assert_array_equal(positions[:, 0], [1.0, 2.0, 0.0])


def test_rotation_turns_x_towards_y() -> None:
    _, rotations = PLANAR.place(np.array([[0.0], [0.0], [0.3]]))
    c, s = math.cos(0.3), math.sin(0.3)
    expected = [c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0]
    np.testing.assert_allclose(rotations[:, 0], expected, atol=1e-16)


def test_a_platform_that_cannot_turn_keeps_its_rotation() -> None:
    _, rotations = PLANAR_TRANSLATION.place(np.array([[3.0, 4.0], [5.0, 6.0]]))
    np.testing.assert_array_equal(rotations, np.repeat(np.eye(3).reshape(9, 1), 2, axis=1))
