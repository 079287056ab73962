"""`forward_kinematics` as it is asked: with the inverse's answers, and with what makes no sense."""

import json
from typing import Any

import numpy as np
import pytest

import analyses
from schemas.analyses import parse_request
from tests.oracles.draws import DRAWS, EVERY

FIVE_BAR = {"kind": "five_bar", "base_distance": 0.6, "crank_length": 0.5, "rod_length": 0.5}
ASKED = {"analysis": "forward_kinematics", "mechanism": FIVE_BAR}


def answered(body: dict[str, Any]) -> dict[str, Any]:
    request = parse_request(json.dumps(body, default=float))
    analyses.check(request, 10**6)
    return analyses.answer(request).model_dump()


@pytest.mark.parametrize("name", sorted(EVERY))
def test_a_pose_is_among_the_modes_of_its_drives(name: str) -> None:
    random = np.random.default_rng(8)
    draw = EVERY[name](random)
    poses = random.uniform(draw.least, draw.most, (20, draw.least.size)).tolist()
    inverse = answered({"analysis": "inverse_kinematics", "mechanism": draw.wire, "poses": poses})
    held = [k for k, row in enumerate(inverse["actuators"]) if None not in row][:5]
    drives = [inverse["actuators"][k] for k in held]
    found = answered(ASKED | {"mechanism": draw.wire, "actuators": drives})
    assert held
    for k, modes in zip(held, found["assembly_modes"], strict=True):
        off = [np.abs(np.array(mode["pose"]) - poses[k]).max() for mode in modes]
        assert min(off) < 1e-7
        assert modes[int(np.argmin(off))]["working_mode"] == inverse["working_mode"]
        assert [mode["determinant"] for mode in modes] == sorted(
            (mode["determinant"] for mode in modes), reverse=True
        )
        for mode in modes:
            own = {"mechanism": draw.wire, "poses": [mode["pose"]]}
            back = answered(
                {"analysis": "inverse_kinematics", "working_mode": mode["working_mode"], **own}
            )
            wrapped = np.array(back["actuators"][0], dtype=float) - inverse["actuators"][k]
            assert np.max(np.abs(np.sin(0.5 * wrapped))) < 1e-7
            assert mode["side"] == np.sign(mode["determinant"])


def test_a_guess_leads_to_the_mode_beside_it() -> None:
    drives = [[np.pi / 2, np.pi / 2]] * 2
    above = answered(ASKED | {"actuators": drives, "guess": [0.05, 0.8]})
    assert [row[0]["pose"] for row in above["assembly_modes"]] == [
        pytest.approx([0.0, 0.9], abs=1e-12)
    ] * 2
    each = answered(ASKED | {"actuators": drives, "guess": [[0.05, 0.8], [0.05, 0.2]]})
    assert [row[0]["pose"][1] for row in each["assembly_modes"]] == pytest.approx([0.9, 0.1])
    assert all(step["converged"] and step["iterations"] > 0 for step in each["newton"])


def test_not_to_converge_is_an_answer() -> None:
    found = answered(ASKED | {"actuators": [[np.pi, 0.0]], "guess": [0.1, 0.1]})
    assert found["assembly_modes"] == [[]]
    assert not found["newton"][0]["converged"]
    everything = answered(ASKED | {"actuators": [[np.pi, 0.0]]})
    assert everything["assembly_modes"] == [[]]
    assert everything["certified"] == [True]


def three_struts(at: list[tuple[float, float]]) -> dict[str, Any]:
    legs = [{"drive": "strut", "base_point": [x, y, 0], "platform_point": [x, y, 0]} for x, y in at]
    return {"kind": "custom", "motion": "planar", "legs": legs}


@pytest.mark.parametrize("length", [0.0, -1.0, 1e-300, 1e-12])
def test_struts_of_no_length_lead_nowhere(length: float) -> None:
    mechanism = three_struts([(1.0, 0.1), (-0.5, 0.8), (-0.4, -0.9)])
    body = ASKED | {"mechanism": mechanism, "actuators": [[length, 1.0, 1.0], [0.1, 0.12, 0.11]]}
    found = answered(body | {"guess": [0.1, 0.2, 0.3]})
    assert not found["newton"][0]["converged"]
    assert found["newton"][0]["residual"] is None
    json.dumps(found, allow_nan=False)
    everything = answered(body)
    assert everything["assembly_modes"][0] == []
    assert everything["route"][0] == "impossible drives"


@pytest.mark.parametrize("shift", [0.0, 10.0, 1e3, 1e6])
def test_a_free_platform_is_not_certified_wherever_it_stands(shift: float) -> None:
    legs = [
        {
            "drive": "crank",
            "base_point": [x + shift, 0, 0],
            "axis": [0, 0, 1],
            "zero_direction": [1, 0, 0],
            "crank_length": 0.5,
            "rod_length": 0.5,
            "platform_point": [0, 0, 0],
        }
        for x in (-0.3, 0.3)
    ]
    mechanism = {"kind": "custom", "motion": "planar_translation", "legs": legs}
    # Both elbows stand at one point.
    lean = float(np.arccos(0.6))
    found = answered(ASKED | {"mechanism": mechanism, "actuators": [[lean, np.pi - lean]]})
    assert found["certified"] == [False]


@pytest.mark.parametrize("shift", [0.0, 1e3])
def test_three_equal_struts_on_equal_bodies_are_not_certified(shift: float) -> None:
    mechanism = three_struts([(1.0, 0.1), (-0.5, 0.8), (-0.4, -0.9)])
    for leg in mechanism["legs"]:
        leg["base_point"][0] += shift
    found = answered(ASKED | {"mechanism": mechanism, "actuators": [[0.3, 0.3, 0.3]]})
    assert found["certified"] == [False]


def test_a_singular_mode_is_there_once_and_on_no_side() -> None:
    # Both rods stretched along one line: the elbows are two rods apart.
    found = answered(ASKED | {"actuators": [[np.pi - np.arccos(0.4), np.arccos(0.4)]]})
    assert [mode["side"] for mode in found["assembly_modes"][0]] == [0]
    height = 0.5 * np.sin(np.arccos(0.4))
    assert found["assembly_modes"][0][0]["pose"] == pytest.approx([0.0, height], abs=1e-6)


def test_similar_bodies_on_six_struts_are_priced_as_a_search() -> None:
    random = np.random.default_rng(5)
    base, platform = random.uniform(-1.0, 1.0, (2, 6, 3))
    prices = []
    for points in (platform, 0.5 * base):
        spec = {"base_points": base.tolist(), "platform_points": points.tolist()}
        mechanism = {"kind": "gough_stewart", **spec}
        body = ASKED | {"mechanism": mechanism, "actuators": [[1.0] * 6] * 50}
        request = parse_request(json.dumps(body))
        prices.append(analyses.estimate(request, 0.5).seconds)
    assert prices[1] > 5.0 * prices[0]


@pytest.mark.parametrize("guess", [None, [0.05, 0.8]])
def test_drives_beyond_their_limits_are_answered_and_told(guess: list[float] | None) -> None:
    limited = FIVE_BAR | {"actuator_limits": {"min": 0.0, "max": 1.6}}
    upright = np.pi / 2
    # Both cranks upright; the second a turn further, which is the same angle; the first too far.
    drives = [[upright, upright], [upright, upright + 2.0 * np.pi], [1.7, upright]]
    found = answered(
        ASKED | {"mechanism": limited, "actuators": drives} | ({"guess": guess} if guess else {})
    )
    assert all(found["assembly_modes"])
    (obstacle,) = found["obstacles"]
    assert (obstacle["pose"], obstacle["leg"], obstacle["reason"]) == (2, 0, "actuator_limits")
    assert (obstacle["value"], obstacle["limit"]) == pytest.approx((1.7, 1.6))


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"actuators": [[1.0]]}, "/actuators/0"),
        ({"actuators": [[1.0, 2.0], [1.0, 2.0, 3.0]]}, "/actuators/1"),
        ({"actuators": [[1.0, 2.0]], "guess": [0.0]}, "/guess"),
        ({"actuators": [[1.0, 2.0]], "guess": []}, "/guess"),
        ({"actuators": [[1.0, 2.0]], "guess": [[0.0, 1.0]] * 2}, "/guess"),
        ({"actuators": [[1.0, 2.0]], "guess": [[0.0]]}, "/guess/0"),
    ],
)
def test_rows_must_fit_the_mechanism(changes: dict[str, Any], place: str) -> None:
    with pytest.raises(analyses.AnalysisError) as error:
        answered(ASKED | changes)
    assert error.value.errors[0][0] == place


def test_stretches_put_together_are_the_whole() -> None:
    draw = DRAWS["planar_3rrr"](np.random.default_rng(0))
    random = np.random.default_rng(1)
    body = ASKED | {"mechanism": draw.wire, "actuators": random.uniform(-3, 3, (7, 3)).tolist()}
    request = parse_request(json.dumps(body, default=float))
    parts = [analyses.compute(request, a, b) for a, b in ((0, 2), (2, 3), (3, 7))]
    assert analyses.assemble(request, lambda: parts) == analyses.answer(request)
