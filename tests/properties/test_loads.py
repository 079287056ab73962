"""Efforts of every kind and motion: the closed form, its worst directions, the platform's body."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.effort import signed_efforts, worst_efforts, worst_load
from mechanics.loads import Load
from tests.oracles import legs
from tests.oracles.legs import Floats
from tests.properties.mechanisms import (
    FEW,
    NAMES,
    Case,
    ask,
    axes,
    customs,
    numbers,
    vectors,
    well_held,
    well_held_cases,
)

EVERY = pytest.mark.parametrize("name", NAMES)
GRAVITY = np.array([0.0, 0.0, -9.80665])


def some_load(data: st.DataObject) -> Load:
    known = np.array(data.draw(vectors(20.0)) + data.draw(vectors(5.0)))[:, None]
    return Load(data.draw(numbers(0.0, 50.0)), data.draw(numbers(0.0, 20.0)), known)


def rows_of(case: Case) -> Floats:
    return legs.effort_rows(case.machine, case.row, case.actuators)


@EVERY
@FEW
@given(data=st.data())
def test_efforts_are_the_closed_form(name: str, data: st.DataObject) -> None:
    case, load = well_held_cases(data, name), some_load(data)
    rows = rows_of(case)
    signed = -rows @ load.known[:, 0]
    forces, moments = np.linalg.norm(rows[:, :3], axis=1), np.linalg.norm(rows[:, 3:], axis=1)
    worst = np.abs(signed) + load.force * forces + load.moment * moments
    slack = 1e-10 * (np.abs(rows).max() * (1 + np.abs(load.known).max()))
    np.testing.assert_allclose(signed_efforts(case.block, load)[:, 0], signed, atol=slack)
    np.testing.assert_allclose(worst_efforts(case.block, load)[:, 0], worst, atol=slack)


@EVERY
@FEW
@given(data=st.data())
def test_the_worst_load_asks_exactly_the_worst_effort(name: str, data: st.DataObject) -> None:
    case, load = well_held_cases(data, name), some_load(data)
    worst, found = worst_efforts(case.block, load)[:, 0], worst_load(case.block, load)
    for leg in range(len(case.pose)):
        wrench = np.concatenate([found.force[leg], found.moment[leg]])
        asked = signed_efforts(case.block, Load(known=load.known + wrench))[leg, 0]
        assert abs(asked) == pytest.approx(worst[leg], rel=1e-11, abs=1e-11 * worst.max())
        assert np.linalg.norm(wrench[:3]) <= load.force * (1 + 1e-12)
        assert np.linalg.norm(wrench[3:]) <= load.moment * (1 + 1e-12)


@EVERY
@FEW
@given(data=st.data())
def test_no_direction_asks_more(name: str, data: st.DataObject) -> None:
    case, load = well_held_cases(data, name), some_load(data)
    worst = worst_efforts(case.block, load)[:, 0]
    for _ in range(5):
        force, moment = legs.unit(data.draw(axes())), legs.unit(data.draw(axes()))
        wrench = np.concatenate([load.force * force, load.moment * moment])[:, None]
        asked = np.abs(signed_efforts(case.block, Load(known=load.known + wrench))[:, 0])
        assert np.all(asked <= worst + 1e-11 * worst.max())


@EVERY
@FEW
@given(data=st.data())
def test_units_are_those_of_each_drive(name: str, data: st.DataObject) -> None:
    case = well_held_cases(data, name)
    answer = ask(case.request("effort", load={"force": 1.0, "moment": 0.5}))
    assert answer["units"] == ["N·m" if d in ("crank", "arc") else "N" for d in case.drives]
    rows = rows_of(case)
    expected = np.linalg.norm(rows[:, :3], axis=1) + 0.5 * np.linalg.norm(rows[:, 3:], axis=1)
    np.testing.assert_allclose(answer["effort"][0], expected, rtol=1e-9, atol=1e-12)


def body(data: st.DataObject) -> tuple[float, Floats, Floats, Floats]:
    """Draw mass, centre of mass, inertia tensor and gravity."""
    columns = np.array([data.draw(vectors()) for _ in range(3)])
    spread = columns @ columns.T
    gravity = np.array(data.draw(st.one_of(st.just([0.0, 0.0, -9.80665]), vectors(10.0))))
    return (
        data.draw(numbers(0.0, 20.0)),
        np.array(data.draw(vectors())),
        # Of a body that is spread so about its centre: every such tensor can be.
        np.trace(spread) * np.eye(3) - spread,
        gravity,
    )


def as_words(mass: float, centre: Floats, inertia: Floats, gravity: Floats) -> dict[str, object]:
    return {
        "mass": mass,
        "centre_of_mass": centre.tolist(),
        "inertia": inertia.tolist(),
        "gravity": gravity.tolist(),
    }


def hand_made(
    case: Case, parts: tuple[float, Floats, Floats, Floats], rates: Floats, changes: Floats
) -> Floats:
    """Return weight and inertia as a wrench: -d/dt of both momenta, and m g at the centre."""
    mass, centre, inertia, gravity = parts
    _, rotation = legs.place(case.machine, case.row)
    arm, tensor = rotation @ centre, rotation @ inertia @ rotation.T
    turn, swing = rates[3:], changes[3:]
    acceleration = changes[:3] + np.cross(swing, arm) + np.cross(turn, np.cross(turn, arm))
    force = mass * (gravity - acceleration)
    spin = tensor @ swing + np.cross(turn, tensor @ turn)
    return np.concatenate([force, np.cross(arm, force) - spin])


@EVERY
@FEW
@given(data=st.data())
def test_a_platform_weighs_as_its_hand_made_load(name: str, data: st.DataObject) -> None:
    case, parts = well_held_cases(data, name), body(data)
    count = len(case.pose)
    rates, changes = (
        case.twists
        @ np.array(data.draw(st.lists(numbers(-3.0, 3.0), min_size=count, max_size=count)))
        for _ in range(2)
    )
    wrench = hand_made(case, parts, rates, changes)
    moving = {"platform_rates": [rates.tolist()], "platform_accelerations": [changes.tolist()]}
    given_ = ask(case.request("effort", platform=as_words(*parts), **moving))["effort"][0]
    known = {"force": wrench[:3].tolist(), "moment": wrench[3:].tolist()}
    expected = ask(case.request("effort", known_load=known))["effort"][0]
    # Loads are rounded where they are made, and the load that the motion lacks is left out.
    slack = 1e-11 * np.abs(rows_of(case)).max() * (1 + np.abs(wrench).max())
    np.testing.assert_allclose(given_, expected, rtol=0, atol=slack)


def momenta(
    case: Case, parts: tuple[float, Floats, Floats, Floats], rates: Floats, changes: Floats
) -> Floats:
    """Return, by differences of places alone, the rates of momentum about where the point is now.

    The platform moves by v t + a t^2 / 2 and turns by exp(w t + alpha t^2 / 2).
    """
    mass, centre, inertia, _ = parts
    _, rotation = legs.place(case.machine, case.row)

    def turned(time: float) -> Floats:
        vector = rates[3:] * time + changes[3:] * time**2 / 2
        angle = float(np.linalg.norm(vector))
        return (legs.about(vector / angle, angle) if angle else np.eye(3)) @ rotation

    def middle(time: float) -> Floats:
        shift: Floats = rates[:3] * time + changes[:3] * time**2 / 2
        return shift + turned(time) @ centre

    step = 1e-3

    def momentum(time: float) -> Floats:
        speed = (middle(time + step) - middle(time - step)) / (2 * step)
        skew = (turned(time + step) - turned(time - step)) / (2 * step) @ turned(time).T
        turn = np.array([skew[2, 1] - skew[1, 2], skew[0, 2] - skew[2, 0], skew[1, 0] - skew[0, 1]])
        spin = turned(time) @ inertia @ turned(time).T @ turn / 2
        return np.concatenate([mass * speed, mass * np.cross(middle(time), speed) + spin])

    made: Floats = (momentum(step) - momentum(-step)) / (2 * step)
    return made


@FEW
@given(data=st.data())
def test_inertia_is_the_rate_of_momentum(data: st.DataObject) -> None:
    """Differences with steps of 1e-3 s at rates below 3: truncation about (3e-3)^2 of 20 N m."""
    case, parts = well_held(data.draw(customs("spatial"))), body(data)
    rates = np.array(data.draw(vectors(3.0)) + data.draw(vectors(1.5)))
    changes = np.array(data.draw(vectors(3.0)) + data.draw(vectors(3.0)))
    weight = parts[0] * parts[3]
    _, rotation = legs.place(case.machine, case.row)
    wrench = np.concatenate([weight, np.cross(rotation @ parts[1], weight)])
    wrench = wrench - momenta(case, parts, rates, changes)
    found = ask(
        case.request(
            "effort",
            platform=as_words(*parts),
            platform_rates=[rates.tolist()],
            platform_accelerations=[changes.tolist()],
        )
    )["effort"][0]
    rows = rows_of(case)
    slack = 2e-4 * np.abs(rows).max() * (1 + np.abs(wrench).max())
    np.testing.assert_allclose(found, -rows @ wrench, rtol=0, atol=slack)


def test_weight_alone_points_down() -> None:
    """2 kg on three upright rails with rods at 45 degrees: each drive lifts a third."""
    document = {
        "kind": "delta_linear",
        "rail_radius": 0.35,
        "platform_radius": 0.05,
        "carriage_arm": 0.0,
        "tool_offset": 0.0,
        "rod_length": 0.5,
    }
    case = Case(document, (0.0, 0.0, 0.0))
    answer = ask(case.request("effort", platform={"mass": 2.0}))
    assert answer["effort"][0] == pytest.approx([2.0 * 9.80665 / 3] * 3, rel=1e-12)
