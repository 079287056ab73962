"""From meshes on the wire to those of `mechanics`."""

import math
from collections.abc import Sequence

import numpy as np

from analyses.errors import AnalysisError, pointer
from mechanics.gears.errors import GearError
from mechanics.gears.friction import Coulomb
from mechanics.gears.mesh import Mesh
from mechanics.gears.points import point_mesh
from mechanics.gears.toothed import bevel_mesh, spur_mesh
from mechanics.gears.wheels import Teeth
from schemas.gears import DesignMesh, ExplicitMesh

RIGHT_ANGLE = 0.5 * math.pi


def build_train(train: Sequence[ExplicitMesh | DesignMesh], at: str = "/train") -> tuple[Mesh, ...]:
    """Return the meshes of a train; `at` points to it in the body.

    Raises
    ------
    AnalysisError : wheels do not mesh as described.
    """
    return tuple(build_mesh(spec, f"{at}/{number}") for number, spec in enumerate(train))


def build_mesh(spec: ExplicitMesh | DesignMesh, at: str) -> Mesh:
    """Return one mesh; `at` points to it in the body.

    Raises
    ------
    AnalysisError : the wheels do not mesh as described.
    """
    try:
        return _points(spec) if isinstance(spec, ExplicitMesh) else _toothed(spec)
    except GearError as error:
        raise refused(error, at) from error


def refused(error: GearError, at: str) -> AnalysisError:
    """Return the error with a pointer to the field at fault of the mesh to which `at` points."""
    return AnalysisError((at + pointer(*error.field), str(error)))


def _points(spec: ExplicitMesh) -> Mesh:
    opposite = spec.opposite_contact
    return point_mesh(
        input_centre=np.array(spec.input_centre),
        output_centre=np.array(spec.output_centre),
        pitch_point=np.array(spec.pitch_point),
        contact=np.array(spec.contact),
        opposite_contact=None if opposite is None else np.array(opposite),
        base_pitch=spec.base_pitch,
        friction=Coulomb(spec.friction_coefficient),
    )


def _toothed(spec: DesignMesh) -> Mesh:
    teeth = Teeth(
        spec.module,
        spec.pressure_angle,
        spec.addendum_coefficient,
        (spec.input.teeth, spec.output.teeth),
        (spec.input.profile_shift, spec.output.profile_shift),
    )
    friction, contact = Coulomb(spec.friction_coefficient), spec.contact_position
    if spec.face == "bevel":
        _check_unused(spec.centre_distance, "centre_distance", "bevel")
        angle = RIGHT_ANGLE if spec.shaft_angle is None else spec.shaft_angle
        return bevel_mesh(teeth, friction, shaft_angle=angle, contact=contact)
    _check_unused(spec.shaft_angle, "shaft_angle", "spur")
    return spur_mesh(teeth, friction, centre_distance=spec.centre_distance, contact=contact)


def _check_unused(value: float | None, field: str, face: str) -> None:
    if value is not None:
        raise GearError(f"must not be given for {face} wheels; given {value:g}", field)
