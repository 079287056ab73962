"""Assembly modes of platforms that turn about a fixed point."""

import math

import numpy as np
import pytest

from mechanics.families.spherical_3rrr import spherical_3rrr
from mechanics.mechanism import Mechanism
from mechanics.motions import SPHERICAL
from tests.mechanics.braced import gap, held, modes_of, on_struts, places
from tests.oracles import legs
from tests.oracles.assembly import Rods, newton_from_everywhere, rods

CONE = math.acos(1.0 / math.sqrt(3.0))
EYE = {"proximal_arc": math.pi / 2, "distal_arc": math.pi / 2}
EYE |= {"base_cone": CONE, "platform_cone": CONE}


def eye() -> Mechanism:
    limits = np.array([[-np.inf, np.inf]] * 3)
    return spherical_3rrr(**EYE, limits=limits, working_mode=np.ones(3))


def trivial() -> list[legs.Floats]:
    """Return the orientations that the agile eye has at any drives: half turns about its axes."""
    machine = legs.read({"kind": "spherical_3rrr", **EYE})
    halves = [legs.angles_of(legs.about(leg.axis, math.pi)) for leg in machine.legs]
    return [np.zeros(3), *halves]


@pytest.mark.parametrize("turn", [120.0, -120.0])
def test_the_agile_eye_has_eight_modes_at_home(turn: float) -> None:
    home = [0.0, 0.0, math.radians(turn)]
    found = modes_of(eye(), held(eye(), home)[0])
    assert len(found.modes) == 8
    assert found.certified
    for pose in (np.array(home), *trivial()):
        assert gap(eye(), found.modes, pose) < 1e-13
    assert [round(mode.determinant, 12) for mode in found.modes] == [1.0] * 4 + [-1.0] * 4


def test_four_modes_of_the_agile_eye_do_not_depend_on_the_drives() -> None:
    for drives in np.random.default_rng(1).uniform(-3.0, 3.0, (20, 3)):
        found = modes_of(eye(), drives)
        assert len(found.modes) == 8
        assert max(gap(eye(), found.modes, pose) for pose in trivial()) < 1e-12


@pytest.mark.parametrize("angle", [0.0, math.pi])
def test_the_modes_of_the_agile_eye_meet_in_pairs(angle: float) -> None:
    """At equal drives of 0 or pi the four others are the four that never move."""
    found = modes_of(eye(), [angle] * 3)
    assert len(found.modes) == 4
    assert max(gap(eye(), found.modes, pose) for pose in trivial()) < 1e-6
    assert max(abs(mode.determinant) for mode in found.modes) < 1e-6


@pytest.mark.parametrize("seed", range(6))
def test_modes_of_arcs_are_those_that_many_starts_lead_to(seed: int) -> None:
    random = np.random.default_rng(seed)
    angles = {"base_cone": 0.95, "platform_cone": 1.9, "proximal_arc": 1.3, "distal_arc": 1.3}
    limits = np.array([[-np.inf, np.inf]] * 3)
    mechanism = spherical_3rrr(**angles, limits=limits, working_mode=np.ones(3))
    drives = random.uniform(-3.0, 3.0, 3)
    machine = legs.read({"kind": "spherical_3rrr", **angles})
    seen = newton_from_everywhere(rods(machine, drives), random, 400)
    _compare(mechanism, drives, seen)


@pytest.mark.parametrize("seed", range(6))
def test_modes_of_struts_are_those_that_many_starts_lead_to(seed: int) -> None:
    random = np.random.default_rng(seed)
    base, platform = random.uniform(-1.0, 1.0, (3, 3)), random.uniform(-0.8, 0.8, (3, 3))
    if seed == 0:
        platform[1] = platform[0]
    if seed == 1:
        platform[1] = 2.0 * platform[0]
    mechanism = on_struts(SPHERICAL, base, platform)
    (lengths,) = held(mechanism, random.uniform(-1.5, 1.5, 3))
    of = Rods(base, platform, lengths, SPHERICAL.twists)
    seen = newton_from_everywhere(of, random, 400)
    assert seen
    _compare(mechanism, lengths, seen)


def _compare(mechanism: Mechanism, drives: legs.Floats, seen: list[legs.Floats]) -> None:
    found = modes_of(mechanism, drives)
    assert len(found.modes) == len(seen)
    for place in seen:
        here = places(mechanism, np.array([mode.pose for mode in found.modes]))
        assert np.abs(here - place).max(axis=1).min() < 1e-6


@pytest.mark.parametrize("seed", range(10))
def test_a_double_mode_is_one_of_determinant_0(seed: int) -> None:
    """The third strut's plane through the centre shares the line of the other two's."""
    random = np.random.default_rng(seed)
    base, platform = random.uniform(-1.0, 1.0, (2, 3, 3))
    pose = random.uniform(-1.5, 1.5, 3)
    _, rotation = legs.place(legs.Machine("spherical", (), legs.Z), pose)
    ends = platform @ rotation.T
    first, second = np.cross(base[:2], ends[:2])
    normal = (ends[2] @ second) * first - (ends[2] @ first) * second
    base[2] = np.cross(ends[2], normal) + 0.3 * ends[2]
    mechanism = on_struts(SPHERICAL, base, platform)
    found = modes_of(mechanism, held(mechanism, pose)[0])
    near = [mode for mode in found.modes if gap(mechanism, (mode,), pose) < 1e-3]
    assert len(near) == 1
    assert gap(mechanism, (near[0],), pose) < 1e-6
    assert abs(near[0].determinant) < 1e-6


def test_a_leg_that_ends_in_the_centre_holds_nothing() -> None:
    mechanism = on_struts(SPHERICAL, np.eye(3), [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    assert not modes_of(mechanism, [1.0, 1.2, 1.1]).certified
