"""Assembly modes of platforms with three translations and one turn."""

import numpy as np
import pytest

from mechanics.motions import schoenflies
from tests.mechanics.braced import gap, held, modes_of, on_struts, places
from tests.oracles.assembly import Rods, newton_from_everywhere

UP = schoenflies(np.array([0.0, 0.0, 1.0]))
SQUARE = np.array([[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [1.0, -1.0, 0.0]])
POSE = [0.1, 0.2, 0.9, 0.4]


@pytest.mark.parametrize("seed", range(8))
def test_modes_are_those_that_many_starts_lead_to(seed: int) -> None:
    random = np.random.default_rng(seed)
    motion = schoenflies(random.normal(size=3))
    base, platform = random.uniform(-1.0, 1.0, (4, 3)), random.uniform(-0.8, 0.8, (4, 3))
    if seed % 2:
        base[:, 2] = platform[:, 2] = 0.0
    mechanism = on_struts(motion, base, platform)
    (lengths,) = held(mechanism, random.uniform(-0.7, 0.7, 4))
    found = modes_of(mechanism, lengths)
    seen = newton_from_everywhere(Rods(base, platform, lengths, motion.twists), random, 400)
    here = places(mechanism, np.array([mode.pose for mode in found.modes]))
    assert len(here) == len(seen) > 0
    for place in seen:
        assert np.abs(here - place).max(axis=1).min() < 1e-6


@pytest.mark.parametrize(("together", "count"), [((0, 1), 4), ((0, 1, 2), 4)])
def test_joints_that_coincide(together: tuple[int, ...], count: int) -> None:
    """The linear system is singular at an angle, or at every angle."""
    random = np.random.default_rng(3)
    base, platform = random.uniform(-1.0, 1.0, (4, 3)), random.uniform(-0.5, 0.5, (4, 3))
    platform[list(together)] = platform[0]
    mechanism = on_struts(UP, base, platform)
    (lengths,) = held(mechanism, POSE)
    found = modes_of(mechanism, lengths)
    seen = newton_from_everywhere(Rods(base, platform, lengths, UP.twists), random, 400)
    assert len(found.modes) == len(seen) == count
    assert gap(mechanism, found.modes, POSE) < 1e-12


def test_similar_squares_are_not_certified() -> None:
    """The differences of opposite legs' equations agree: the platform is never held."""
    mechanism = on_struts(UP, SQUARE, 0.5 * SQUARE)
    assert not modes_of(mechanism, held(mechanism, POSE)[0]).certified
