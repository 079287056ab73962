"""Wheels, meshes and trains against textbook formulas, and what they refuse."""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

from mechanics.arrays import Floats
from mechanics.gears.contact import Sense
from mechanics.gears.cycle import curve, mean_torque_factor
from mechanics.gears.errors import GearError
from mechanics.gears.friction import Coulomb
from mechanics.gears.involute import inverse_involute, involute
from mechanics.gears.mesh import Mesh
from mechanics.gears.points import point_mesh
from mechanics.gears.toothed import bevel_mesh, spur_mesh
from mechanics.gears.train import Contact, at_place, carry, transfer
from mechanics.gears.wheels import Teeth, pair

ANGLE = math.radians(20.0)
RANGE = [(18, 18), (18, 60), (20, 40), (40, 20), (25, 100), (33, 47), (60, 60), (100, 150)]


def teeth(first: float, second: float, **changes: Any) -> Teeth:  # noqa: ANN401
    return replace(Teeth(0.002, ANGLE, 1.0, (first, second), (0.0, 0.0)), **changes)


def points(**changes: Any) -> Mesh:  # noqa: ANN401
    data: dict[str, Any] = {
        "input_centre": (-0.3, 0.0),
        "output_centre": (0.3, 0.0),
        "pitch_point": (0.0, 0.0),
        "contact": (0.024, 0.065),
        "opposite_contact": None,
    } | changes
    arrays: dict[str, Any] = {
        name: None if value is None else np.array(value, dtype=float)
        for name, value in data.items()
        if name not in ("base_pitch", "friction")
    }
    friction = Coulomb(data.get("friction", 0.16))
    return point_mesh(**arrays, base_pitch=data.get("base_pitch"), friction=friction)


def gear_loss_factor(mesh: Mesh, counts: tuple[int, int]) -> float:
    """Return Hv of Niemann and Winter, Maschinenelemente II, for equal sharing."""
    assert mesh.base_pitch is not None
    first, second = mesh.recess / mesh.base_pitch, mesh.approach / mesh.base_pitch
    ratio = counts[1] / counts[0]
    total = first + second
    shape = 1.0 - total + first**2 + second**2
    return math.pi * (ratio + 1.0) / (counts[0] * ratio) * shape


@pytest.mark.parametrize("angle", [1e-4, 0.01, 0.3, 0.7, 1.3, 1.55])
def test_inverse_involute(angle: float) -> None:
    assert inverse_involute(involute(angle)) == pytest.approx(angle, rel=1e-7)


def test_an_involute_angle_of_the_tables() -> None:
    # inv 20 degrees, as every table of gears prints it.
    assert involute(ANGLE) == pytest.approx(0.014904, abs=5e-7)


@pytest.mark.parametrize("counts", RANGE)
def test_contact_ratio_of_the_textbook(counts: tuple[int, int]) -> None:
    mesh = spur_mesh(teeth(*counts), Coulomb(0.1))
    first, second = counts
    # Of standard wheels, in modules: Buckingham, Analytical Mechanics of Gears.
    expected = (
        math.sqrt((first + 2) ** 2 - (first * math.cos(ANGLE)) ** 2)
        + math.sqrt((second + 2) ** 2 - (second * math.cos(ANGLE)) ** 2)
        - (first + second) * math.sin(ANGLE)
    ) / (2.0 * math.pi * math.cos(ANGLE))
    assert mesh.contact_ratio == pytest.approx(expected, rel=1e-12)


def test_shifted_pair_of_a_catalogue() -> None:
    """Module 3, 12 and 24 teeth, shifts 0.6 and 0.36: KHK, Gear technical reference, table 4.4."""
    found = pair(teeth(12, 24, module=3e-3, shifts=(0.6, 0.36)))
    assert math.degrees(found.pressure_angle) == pytest.approx(26.0886, abs=5e-4)
    assert found.centre_distance == pytest.approx(56.4999e-3, abs=5e-8)
    assert 2.0 * np.array(found.pitch_radii) == pytest.approx([37.667e-3, 75.333e-3], abs=1e-6)
    assert 2.0 * np.array(found.tip_radii) == pytest.approx([44.840e-3, 79.400e-3], abs=5e-7)


def test_tip_thickness_by_the_flanks_points() -> None:
    """Where an involute from half a tooth at the pitch circle has unwound to the tip circle."""
    count, shift = 25, 0.4
    found = pair(teeth(count, 40, shifts=(shift, 0.0)))
    half = 0.5 * math.pi / count + 2.0 * shift * math.tan(ANGLE) / count
    unwound = [math.sqrt((r / found.base_radii[0]) ** 2 - 1.0) for r in (0.025, found.tip_radii[0])]
    # Polar angle of an involute's point: the angle unwound less the angle of contact.
    polar = [t - math.atan(t) for t in unwound]
    thickness = 2.0 * found.tip_radii[0] * (half - (polar[1] - polar[0]))
    assert found.tip_thickness[0] == pytest.approx(thickness, rel=1e-9)


@pytest.mark.parametrize("counts", RANGE)
@pytest.mark.parametrize("friction", [0.01, 0.05])
def test_mean_loss_is_friction_times_gear_loss_factor(
    counts: tuple[int, int], friction: float
) -> None:
    mesh = spur_mesh(teeth(*counts), Coulomb(friction))
    loss = mean_torque_factor(mesh, "driving", math.nan) - 1.0
    assert loss == pytest.approx(friction * gear_loss_factor(mesh, counts), rel=0.01)


@pytest.mark.parametrize("counts", RANGE)
def test_mean_loss_tends_to_the_gear_loss_factor(counts: tuple[int, int]) -> None:
    mesh = spur_mesh(teeth(*counts), Coulomb(1e-6))
    loss = mean_torque_factor(mesh, "driving", math.nan) - 1.0
    assert loss == pytest.approx(1e-6 * gear_loss_factor(mesh, counts), rel=1e-5)


@pytest.mark.parametrize("friction", [0.08, 0.16])
@pytest.mark.parametrize("counts", RANGE)
def test_mean_loss_with_much_friction_is_up_to_three_per_cent_more(
    counts: tuple[int, int], friction: float
) -> None:
    mesh = spur_mesh(teeth(*counts), Coulomb(friction))
    loss = mean_torque_factor(mesh, "driving", math.nan) - 1.0
    assert 1.0 <= loss / (friction * gear_loss_factor(mesh, counts)) < 1.03


@pytest.mark.parametrize("contact", ["pitch", "approach_end", "recess_end", "worst", "mean"])
@pytest.mark.parametrize("sense", ["driving", "back_driving"])
@pytest.mark.parametrize("counts", RANGE)
def test_without_friction_torques_are_exactly_in_the_ratio(
    contact: Contact, sense: Sense, counts: tuple[int, int]
) -> None:
    (stage,) = carry([spur_mesh(teeth(*counts), Coulomb(0.0))], 50.0, contact, sense=sense)
    assert stage.input_torque == stage.frictionless_input_torque
    assert stage.input_torque == 50.0 * (counts[0] / counts[1])
    assert stage.transfer.efficiency == 1.0


@pytest.mark.parametrize("sense", ["driving", "back_driving"])
def test_the_mean_is_that_of_the_curve(sense: Sense) -> None:
    mesh = spur_mesh(teeth(23, 31), Coulomb(0.12))
    found = curve(mesh, 20_000, sense, math.nan)
    area = np.trapezoid(found.torque_factor, found.phase)
    assert mean_torque_factor(mesh, sense, math.nan) == pytest.approx(area, rel=1e-9)


def test_worst_is_nowhere_in_the_cycle_exceeded() -> None:
    mesh = spur_mesh(teeth(23, 31), Coulomb(0.12))
    worst = transfer(mesh, "worst", "driving").torque_factor
    assert curve(mesh, 500, "driving", math.nan).torque_factor.max() <= worst


def test_bevel_wheels_lose_what_their_equivalent_pair_loses() -> None:
    """Mitre wheels of 20 teeth stand for spur wheels of 20 sqrt(2) teeth."""
    mesh = bevel_mesh(teeth(20, 20), Coulomb(0.1), shaft_angle=0.5 * math.pi)
    same = spur_mesh(teeth(20 * math.sqrt(2), 20 * math.sqrt(2)), Coulomb(0.1))
    assert mesh.ratio == 1.0
    assert mesh.contact_ratio == pytest.approx(same.contact_ratio, rel=1e-12)
    for contact in ("worst", "mean"):
        found = transfer(mesh, contact, "driving")
        expected = transfer(same, contact, "driving")
        assert found.torque_factor == pytest.approx(expected.torque_factor, rel=1e-12)


def test_bevel_wheels_turn_in_their_true_ratio() -> None:
    mesh = bevel_mesh(teeth(20, 40), Coulomb(0.1), shaft_angle=0.5 * math.pi)
    assert mesh.ratio == 0.5
    first, second = mesh.pitch_radii
    # u_v = u^2 at a right angle, ISO 23509.
    assert second / first == pytest.approx(4.0, rel=1e-12)
    assert mesh.speed_radius == pytest.approx(0.04)


def test_speeds_rise_towards_a_motor_with_smaller_wheels() -> None:
    mesh = spur_mesh(teeth(20, 40), Coulomb(0.1))
    stages = carry([mesh, mesh], 1.0, "worst", output_speed=3.0)
    assert [stage.input_speed for stage in stages] == [6.0, 12.0]
    first, second = (stage.transfer.sliding_speed for stage in stages)
    assert second == pytest.approx(2.0 * first)


def test_a_ring_and_its_pinion_slide_less_than_two_wheels() -> None:
    """A pinion of 0.1 m in a ring of 0.3 m; with teeth outside, arms and sliding are known."""
    ring = points(
        input_centre=(0, 0), output_centre=(-0.2, 0), pitch_point=(0.1, 0), contact=(0.104, 0.01)
    )
    assert ring.pitch_radii == pytest.approx((0.1, -0.3))
    place = 0.01
    found = at_place(ring, place, "driving", 1.0)
    assert found.sliding_speed == pytest.approx(place * (1 / 0.1 - 1 / 0.3))
    assert ring.ratio == pytest.approx(1 / 3)


def test_a_ring_by_cross_products() -> None:
    """Both moments of a force taken from its components, at a contact in recess."""
    for first, second, point in (((0, 0), (-0.2, 0), (0.1, 0)), ((-0.2, 0), (0, 0), (0.1, 0))):
        along = np.array([math.sin(0.4), math.cos(0.4)])
        if first == (-0.2, 0):
            along *= np.array([-1.0, 1.0])
        contact = np.array(point) + 0.01 * along
        mesh = points(input_centre=first, output_centre=second, pitch_point=point, contact=contact)
        speeds = [1.0 / np.linalg.norm(np.subtract(point, c)) for c in (first, second)]
        arms = [contact - np.array(c, dtype=float) for c in (first, second)]
        velocities = [w * np.array([-r[1], r[0]]) for w, r in zip(speeds, arms, strict=True)]
        push = along if velocities[0] @ along > 0 else -along
        slip = velocities[0] - velocities[1]
        force = push + 0.16 * slip / np.linalg.norm(slip)
        moments = [abs(r[0] * force[1] - r[1] * force[0]) for r in arms]
        assert mesh.contact is not None
        sense: Sense = "driving" if push @ along > 0 else "back_driving"
        found = at_place(mesh, mesh.contact, sense)
        assert mesh.ratio * found.torque_factor == pytest.approx(moments[0] / moments[1])


def test_much_friction_locks_the_load_and_not_the_motor() -> None:
    mesh = points(friction=1.9)
    assert transfer(mesh, "recess_end", "back_driving").locks
    assert transfer(mesh, "recess_end", "back_driving").efficiency == 0.0
    assert not transfer(mesh, "recess_end", "driving").locks


def test_nothing_arrives_behind_a_mesh_that_locks() -> None:
    train = [points(friction=0.1), points(friction=1.9), points(friction=0.1)]
    stages = carry(train, 50.0, "recess_end", sense="back_driving")
    assert [math.isnan(stage.input_torque) for stage in stages] == [False, True, True]
    assert [stage.transfer.locks for stage in stages] == [False, True, False]


def test_a_mean_locks_where_any_phase_does() -> None:
    mesh = points(friction=1.9, base_pitch=0.138)
    assert transfer(mesh, "mean", "back_driving").locks


REFUSED = [
    ({"pitch_point": (0.0, 0.01)}, ("pitch_point",), "0.01 m off"),
    ({"pitch_point": (0.3, 0.0)}, ("pitch_point",), "must not be a centre"),
    ({"output_centre": (-0.3, 0.0)}, ("output_centre",), "they are 0 m apart"),
    ({"contact": (0.0, 0.0)}, ("contact",), "must differ"),
    ({"contact": (0.1, 0.0)}, ("contact",), "line of centres"),
    ({"contact": (0.048, 0.13)}, ("contact",), "outside of the line of action"),
    ({"opposite_contact": (-0.024, -0.06)}, ("opposite_contact",), "off"),
    ({"opposite_contact": (0.012, 0.0325)}, ("opposite_contact",), "other side"),
    ({"opposite_contact": (-0.048, -0.13)}, ("opposite_contact",), "outside"),
    ({"base_pitch": 0.15}, ("base_pitch",), "contact ratio is 0.9239"),
    ({"base_pitch": 1e-6}, ("base_pitch",), "from 1 to 20"),
    ({"friction": 2.8}, ("friction_coefficient",), "below 2.70833"),
]


@pytest.mark.parametrize(("changes", "field", "said"), REFUSED)
def test_points_that_make_no_mesh(
    changes: dict[str, Any], field: tuple[str, ...], said: str
) -> None:
    with pytest.raises(GearError, match=said.replace("(", r"\(")) as caught:
        points(**changes)
    assert caught.value.field == field


TEETH_REFUSED = [
    ((16, 40), {}, None, ("input", "profile_shift"), r"undercut.* is 0.0641778 below the least"),
    ((40, 16), {}, None, ("output", "profile_shift"), "undercut"),
    ((18, 40), {"shifts": (2.0, 0.0)}, None, ("input", "profile_shift"), "pointed"),
    ((20, 40), {"addendum_coefficient": 0.3}, None, (), "contact ratio is 0.5"),
    ((20, 40), {}, 0.0621, (), "contact ratio is 0.7"),
    ((20, 40), {}, 0.0595, ("centre_distance",), "overlap by 0.0005 m"),
    ((20, 40), {"shifts": (3.0, -20.0)}, None, ("output", "profile_shift"), "undercut"),
]


@pytest.mark.parametrize(("counts", "changes", "distance", "field", "said"), TEETH_REFUSED)
def test_teeth_that_do_not_mesh(
    counts: tuple[int, int],
    changes: dict[str, Any],
    distance: float | None,
    field: tuple[str, ...],
    said: str,
) -> None:
    with pytest.raises(GearError, match=said) as caught:
        spur_mesh(teeth(*counts, **changes), Coulomb(0.1), centre_distance=distance)
    assert caught.value.field == field


def test_a_contact_beyond_the_line_of_action() -> None:
    with pytest.raises(GearError, match=r"outside of the line of action.*beyond"):
        spur_mesh(teeth(20, 40), Coulomb(0.1), contact=0.006)


def test_bevel_shifts_that_do_not_balance() -> None:
    with pytest.raises(GearError, match="must sum to 0"):
        bevel_mesh(teeth(20, 40, shifts=(0.2, 0.0)), Coulomb(0.1), shaft_angle=1.5)


def test_a_bevel_wheel_that_would_be_a_ring() -> None:
    with pytest.raises(GearError, match="half-angle"):
        bevel_mesh(teeth(20, 60), Coulomb(0.1), shaft_angle=2.5)


@pytest.mark.parametrize(("contact", "field"), [("mean", "base_pitch")])
def test_contacts_that_a_mesh_does_not_have(contact: Contact, field: str) -> None:
    with pytest.raises(GearError) as caught:
        transfer(points(), contact, "driving")
    assert caught.value.field == (field,)


def test_a_pair_that_never_touches_at_the_pitch_point() -> None:
    mesh = spur_mesh(teeth(24, 80, shifts=(0.9, -2.4), addendum_coefficient=1.0), Coulomb(0.1))
    assert mesh.approach < 0.0
    with pytest.raises(GearError, match="pitch point lies outside"):
        transfer(mesh, "pitch", "driving")


@dataclass(frozen=True)
class Stribeck:
    """Friction that falls with speed."""

    def coefficient(self, sliding_speed: Floats) -> Floats:
        """Return less friction the faster the teeth slide."""
        return 0.05 + 0.1 * np.exp(-sliding_speed)


@pytest.mark.parametrize("place", [-0.003, 0.002])
def test_another_law_is_asked_at_the_sliding_speed(place: float) -> None:
    wheels = teeth(20, 40)
    mesh = spur_mesh(wheels, Stribeck())
    slide = 1.5 * (1.0 / 0.02 + 1.0 / 0.04) * abs(place)
    same = spur_mesh(wheels, Coulomb(0.05 + 0.1 * math.exp(-slide)))
    for sense in ("driving", "back_driving"):
        found = at_place(mesh, place, sense, 1.5)
        expected = at_place(same, place, sense, 1.5)
        assert found.torque_factor == pytest.approx(expected.torque_factor, rel=1e-12)
        assert found.input_arm == pytest.approx(expected.input_arm, rel=1e-12)


@pytest.mark.parametrize("sense", ["driving", "back_driving"])
@pytest.mark.parametrize("friction", [0.05, 0.5, 1.45])
def test_the_mean_of_one_pair_in_closed_form(sense: Sense, friction: float) -> None:
    """With one pair always in contact, moments are linear on either side of the pitch point."""
    length = 0.05
    mesh = replace(points(friction=friction), approach=length, recess=length, base_pitch=0.1)
    radius, tangent = mesh.base_radii[0], 0.3 * math.sin(mesh.pressure_angle)
    total = 0.0
    for side in (-1.0, 1.0):
        g = friction * side * (1.0 if sense == "driving" else -1.0)
        # Integrated over s: (here + g s) / (here - g s) = -1 + 2 here / (here - g s).
        here = radius + g * tangent
        total += -0.5 - 2.0 * here / g * math.log((here - g * side * length) / here) * side / 0.1
    assert mean_torque_factor(mesh, sense, math.nan) == pytest.approx(total, rel=1e-12)
