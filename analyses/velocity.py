"""Velocity: rates of platform, drives and passive joints."""

from functools import partial

import numpy as np

from analyses.analysis import Analysis, Arrays, Stretches, by_blocks, joined
from analyses.columns import BYTES_PER_NUMBER, nullable, nullable_vectors
from analyses.mechanisms import build
from analyses.poses import (
    check_motion,
    check_poses,
    check_rows,
    obstacle_rows,
    obstacles,
    pose_conditions,
)
from analyses.units import rate_units
from mechanics import velocity
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from schemas.poses import Obstacle
from schemas.quantities import Model
from schemas.velocity import VelocityRequest, VelocityResult

SECONDS_PER_LEG = 4e-6
NUMBERS_PER_LEG = 7


class Velocity(Analysis[VelocityRequest]):
    """Answers `velocity`."""

    name = "velocity"

    def check(self, request: VelocityRequest, node_limit: int) -> None:
        """Raise AnalysisError if poses, rates or working mode do not fit the mechanism."""
        mechanism = _mechanism(request)
        check_poses(mechanism, request.poses)
        count = len(request.poses)
        if request.platform_rates is not None:
            check_rows("/platform_rates", request.platform_rates, count, 6)
            check_motion("/platform_rates", mechanism, request.platform_rates)
        if request.actuator_rates is not None:
            check_rows("/actuator_rates", request.actuator_rates, count, mechanism.drive_count)

    def items(self, request: VelocityRequest) -> int:
        """Return the number of poses."""
        return len(request.poses)

    def seconds_per_item(self, request: VelocityRequest) -> float:
        """Return the cost of a pose. [s]"""
        return SECONDS_PER_LEG * _mechanism(request).drive_count

    def result_bytes(self, request: VelocityRequest) -> int:
        """Return the size of all rates in JSON. [B]"""
        drives = _mechanism(request).drive_count
        return len(request.poses) * (6 + drives * NUMBERS_PER_LEG) * BYTES_PER_NUMBER

    def compute(self, request: VelocityRequest, start: int, stop: int) -> Arrays:
        """Return rates and obstacles of the poses `start` to `stop`."""
        return by_blocks(partial(self._block, request), start, stop)

    def _block(self, request: VelocityRequest, start: int, stop: int) -> Arrays:
        mechanism = _mechanism(request)
        poses = mechanism.columns(np.array(request.poses[start:stop], dtype=float))
        block = Configuration(mechanism, poses)
        if request.platform_rates is not None:
            twists = np.array(request.platform_rates[start:stop], dtype=float).T
            rates = velocity.actuator_rates(block, twists)
        else:
            rates = np.array((request.actuator_rates or [])[start:stop], dtype=float).T
            twists = velocity.platform_twists(block, rates)
        passive = velocity.passive_rates(block, twists, rates)
        found = obstacles(
            block,
            pose_conditions(mechanism),
            start,
            singular=request.platform_rates is None,
            dead_drives=request.platform_rates is not None,
        )
        return {
            "platform_rates": twists.T,
            "actuator_rates": rates.T,
            **{f"passive_{leg}": rows.T for leg, rows in enumerate(passive)},
            **found,
        }

    def assemble(self, request: VelocityRequest, stretches: Stretches) -> Model:
        """Return the columns of all poses."""
        arrays = joined(stretches())
        mechanism = _mechanism(request)
        passive = [nullable_vectors(arrays[f"passive_{k}"]) for k in range(mechanism.leg_count)]
        return VelocityResult.model_construct(
            analysis=self.name,
            working_mode=list(mechanism.working_mode),
            units=rate_units(mechanism),
            platform_rates=nullable_vectors(arrays["platform_rates"]),
            actuator_rates=nullable(arrays["actuator_rates"]),
            passive_joints=[list(velocity.PASSIVE_JOINTS[int(j)]) for j in mechanism.legs.joints],
            passive_rates=[list(legs) for legs in zip(*passive, strict=True)],
            obstacles=[Obstacle.model_construct(**row) for row in obstacle_rows(arrays)],
        )


def _mechanism(request: VelocityRequest) -> Mechanism:
    return build(request.mechanism, request.working_mode)
