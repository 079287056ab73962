"""From the bounds of a workspace request to the conditions of `mechanics`, and their sense."""

import math
from collections.abc import Iterator

import numpy as np

from analyses.units import effort_units, rate_units, shared_unit
from mechanics.arrays import Floats
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.actuator_speed import ActuatorSpeed
from mechanics.conditions.base_joint_angle import BaseJointAngle
from mechanics.conditions.condition import Condition
from mechanics.conditions.condition_number import ConditionNumber
from mechanics.conditions.crank_rod_angle import CrankRodAngle, legs_with_elbows
from mechanics.conditions.determinant import Determinant
from mechanics.conditions.effort import Effort
from mechanics.conditions.motor_limits import MotorLimits
from mechanics.conditions.platform_joint_angle import PlatformJointAngle
from mechanics.conditions.pressure_angle import PressureAngle
from mechanics.conditions.reach import Reach
from mechanics.conditions.rod_distance import RodDistance, separate_rods
from mechanics.conditions.rod_rod_angle import RodRodAngle, rods_at_shared_joints
from mechanics.legs import ARC_JOINTS
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.velocity import Speed
from schemas.quantities import Model
from schemas.workspace import Constructive, Effective, WorkspaceRequest

CLASSES = ("theoretical", "constructive", "effective")
EFFECTIVE_BOUNDS = (
    "max_effort",
    "max_pressure_angle",
    "min_abs_determinant",
    "max_condition_number",
    "max_actuator_speed",
)
Complaint = tuple[str, str]
"""The pointer to a field, and what is wrong with it."""


def conditions_of(request: WorkspaceRequest, mechanism: Mechanism) -> tuple[Condition, ...]:
    """Return the conditions of the request's class, in the order that reason codes follow."""
    rank = CLASSES.index(request.class_)
    conditions: list[Condition] = [Reach(mechanism)]
    if rank >= CLASSES.index("constructive"):
        conditions += _constructive(request.constructive or Constructive(), mechanism)
    if rank >= CLASSES.index("effective") and request.effective is not None:
        conditions += _effective(request.effective, mechanism)
    return tuple(conditions)


def _constructive(bounds: Constructive, mechanism: Mechanism) -> Iterator[Condition]:
    limits = np.array([mechanism.legs.lower_limit, mechanism.legs.upper_limit])
    if np.isfinite(limits).any():
        yield ActuatorLimits(mechanism)
    if _has_motor_limits(mechanism):
        yield MotorLimits(mechanism)
    crank_rod = bounds.min_crank_rod_angle, bounds.max_crank_rod_angle
    if crank_rod != (None, None):
        yield CrankRodAngle(mechanism, *_both_ends(*crank_rod))
    rod_rod = bounds.min_rod_rod_angle, bounds.max_rod_rod_angle
    if rod_rod != (None, None):
        yield RodRodAngle(mechanism, *_both_ends(*rod_rod))
    cone, axes = bounds.max_base_joint_angle, bounds.base_joint_axes
    if cone is not None and axes is not None:
        yield BaseJointAngle(mechanism, _directions(axes), cone)
    cone, axes = bounds.max_platform_joint_angle, bounds.platform_joint_axes
    if cone is not None and axes is not None:
        yield PlatformJointAngle(mechanism, _directions(axes), cone)
    if bounds.min_rod_distance is not None:
        yield RodDistance(mechanism, bounds.min_rod_distance)


def _has_motor_limits(mechanism: Mechanism) -> bool:
    """Return whether a motor of the wrist has a stop."""
    wrist = mechanism.wrist
    if wrist is None:
        return False
    return bool(np.isfinite([wrist.lower_limit, wrist.upper_limit]).any())


def _both_ends(lower: float | None, upper: float | None) -> tuple[float, float]:
    return 0.0 if lower is None else lower, math.pi if upper is None else upper


def _directions(axes: list[list[float]]) -> Floats:
    rows = np.array(axes, dtype=float)
    units: Floats = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    return units


def _effective(bounds: Effective, mechanism: Mechanism) -> Iterator[Condition]:
    if bounds.max_effort is not None:
        yield Effort(mechanism, load_of(bounds), _per_drive(bounds.max_effort, mechanism))
    if bounds.max_pressure_angle is not None:
        yield PressureAngle(mechanism, bounds.max_pressure_angle)
    if bounds.min_abs_determinant is not None:
        yield Determinant(bounds.min_abs_determinant)
    if bounds.max_condition_number is not None:
        yield ConditionNumber(bounds.max_condition_number)
    if bounds.max_actuator_speed is not None and bounds.platform_speed is not None:
        speed = Speed(bounds.platform_speed.linear, bounds.platform_speed.angular)
        yield ActuatorSpeed(mechanism, speed, _per_drive(bounds.max_actuator_speed, mechanism))


def _per_drive(limits: float | list[float], mechanism: Mechanism) -> Floats:
    return np.array(np.broadcast_to(limits, mechanism.drive_count), dtype=float)


def load_of(effective: Effective | None) -> Load:
    """Return the load of the effort limits and fields."""
    size = effective.load if effective is not None else None
    return Load() if size is None else Load(size.force, size.moment)


def bound_errors(request: WorkspaceRequest, mechanism: Mechanism) -> list[Complaint]:
    """Return the bounds that make no sense for the mechanism, whether applied or not."""
    errors: list[Complaint] = []
    if request.constructive is not None:
        errors += _lacking(request.constructive, mechanism)
        errors += _cone_errors(request.constructive, mechanism)
    bounds = request.effective
    if bounds is not None:
        efforts, rates = effort_units(mechanism), rate_units(mechanism)
        errors += _limit_errors("max_effort", bounds.max_effort, "bear", efforts)
        errors += _limit_errors("max_actuator_speed", bounds.max_actuator_speed, "move in", rates)
        names = "max_actuator_speed", "platform_speed"
        errors += _missing_partner("/effective", bounds, *names)
    given = [name for name in EFFECTIVE_BOUNDS if getattr(bounds, name, None) is not None]
    if request.class_ == "effective" and not given:
        known = ", ".join(EFFECTIVE_BOUNDS)
        errors.append(
            ("/effective", f"the class effective needs a bound; none is given of {known}")
        )
    if (bounds is None or bounds.load is None) and any("effort" in f for f in request.fields):
        errors.append(("/effective/load", "the effort fields need a load; it is missing"))
    return errors


def _lacking(bounds: Constructive, mechanism: Mechanism) -> Iterator[Complaint]:
    """Yield the bounds on something that the mechanism does not have."""
    lacking = {}
    if not legs_with_elbows(mechanism):
        lacking["crank_rod_angle"] = "no leg of this mechanism has a crank and a rod"
    if not rods_at_shared_joints(mechanism):
        lacking["rod_rod_angle"] = "no two rods of this mechanism share a joint"
    if not separate_rods(mechanism):
        lacking["rod_distance"] = "no two straight rods of this mechanism are apart at both ends"
    if (mechanism.legs.joints == ARC_JOINTS).any():
        arcs = "arcs turn about fixed axes; their joints have no cone"
        lacking |= {"base_joint_angle": arcs, "platform_joint_angle": arcs}
    for what, detail in lacking.items():
        for name in (f"min_{what}", f"max_{what}"):
            if getattr(bounds, name, None) is not None:
                yield f"/constructive/{name}", detail


def _cone_errors(bounds: Constructive, mechanism: Mechanism) -> Iterator[Complaint]:
    count = mechanism.leg_count
    for end in ("base", "platform"):
        axes = getattr(bounds, f"{end}_joint_axes")
        names = f"max_{end}_joint_angle", f"{end}_joint_axes"
        yield from _missing_partner("/constructive", bounds, *names)
        if axes is not None and len(axes) != count:
            yield f"/constructive/{names[1]}", f"must be {count}, one per leg; given {len(axes)}"


def _missing_partner(at: str, bounds: Model, one: str, other: str) -> Iterator[Complaint]:
    """Yield the one of two fields that is missing beside the other."""
    for name, partner in ((one, other), (other, one)):
        if getattr(bounds, name) is None and getattr(bounds, partner) is not None:
            yield f"{at}/{name}", f"{partner} needs it; it is missing"


def _limit_errors(
    name: str, limits: float | list[float] | None, verb: str, units: list[str]
) -> Iterator[Complaint]:
    if isinstance(limits, float) and len(set(units)) > 1:
        detail = f"drives {verb} {shared_unit(units)}; give one number per drive"
        yield f"/effective/{name}", detail
    if isinstance(limits, list) and len(limits) != len(units):
        detail = f"must be one number or {len(units)}, one per drive; given {len(limits)}"
        yield f"/effective/{name}", detail
