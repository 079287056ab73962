"""Inverse kinematics: which drive positions hold a pose, in one working mode or in all."""

from functools import partial

import numpy as np

from analyses.analysis import Analysis, Arrays, Stretches, by_blocks, joined
from analyses.columns import BYTES_PER_NUMBER, nullable
from analyses.directions import angles_of, check_directions
from analyses.mechanisms import build
from analyses.poses import check_poses, holds, obstacle_rows, obstacles, pose_conditions
from analyses.units import drive_units
from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from schemas.inverse_kinematics import (
    InverseKinematicsAllModesResult,
    InverseKinematicsRequest,
    InverseKinematicsResult,
    ObstacleInMode,
)
from schemas.poses import Obstacle
from schemas.quantities import Model

SECONDS_PER_LEG = 1e-6


class InverseKinematics(Analysis[InverseKinematicsRequest]):
    """Answers `inverse_kinematics`."""

    name = "inverse_kinematics"

    def check(self, request: InverseKinematicsRequest, node_limit: int) -> None:
        """Raise AnalysisError if a pose or the working mode does not fit the mechanism."""
        motion, names = _mechanism(request).motion, None
        if request.directions is not None:
            check_directions(motion, request.poses, request.directions)
            names = motion.translations
        check_poses(_mechanism(request), request.poses, names)

    def items(self, request: InverseKinematicsRequest) -> int:
        """Return the number of poses."""
        return len(request.poses)

    def seconds_per_item(self, request: InverseKinematicsRequest) -> float:
        """Return the cost of a pose in all modes asked. [s]"""
        return SECONDS_PER_LEG * _mechanism(request).drive_count * len(_modes(request))

    def result_bytes(self, request: InverseKinematicsRequest) -> int:
        """Return the size of the drive coordinates in JSON. [B]"""
        numbers = len(request.poses) * _mechanism(request).drive_count * len(_modes(request))
        return numbers * BYTES_PER_NUMBER

    def compute(self, request: InverseKinematicsRequest, start: int, stop: int) -> Arrays:
        """Return drive coordinates, verdicts and obstacles of the poses `start` to `stop`."""
        return by_blocks(partial(self._block, request), start, stop)

    def _block(self, request: InverseKinematicsRequest, start: int, stop: int) -> Arrays:
        mechanism = _mechanism(request)
        poses = mechanism.columns(_poses(request, start, stop))
        parts = []
        for number, mode in enumerate(_modes(request)):
            block = Configuration(mechanism.in_working_mode(tuple(mode)), poses)
            conditions = pose_conditions(block.mechanism)
            found = obstacles(block, conditions, start)
            parts.append(
                {
                    "actuators": block.actuators.T[:, None],
                    "reachable": holds(block, conditions)[:, None],
                    "obstacle_mode": np.full(found["obstacle_pose"].size, number),
                    **found,
                }
            )
        return joined(parts, {"actuators": 1, "reachable": 1})

    def assemble(self, request: InverseKinematicsRequest, stretches: Stretches) -> Model:
        """Return the columns of all poses."""
        arrays = joined(stretches())
        # By mode, then by pose, however the poses were cut into stretches.
        order = np.lexsort((arrays["obstacle_pose"], arrays["obstacle_mode"]))
        unordered = obstacle_rows(arrays)
        rows = [unordered[n] for n in order]
        units = drive_units(_mechanism(request))
        actuators = np.moveaxis(arrays["actuators"], 1, 0)
        reachable = arrays["reachable"].T
        if request.working_mode != "all":
            return InverseKinematicsResult.model_construct(
                analysis=self.name,
                working_mode=_modes(request)[0],
                units=units,
                reachable=reachable[0].tolist(),
                actuators=nullable(actuators[0]),
                obstacles=[Obstacle.model_construct(**row) for row in rows],
            )
        modes = arrays["obstacle_mode"][order].tolist()
        return InverseKinematicsAllModesResult.model_construct(
            analysis=self.name,
            working_modes=_modes(request),
            units=units,
            reachable=reachable.tolist(),
            actuators=nullable(actuators),
            obstacles=[
                ObstacleInMode.model_construct(mode=mode, **row)
                for mode, row in zip(modes, rows, strict=True)
            ],
        )


def _mechanism(request: InverseKinematicsRequest) -> Mechanism:
    mode = request.working_mode
    return build(request.mechanism, None if mode == "all" else mode)


def _poses(request: InverseKinematicsRequest, start: int, stop: int) -> Floats:
    """Return the poses `start` to `stop`, one a row, with the angles that directions stand for."""
    poses = np.array(request.poses[start:stop], dtype=float)
    if request.directions is None:
        return poses
    return np.hstack([poses, angles_of(request.directions[start:stop])])


def _modes(request: InverseKinematicsRequest) -> list[list[int]]:
    mechanism = _mechanism(request)
    if request.working_mode == "all":
        return [list(mode) for mode in mechanism.working_modes]
    return [list(mechanism.working_mode)]
