"""Friction torque of a mechanism: what its motors must turn with, through their gear trains."""

from functools import partial
from typing import Any

import numpy as np

from analyses.analysis import Analysis, Arrays, Stretches, by_blocks, joined
from analyses.columns import BYTES_PER_NUMBER, nullable, nullable_vectors
from analyses.errors import AnalysisError
from analyses.gears import build_train, refused
from analyses.loads import check_known_load, load_of, vectors
from analyses.mechanisms import build
from analyses.poses import check_poses, check_rows, obstacle_rows, obstacles, pose_conditions
from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.effort import signed_efforts, worst_efforts, worst_load
from mechanics.gears.contact import SIGNS
from mechanics.gears.errors import GearError
from mechanics.gears.mesh import Mesh
from mechanics.gears.train import check_contact
from mechanics.mechanism import Mechanism
from mechanics.motor_torques import chain_factor, motor_factors, motor_senses
from schemas.friction_torque import FrictionTorqueRequest, MotorTorqueResult
from schemas.geared import GearedDecoupled
from schemas.poses import Obstacle
from schemas.quantities import Model

SECONDS_PER_POSE = 2e-5
NUMBERS_PER_POSE = 27
SENSES = {sign: sense for sense, sign in SIGNS.items()}


class MotorTorques(Analysis[FrictionTorqueRequest]):
    """Answers `friction_torque` of a mechanism; an item is a pose."""

    name = "friction_torque"

    def check(self, request: FrictionTorqueRequest, node_limit: int) -> None:
        """Raise AnalysisError if no motor has a train, or poses, loads or contacts do not fit."""
        train = _train(request)
        for number, mesh in enumerate(train):
            try:
                check_contact(mesh, request.contact)
            except GearError as error:
                raise refused(error, f"/mechanism/train/{number}") from error
        mechanism, count = _mechanism(request), self.items(request)
        check_poses(mechanism, request.poses or [])
        if request.known_load is not None:
            check_known_load(request.known_load, count)
        turning = request.angular_velocity
        if turning is not None and isinstance(turning[0], list):
            check_rows("/angular_velocity", turning, count, 3)

    def items(self, request: FrictionTorqueRequest) -> int:
        """Return the number of poses."""
        return len(request.poses or [])

    def seconds_per_item(self, request: FrictionTorqueRequest) -> float:
        """Return the cost of a pose. [s]"""
        return SECONDS_PER_POSE

    def result_bytes(self, request: FrictionTorqueRequest) -> int:
        """Return the size of torques and worst loads in JSON. [B]"""
        return self.items(request) * NUMBERS_PER_POSE * BYTES_PER_NUMBER

    def compute(self, request: FrictionTorqueRequest, start: int, stop: int) -> Arrays:
        """Return torques, senses and obstacles of the poses `start` to `stop`."""
        return by_blocks(partial(self._block, request), start, stop)

    def _block(self, request: FrictionTorqueRequest, start: int, stop: int) -> Arrays:
        mechanism = _mechanism(request)
        poses = mechanism.columns(np.array((request.poses or [])[start:stop], dtype=float))
        block = Configuration(mechanism, poses)
        load = load_of(request.load, request.known_load, start, stop)
        motors = slice(mechanism.leg_count, None)
        found = obstacles(block, pose_conditions(mechanism), start, singular=True)
        worst: Arrays = {}
        if request.load is None:
            torques = signed_efforts(block, load)[motors]
        else:
            torques = worst_efforts(block, load)[motors]
            directions = worst_load(block, load)
            worst["worst_force"] = np.moveaxis(directions.force[motors], 2, 0)
            worst["worst_moment"] = np.moveaxis(directions.moment[motors], 2, 0)
        senses = _senses(request, block, torques, start, stop)
        factors = motor_factors(mechanism, *_factors(request), senses)
        torques = torques + 0.0  # no -0
        told = {"torque": factors * torques, "frictionless": torques, "senses": senses}
        return {name: column.T for name, column in told.items()} | worst | found

    def assemble(self, request: FrictionTorqueRequest, stretches: Stretches) -> Model:
        """Return the columns of all poses."""
        arrays = joined(stretches())
        mechanism = _mechanism(request)
        worst: dict[str, Any] = {
            name: nullable_vectors(arrays[name]) if name in arrays else None
            for name in ("worst_force", "worst_moment")
        }
        chain = _factors(request)
        factors = [
            motor_factors(mechanism, *chain, np.full((3, 1), sign))[:, 0]
            for sign in (SIGNS["driving"], SIGNS["back_driving"])
        ]
        return MotorTorqueResult.model_construct(
            analysis=self.name,
            working_mode=list(mechanism.working_mode),
            contact=request.contact,
            torque=nullable(arrays["torque"]),
            frictionless_torque=nullable(arrays["frictionless"]),
            sense=[[SENSES.get(sign) for sign in row] for row in arrays["senses"].tolist()],
            driving_factor=nullable(factors[0]),
            back_driving_factor=nullable(factors[1]),
            self_locking=np.isnan(factors[1]).tolist(),
            **worst,
            obstacles=[Obstacle.model_construct(**row) for row in obstacle_rows(arrays)],
        )


def _mechanism(request: FrictionTorqueRequest) -> Mechanism:
    return build(_spec(request), request.working_mode)


def _spec(request: FrictionTorqueRequest) -> GearedDecoupled:
    """Return the mechanism on the wire, which has motors behind gears."""
    if isinstance(request.mechanism, GearedDecoupled):
        return request.mechanism
    kind = None if request.mechanism is None else request.mechanism.kind
    detail = f"only geared_decoupled has motors behind gears; given {kind}"
    raise AnalysisError(("/mechanism/kind", detail))


def _train(request: FrictionTorqueRequest) -> tuple[Mesh, ...]:
    spec = _spec(request)
    if spec.train is None:
        detail = "the meshes between the platform and D1, and likewise D2, are needed; missing"
        raise AnalysisError(("/mechanism/train", detail))
    return build_train(spec.train, "/mechanism/train")


def _factors(request: FrictionTorqueRequest) -> tuple[float, float]:
    """Return the factors of the train driving and driven back."""
    train = _train(request)
    return (
        chain_factor(train, request.contact, "driving"),
        chain_factor(train, request.contact, "back_driving"),
    )


def _senses(
    request: FrictionTorqueRequest, block: Configuration, torques: Floats, start: int, stop: int
) -> Floats:
    if request.angular_velocity is None:
        return np.full(torques.shape, SIGNS[request.sense])
    return motor_senses(block, torques, vectors(request.angular_velocity, start, stop))
