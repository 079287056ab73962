"""Effort: what the drives must bear under a load on the platform."""

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from analyses.analysis import Analysis, Arrays, Stretches, by_blocks, joined
from analyses.columns import BYTES_PER_NUMBER, nullable, nullable_vectors
from analyses.loads import check_known_load, load_of, vectors
from analyses.mechanisms import build
from analyses.poses import (
    check_motion,
    check_poses,
    check_rows,
    obstacle_rows,
    obstacles,
    pose_conditions,
)
from analyses.units import effort_units
from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.effort import signed_efforts, worst_efforts, worst_load
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.platforms import Platform, inertial_wrench
from schemas.effort import EffortRequest, EffortResult, PlatformBody
from schemas.poses import Obstacle
from schemas.quantities import Model

SECONDS_PER_LEG = 2e-6
NUMBERS_PER_EFFORT = 7
STANDARD_GRAVITY = [0.0, 0.0, -9.80665]


class Effort(Analysis[EffortRequest]):
    """Answers `effort`."""

    name = "effort"

    def check(self, request: EffortRequest, node_limit: int) -> None:
        """Raise AnalysisError if poses, working mode or loads do not fit."""
        mechanism = _mechanism(request)
        check_poses(mechanism, request.poses)
        count = len(request.poses)
        if request.known_load is not None:
            check_known_load(request.known_load, count)
        for name in ("platform_rates", "platform_accelerations"):
            rows = getattr(request, name)
            if rows is None:
                continue
            if len(rows) != 1:
                check_rows(f"/{name}", rows, count, 6)
            check_motion(f"/{name}", mechanism, rows)

    def items(self, request: EffortRequest) -> int:
        """Return the number of poses."""
        return len(request.poses)

    def seconds_per_item(self, request: EffortRequest) -> float:
        """Return the cost of a pose. [s]"""
        return SECONDS_PER_LEG * _mechanism(request).drive_count

    def result_bytes(self, request: EffortRequest) -> int:
        """Return the size of efforts and worst loads in JSON. [B]"""
        efforts = len(request.poses) * _mechanism(request).drive_count
        numbers = 1 if request.load is None else NUMBERS_PER_EFFORT
        return efforts * numbers * BYTES_PER_NUMBER

    def compute(self, request: EffortRequest, start: int, stop: int) -> Arrays:
        """Return efforts, worst loads and obstacles of the poses `start` to `stop`."""
        return by_blocks(partial(self._block, request), start, stop)

    def _block(self, request: EffortRequest, start: int, stop: int) -> Arrays:
        mechanism = _mechanism(request)
        poses = mechanism.columns(np.array(request.poses[start:stop], dtype=float))
        block = Configuration(mechanism, poses)
        load = _load(request, block, start, stop)
        # Before all else, in the one pass that scans go too: asked later, it would read cofactors.
        efforts = None if request.load is None else worst_efforts(block, load).T
        found = obstacles(block, pose_conditions(mechanism), start, singular=True)
        if efforts is None:
            return {"effort": signed_efforts(block, load).T, **found}
        worst = worst_load(block, load)
        return {
            "effort": efforts,
            "worst_force": np.moveaxis(worst.force, 2, 0),
            "worst_moment": np.moveaxis(worst.moment, 2, 0),
            **found,
        }

    def assemble(self, request: EffortRequest, stretches: Stretches) -> Model:
        """Return the columns of all poses."""
        arrays = joined(stretches())
        mechanism = _mechanism(request)
        worst: dict[str, Any] = {
            name: nullable_vectors(arrays[name]) if name in arrays else None
            for name in ("worst_force", "worst_moment")
        }
        return EffortResult.model_construct(
            analysis=self.name,
            working_mode=list(mechanism.working_mode),
            units=effort_units(mechanism),
            effort=nullable(arrays["effort"]),
            **worst,
            obstacles=[Obstacle.model_construct(**row) for row in obstacle_rows(arrays)],
        )


def _mechanism(request: EffortRequest) -> Mechanism:
    return build(request.mechanism, request.working_mode)


def _load(request: EffortRequest, block: Configuration, start: int, stop: int) -> Load:
    load = load_of(request.load, request.known_load, start, stop)
    if request.platform is None:
        return load
    inertial = _inertial(request, request.platform, block, start, stop)
    return replace(load, known=load.known + inertial)


def _inertial(
    request: EffortRequest, body: PlatformBody, block: Configuration, start: int, stop: int
) -> Floats:
    return inertial_wrench(
        Platform(
            body.mass,
            np.array(body.centre_of_mass or [0.0] * 3),
            np.array(body.inertia or np.zeros((3, 3))),
        ),
        block.placement[1],
        vectors(request.platform_rates or [0.0] * 6, start, stop),
        vectors(request.platform_accelerations or [0.0] * 6, start, stop),
        np.array(body.gravity or STANDARD_GRAVITY),
    )
