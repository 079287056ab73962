"""Line of action, arms and torques against two flanks turned numerically."""

import math

import numpy as np
import pytest

from mechanics.arrays import Floats
from mechanics.gears.contact import Sense
from mechanics.gears.cycle import curve, mean_torque_factor
from mechanics.gears.friction import Coulomb
from mechanics.gears.mesh import Mesh
from mechanics.gears.toothed import spur_mesh
from mechanics.gears.train import at_place
from mechanics.gears.wheels import Teeth
from tests.oracles.involutes import Wheels, touches

SENSES: tuple[tuple[Sense, float], ...] = (("driving", 1.0), ("back_driving", -1.0))
PAIRS = [
    pytest.param((18, 18), (0.0, 0.0), 1.0, None, id="equal"),
    pytest.param((20, 43), (0.3, -0.1), 1.0, None, id="shifted"),
    pytest.param((61, 24), (0.0, 0.0), 0.8, None, id="stub teeth, speeding up"),
    pytest.param((25, 30), (0.0, 0.0), 1.0, 0.0277, id="pulled apart"),
]
MODULE, ANGLE, FRICTION = 1e-3, math.radians(20.0), 0.16


def mesh_of(
    counts: tuple[int, int], shifts: tuple[float, float], addendum: float, distance: float | None
) -> tuple[Mesh, Wheels, tuple[float, float]]:
    teeth = Teeth(MODULE, ANGLE, addendum, counts, shifts)
    mesh = spur_mesh(teeth, Coulomb(FRICTION), centre_distance=distance)
    apart = sum(mesh.pitch_radii)
    base = (
        0.5 * MODULE * counts[0] * math.cos(ANGLE),
        0.5 * MODULE * counts[1] * math.cos(ANGLE),
    )
    closer = 0.0
    if distance is None:
        closer = 0.5 * sum(counts) + sum(shifts) - apart / MODULE
    tips = (
        MODULE * (0.5 * counts[0] + addendum + shifts[0] - closer),
        MODULE * (0.5 * counts[1] + addendum + shifts[1] - closer),
    )
    return mesh, Wheels(base, apart), tips


def ends(mesh: Mesh, wheels: Wheels) -> Floats:
    """Return the first wheel's angles at which teeth meet and part, by its base circle."""
    return np.array([-mesh.approach, mesh.recess]) / wheels.base[0]


@pytest.mark.parametrize(("counts", "shifts", "addendum", "distance"), PAIRS)
def test_teeth_meet_and_part_at_the_tip_circles(
    counts: tuple[int, int], shifts: tuple[float, float], addendum: float, distance: float | None
) -> None:
    mesh, wheels, tips = mesh_of(counts, shifts, addendum, distance)
    first, last = touches(wheels, ends(mesh, wheels), 0.0, 1.0)
    assert first.radii[1] == pytest.approx(tips[1], rel=1e-9)
    assert last.radii[0] == pytest.approx(tips[0], rel=1e-9)


@pytest.mark.parametrize(("sense", "sign"), SENSES)
@pytest.mark.parametrize(("counts", "shifts", "addendum", "distance"), PAIRS)
def test_torques_of_one_pair_of_flanks(
    counts: tuple[int, int],
    shifts: tuple[float, float],
    addendum: float,
    distance: float | None,
    sense: Sense,
    sign: float,
) -> None:
    mesh, wheels, _ = mesh_of(counts, shifts, addendum, distance)
    # An even number: at the pitch point the flanks slide either way by rounding.
    first, last = ends(mesh, wheels)
    angles = np.linspace(first, last, 6)
    for angle, touch in zip(angles, touches(wheels, angles, FRICTION, sign), strict=True):
        found = at_place(mesh, angle * wheels.base[0], sense, mesh.pitch_radii[0])
        ratio = touch.moments[0] / touch.moments[1]
        assert mesh.ratio * found.torque_factor == pytest.approx(ratio, rel=1e-6)
        assert found.sliding_speed == pytest.approx(touch.sliding, rel=1e-6, abs=1e-9)
        length = math.hypot(1.0, FRICTION)
        assert found.input_arm == pytest.approx(touch.moments[0] / length, rel=1e-6)
        assert found.output_arm == pytest.approx(touch.moments[1] / length, rel=1e-6)


@pytest.mark.parametrize(("sense", "sign"), SENSES)
@pytest.mark.parametrize(("counts", "shifts", "addendum", "distance"), PAIRS)
def test_torque_of_all_pairs_in_contact(
    counts: tuple[int, int],
    shifts: tuple[float, float],
    addendum: float,
    distance: float | None,
    sense: Sense,
    sign: float,
) -> None:
    mesh, wheels, tips = mesh_of(counts, shifts, addendum, distance)
    pitch = 2.0 * math.pi / counts[0]
    first = ends(mesh, wheels)[0]
    for phase in (0.07, 0.33, 0.61, 0.96):
        angles = first + pitch * (phase + np.arange(4))
        angles = angles[angles < ends(mesh, wheels)[1] + 0.5 * pitch]
        touching = [
            touch
            for touch in touches(wheels, angles, FRICTION, sign)
            if touch.radii[0] <= tips[0] and touch.radii[1] <= tips[1]
        ]
        found = curve(mesh, 2000, sense, math.nan)
        assert found.pairs[np.searchsorted(found.phase, phase)] == len(touching)
        moments = np.sum([touch.moments for touch in touching], axis=0)
        expected = moments[0] / moments[1] / mesh.ratio
        between = np.interp(phase, found.phase, found.torque_factor)
        assert between == pytest.approx(expected, rel=1e-7)


def test_mean_over_the_cycle_of_turned_flanks() -> None:
    mesh, wheels, tips = mesh_of((20, 43), (0.3, -0.1), 1.0, None)
    pitch = 2.0 * math.pi / 20
    first, last = ends(mesh, wheels)
    count = 400
    steps = first + pitch * (np.arange(3 * count) + 0.5) / count
    found = touches(wheels, steps[steps < last], FRICTION, 1.0)
    sums = np.zeros((count, 2))
    for number, touch in enumerate(found):
        assert touch.radii[0] <= tips[0]
        sums[number % count] += touch.moments
    mean = float(np.mean(sums[:, 0] / sums[:, 1])) / mesh.ratio
    # Of 400 phases up to two are on the wrong side of a jump by half a step.
    assert mean_torque_factor(mesh, "driving", math.nan) == pytest.approx(mean, abs=2e-4)
