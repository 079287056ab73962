"""`friction_torque` between the wire and the mechanics."""

import itertools
import json
import math
from typing import Any

import numpy as np
import pytest

import analyses
from analyses import AnalysisError
from analyses.gears import build_train
from analyses.pictures import CurvePicture
from schemas.friction_torque import FrictionTorqueRequest, FrictionTorqueResult

SPUR: dict[str, Any] = {
    "kind": "design",
    "module": 0.002,
    "input": {"teeth": 20, "profile_shift": 0.3},
    "output": {"teeth": 40},
    "friction_coefficient": 0.08,
}
BEVEL: dict[str, Any] = {
    "kind": "design",
    "face": "bevel",
    "module": 0.003,
    "input": {"teeth": 22, "profile_shift": 0.2},
    "output": {"teeth": 34, "profile_shift": -0.2},
    "shaft_angle": 1.4,
    "friction_coefficient": 0.12,
}
PAIR: dict[str, Any] = {
    "kind": "explicit",
    "input_centre": [-0.3, 0.0],
    "output_centre": [0.3, 0.0],
    "pitch_point": [0.0, 0.0],
    "contact": [0.024, 0.065],
    "base_pitch": 0.1,
    "friction_coefficient": 0.16,
}


def asked(**changes: Any) -> FrictionTorqueRequest:  # noqa: ANN401
    body = {
        "analysis": "friction_torque",
        "train": [SPUR, BEVEL, PAIR],
        "output_torque": 50.0,
        "contact": "mean",
        "output_speed": 2.0,
    }
    request = analyses.parse(json.dumps(body | changes))
    assert isinstance(request, FrictionTorqueRequest)
    analyses.check(request, 10**6)
    return request


def answer(**changes: Any) -> FrictionTorqueResult:  # noqa: ANN401
    result = analyses.answer(asked(**changes))
    assert isinstance(result, FrictionTorqueResult)
    return result


def moved(shift: float, turn: float) -> dict[str, Any]:
    """Return the pair somewhere else in its plane."""
    c, s = math.cos(turn), math.sin(turn)
    turned = np.array([[c, -s], [s, c]])
    points = ("input_centre", "output_centre", "pitch_point", "contact")
    places = {name: (turned @ PAIR[name] + [shift, -shift]).tolist() for name in points}
    return PAIR | places


@pytest.mark.parametrize("sense", ["driving", "back_driving"])
@pytest.mark.parametrize("contact", ["mean", "worst", "approach_end", "recess_end"])
def test_power_in_is_power_out_and_loss(sense: str, contact: str) -> None:
    found = answer(sense=sense, contact=contact)
    assert found.input_torque is not None
    assert found.power_loss is not None
    at_output, at_motor = 50.0 * 2.0, found.input_torque * 2.0 / found.ratio
    power_in, power_out = (at_motor, at_output) if sense == "driving" else (at_output, at_motor)
    assert power_in == pytest.approx(power_out + found.power_loss, rel=1e-12)
    assert found.loss == pytest.approx(found.power_loss / power_in, rel=1e-9)
    assert found.efficiency == pytest.approx(power_out / power_in, rel=1e-12)


def test_losses_of_the_meshes_make_that_of_the_train() -> None:
    found = answer()
    losses = [stage.power_loss or math.nan for stage in found.stages]
    assert found.power_loss == pytest.approx(sum(losses))
    assert found.efficiency == pytest.approx(math.prod(s.efficiency for s in found.stages))


def test_every_mesh_hands_its_torque_on() -> None:
    stages = answer().stages
    assert stages[0].output_torque == 50.0
    for before, after in itertools.pairwise(stages):
        assert after.output_torque == before.input_torque
        assert after.frictionless_output_torque == before.frictionless_input_torque


@pytest.mark.parametrize("contact", ["mean", "worst"])
def test_without_friction_the_ratio_is_exact(contact: str) -> None:
    train = [mesh | {"friction_coefficient": 0.0} for mesh in (SPUR, BEVEL, PAIR)]
    found = answer(train=train, contact=contact)
    assert found.input_torque == found.frictionless_input_torque
    assert (found.excess, found.loss, found.efficiency, found.power_loss) == (0.0, 0.0, 1.0, 0.0)


def test_no_torque_still_has_an_efficiency() -> None:
    found = answer(output_torque=0.0)
    assert (found.input_torque, found.power_loss) == (0.0, 0.0)
    assert 0.9 < found.efficiency < 1.0
    assert found.excess == pytest.approx(1.0 / found.efficiency - 1.0)


def test_without_a_speed_nothing_slides_or_heats() -> None:
    found = answer(output_speed=None, contact="worst")
    assert found.power_loss is None
    assert {(s.power_loss, s.sliding_speed) for s in found.stages} == {(None, None)}
    assert found.efficiency == answer(contact="worst").efficiency


@pytest.mark.parametrize(("shift", "turn"), [(0.0, 1.0), (3.0, -2.0), (-100.0, math.pi)])
def test_a_pair_may_stand_anywhere_in_its_plane(shift: float, turn: float) -> None:
    here = answer(train=[PAIR])
    there = answer(train=[moved(shift, turn)])
    assert there.input_torque == pytest.approx(here.input_torque, rel=1e-9)
    assert there.stages[0].geometry.pitch_radii == pytest.approx([0.3, 0.3])


def test_teeth_by_points_and_by_design_agree() -> None:
    design = answer(train=[SPUR], contact="worst").stages[0].geometry
    first, second = design.pitch_radii
    sine, cosine = math.sin(design.pressure_angle), math.cos(design.pressure_angle)
    points = {
        "kind": "explicit",
        "input_centre": [0.0, 0.0],
        "output_centre": [first + second, 0.0],
        "pitch_point": [first, 0.0],
        "contact": [first + design.recess * sine, design.recess * cosine],
        "opposite_contact": [first - design.approach * sine, -design.approach * cosine],
        "base_pitch": math.pi * 0.002 * math.cos(math.radians(20.0)),
        "friction_coefficient": 0.08,
    }
    for contact in ("worst", "approach_end", "recess_end", "mean"):
        for sense in ("driving", "back_driving"):
            one = answer(train=[SPUR], contact=contact, sense=sense)
            other = answer(train=[points], contact=contact, sense=sense)
            assert other.efficiency == pytest.approx(one.efficiency, rel=1e-12)


def test_a_place_on_the_line_of_action_is_one_of_the_curve() -> None:
    """Between two pairs' stretches one pair carries all, so the curve is that of its place."""
    mesh = SPUR | {"contact_position": 0.0005}
    explicit = answer(train=[mesh], contact="explicit")
    curve = answer(train=[mesh], curve_points=1000).stages[0].curve
    (built,) = build_train(asked(train=[mesh]).meshes)
    assert curve is not None
    assert built.base_pitch is not None
    phase = (built.approach + 0.0005) / built.base_pitch
    assert phase < 1.0
    assert curve.pairs[int(np.searchsorted(curve.phase, phase))] == 1
    shown = np.interp(phase, curve.phase, np.array(curve.input_torque, dtype=float))
    assert shown == pytest.approx(explicit.input_torque, rel=1e-6)


def test_a_curve_jumps_where_pairs_come_and_go() -> None:
    curve = answer(train=[SPUR], curve_points=30).stages[0].curve
    assert curve is not None
    twice = [a for a, b in itertools.pairwise(curve.phase) if a == b]
    assert len(twice) == 2
    changes = [p for p, q in itertools.pairwise(curve.pairs) if p != q]
    assert changes == [2]


@pytest.mark.parametrize("cut", [1, 2])
def test_meshes_in_tiles_answer_as_all_at_once(cut: int) -> None:
    request = asked(curve_points=10)
    pieces = [analyses.compute(request, 0, cut), analyses.compute(request, cut, 3)]
    assembled = analyses.assemble(request, lambda: pieces)
    assert assembled.model_dump_json() == analyses.answer(request).model_dump_json()


def test_a_picture_shows_the_meshes_that_have_a_cycle() -> None:
    plain = {name: value for name, value in PAIR.items() if name != "base_pitch"}
    request = asked(train=[SPUR, plain, BEVEL], contact="worst")
    found = analyses.picture(request, lambda: [], None)
    assert isinstance(found, CurvePicture)
    assert [curve.label for curve in found.curves] == ["mesh 0", "mesh 2"]
    assert "2 of 3 meshes" in found.subtitle


def test_a_picture_of_torques_has_the_answered_means() -> None:
    request = asked()
    found = analyses.picture(request, lambda: [], "input_torque")
    assert isinstance(found, CurvePicture)
    levels = [curve.level for curve in found.curves]
    assert levels == pytest.approx([stage.input_torque for stage in answer().stages])


def test_ratios_beyond_all_use_are_refused() -> None:
    steep = SPUR | {"input": {"teeth": 100_000}, "output": {"teeth": 18}}
    with pytest.raises(AnalysisError, match="make 1e15"):
        asked(train=[steep] * 4, contact="worst")


@pytest.mark.parametrize("first", ["up", "down"])
def test_ratios_may_not_leave_and_come_back(first: str) -> None:
    """A hundred million times faster and slower again, forty times: numbers end in between."""
    near = {
        "kind": "explicit",
        "pitch_point": [1.0 - 1e-8, 0.0],
        "contact": [1.0 - 8e-9, 2.5e-9],
        "friction_coefficient": 0.1,
    }
    left, right = {"input_centre": [-1.0, 0.0]}, {"input_centre": [1.0, 0.0]}
    up = near | left | {"output_centre": [1.0, 0.0]}
    down = near | right | {"output_centre": [-1.0, 0.0]}
    meshes = [up] * 40 + [down] * 40 if first == "up" else [down] * 40 + [up] * 40
    with pytest.raises(AnalysisError, match=r"first 2 meshes make 1e-?16\.6"):
        asked(train=meshes, contact="pitch")


def all_but_locking() -> dict[str, Any]:
    """Return the pair with the coefficient next below the one at which it locks in approach.

    The force on the output wheel passes its centre where f (tan a + s / rb) = 1.
    """
    place, sine = math.hypot(0.024, 0.065), 0.024 / math.hypot(0.024, 0.065)
    lever = math.tan(math.asin(sine)) + place / (0.3 * math.sqrt(1.0 - sine**2))
    return PAIR | {"friction_coefficient": (1.0 - 1e-12) / lever}


def test_meshes_that_all_but_lock_lock_together() -> None:
    """One takes 1e12 times the torque; a hundred would take more than there are numbers for."""
    one = answer(train=[all_but_locking()], contact="approach_end")
    assert one.excess is not None
    assert one.excess > 1e11
    assert not one.self_locking
    whole = answer(train=[all_but_locking()] * 100, contact="approach_end")
    assert whole.self_locking
    assert (whole.input_torque, whole.excess, whole.power_loss) == (None, None, None)
    assert whole.efficiency == 0.0
    assert not any(stage.self_locking for stage in whole.stages)


def test_a_picture_says_that_meshes_lock_together() -> None:
    request = asked(train=[all_but_locking()] * 100, contact="approach_end")
    assert ", self-locking, " in analyses.picture(request, lambda: [], None).subtitle
