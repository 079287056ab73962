"""What holds for every pair of wheels, whatever its design."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mechanics.arrays import Floats
from mechanics.gears.contact import SIGNS, Sense, arms, shares, sliding_speed, torque_factor
from mechanics.gears.cycle import curve, mean_torque_factor, pieces
from mechanics.gears.errors import GearError
from mechanics.gears.friction import Coulomb
from mechanics.gears.mesh import Mesh
from mechanics.gears.toothed import spur_mesh
from mechanics.gears.train import at_place, transfer
from mechanics.gears.wheels import Teeth, pair

SENSES: list[Sense] = ["driving", "back_driving"]


@st.composite
def teeth(draw: st.DrawFn) -> Teeth:
    counts = draw(st.integers(10, 200)), draw(st.integers(10, 200))
    shifts = draw(st.floats(-0.5, 1.0)), draw(st.floats(-0.5, 1.0))
    angle = math.radians(draw(st.floats(14.5, 30.0)))
    return Teeth(draw(st.floats(1e-4, 0.05)), angle, draw(st.floats(0.7, 1.3)), counts, shifts)


@st.composite
def meshes(draw: st.DrawFn) -> Mesh:
    wheels = draw(teeth())
    friction = Coulomb(draw(st.floats(0.0, 0.6)))
    try:
        return spur_mesh(wheels, friction)
    except GearError:
        assume(False)
        raise


def places(mesh: Mesh, count: int = 41) -> Floats:
    return np.linspace(-mesh.approach, mesh.recess, count)


@given(teeth())
def test_the_line_of_action_is_an_inner_tangent_of_the_base_circles(wheels: Teeth) -> None:
    try:
        found = pair(wheels)
    except GearError:
        assume(False)
    cosine = sum(found.base_radii) / found.centre_distance
    assert math.cos(found.pressure_angle) == pytest.approx(cosine)
    assert sum(found.pitch_radii) == pytest.approx(found.centre_distance)
    tangent = math.sqrt(found.centre_distance**2 - sum(found.base_radii) ** 2)
    # Contact ends on the tip circles: Pythagoras from both tangent points.
    for place, side in ((found.recess, 0), (found.approach, 1)):
        from_tangent = found.pitch_radii[side] * math.sin(found.pressure_angle) + place
        assert from_tangent <= tangent * (1.0 + 1e-8)
        radius = math.hypot(found.base_radii[side], from_tangent)
        assert radius == pytest.approx(found.tip_radii[side], rel=1e-9)


@given(teeth())
def test_teeth_without_backlash_fill_the_pitch_circle(wheels: Teeth) -> None:
    """Thicknesses of both teeth at the pitch circles at work sum to the pitch."""
    try:
        found = pair(wheels)
    except GearError:
        assume(False)
    inv = math.tan(wheels.pressure_angle) - wheels.pressure_angle
    working = math.tan(found.pressure_angle) - found.pressure_angle
    total = 0.0
    for count, shift, radius in zip(wheels.counts, wheels.shifts, found.pitch_radii, strict=True):
        half = 0.5 * math.pi + 2.0 * shift * math.tan(wheels.pressure_angle)
        total += 2.0 * radius * (half / count + inv - working)
    pitch = 2.0 * math.pi * found.pitch_radii[0] / wheels.counts[0]
    assert total == pytest.approx(pitch, rel=1e-9)


@settings(deadline=None)
@given(meshes(), st.sampled_from(SENSES), st.floats(0.01, 10.0))
def test_power_in_is_power_out_and_loss_along_the_whole_cycle(
    mesh: Mesh, sense: Sense, speed: float
) -> None:
    """Normal and friction force, from arms and sliding, against both torques."""
    assert mesh.base_pitch is not None
    for piece in pieces(mesh):
        phase = np.linspace(piece.start, piece.stop, 9)
        at = piece.first + mesh.base_pitch * (phase + np.arange(piece.sides.size)[:, None])
        sides = np.broadcast_to(piece.sides[:, None], at.shape)
        force = shares(mesh, at, sides, sense, speed)
        normal = 1.0 / np.hypot(1.0, force.coefficient)
        first, second = arms(mesh, force)
        power_in = np.sum(first / normal, axis=0) * speed / mesh.pitch_radii[0]
        power_out = np.sum(second / normal, axis=0) * speed / mesh.pitch_radii[1]
        loss = np.sum(force.coefficient * sliding_speed(mesh, at, speed), axis=0)
        total = np.abs(power_in) + np.abs(power_out)
        missing = SIGNS[sense] * (power_in - power_out) - loss
        assert np.all(np.abs(missing) <= 1e-9 * total)


@given(meshes(), st.sampled_from(SENSES))
def test_a_pair_loses_the_more_the_farther_it_is_from_the_pitch_point(
    mesh: Mesh, sense: Sense
) -> None:
    for end in (-mesh.approach, mesh.recess):
        lost = [1.0 - at_place(mesh, end * part, sense).efficiency for part in (0.2, 0.6, 1.0)]
        assert lost == sorted(lost) or max(lost) < 1e-12


@given(meshes(), st.sampled_from(SENSES))
def test_worst_loses_at_least_what_any_phase_loses(mesh: Mesh, sense: Sense) -> None:
    worst = transfer(mesh, "worst", sense)
    assume(not worst.locks)
    factor = curve(mesh, 50, sense, math.nan).torque_factor
    extreme = factor.max() if sense == "driving" else factor.min()
    assert SIGNS[sense] * (worst.torque_factor - extreme) >= -1e-12


@given(meshes())
def test_driving_needs_more_and_back_driving_gives_less(mesh: Mesh) -> None:
    driving = mean_torque_factor(mesh, "driving", math.nan)
    back = mean_torque_factor(mesh, "back_driving", math.nan)
    assert math.isnan(driving) or driving >= 1.0 - 1e-12
    assert math.isnan(back) or back <= 1.0 + 1e-12


@given(teeth())
def test_without_friction_nothing_is_lost_anywhere(wheels: Teeth) -> None:
    try:
        mesh = spur_mesh(wheels, Coulomb(0.0))
    except GearError:
        assume(False)
    at = places(mesh)
    assert np.all(torque_factor(shares(mesh, at, np.sign(at), "driving", math.nan)) == 1.0)


@given(meshes())
def test_swapping_wheels_swaps_the_senses(mesh: Mesh) -> None:
    """Driving a train and driving its mirror image back pass the same forces."""
    first, second = mesh.pitch_radii
    swapped = Mesh(
        1.0 / mesh.ratio,
        (second, first),
        mesh.pressure_angle,
        mesh.recess,
        mesh.approach,
        mesh.base_pitch,
        first,
        mesh.friction,
    )
    for place in places(mesh, 7):
        one = at_place(mesh, place, "driving")
        # The load on the swapped train's output is what its motor was: its flank is the other.
        other = at_place(swapped, -place, "back_driving")
        if one.locks:
            assert other.locks
        else:
            assert one.torque_factor * other.torque_factor == pytest.approx(1.0, rel=1e-9)
