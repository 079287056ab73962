"""`forward_kinematics` from guesses, over HTTP."""

import math
from typing import Any

import pytest

from tests.service.services import Service

UPRIGHT = math.pi / 2
FIVE_BAR = {"kind": "five_bar", "base_distance": 0.6, "crank_length": 0.5, "rod_length": 0.5}


@pytest.mark.parametrize(
    ("guess", "left"),
    [
        ([0.0, 0.8], False),
        # There the drives next to upright cross the elbows: the rods lie in line on the way.
        ([0.0, -0.2], True),
        # There the first crank leans the other way: its leg is stretched or folded on the way.
        ([-0.4, 0.6], True),
        # Out of reach, so that the mechanism cannot start there.
        ([0.0, 1.1], None),
    ],
)
def test_a_guess_that_left_its_mode_is_marked(
    refusing: Service, guess: list[float], left: bool | None
) -> None:
    asked = {"analysis": "forward_kinematics", "mechanism": FIVE_BAR, "guess": guess}
    answer = refusing.post("/v1/analyses", asked | {"actuators": [[UPRIGHT, UPRIGHT]]})
    (step,) = answer.json()["newton"]
    assert (step["converged"], step["left_mode"]) == (True, left)


def test_what_did_not_converge_has_left_for_nowhere(refusing: Service) -> None:
    asked = {"analysis": "forward_kinematics", "mechanism": FIVE_BAR, "guess": [0.1, 0.1]}
    answer = refusing.post("/v1/analyses", asked | {"actuators": [[math.pi, 0.0]]})
    (step,) = answer.json()["newton"]
    assert (step["converged"], step["left_mode"]) == (False, None)


@pytest.mark.parametrize(
    ("guess", "told"),
    [
        ([None, 0.8], {"/guess/0": "should be a valid number; given None"}),
        ([[0.0, 0.8], 0.8], {"/guess/1": "should be a valid list; given 0.8"}),
        ([[0.0, 0.8]] * 700 + [[0.0, {}]], {"/guess/700/1": "should be a valid number; given {}"}),
    ],
)
def test_what_is_told_of_a_guess_is_what_is_wrong_with_it(
    refusing: Service, guess: list[Any], told: dict[str, str]
) -> None:
    """And not how it differs from the other of the two forms."""
    asked = {"analysis": "forward_kinematics", "mechanism": FIVE_BAR, "guess": guess}
    answer = refusing.post("/v1/analyses", asked | {"actuators": [[UPRIGHT, UPRIGHT]]})
    assert answer.status_code == 422
    assert {one["pointer"]: one["detail"] for one in answer.json()["errors"]} == told
