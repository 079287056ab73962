"""Coordinates read back from rotation matrices, and finite turns put on top of poses."""

import numpy as np
import pytest

from mechanics.motions import PLANAR, PLANAR_TRANSLATION, SPATIAL, SPHERICAL, Motion, schoenflies
from mechanics.rotations import (
    about,
    coordinates,
    fixed_axis_angles,
    move,
    principal_angles,
    product,
    wrapped,
)
from tests.oracles import legs

TILTED = schoenflies(np.array([1.0, -2.0, 0.5]))


@pytest.mark.parametrize("motion", [PLANAR_TRANSLATION, PLANAR, TILTED, SPHERICAL, SPATIAL])
def test_coordinates_are_read_back(motion: Motion) -> None:
    random = np.random.default_rng(0)
    poses = random.uniform(-1.5, 1.5, (len(motion.coordinates), 50))
    np.testing.assert_allclose(coordinates(motion, *motion.place(poses)), poses, atol=1e-14)


@pytest.mark.parametrize("tilt", [np.pi / 2, -np.pi / 2, np.pi / 2 - 1e-9, 1e-8 - np.pi / 2])
def test_nothing_is_lost_where_two_axes_are_one(tilt: float) -> None:
    rotation = legs.about(legs.Z, 0.7) @ legs.about(legs.Y, tilt) @ legs.about(legs.X, -1.1)
    angles = fixed_axis_angles(rotation.reshape(9, 1))
    _, again = SPHERICAL.place(angles)
    np.testing.assert_allclose(again[:, 0], rotation.ravel(), atol=2e-15)


@pytest.mark.parametrize("size", [0.0, 1e-12, 1e-4, 1.0, 3.0])
def test_turns_about_vectors(size: float) -> None:
    axis = legs.unit([1.0, 2.0, -2.0])
    turned = about((size * axis)[:, None])[:, 0]
    np.testing.assert_allclose(turned, legs.about(axis, size).ravel(), atol=1e-15)


def test_products_of_rotations() -> None:
    first, second = legs.about(legs.X, 0.3), legs.about(legs.Y, -0.8)
    found = product(first.reshape(9, 1), second.reshape(9, 1))
    np.testing.assert_allclose(found[:, 0], (first @ second).ravel(), atol=1e-16)


def test_a_step_turns_on_top_of_the_pose() -> None:
    pose, step = (
        np.array([1.0, 2.0, 3.0, 0.4, -0.5, 0.6]),
        np.array([0.1, 0.2, 0.3, 0.7, 0.1, -0.2]),
    )
    moved = move(SPATIAL, pose[:, None], step[:, None])
    angle = float(np.linalg.norm(step[3:]))
    _, before = legs.place(legs.Machine("spatial", (), legs.Z), pose)
    _, after = SPATIAL.place(moved)
    expected = legs.about(step[3:] / angle, angle) @ before
    np.testing.assert_allclose(moved[:3, 0], pose[:3] + step[:3], atol=1e-15)
    np.testing.assert_allclose(after[:, 0], expected.ravel(), atol=1e-15)


def test_principal_angles_are_those_of_the_rotation() -> None:
    random = np.random.default_rng(1)
    angles = random.uniform(-12.0, 12.0, (3, 500))
    _, rotations = SPHERICAL.place(angles)
    np.testing.assert_allclose(principal_angles(angles), fixed_axis_angles(rotations), atol=1e-12)


def test_principal_angles_are_left_as_they_are() -> None:
    angles = np.array([[np.pi, -0.1, 3.1], [0.5 * np.pi, -0.5 * np.pi, 0.2], [0.3, np.pi, -3.0]])
    assert np.array_equal(principal_angles(angles), angles)


def test_angles_of_one_turn() -> None:
    given = np.array([-np.pi, np.pi, 0.3, -0.3, 7.0, -7.0])
    expected = [np.pi, np.pi, 0.3, -0.3, 7.0 - 2.0 * np.pi, 2.0 * np.pi - 7.0]
    np.testing.assert_array_equal(wrapped(given), expected)
