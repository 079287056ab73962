"""Many rows of drive coordinates in one question."""

import numpy as np
import pytest

from mechanics.errors import ActuatorsError
from mechanics.forward import IMPOSSIBLE, assembly_modes
from mechanics.motions import PLANAR_TRANSLATION, SPATIAL
from tests.mechanics.braced import held, on_struts
from tests.oracles.legs import Floats

BAR = on_struts(PLANAR_TRANSLATION, [[0.0, 0.0], [3.0, 0.0]], np.zeros((2, 2)))


def test_no_row_has_no_answer() -> None:
    assert list(assembly_modes(BAR, np.empty((0, 2)))) == []


def test_rows_that_cannot_be_stand_among_others() -> None:
    rows = np.array([[4.0, 5.0], [-1.0, 5.0], [9.0, 2.0], [3.0, np.nan], [2.0, 2.0]])
    found = assembly_modes(BAR, rows)
    assert [len(one.modes) for one in found] == [2, 0, 0, 0, 2]
    assert [one.route == IMPOSSIBLE for one in found] == [False, True, False, True, False]


def test_all_rows_may_be_impossible() -> None:
    assert [one.route for one in assembly_modes(BAR, np.zeros((2, 2)))] == [IMPOSSIBLE] * 2


def test_many_thousand_rows_are_each_answered_in_place() -> None:
    heights = np.linspace(0.1, 4.0, 5000)
    rows = held(BAR, *np.column_stack([np.ones_like(heights), heights]))
    for one, height in zip(assembly_modes(BAR, rows), heights, strict=True):
        np.testing.assert_allclose(sorted(mode.pose[1] for mode in one.modes), [-height, height])


def test_six_rods_without_structure_take_their_own_route() -> None:
    base, platform = np.random.default_rng(0).uniform(-1.0, 1.0, (2, 6, 3))
    mechanism = on_struts(SPATIAL, base, 0.5 * platform)
    poses: Floats = np.array([[0.1, 0.2, 1.0, 0.1, -0.2, 0.3], [0.0, 0.1, 0.9, 0.4, 0.2, -0.3]])
    rows = held(mechanism, *poses)
    for one, pose in zip(assembly_modes(mechanism, rows), poses, strict=True):
        assert one.certified
        assert one.route == "homotopy"
        assert min(np.abs(mode.pose - pose).max() for mode in one.modes) < 1e-12
        assert sum(np.sign(mode.determinant) for mode in one.modes) == 0


@pytest.mark.parametrize("shape", [(1, 3), (2,), (1, 1)])
def test_actuators_of_another_shape_are_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(ActuatorsError, match=r"shape \(rows, 2\)"):
        assembly_modes(BAR, np.ones(shape))
