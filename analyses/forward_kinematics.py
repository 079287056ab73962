"""Forward kinematics: all assembly modes at drive positions, or the one reached from a guess."""

from functools import partial
from typing import Any

import numpy as np

from analyses.analysis import Analysis, Arrays, Stretches, by_blocks, joined
from analyses.columns import BYTES_PER_NUMBER, nullable
from analyses.errors import AnalysisError
from analyses.mechanisms import build
from analyses.poses import check_rows, drive_obstacles, obstacle_rows
from analyses.units import determinant_unit
from mechanics.arrays import Floats
from mechanics.assembly.aspects import UNKNOWN
from mechanics.assembly.modes import Modes
from mechanics.forward import assembly_modes, nearby_modes, searched
from mechanics.mechanism import Mechanism
from schemas.forward_kinematics import (
    AssemblyMode,
    ForwardKinematicsGuessResult,
    ForwardKinematicsRequest,
    ForwardKinematicsResult,
    Iteration,
)
from schemas.poses import Obstacle
from schemas.quantities import Model

SECONDS_ALL = {
    "planar_translation": 5e-5,
    "translation": 5e-5,
    "planar": 1.5e-4,
    "schoenflies": 3e-4,
    "spherical": 3e-4,
    "spatial": 4e-3,
}
"""Of all modes of a row, by motion. [s]"""
SECONDS_SEARCHED = 5e-2
"""Of all modes of a row that are searched from random poses. [s]"""
LOOKED_AT = 32
"""Rows looked at to tell how many will be."""
SECONDS_FROM_GUESS = 3e-4
MODES = {
    "planar_translation": 2,
    "translation": 2,
    "planar": 6,
    "schoenflies": 8,
    "spherical": 8,
    "spatial": 40,
}
"""How many modes there are at most."""
TOLD = {0: False, 1: True, UNKNOWN: None}
"""Whether a guess has left its mode, on the wire."""


class ForwardKinematics(Analysis[ForwardKinematicsRequest]):
    """Answers `forward_kinematics`."""

    name = "forward_kinematics"

    def check(self, request: ForwardKinematicsRequest, node_limit: int) -> None:
        """Raise AnalysisError if a row of drives or a guess does not fit the mechanism."""
        mechanism = build(request.mechanism)
        rows = request.actuators
        for number, row in enumerate(rows):
            _check_width(f"/actuators/{number}", row, mechanism.drive_count, "one per drive")
        names = mechanism.motion.coordinates
        if _one_for_all(request):
            _check_width("/guess", _guesses(request)[0], len(names), ", ".join(names))
        elif request.guess is not None:
            check_rows("/guess", _guesses(request), len(rows), len(names), "row of actuators")

    def items(self, request: ForwardKinematicsRequest) -> int:
        """Return the number of rows."""
        return len(request.actuators)

    def seconds_per_item(self, request: ForwardKinematicsRequest) -> float:
        """Return the cost of a row. [s]"""
        if request.guess is not None:
            return SECONDS_FROM_GUESS
        mechanism = build(request.mechanism)
        some = request.actuators[:: max(1, len(request.actuators) // LOOKED_AT)]
        share = float(np.mean(searched(mechanism, _rows(some))))
        return SECONDS_ALL[_closed_by_legs(mechanism)] + share * SECONDS_SEARCHED

    def result_bytes(self, request: ForwardKinematicsRequest) -> int:
        """Return the size of the modes in JSON, if there are as many as can be. [B]"""
        mechanism = build(request.mechanism)
        modes = 1 if request.guess is not None else MODES[_closed_by_legs(mechanism)]
        numbers = len(mechanism.motion.coordinates) + 4
        return len(request.actuators) * modes * numbers * BYTES_PER_NUMBER

    def compute(self, request: ForwardKinematicsRequest, start: int, stop: int) -> Arrays:
        """Return the modes of the rows `start` to `stop`, and how many each row has."""
        block = self._all if request.guess is None else self._from_guess
        return by_blocks(partial(block, request), start, stop)

    def _all(self, request: ForwardKinematicsRequest, start: int, stop: int) -> Arrays:
        mechanism = build(request.mechanism)
        drives = _rows(request.actuators[start:stop])
        found = assembly_modes(mechanism, drives)
        return {
            "counts": found.counts,
            "routes": np.array(found.routes, dtype="U32"),
            "certified": found.certified,
            **_columns(found.modes),
            **drive_obstacles(mechanism, drives.T, start),
        }

    def _from_guess(self, request: ForwardKinematicsRequest, start: int, stop: int) -> Arrays:
        mechanism = build(request.mechanism)
        own = slice(None) if _one_for_all(request) else slice(start, stop)
        guesses = _rows(_guesses(request)[own])
        drives = _rows(request.actuators[start:stop])
        guesses = np.broadcast_to(guesses, (len(drives), guesses.shape[1]))
        found = nearby_modes(mechanism, drives, guesses)
        return {
            "converged": found.converged,
            "iterations": found.iterations,
            "left": found.left,
            **_columns(found.modes),
            **drive_obstacles(mechanism, drives.T, start),
        }

    def assemble(self, request: ForwardKinematicsRequest, stretches: Stretches) -> Model:
        """Return the modes of all rows."""
        arrays = joined(stretches())
        unit = determinant_unit(build(request.mechanism))
        modes = _modes(arrays)
        obstacles = [Obstacle.model_construct(**row) for row in obstacle_rows(arrays)]
        if request.guess is not None:
            return ForwardKinematicsGuessResult.model_construct(
                analysis=self.name,
                determinant_unit=unit,
                assembly_modes=[
                    [mode] if reached else []
                    for mode, reached in zip(modes, arrays["converged"], strict=True)
                ],
                newton=_iterations(arrays),
                obstacles=obstacles,
            )
        ends = np.cumsum(arrays["counts"]).tolist()
        return ForwardKinematicsResult.model_construct(
            analysis=self.name,
            determinant_unit=unit,
            assembly_modes=[modes[a:b] for a, b in zip([0, *ends[:-1]], ends, strict=True)],
            route=arrays["routes"].tolist(),
            certified=arrays["certified"].tolist(),
            obstacles=obstacles,
        )


def _closed_by_legs(mechanism: Mechanism) -> str:
    """Return the motion whose modes are sought: under a wrist, that of what the legs carry."""
    own = mechanism if mechanism.wrist is None else mechanism.carrier
    return own.motion.name


def _guesses(request: ForwardKinematicsRequest) -> list[list[float]]:
    guess: list[Any] = list(request.guess or [])
    return [guess] if _one_for_all(request) else guess


def _one_for_all(request: ForwardKinematicsRequest) -> bool:
    return request.guess is not None and not any(isinstance(row, list) for row in request.guess)


def _check_width(pointer: str, row: list[float], width: int, told: str) -> None:
    if len(row) != width:
        raise AnalysisError((pointer, f"must have {width} numbers ({told}); given {len(row)}"))


def _rows(rows: list[list[float]]) -> Floats:
    return np.array(rows, dtype=float)


def _columns(modes: Modes) -> Arrays:
    """Return what is known of modes, one row each, also where there are none."""
    return {
        "poses": modes.poses.T,
        "working_modes": modes.working_modes.T,
        "determinants": modes.determinants,
        "sides": modes.sides,
        "residuals": modes.residuals,
    }


def _modes(arrays: Arrays) -> list[AssemblyMode]:
    names = ("poses", "working_modes", "determinants", "sides", "residuals")
    columns = [arrays[name].tolist() for name in names]
    return [AssemblyMode(*row) for row in zip(*columns, strict=True)]


def _iterations(arrays: Arrays) -> list[Iteration]:
    left = [TOLD[known] for known in arrays["left"].tolist()]
    poses, residuals = nullable(arrays["poses"]), nullable(arrays["residuals"])
    columns = arrays["converged"].tolist(), arrays["iterations"].tolist(), left, poses, residuals
    return [Iteration(*row) for row in zip(*columns, strict=True)]
