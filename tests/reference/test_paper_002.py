"""Glazunov et al., ch. 4: one step of the screw iteration as printed, and where it ends."""

import numpy as np
import pytest

from mechanics.configuration import Configuration
from mechanics.forward import assembly_modes, nearby_modes
from mechanics.mechanism import Mechanism
from mechanics.motions import SPATIAL
from tests.mechanics.braced import on_struts
from tests.oracles.legs import Floats

JOINTS = np.array([[0.0, 1.0, 0.0]] * 3 + [[1.0, 0.0, 0.0]] * 2 + [[-1.0, 0.0, 0.0]])
DIRECTIONS = np.array(
    [[0, -1, 0], [1, 0, 0], [0, 0, 1], [0, 0, 1], [-1, 0, 0], [0, 0, 1]], dtype=float
)
LENGTHS = 2.0 + np.array([0.1, 0.1, 0.1, 0.0, 0.0, 0.1])
FEET = JOINTS - 2.0 * DIRECTIONS
START = np.zeros((1, 6))


def mechanism() -> Mechanism:
    return on_struts(SPATIAL, FEET, JOINTS)


def one_step() -> tuple[Floats, Floats]:
    """Return v and the turn of one step, which the product carries out as a finite turn."""
    (found,) = nearby_modes(mechanism(), LENGTHS[None], START, iterations=1)
    _, rotation = SPATIAL.place(found.mode.pose[:, None])
    turn = rotation.reshape(3, 3)
    sine = 0.5 * np.array(
        [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
    )
    size = float(np.linalg.norm(sine))
    return found.mode.pose[:3], sine / size * np.arcsin(size)


def test_the_screw_of_the_first_step() -> None:
    v, omega = one_step()
    np.testing.assert_allclose(v, [0.0, -0.1, 0.05], atol=1e-15)
    np.testing.assert_allclose(omega, [0.05, 0.05, -0.1], atol=1e-15)


@pytest.mark.parametrize(
    ("leg", "expected", "residual"),
    [(0, [0.1, 0.9, 0.1], 0.0048), (3, [1.0, -0.2, 0.0], 0.01), (5, [-1.0, 0.0, 0.1], 0.0)],
)
def test_the_joints_after_the_first_step(leg: int, expected: list[float], residual: float) -> None:
    """Moved by v + omega x P as the paper does; it prints P1 with z = -0.1, against its screw."""
    v, omega = one_step()
    joint = JOINTS[leg] + v + np.cross(omega, JOINTS[leg])
    np.testing.assert_allclose(joint, expected, atol=1e-15)
    for strut in np.flatnonzero(np.all(JOINTS[leg] == JOINTS, axis=1)):
        length = float(np.linalg.norm(joint - FEET[strut]))
        assert length - LENGTHS[strut] == pytest.approx(residual, abs=5e-5)


def test_the_determinant_at_the_start() -> None:
    block = Configuration(mechanism(), np.zeros((6, 1)))
    assert block.determinants[0] == pytest.approx(-2.0, abs=1e-15)


def test_the_iteration_ends_at_one_of_the_modes() -> None:
    (found,) = nearby_modes(mechanism(), LENGTHS[None], START)
    assert found.converged
    (assembly,) = assembly_modes(mechanism(), LENGTHS[None])
    assert assembly.route == "tetrahedra"
    gaps = [np.abs(mode.pose - found.mode.pose).max() for mode in assembly.modes]
    assert sorted(gaps)[0] < 1e-14
    assert sorted(gaps)[1] > 0.1
