"""Effort: what the drives must bear under a load on the platform."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from analyses.analysis import Analysis, Arrays, joined
from analyses.columns import nullable, nullable_vectors
from analyses.errors import AnalysisError
from analyses.inverse_kinematics import BYTES_PER_NUMBER
from analyses.mechanisms import build
from analyses.poses import check_poses, obstacle_rows, obstacles, pose_conditions, signs
from analyses.units import effort_units
from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.effort import signed_efforts, worst_efforts, worst_load
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from schemas.effort import EffortRequest, EffortResult, KnownLoad
from schemas.poses import Obstacle
from schemas.quantities import Model

SECONDS_PER_LEG = 2e-6
NUMBERS_PER_EFFORT = 7


class Effort(Analysis[EffortRequest]):
    """Answers `effort`."""

    name = "effort"

    def check(self, request: EffortRequest, node_limit: int) -> None:
        """Raise AnalysisError if poses, working mode or loads do not fit."""
        check_poses(_mechanism(request), request.poses)
        if request.known_load is not None:
            _check_rows(request.known_load, len(request.poses))

    def items(self, request: EffortRequest) -> int:
        """Return the number of poses."""
        return len(request.poses)

    def seconds_per_item(self, request: EffortRequest) -> float:
        """Return the cost of a pose. [s]"""
        return SECONDS_PER_LEG * _mechanism(request).leg_count

    def result_bytes(self, request: EffortRequest) -> int:
        """Return the size of efforts and worst loads in JSON. [B]"""
        efforts = len(request.poses) * _mechanism(request).leg_count
        numbers = 1 if request.load is None else NUMBERS_PER_EFFORT
        return efforts * numbers * BYTES_PER_NUMBER

    def compute(self, request: EffortRequest, start: int, stop: int) -> Arrays:
        """Return efforts, worst loads and obstacles of the poses `start` to `stop`."""
        mechanism = _mechanism(request)
        poses = mechanism.columns(np.array(request.poses[start:stop], dtype=float))
        block = Configuration(mechanism, poses)
        load = _load(request, start, stop)
        found = obstacles(block, pose_conditions(mechanism), start, singular=True)
        if request.load is None:
            return {"effort": signed_efforts(block, load).T, **found}
        worst = worst_load(block, load)
        return {
            "effort": worst_efforts(block, load).T,
            "worst_force": np.moveaxis(worst.force, 2, 0),
            "worst_moment": np.moveaxis(worst.moment, 2, 0),
            **found,
        }

    def assemble(self, request: EffortRequest, stretches: Iterable[Arrays]) -> Model:
        """Return the columns of all poses."""
        arrays = joined(stretches)
        mechanism = _mechanism(request)
        worst: dict[str, Any] = {
            name: nullable_vectors(arrays[name]) if name in arrays else None
            for name in ("worst_force", "worst_moment")
        }
        return EffortResult.model_construct(
            analysis=self.name,
            working_mode=signs(mechanism.legs.working_mode),
            units=effort_units(mechanism),
            effort=nullable(arrays["effort"]),
            **worst,
            obstacles=[Obstacle.model_construct(**row) for row in obstacle_rows(arrays)],
        )


def _mechanism(request: EffortRequest) -> Mechanism:
    return build(request.mechanism, request.working_mode)


def _check_rows(known: KnownLoad, poses: int) -> None:
    for name in ("force", "moment"):
        vectors = getattr(known, name)
        if vectors is not None and isinstance(vectors[0], list) and len(vectors) != poses:
            raise AnalysisError(
                (
                    f"/known_load/{name}",
                    f"must be one vector, or one per pose, that is {poses}; given {len(vectors)}",
                )
            )


def _load(request: EffortRequest, start: int, stop: int) -> Load:
    size = request.load
    known = request.known_load
    wrench = (
        np.zeros((6, 1))
        if known is None
        else np.ascontiguousarray(
            np.concatenate([_vectors(v, start, stop) for v in (known.force, known.moment)])
        )
    )
    return Load(0.0 if size is None else size.force, 0.0 if size is None else size.moment, wrench)


def _vectors(vectors: list[float] | list[list[float]] | None, start: int, stop: int) -> Floats:
    rows = np.atleast_2d(np.array(vectors or [0.0, 0.0, 0.0], dtype=float))
    chosen = rows[start:stop] if len(rows) > 1 else rows
    return np.array(np.broadcast_to(chosen.T, (3, stop - start)))
