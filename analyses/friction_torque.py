"""Friction torque: what friction between the teeth of a gear train costs."""

import itertools
import math
import operator
from collections.abc import Sequence
from typing import Any

import numpy as np

from analyses.analysis import Analysis, Arrays, Stretches, joined
from analyses.columns import BYTES_PER_NUMBER, nullable
from analyses.errors import AnalysisError
from analyses.gears import build_train, refused
from mechanics.gears.contact import SIGNS
from mechanics.gears.cycle import curve, require_cycle
from mechanics.gears.errors import GearError
from mechanics.gears.mesh import Mesh
from mechanics.gears.train import (
    Stage,
    Transfer,
    check_contact,
    pass_on,
    shaft_speeds,
    transfer,
)
from schemas.friction_torque import (
    FrictionTorqueRequest,
    FrictionTorqueResult,
    GearStage,
    MeshCurve,
    MeshGeometry,
)
from schemas.quantities import Model

SECONDS_PER_MESH = 3e-4
SECONDS_PER_POINT = 3e-7
NUMBERS_PER_MESH = 40
NUMBERS_PER_POINT = 4

MOST_RATIO = 1e12
"""Of the meshes up to any shaft together; torques beyond are no longer numbers worth telling."""

TRANSFER = ("torque_factor", "efficiency", "place", "input_arm", "output_arm", "sliding_speed")
CURVE = ("mesh", "phase", "pairs", "torque_factor")


class FrictionTorque(Analysis[FrictionTorqueRequest]):
    """Answers `friction_torque` of a train; an item is a mesh."""

    name = "friction_torque"
    needs_gears = True

    def check(self, request: FrictionTorqueRequest, node_limit: int) -> None:
        """Raise AnalysisError if wheels do not mesh, or have no such contact or no cycle."""
        train = build_train(request.meshes)
        for number, mesh in enumerate(train):
            try:
                check_contact(mesh, request.contact)
                if request.curve_points is not None:
                    require_cycle(mesh)
            except GearError as error:
                raise refused(error, f"/train/{number}") from error
        _check_ratio(train)

    def items(self, request: FrictionTorqueRequest) -> int:
        """Return the number of meshes."""
        return len(request.meshes)

    def seconds_per_item(self, request: FrictionTorqueRequest) -> float:
        """Return the cost of a mesh. [s]"""
        return SECONDS_PER_MESH + SECONDS_PER_POINT * (request.curve_points or 0)

    def result_bytes(self, request: FrictionTorqueRequest) -> int:
        """Return the size of all stages in JSON. [B]"""
        numbers = NUMBERS_PER_MESH + NUMBERS_PER_POINT * (request.curve_points or 0)
        return len(request.meshes) * numbers * BYTES_PER_NUMBER

    def compute(self, request: FrictionTorqueRequest, start: int, stop: int) -> Arrays:
        """Return what the meshes `start` to `stop` make of a torque, and their curves."""
        train = build_train(request.meshes)
        speeds = shaft_speeds(train, _speed(request))
        found = [
            transfer(mesh, request.contact, request.sense, mesh.speed_radius * speed)
            for mesh, speed in zip(train[start:stop], speeds[start:stop], strict=True)
        ]
        columns = {name: np.array([getattr(one, name) for one in found]) for name in TRANSFER}
        curves = [
            _curve(request, train[number], number, train[number].speed_radius * speeds[number])
            for number in range(start, stop)
        ]
        return columns | {f"curve_{name}": column for name, column in joined(curves).items()}

    def assemble(self, request: FrictionTorqueRequest, stretches: Stretches) -> Model:
        """Return the torques along the train."""
        arrays = joined(stretches())
        train = build_train(request.meshes)
        rows = zip(*(arrays[name].tolist() for name in TRANSFER), strict=True)
        transfers = [Transfer(*row) for row in rows]
        speeds = shaft_speeds(train, _speed(request))
        stages = pass_on(train, transfers, request.load_torque, speeds)
        return FrictionTorqueResult.model_construct(
            analysis=self.name,
            contact=request.contact,
            sense=request.sense,
            **_whole(request, train, stages),
            stages=_stages(request, train, stages, arrays),
        )


def _check_ratio(train: Sequence[Mesh]) -> None:
    # Up to every shaft: the last one may turn as fast as the first with numbers lost between.
    sizes = itertools.accumulate(math.log10(mesh.ratio) for mesh in train)
    for count, size in enumerate(sizes, start=1):
        if abs(size) > math.log10(MOST_RATIO):
            raise AnalysisError(
                (
                    "/train",
                    f"the ratios of the first {count} meshes make 1e{size:.3g}; up to every shaft "
                    f"they must be from {1.0 / MOST_RATIO:g} to {MOST_RATIO:g}",
                )
            )


def _speed(request: FrictionTorqueRequest) -> float:
    return math.nan if request.output_speed is None else request.output_speed


def _curve(request: FrictionTorqueRequest, mesh: Mesh, number: int, pitch_speed: float) -> Arrays:
    """Return the cycle of a mesh, its points marked with the mesh's number; none if not asked."""
    if request.curve_points is None:
        return {name: np.empty(0) for name in CURVE}
    found = curve(mesh, request.curve_points, request.sense, pitch_speed)
    return {"mesh": np.full(found.phase.size, number), **found._asdict()}


def _whole(
    request: FrictionTorqueRequest, train: Sequence[Mesh], stages: Sequence[Stage]
) -> dict[str, Any]:
    """Return what is told of the train as a whole."""
    efficiency = math.prod(stage.transfer.efficiency for stage in stages)
    losses = [_power_loss(stage, request) for stage in stages]
    at_motor, factor = stages[-1].input_torque, _factors(stages)[-1]
    return {
        "input_torque": _number(at_motor),
        "frictionless_input_torque": stages[-1].frictionless_input_torque,
        "excess": _number(factor - 1.0),
        "ratio": math.prod(mesh.ratio for mesh in train),
        "efficiency": efficiency,
        "loss": 1.0 - efficiency,
        "power_loss": _number(math.fsum(losses)),
        "self_locking": not (math.isfinite(at_motor) and math.isfinite(factor)),
    }


def _stages(
    request: FrictionTorqueRequest,
    train: Sequence[Mesh],
    stages: Sequence[Stage],
    arrays: Arrays,
) -> list[GearStage]:
    told = []
    rows = zip(train, stages, _factors(stages), strict=True)
    for number, (mesh, stage, factor) in enumerate(rows):
        found = stage.transfer
        told.append(
            GearStage.model_construct(
                output_torque=_number(stage.output_torque),
                input_torque=_number(stage.input_torque),
                frictionless_output_torque=stage.frictionless_output_torque,
                frictionless_input_torque=stage.frictionless_input_torque,
                excess=_number(factor - 1.0),
                ratio=mesh.ratio,
                efficiency=found.efficiency,
                loss=1.0 - found.efficiency,
                power_loss=_number(_power_loss(stage, request)),
                self_locking=found.locks,
                contact_position=_number(found.place),
                input_arm=_number(found.input_arm),
                output_arm=_number(found.output_arm),
                sliding_speed=_number(found.sliding_speed),
                geometry=_geometry(mesh),
                curve=_told_curve(request, mesh, stage, number, arrays),
            )
        )
    return told


def _factors(stages: Sequence[Stage]) -> list[float]:
    """Return torque over that without friction, behind each mesh; also where both are 0."""
    return list(itertools.accumulate((s.transfer.torque_factor for s in stages), operator.mul))


def _power_loss(stage: Stage, request: FrictionTorqueRequest) -> float:
    """Return the power that turns into heat, from what goes in and out; NaN if not known. [W]"""
    at_input = stage.input_torque * stage.input_speed
    at_output = stage.output_torque * stage.output_speed
    return SIGNS[request.sense] * (at_input - at_output)


def _geometry(mesh: Mesh) -> MeshGeometry:
    return MeshGeometry.model_construct(
        pitch_radii=list(mesh.pitch_radii),
        base_radii=list(mesh.base_radii),
        pressure_angle=mesh.pressure_angle,
        tip_radii=None if mesh.tip_radii is None else list(mesh.tip_radii),
        tip_thickness=None if mesh.tip_thickness is None else list(mesh.tip_thickness),
        approach=mesh.approach,
        recess=mesh.recess,
        contact_ratio=mesh.contact_ratio,
    )


def _told_curve(
    request: FrictionTorqueRequest, mesh: Mesh, stage: Stage, number: int, arrays: Arrays
) -> MeshCurve | None:
    if request.curve_points is None:
        return None
    mine = arrays["curve_mesh"] == number
    factor = arrays["curve_torque_factor"][mine]
    return MeshCurve.model_construct(
        phase=arrays["curve_phase"][mine].tolist(),
        pairs=arrays["curve_pairs"][mine].tolist(),
        torque_factor=nullable(factor),
        input_torque=nullable(stage.output_torque * mesh.ratio * factor),
    )


def _number(value: float) -> float | None:
    # Meshes that are all about to lock multiply a torque beyond every number: none moves them.
    return value if math.isfinite(value) else None
