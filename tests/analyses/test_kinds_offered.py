"""Every kind that is offered works as offered: its example, its presets, its analyses."""

import json

import numpy as np
import pytest

import analyses
from analyses.mechanisms import build, check_mechanism
from mechanics.configuration import Configuration
from schemas.kinds import Kind
from schemas.mechanisms import (
    KINDS,
    InlineMechanism,
    canonical_json,
    mechanism_id,
    parse_spec,
)
from tests.oracles import legs
from tests.oracles.draws import WRISTED
from tests.properties.mechanisms import Document, ask

OFFERED = {kind.kind: kind for kind in analyses.offered_kinds()}
EACH = pytest.mark.parametrize("kind", OFFERED.values(), ids=OFFERED)
MACHINES: dict[str, InlineMechanism] = {
    f"{kind.kind} {name}": spec
    for kind in OFFERED.values()
    for name, spec in [
        ("example", kind.example),
        *((preset.name, preset.mechanism) for preset in kind.presets),
    ]
}
MACHINE = pytest.mark.parametrize("spec", MACHINES.values(), ids=MACHINES)


def reachable(spec: InlineMechanism) -> list[float]:
    """Return a pose that all legs reach, from a wide search."""
    mechanism = build(spec)
    turns = len(mechanism.motion.turns)
    random = np.random.default_rng(3)
    poses = random.uniform(-1.0, 1.0, (len(mechanism.motion.coordinates), 100_000))
    poses[len(poses) - turns :] *= 0.5
    block = Configuration(mechanism, poses)
    held = ~np.isnan(block.actuators).any(axis=0)
    steady = np.where(held, np.abs(np.nan_to_num(block.determinants)), -1.0)
    assert steady.max() > 0
    return [float(number) for number in poses[:, int(steady.argmax())]]


def test_every_kind_is_offered() -> None:
    assert set(OFFERED) == set(KINDS)


@MACHINE
def test_machines_are_regular(spec: InlineMechanism) -> None:
    check_mechanism(spec)


@MACHINE
def test_machines_reach_somewhere(spec: InlineMechanism) -> None:
    reachable(spec)


@EACH
def test_kinds_describe_their_examples(kind: Kind) -> None:
    if kind.kind not in WRISTED:
        machine = legs.read(kind.example.model_dump(mode="json"))
        assert kind.motion == machine.motion
        assert len(kind.coordinates) == len(machine.legs)
    assert len(kind.coordinates) == len(kind.coordinate_units) == len(kind.drives)
    assert {"inverse_kinematics", "velocity", "effort", "singularity"} <= set(kind.analyses)


@EACH
def test_every_analysis_offered_answers(kind: Kind) -> None:
    pose = reachable(kind.example)
    count = len(pose)
    document = kind.example.model_dump(mode="json")
    common: Document = {"mechanism": document, "poses": [pose]}
    requests: dict[str, Document] = {
        "inverse_kinematics": common,
        "forward_kinematics": {
            "mechanism": document,
            "actuators": ask({"analysis": "inverse_kinematics", **common})["actuators"],
        },
        "velocity": {**common, "actuator_rates": [[0.1] * count]},
        "effort": {**common, "load": {"force": 1.0}},
        "singularity": common,
        "friction_torque": {**common, "load": {"moment": 1.0}, "contact": "worst"},
        "workspace": {
            "mechanism": document,
            "class": "theoretical",
            "type": "constant_orientation" if kind.motion != "spherical" else "orientation",
            "grid": [
                {"coordinate": kind.coordinates[0], "min": pose[0], "max": pose[0], "step": 1}
            ],
            "fixed": dict(zip(kind.coordinates[1:], pose[1:], strict=True)),
        },
    }
    for analysis in kind.analyses:
        answer = ask({"analysis": analysis, **requests[analysis]})
        if analysis == "workspace":
            assert answer["inside"] == 1
        elif analysis == "forward_kinematics":
            assert answer["assembly_modes"][0]
        else:
            assert answer["obstacles"] == []


@MACHINE
def test_the_canonical_form_is_its_own(spec: InlineMechanism) -> None:
    text = canonical_json(spec)
    assert canonical_json(parse_spec(text)) == text
    assert parse_spec(text) == spec


def spelled_otherwise(document: Document) -> Document:
    """Return the same with other order, whole numbers as such and defaults left out."""
    kept = {
        name: value
        for name, value in document.items()
        if value is not None and name not in ("working_mode", "actuator_limits")
    }

    def whole(value: object) -> object:
        if isinstance(value, float) and value.is_integer():
            return int(value)
        if isinstance(value, list):
            return [whole(part) for part in value]
        if isinstance(value, dict):
            return {name: whole(value[name]) for name in reversed(value)}
        return value

    return {name: whole(kept[name]) for name in reversed(kept)}


@EACH
def test_one_id_however_it_is_spelled(kind: Kind) -> None:
    document = spelled_otherwise(kind.example.model_dump(mode="json"))
    assert mechanism_id(parse_spec(json.dumps(document))) == mechanism_id(kind.example)


def test_ids_of_all_machines_differ() -> None:
    plain = {canonical_json(spec) for spec in MACHINES.values()}
    assert len({mechanism_id(spec) for spec in MACHINES.values()}) == len(plain)
