"""Whether a guess has left its mode, held against signs worked out one pose at a time."""

import json
from typing import Any, NamedTuple

import numpy as np
import pytest

from tests.oracles import legs
from tests.oracles.draws import DRAWS, EVERY
from tests.oracles.legs import Floats, Machine
from tests.properties.mechanisms import ask

Document = dict[str, Any]
CLEAR = 1e-4
"""Signs of what is smaller, as a share of its greatest, are not asked for."""


class Way(NamedTuple):
    """Drives, a guess, the inverse solutions there in all working modes, and what is answered."""

    drives: Floats
    guess: Floats
    solutions: Floats
    newton: Document
    modes: list[Document]


def ways(wire: Document, targets: Floats, guesses: Floats) -> list[Way]:
    """Return what guesses lead to, of those targets that are in reach."""
    asked = {"analysis": "inverse_kinematics", "mechanism": wire}
    drives = ask(asked | {"poses": targets.tolist()})["actuators"]
    held = [k for k, row in enumerate(drives) if None not in row]
    rows, tried = [drives[k] for k in held], guesses[held]
    there = ask(asked | {"poses": tried.tolist(), "working_mode": "all"})["actuators"]
    solutions = np.array(there, dtype=float).transpose(1, 0, 2)
    body = {"analysis": "forward_kinematics", "mechanism": wire}
    found = ask(body | {"actuators": rows, "guess": tried.tolist()})
    columns = (np.array(rows), tried, solutions, found["newton"], found["assembly_modes"])
    return [Way(*row) for row in zip(*columns, strict=True)]


def nearest(machine: Machine, way: Way) -> Floats:
    """Return each leg's solution at the guess that is next to its drive; NaN: none."""
    gaps = way.solutions - way.drives
    turning = [leg.drive in ("crank", "arc") for leg in machine.legs]
    gaps = np.where(turning, np.abs(np.angle(np.exp(1j * gaps))), np.abs(gaps))
    chosen = np.argmin(np.where(np.isnan(gaps), np.inf, gaps), axis=0)
    solutions: Floats = way.solutions[chosen, np.arange(len(turning))]
    return solutions


def signs(machine: Machine, pose: Floats, drives: Floats) -> Floats | None:
    """Return those of det Jx and of each leg's lever; None where one is not clear."""
    rows, levers = legs.leg_rows(machine, pose, drives)
    scaled = legs.at_size(machine, rows)
    share = np.linalg.det(scaled) / np.prod(np.linalg.norm(scaled, axis=1))
    if min(abs(share), legs.transmission(machine, pose, drives).min()) < CLEAR:
        return None
    return np.sign([share, *levers])


def expected(machine: Machine, way: Way) -> tuple[bool | None, bool]:
    """Return whether the guess has left its mode, and whether that can be asked for."""
    drives = nearest(machine, way)
    if not way.newton["converged"] or np.isnan(drives).any():
        return None, True
    before = signs(machine, way.guess, drives)
    after = signs(machine, np.array(way.modes[0]["pose"]), way.drives)
    if before is None or after is None:
        return None, False
    return bool(np.any(before != after)), True


def drawn(name: str, seed: int) -> tuple[Document, Floats, Floats]:
    """Return a mechanism on the wire and two poses a row, near each other and far."""
    random = np.random.default_rng(seed)
    draw = EVERY[name](random)
    targets, others = random.uniform(draw.least, draw.most, (2, 60, draw.least.size))
    share = random.choice([0.0, 1e-3, 0.1, 1.0], (60, 1))
    wire = json.loads(json.dumps(draw.wire, default=float))
    return wire, targets, targets + share * (others - targets)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", sorted(DRAWS))
def test_left_is_what_has_another_sign_at_its_end(name: str, seed: int) -> None:
    wire, *poses = drawn(name, seed)
    machine = legs.read(wire)
    seen = 0
    for way in ways(wire, *poses):
        left, clear = expected(machine, way)
        if clear:
            assert way.newton["left_mode"] is left
            seen += 1
    assert seen > 3


@pytest.mark.parametrize("name", sorted(EVERY))
def test_a_guess_that_is_a_mode_has_not_left_it(name: str) -> None:
    """In whatever working mode it is."""
    wire, targets, _ = drawn(name, 5)
    asked = {"analysis": "inverse_kinematics", "mechanism": wire, "poses": targets.tolist()}
    rows = [row for row in ask(asked)["actuators"] if None not in row][:5]
    body = {"analysis": "forward_kinematics", "mechanism": wire}
    every = ask(body | {"actuators": rows})["assembly_modes"]
    pairs = [(row, mode) for row, modes in zip(rows, every, strict=True) for mode in modes]
    clear = [(row, mode) for row, mode in pairs if mode["side"] != 0]
    guesses = [mode["pose"] for _, mode in clear]
    found = ask(body | {"actuators": [row for row, _ in clear], "guess": guesses})
    assert guesses
    assert [step["left_mode"] for step in found["newton"]] == [False] * len(guesses)
