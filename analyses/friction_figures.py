"""What a picture of a gear train's friction shows."""

import math
from collections.abc import Sequence

import numpy as np

from analyses.analysis import Stretches
from analyses.errors import AnalysisError
from analyses.gears import build_train
from analyses.pictures import CurvePicture, PictureCurve
from mechanics.gears.contact import SIGNS
from mechanics.gears.cycle import curve, mean_torque_factor
from mechanics.gears.mesh import Mesh
from mechanics.gears.train import Stage, carry
from schemas.friction_torque import FrictionTorqueRequest

FIELDS = {
    "loss": ("Share of the power that is lost", "%"),
    "input_torque": ("Input torque", "N·m"),
}
"""What is shown over the cycle, the default first: its words and unit."""

POINTS = 600
"""Phases of a cycle that are drawn."""

SENSES = {"driving": "the motor drives", "back_driving": "the load drives back"}
CONTACTS = {
    "pitch": "contact at the pitch points",
    "approach_end": "contact where teeth meet",
    "recess_end": "contact where teeth part",
    "worst": "contact at the worse ends",
    "mean": "means of the cycles",
    "explicit": "contact where it was asked for",
}


def check_picture(request: FrictionTorqueRequest, field: str | None) -> str:
    """Return the field that is shown over the cycle.

    Raises
    ------
    AnalysisError : there is no such field, no mesh has a cycle, or a mechanism was asked about.
    """
    if request.mechanism is not None:
        detail = "a figure shows the cycles of a train; ask about the train alone"
        raise AnalysisError(("/mechanism", detail))
    if field is not None and field not in FIELDS:
        raise AnalysisError(("?field", f"given {field!r}; allowed: {', '.join(FIELDS)}"))
    if all(mesh.base_pitch is None for mesh in build_train(request.meshes)):
        detail = "a figure shows the cycles of meshes; give the base_pitch of one at least"
        raise AnalysisError(("/train", detail))
    return field or next(iter(FIELDS))


def picture(
    request: FrictionTorqueRequest, stretches: Stretches, field: str | None
) -> CurvePicture:
    """Return the cycle of every mesh that has one; stretches have no part in it.

    Raises
    ------
    AnalysisError : as `check_picture`.
    """
    chosen = check_picture(request, field)
    train, stages = _stages(request)
    label, unit = FIELDS[chosen]
    curves = [
        _curve(request, mesh, stage, chosen, f"mesh {number}")
        for number, (mesh, stage) in enumerate(zip(train, stages, strict=True))
        if mesh.base_pitch is not None
    ]
    return CurvePicture(
        title=f"Friction over the mesh cycle, {SENSES[request.sense]}",
        subtitle=_subtitle(request, stages, len(curves)),
        x_label="Part of the cycle since teeth came into contact",
        x_unit="",
        y_label=label,
        y_unit=unit,
        curves=tuple(curves),
    )


def _stages(request: FrictionTorqueRequest) -> tuple[tuple[Mesh, ...], tuple[Stage, ...]]:
    train = build_train(request.meshes)
    speed = math.nan if request.output_speed is None else request.output_speed
    stages = carry(
        train, request.load_torque, request.contact, sense=request.sense, output_speed=speed
    )
    return train, stages


def _curve(
    request: FrictionTorqueRequest, mesh: Mesh, stage: Stage, field: str, label: str
) -> PictureCurve:
    pitch_speed = mesh.speed_radius * stage.output_speed
    found = curve(mesh, POINTS, request.sense, pitch_speed)
    mean = mean_torque_factor(mesh, request.sense, pitch_speed)
    factors = np.append(found.torque_factor, mean)
    if field == "input_torque":
        shown = stage.output_torque * mesh.ratio * factors
    else:
        # Power out over power in is the factor or its inverse, whoever drives.
        shown = 100.0 * (1.0 - factors ** -SIGNS[request.sense])
    return PictureCurve(label, found.phase, shown[:-1], float(shown[-1]))


def _subtitle(request: FrictionTorqueRequest, stages: Sequence[Stage], shown: int) -> str:
    torque = stages[-1].input_torque
    motor = f"{torque:.4g} N·m at the motor" if math.isfinite(torque) else "self-locking"
    parts = [f"{request.load_torque:g} N·m at the output", motor, CONTACTS[request.contact]]
    if shown < len(stages):
        parts.append(f"{shown} of {len(stages)} meshes, the others' base pitch being unknown")
    return ", ".join(parts)
