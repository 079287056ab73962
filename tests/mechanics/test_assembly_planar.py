"""Assembly modes of three legs in the plane: their number, double ones, and degenerate shapes."""

import numpy as np
import pytest

from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.mechanism import Mechanism
from mechanics.motions import PLANAR
from tests.mechanics.braced import gap, held, modes_of, on_struts
from tests.oracles import legs
from tests.oracles.assembly import Rods, count_by_scan, rods

TRIANGLE = np.array([[0.0, 0.0], [1.0, 0.0], [0.4, 0.8]])
MIRRORED = TRIANGLE * [1.0, -1.0]
LINE = np.array([[0.0, 0.0], [1.0, 0.0], [3.0, 0.0]])
POSE = [0.3, 0.5, 0.7]

DIMENSIONS = {"base_side": 0.4, "platform_radius": 0.08, "crank_length": 0.18, "rod_length": 0.18}
SIX = [-2.7, 0.9, 2.2]
TWO = [-2.3, 1.0, 0.9]
NONE = [np.pi / 2, np.radians(210.0), np.radians(330.0)]


def paper_000() -> Mechanism:
    limits = np.array([[-np.inf, np.inf]] * 3)
    return planar_3rrr(**DIMENSIONS, limits=limits, working_mode=np.ones(3))


def scanned(actuators: list[float]) -> int:
    machine = legs.read({"kind": "planar_3rrr", **DIMENSIONS})
    return count_by_scan(rods(machine, np.array(actuators)))


@pytest.mark.parametrize(("actuators", "count"), [(SIX, 6), (TWO, 2), (NONE, 0)])
def test_as_many_modes_as_a_scan_sees(actuators: list[float], count: int) -> None:
    found = modes_of(paper_000(), actuators)
    assert len(found.modes) == scanned(actuators) == count
    assert found.certified


def test_random_drives_have_as_many_modes_as_a_scan_sees() -> None:
    random = np.random.default_rng(4)
    counts = []
    for actuators in random.uniform(-3.0, 3.0, (60, 3)):
        counts.append(len(modes_of(paper_000(), actuators).modes))
        assert counts[-1] == scanned(actuators)
    assert set(counts) == {0, 2, 4, 6}


@pytest.mark.parametrize(
    ("base", "platform", "count"),
    [
        (TRIANGLE, MIRRORED, 6),  # the linear system is singular at every angle
        (LINE, 0.5 * LINE, 4),  # likewise
        (LINE, LINE[:, ::-1], 4),
        (TRIANGLE, 0.5 * TRIANGLE, 4),
        (TRIANGLE, TRIANGLE, 4),
        (TRIANGLE, [[0.0, 0.0], [0.0, 0.0], [0.2, 0.4]], 2),
        ([[0.0, 0.0], [0.0, 0.0], [1.0, 0.0]], [[0.0, 0.0], [0.3, 0.0], [0.2, 0.4]], 4),
        ([[0.0, 0.0], [0.0, 0.0], [1.0, 0.0]], [[0.0, 0.0], [0.3, 0.0], [0.0, 0.0]], 4),
    ],
)
def test_modes_of_degenerate_shapes(base: object, platform: object, count: int) -> None:
    mechanism = on_struts(PLANAR, np.array(base), np.array(platform))
    (lengths,) = held(mechanism, POSE)
    found = modes_of(mechanism, lengths)
    of = mechanism.legs
    seen = count_by_scan(Rods(of.base_point, of.platform_point, lengths, PLANAR.twists))
    assert len(found.modes) == seen == count
    assert gap(mechanism, found.modes, POSE) < 1e-12


@pytest.mark.parametrize("seed", range(20))
def test_a_double_mode_is_one_of_determinant_0(seed: int) -> None:
    """The third strut is set on a line through the crossing of the first two."""
    random = np.random.default_rng(seed)
    base, platform = random.uniform(-1.0, 1.0, (2, 3, 2))
    pose = random.uniform(-1.0, 1.0, 3)
    ends = pose[:2] + platform @ _turn(pose[2]).T
    shares = np.linalg.solve((ends[:2] - base[:2]).T * [1.0, -1.0], base[1] - base[0])
    crossing = base[0] + shares[0] * (ends[0] - base[0])
    base[2] = ends[2] + random.uniform(0.3, 1.0) * (crossing - ends[2])
    mechanism = on_struts(PLANAR, base, platform)
    (lengths,) = held(mechanism, pose)
    found = modes_of(mechanism, lengths)
    near = [mode for mode in found.modes if np.abs(mode.pose - pose).max() < 1e-3]
    assert len(near) == 1
    assert np.abs(near[0].pose - pose).max() < 1e-6
    assert abs(near[0].determinant) < 1e-6
    assert found.certified


def _turn(angle: float) -> legs.Floats:
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def test_a_path_on_which_the_legs_stay_closed_is_not_certified() -> None:
    """Equal struts between congruent triangles: the platform swings along a circle."""
    found = modes_of(on_struts(PLANAR, TRIANGLE, TRIANGLE), [1.0, 1.0, 1.0])
    assert not found.certified
    turned = [mode for mode in found.modes if abs(mode.pose[2]) > 1e-6]
    assert len(turned) == 2


def test_a_platform_that_spins_freely_is_not_certified() -> None:
    mechanism = on_struts(PLANAR, TRIANGLE, np.zeros((3, 2)))
    found = modes_of(mechanism, held(mechanism, POSE)[0])
    assert (found.modes, found.certified) == ((), False)


def test_offsets_out_of_the_plane_shorten_the_rods() -> None:
    """A strut that climbs by h is one of length sqrt(l^2 - h^2) in the plane."""
    climb = np.array([0.3, -0.2, 0.5])
    base = np.column_stack([TRIANGLE, [0.1, 0.0, -0.4]])
    platform = np.column_stack([0.5 * MIRRORED, base[:, 2] + climb])
    flat = on_struts(PLANAR, TRIANGLE, 0.5 * MIRRORED)
    (lengths,) = held(flat, POSE)
    expected = modes_of(flat, lengths).modes
    found = modes_of(on_struts(PLANAR, base, platform), np.hypot(lengths, climb)).modes
    assert len(found) == len(expected) > 0
    for mode in found:
        assert gap(flat, expected, mode.pose) < 1e-12


def test_turns_come_in_one_turn() -> None:
    mechanism = on_struts(PLANAR, TRIANGLE, 0.5 * MIRRORED)
    rows = held(mechanism, *[[0.3, 0.5, turn] for turn in np.linspace(-6.0, 6.0, 25)])
    angles = np.array([mode.pose[2] for row in rows for mode in modes_of(mechanism, row).modes])
    assert np.all((angles > -np.pi) & (angles <= np.pi))
