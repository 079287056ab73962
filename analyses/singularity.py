"""Singularity: how close a pose is to a singularity, and of which type that is."""

from functools import partial

import numpy as np

from analyses.analysis import Analysis, Arrays, Stretches, by_blocks, joined
from analyses.columns import BYTES_PER_NUMBER, nullable, nullable_vectors
from analyses.mechanisms import build
from analyses.poses import check_poses, obstacle_rows, obstacles, pose_conditions
from analyses.units import determinant_unit
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from mechanics.singularity import singularities
from schemas.poses import Obstacle
from schemas.quantities import Model
from schemas.singularity import SingularityRequest, SingularityResult

SECONDS_PER_LEG = 1e-5
NUMBERS_PER_POSE = 9


class Singularity(Analysis[SingularityRequest]):
    """Answers `singularity`."""

    name = "singularity"

    def check(self, request: SingularityRequest, node_limit: int) -> None:
        """Raise AnalysisError if a pose or the working mode does not fit the mechanism."""
        check_poses(_mechanism(request), request.poses)

    def items(self, request: SingularityRequest) -> int:
        """Return the number of poses."""
        return len(request.poses)

    def seconds_per_item(self, request: SingularityRequest) -> float:
        """Return the cost of a pose. [s]"""
        return SECONDS_PER_LEG * _mechanism(request).drive_count

    def result_bytes(self, request: SingularityRequest) -> int:
        """Return the size of the columns in JSON. [B]"""
        numbers = NUMBERS_PER_POSE + _mechanism(request).drive_count
        return len(request.poses) * numbers * BYTES_PER_NUMBER

    def compute(self, request: SingularityRequest, start: int, stop: int) -> Arrays:
        """Return the columns and obstacles of the poses `start` to `stop`."""
        return by_blocks(partial(self._block, request), start, stop)

    def _block(self, request: SingularityRequest, start: int, stop: int) -> Arrays:
        mechanism = _mechanism(request)
        poses = mechanism.columns(np.array(request.poses[start:stop], dtype=float))
        block = Configuration(mechanism, poses)
        found = singularities(block)
        return {
            "determinant": found.determinant,
            "condition_number": np.where(
                np.isinf(found.condition_number), np.nan, found.condition_number
            ),
            "type": found.type,
            "pressure_angles": found.pressure_angles.T,
            "free_motion": found.free_motion.T,
            **obstacles(block, pose_conditions(mechanism), start),
        }

    def assemble(self, request: SingularityRequest, stretches: Stretches) -> Model:
        """Return the columns of all poses."""
        arrays = joined(stretches())
        mechanism = _mechanism(request)
        return SingularityResult.model_construct(
            analysis=self.name,
            working_mode=list(mechanism.working_mode),
            determinant=nullable(arrays["determinant"]),
            determinant_unit=determinant_unit(mechanism),
            condition_number=nullable(arrays["condition_number"]),
            characteristic_length=mechanism.characteristic_length,
            type=[None if kind < 0 else kind for kind in arrays["type"].tolist()],
            pressure_angles=nullable(arrays["pressure_angles"]),
            free_motion=nullable_vectors(arrays["free_motion"]),
            obstacles=[Obstacle.model_construct(**row) for row in obstacle_rows(arrays)],
        )


def _mechanism(request: SingularityRequest) -> Mechanism:
    return build(request.mechanism, request.working_mode)
