"""`friction_torque` of the geared mechanism: its motors under a load, through their gears."""

import json
import math
from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError

import analyses
from analyses.errors import AnalysisError
from mechanics.arrays import Floats
from schemas.analyses import parse_request
from schemas.starters import STARTERS

Document = dict[str, Any]
MESH = {
    "kind": "explicit",
    "input_centre": [-0.3, 0.0],
    "output_centre": [0.3, 0.0],
    "pitch_point": [0.0, 0.0],
    "contact": [0.024, 0.065],
    "friction_coefficient": 0.16,
}
"""The pair of 2022 that makes 53.863 of 50 N m, and 54.370 at the other end of its line."""
GEARED = {
    "kind": "geared_decoupled",
    "rail_radius": 0.33,
    "platform_radius": 0.08,
    "rod_length": 0.37,
    "carriage_arm": 0.022,
    "tool_offset": 0.05,
    "wrist": {"k1": 0.9, "k2": 1.0, "kp": 0.87, "k_gamma": 1.4},
    "train": [MESH] * 4,
}
AHEAD = [0.05, 0.0, 0.0, 0.0, 0.0, 0.0]
ASKED = {
    "analysis": "friction_torque",
    "mechanism": GEARED,
    "poses": [AHEAD],
    "known_load": {"moment": [50.0, 0.0, 0.0]},
    "contact": "worst",
}


def parsed(body: Document) -> Any:  # noqa: ANN401
    request = parse_request(json.dumps(body, default=float))
    analyses.check(request, 10**6)
    return request


def answered(body: Document) -> Document:
    return analyses.answer(parsed(body)).model_dump(mode="json")


def through(train: list[Document], torque: float, **fields: Any) -> Document:  # noqa: ANN401
    """Return the answer about a train alone."""
    asked = {"analysis": "friction_torque", "train": train, "output_torque": torque}
    return answered({"contact": "worst", **asked, **fields})


def samples(count: int) -> tuple[Floats, Floats, Floats]:
    """Return poses, moments and angular velocities, one a row."""
    random = np.random.default_rng(4)
    poses = random.uniform(-1.0, 1.0, (count, 6)) * [0.05, 0.05, 0.1, 3.0, 1.3, 3.0]
    return poses, *random.normal(size=(2, count, 3))


def test_at_the_pitch_point_nothing_is_lost() -> None:
    """The best case: 50 N m about x through k = 0.783 twice, and what D3 holds against both."""
    found = answered(ASKED | {"contact": "pitch"})
    assert found["torque"][0] == pytest.approx([-31.93, -31.93, 89.40], abs=5e-3)
    assert found["torque"] == found["frictionless_torque"]
    assert found["driving_factor"] == [1.0, 1.0, 1.0]


def test_at_the_worst_end_every_mesh_takes_its_share() -> None:
    """Four meshes each of 54.370 N m for 50, in two chains; the third motor has none."""
    found = answered(ASKED)
    share = (54.370 / 50.0) ** 4
    assert found["driving_factor"] == pytest.approx([share, share, 1.0], rel=1e-4)
    expected = [-31.928 * share, -31.928 * share, 89.40]
    assert found["torque"][0] == pytest.approx(expected, rel=1e-4)
    assert found["sense"] == [["driving"] * 3]


def test_the_mean_lies_between() -> None:
    mean = STARTERS["geared_decoupled"].model_dump(mode="json")
    asked = ASKED | {"mechanism": mean}
    best, middle, worst = (
        abs(answered(asked | {"contact": contact})["torque"][0][0])
        for contact in ("pitch", "mean", "worst")
    )
    assert best < middle < worst


@pytest.mark.parametrize("sense", ["driving", "back_driving"])
@pytest.mark.parametrize("contact", ["pitch", "worst", "mean", "approach_end"])
def test_a_motor_bears_what_its_train_says(contact: str, sense: str) -> None:
    mechanism = STARTERS["geared_decoupled"].model_dump(mode="json")
    how = {"contact": contact, "sense": sense}
    alone = through(mechanism["train"], 10.0, **how)
    found = answered(ASKED | {"mechanism": mechanism} | how)
    factor = alone["input_torque"] / alone["frictionless_input_torque"]
    assert found[f"{sense}_factor"] == pytest.approx([factor, factor, 1.0], rel=1e-13)
    plain = np.array(found["frictionless_torque"][0])
    assert found["torque"][0] == pytest.approx((plain * [factor, factor, 1.0]).tolist(), rel=1e-13)


def test_motors_that_brake_are_driven_back() -> None:
    poses, moments, turning = samples(50)
    body = ASKED | {"poses": poses.tolist(), "known_load": {"moment": moments.tolist()}}
    found = answered(body | {"angular_velocity": turning.tolist()})
    spun = np.hstack([np.zeros_like(turning), turning]).tolist()
    rates = answered(
        {
            "analysis": "velocity",
            "mechanism": GEARED,
            "poses": poses.tolist(),
            "platform_rates": spun,
        }
    )["actuator_rates"]
    powers = np.array(found["frictionless_torque"]) * np.array(rates)[:, 3:]
    senses = np.where(powers < 0.0, "back_driving", "driving").tolist()
    assert found["sense"] == senses
    assert len({sense for row in senses for sense in row}) == 2
    factors = np.where(powers < 0.0, found["back_driving_factor"], found["driving_factor"])
    expected = factors * np.array(found["frictionless_torque"])
    np.testing.assert_allclose(found["torque"], expected, rtol=1e-13)


def test_friction_takes_power_whichever_way_the_platform_turns() -> None:
    """What motors give, and what the load gives, is not below 0: the rest turns into heat."""
    poses, moments, turning = samples(200)
    body = ASKED | {"poses": poses.tolist(), "known_load": {"moment": moments.tolist()}}
    found = answered(body | {"angular_velocity": turning.tolist()})
    spun = np.hstack([np.zeros_like(turning), turning]).tolist()
    moved = answered(
        {
            "analysis": "velocity",
            "mechanism": GEARED,
            "poses": poses.tolist(),
            "platform_rates": spun,
        }
    )
    rates = np.array(moved["actuator_rates"])[:, 3:]
    lost = np.sum(np.array(found["torque"]) * rates, axis=1) + np.sum(moments * turning, axis=1)
    plain = np.array(found["frictionless_torque"]) * rates
    driving, back = found["driving_factor"][0], found["back_driving_factor"][0]
    heat = np.where(plain > 0.0, driving - 1.0, back - 1.0)[:, :2] * plain[:, :2]
    assert np.all(lost > 0.0)
    np.testing.assert_allclose(lost, heat.sum(axis=1), rtol=1e-11)


def test_the_worst_moment_is_worst_with_friction_too() -> None:
    pose = [0.03, -0.02, -0.1, 0.3, -0.4, 0.5]
    load = {"force": 10.0, "moment": 2.0}
    body = {**ASKED, "poses": [pose], "load": load, "known_load": {"moment": [0.3, 0.1, -0.2]}}
    found = answered(body)
    greatest = np.array(found["torque"][0])
    random = np.random.default_rng(1)
    directions = random.normal(size=(2, 400, 3))
    forces, moments = directions / np.linalg.norm(directions, axis=2, keepdims=True)
    forces[:3] = np.array(found["worst_force"][0]) / 10.0
    moments[:3] = np.array(found["worst_moment"][0]) / 2.0
    known = {
        "force": (10.0 * forces).tolist(),
        "moment": (2.0 * moments + np.array([0.3, 0.1, -0.2])).tolist(),
    }
    tried = answered({**ASKED, "poses": [pose] * 400, "known_load": known})["torque"]
    sizes = np.abs(np.array(tried))
    assert np.all(sizes <= greatest * (1 + 1e-12))
    np.testing.assert_allclose(np.diag(sizes[:3]), greatest, rtol=1e-11)


def test_gears_that_lock_hold_what_would_drive_them_back() -> None:
    """A coefficient at which the pair cannot be driven back, though the motor still turns it."""
    pair = MESH | {"friction_coefficient": 1.9}
    how = {"contact": "recess_end", "sense": "back_driving"}
    assert through([pair], 1.0, **how)["self_locking"]
    found = answered({**ASKED, **how, "mechanism": GEARED | {"train": [pair]}})
    assert found["self_locking"] == [True, True, False]
    assert found["back_driving_factor"] == [None, None, 1.0]
    assert found["torque"][0][:2] == [None, None]
    assert found["frictionless_torque"][0][:2] == pytest.approx([-31.928] * 2, rel=1e-4)


def test_poses_out_of_reach_have_no_torques() -> None:
    found = answered(ASKED | {"poses": [[1.0, 0.0, 0.0, 0.0, 0.0, 0.0], AHEAD]})
    assert found["torque"][0] == [None] * 3
    assert None not in found["torque"][1]
    assert {entry["reason"] for entry in found["obstacles"]} == {"reach"}


def test_nobody_knows_the_sense_of_motors_whose_axes_align() -> None:
    aligned = [0.05, 0.0, 0.0, 0.3, 0.5 * math.pi, 0.2]
    body = {**ASKED, "poses": [aligned, AHEAD, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]]}
    found = answered(
        {**body, "known_load": {"moment": [1.0, 2.0, 3.0]}, "angular_velocity": [1, 2, 3]}
    )
    assert [None in row for row in found["sense"]] == [True, False, True]
    plain, told = found["frictionless_torque"][0], found["torque"][0]
    assert None not in plain
    assert told == [None, None, plain[2]]


def test_meshes_that_all_but_lock_lock_together() -> None:
    """Each takes about a million times the torque, a hundred more than there are numbers for."""
    place, sine = math.hypot(0.024, 0.065), 0.024 / math.hypot(0.024, 0.065)
    lever = math.tan(math.asin(sine)) + place / (0.3 * math.sqrt(1.0 - sine**2))
    pair = MESH | {"friction_coefficient": (1.0 - 1e-6) / lever}
    few, many = (
        answered({**ASKED, "mechanism": GEARED | {"train": [pair] * n}, "contact": "approach_end"})
        for n in (2, 100)
    )
    assert few["driving_factor"][0] > 1e10
    assert many["driving_factor"] == [None, None, 1.0]
    assert many["torque"][0][:2] == [None, None]


def test_the_starters_gears_make_its_k() -> None:
    spec = STARTERS["geared_decoupled"].model_dump()
    ratios = [mesh["output"]["teeth"] / mesh["input"]["teeth"] for mesh in spec["train"]]
    wrist = spec["wrist"]
    assert math.prod(ratios) == pytest.approx(wrist["k1"] * wrist["k2"] * wrist["kp"], rel=1e-13)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"mechanism": {k: v for k, v in GEARED.items() if k != "train"}}, "/mechanism/train"),
        (
            {
                "mechanism": {"kind": "five_bar", "base_distance": 1.0, "crank_length": 1.0}
                | {"rod_length": 1.0},
                "poses": [[0.0, 1.0]],
            },
            "/mechanism/kind",
        ),
        ({"contact": "mean"}, "/mechanism/train/0"),
        ({"poses": [[0.0] * 3]}, "/poses/0"),
        ({"angular_velocity": [[1.0, 0.0, 0.0]] * 2}, "/angular_velocity"),
        ({"known_load": {"moment": [[1.0, 0.0, 0.0]] * 2}}, "/known_load/moment"),
        (
            {"mechanism": GEARED | {"train": [MESH, MESH | {"pitch_point": [0.0, 0.1]}]}},
            "/mechanism/train/1",
        ),
    ],
)
def test_what_does_not_fit_is_named(change: Document, told: str) -> None:
    with pytest.raises(AnalysisError, match=told):
        parsed(ASKED | change)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"train": [MESH]}, "either train"),
        ({"mechanism": None}, "either train"),
        ({"poses": None}, "needs poses"),
        ({"output_torque": 1.0}, "takes no output_torque"),
        ({"curve_points": 10}, "takes no curve_points"),
        ({"known_load": None}, "needs load or known_load"),
        ({"load": {"moment": 1.0}, "angular_velocity": [1.0, 0.0, 0.0]}, "open direction"),
    ],
)
def test_a_request_is_about_one_thing(change: Document, told: str) -> None:
    with pytest.raises(ValidationError, match=told):
        parsed(ASKED | change)


def test_a_train_takes_nothing_of_a_mechanism() -> None:
    with pytest.raises(ValidationError, match="takes no poses"):
        through([MESH], 1.0, poses=[AHEAD])
