"""A mechanism moved and turned as a whole, platform and load with it, is the same mechanism."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.effort import signed_efforts, worst_efforts, worst_load
from mechanics.loads import Load
from mechanics.singularity import singularities
from tests.oracles import legs
from tests.oracles.legs import Floats
from tests.properties.mechanisms import FEW, Case, axes, customs, numbers, vectors, well_held


@st.composite
def pairs(draw: st.DrawFn) -> tuple[Case, Case, Floats]:
    """Draw a spatial mechanism, its like elsewhere, and the rotation between them."""
    case = well_held(draw(customs("spatial")))
    turn = legs.about(legs.unit(draw(axes())), draw(numbers(-3.0, 3.0)))
    shift = np.array(draw(vectors(2.0)))

    def moved(leg: dict[str, Any]) -> dict[str, Any]:
        turned: dict[str, Any] = {
            name: [float(number) for number in turn @ np.array(leg[name])]
            for name in map(str, ("axis", "zero_direction", "direction"))
            if name in leg
        }
        base = [float(number) for number in turn @ np.array(leg["base_point"]) + shift]
        return {**leg, **turned, "base_point": base}

    point, rotation = legs.place(case.machine, case.row)
    pose = (*(turn @ point + shift), *legs.angles_of(turn @ rotation))
    document = {**case.document, "legs": [moved(leg) for leg in case.document["legs"]]}
    return case, Case(document, tuple(float(number) for number in pose)), turn


@FEW
@given(pairs())
def test_drives_stay(pair: tuple[Case, Case, Floats]) -> None:
    here, there, _ = pair
    gap = there.actuators - here.actuators
    turning = np.array([drive == "crank" for drive in here.drives])
    assert np.abs(np.where(turning, np.sin(gap), gap)).max() < 1e-11


@FEW
@given(pairs())
def test_determinants_stay(pair: tuple[Case, Case, Floats]) -> None:
    here, there, _ = pair
    assert there.block.determinants[0] == pytest.approx(here.block.determinants[0], rel=1e-9)


@FEW
@given(pairs())
def test_closeness_to_singularities_stays(pair: tuple[Case, Case, Floats]) -> None:
    here, there = (singularities(case.block) for case in pair[:2])
    assert there.type[0] == here.type[0] == 0
    assert there.condition_number[0] == pytest.approx(here.condition_number[0], rel=1e-9)
    np.testing.assert_allclose(there.pressure_angles, here.pressure_angles, atol=1e-8)


@FEW
@given(pairs(), numbers(0.0, 20.0), numbers(0.0, 20.0), vectors(10.0), vectors(10.0))
def test_efforts_stay(
    pair: tuple[Case, Case, Floats],
    force: float,
    moment: float,
    push: list[float],
    twist: list[float],
) -> None:
    here, there, turn = pair
    known = np.concatenate([push, twist])[:, None]
    turned = np.concatenate([turn @ push, turn @ twist])[:, None]
    first, second = Load(force, moment, known), Load(force, moment, turned)
    size = np.abs(worst_efforts(here.block, first)).max() + 1e-12
    for efforts in (signed_efforts, worst_efforts):
        found, expected = efforts(there.block, second), efforts(here.block, first)
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * size)


@FEW
@given(pairs())
def test_worst_loads_turn_along(pair: tuple[Case, Case, Floats]) -> None:
    here, there, turn = pair
    found, before = (worst_load(case.block, Load(5.0, 2.0)) for case in (there, here))
    for made, old in ((found.force, before.force), (found.moment, before.moment)):
        expected = old[..., 0] @ turn.T
        np.testing.assert_allclose(
            np.abs(np.sum(made[..., 0] * expected, axis=1)),
            np.sum(old[..., 0] ** 2, axis=1),
            rtol=1e-8,
        )
