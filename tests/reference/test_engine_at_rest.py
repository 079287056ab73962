"""Assembly modes against an independent multibody engine, started at places near them.

The engine closes the joints by itself; where its platform comes to rest must be one of the modes.
"""

from zlib import crc32

import numpy as np
import pytest

from mechanics.forward import assembly_modes
from tests.mechanics.braced import places
from tests.oracles.draws import DRAWS
from tests.oracles.machines import Floats, machine
from tests.oracles.settling import rest
from tests.reference.test_independent_engine import mechanism_of, samples

AWAY = 0.02
"""How far the starts are from the poses that gave the drives. [m and rad]"""

AGREEMENT = 1e-9
"""The engine's own iteration ends at relative errors of 1e-12."""

SPATIAL = ("gough_stewart", "hexa_linear", "hexa_rotary", "custom_spatial")


@pytest.mark.parametrize("name", [name for name in DRAWS if name not in SPATIAL])
def test_the_engine_comes_to_rest_at_a_mode(name: str) -> None:
    random = np.random.default_rng(crc32(name.encode()))
    for sample in samples(name)[:5]:
        mechanism, body = mechanism_of(sample.wire), machine(sample.wire)
        found = assembly_modes(mechanism, sample.actuators)
        for pose, drives, assembly in zip(sample.poses, sample.actuators, found, strict=True):
            start: Floats = pose + random.uniform(-AWAY, AWAY, pose.size)
            here = places(mechanism, np.array([mode.pose for mode in assembly.modes]))
            away = np.abs(here - rest(body, start, drives)).max(axis=1)
            assert away.min() < AGREEMENT
