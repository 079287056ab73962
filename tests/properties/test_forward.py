"""Forward kinematics undoes inverse kinematics: every family, and freely mixed drives."""

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st

from mechanics.assembly.modes import AssemblyMode
from mechanics.configuration import Configuration
from mechanics.forward import assembly_modes, nearby_modes
from mechanics.mechanism import Mechanism
from tests.mechanics.braced import gap, places
from tests.oracles import legs
from tests.oracles.legs import Floats
from tests.properties.mechanisms import NAMES, Case, cases, well_held_cases

SPATIAL = ("hexa_linear", "gough_stewart", "hexa_rotary", "custom spatial")
CLOSED = [name for name in NAMES if name not in SPATIAL]
STRETCHED = 1e-4
"""Of a leg nearer to stretched than this the drive follows only roughly from the pose."""

SOME = settings(
    max_examples=10,
    deadline=None,
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
)


def modes_of(case: Case) -> tuple[AssemblyMode, ...]:
    (assembly,) = assembly_modes(case.mechanism, case.actuators[None])
    return assembly.modes


def drives_at(mechanism: Mechanism, mode: AssemblyMode) -> Floats:
    """Return the inverse solution at a mode, in the working mode that it tells."""
    columns = mechanism.columns(mode.pose[None])
    return Configuration(mechanism.in_working_mode(mode.working_mode), columns).actuators[:, 0]


def difference(case: Case, found: Floats) -> float:
    """Return the greatest difference from the case's drives; whole turns are none."""
    away = found - case.actuators
    turning = np.array([drive in ("crank", "arc") for drive in case.drives])
    return float(np.abs(np.where(turning, np.angle(np.exp(1j * away)), away)).max())


@pytest.mark.parametrize("name", NAMES)
@SOME
@given(st.data())
def test_one_of_the_modes_is_the_pose(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    assert gap(case.mechanism, modes_of(case), case.row) < 1e-9


@pytest.mark.parametrize("name", NAMES)
@SOME
@given(st.data())
def test_every_mode_gives_the_drives_back(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    seen = 0
    for mode in modes_of(case):
        if legs.transmission(case.machine, mode.pose, case.actuators).min() > STRETCHED:
            assert difference(case, drives_at(case.mechanism, mode)) < 1e-9
            seen += 1
    assert seen > 0


@pytest.mark.parametrize("name", CLOSED)
@SOME
@given(st.data())
def test_every_mode_closes_the_legs(name: str, data: st.DataObject) -> None:
    """By the oracle's leg equations, also where a leg is stretched and in any working mode."""
    case = cases(data, name)
    assume(np.isfinite(case.actuators).all())
    for mode in modes_of(case):
        joints = legs.joints(case.machine, mode.pose)
        for leg, joint, drive in zip(case.machine.legs, joints, case.actuators, strict=True):
            assert abs(legs.residual(leg, joint, drive)) < 1e-12
        assert mode.residual <= 2e-14


@pytest.mark.parametrize("name", CLOSED)
@SOME
@given(st.data())
def test_as_many_modes_have_one_sign_as_the_other(name: str, data: st.DataObject) -> None:
    """Lengths of rods are a proper map of poses that some lengths miss: its degree is 0."""
    case = well_held_cases(data, name)
    modes = modes_of(case)
    rows = [legs.leg_rows(case.machine, mode.pose, case.actuators)[0] for mode in modes]
    assume(all(np.linalg.cond(legs.at_size(case.machine, row)) < 1e5 for row in rows))
    assert sum(np.sign(mode.determinant) for mode in modes) == 0


@pytest.mark.parametrize("name", CLOSED)
@SOME
@given(st.data())
def test_determinants_are_those_of_the_poses(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    for mode in modes_of(case):
        rows, _ = legs.leg_rows(case.machine, mode.pose, case.actuators)
        sizes = float(np.prod(np.linalg.norm(rows, axis=1)))
        assert abs(mode.determinant - np.linalg.det(rows)) < 1e-11 * sizes


@pytest.mark.parametrize("name", CLOSED)
@SOME
@given(st.data())
def test_modes_are_all_different(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    here = places(case.mechanism, np.array([mode.pose for mode in modes_of(case)]))
    for number, place in enumerate(here[1:], start=1):
        assert np.abs(here[:number] - place).max(axis=1).min() > 1e-7


@pytest.mark.parametrize("name", CLOSED)
@SOME
@given(st.data())
def test_a_row_does_not_depend_on_its_company(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    random = np.random.default_rng(0)
    others = case.actuators + random.uniform(-0.3, 0.3, (9, case.actuators.size))
    together = assembly_modes(case.mechanism, np.vstack([others, case.actuators]))[-1]
    (alone,) = assembly_modes(case.mechanism, case.actuators[None])
    assert len(together.modes) == len(alone.modes)
    for one, other in zip(together.modes, alone.modes, strict=True):
        np.testing.assert_array_equal(one.pose, other.pose)


@pytest.mark.parametrize("name", NAMES)
@SOME
@given(st.data())
def test_a_guess_nearby_leads_back_to_the_pose(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    away = 1e-3 * case.reach * np.random.default_rng(0).uniform(-1.0, 1.0, len(case.pose))
    (found,) = nearby_modes(case.mechanism, case.actuators[None], (case.row + away)[None])
    assert found.converged
    assert gap(case.mechanism, (found.mode,), case.row) < 1e-9
