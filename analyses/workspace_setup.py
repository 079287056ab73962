"""From a workspace request to the grid, the conditions and the fields of `mechanics`."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, Context

import numpy as np

from analyses.errors import AnalysisError, pointer
from analyses.mechanisms import build
from analyses.units import determinant_unit, drive_units, effort_units, shared_unit
from mechanics import fields as kept
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import Condition
from mechanics.conditions.crank_rod_angle import CrankRodAngle, legs_with_elbows
from mechanics.conditions.effort import Effort
from mechanics.conditions.reach import Reach
from mechanics.conditions.rod_rod_angle import RodRodAngle, rods_at_shared_joints
from mechanics.grid import Axis, Grid
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from schemas.workspace import Constructive, Effective, WorkspaceRequest

CLASSES = ("theoretical", "constructive", "effective")


@dataclass(frozen=True)
class WorkspaceSetup:
    """Everything that a scan needs."""

    mechanism: Mechanism
    grid: Grid
    conditions: tuple[Condition, ...]
    fields: Mapping[str, kept.Field]


def set_up(request: WorkspaceRequest) -> WorkspaceSetup:
    """Return what a scan of a checked request needs."""
    mechanism = build(request.mechanism, request.working_mode)
    coordinates = mechanism.motion.coordinates
    axes = tuple(Axis(a.coordinate, a.min, a.max, a.step) for a in request.grid)
    columns = tuple(coordinates.index(axis.coordinate) for axis in axes)
    fixed = np.array([request.fixed.get(c, 0.0) for c in coordinates])
    return WorkspaceSetup(
        mechanism,
        Grid(axes, columns, fixed),
        conditions_of(request, mechanism),
        fields_of(request),
    )


def conditions_of(request: WorkspaceRequest, mechanism: Mechanism) -> tuple[Condition, ...]:
    """Return the conditions of the request's class, in the order that reason codes follow."""
    rank = CLASSES.index(request.class_)
    conditions: list[Condition] = [Reach(mechanism)]
    if rank >= CLASSES.index("constructive"):
        conditions += _constructive(request.constructive or Constructive(), mechanism)
    if rank >= CLASSES.index("effective") and request.effective is not None:
        conditions += _effective(request.effective, mechanism)
    return tuple(conditions)


def _constructive(bounds: Constructive, mechanism: Mechanism) -> list[Condition]:
    conditions: list[Condition] = []
    limits = np.array([mechanism.legs.lower_limit, mechanism.legs.upper_limit])
    if np.isfinite(limits).any():
        conditions.append(ActuatorLimits(mechanism))
    crank_rod = bounds.min_crank_rod_angle, bounds.max_crank_rod_angle
    if crank_rod != (None, None):
        conditions.append(CrankRodAngle(mechanism, *_both_ends(*crank_rod)))
    rod_rod = bounds.min_rod_rod_angle, bounds.max_rod_rod_angle
    if rod_rod != (None, None):
        conditions.append(RodRodAngle(mechanism, *_both_ends(*rod_rod)))
    return conditions


def _both_ends(lower: float | None, upper: float | None) -> tuple[float, float]:
    return 0.0 if lower is None else lower, math.pi if upper is None else upper


def _effective(bounds: Effective, mechanism: Mechanism) -> list[Condition]:
    if bounds.max_effort is None:
        return []
    limits = np.array(np.broadcast_to(bounds.max_effort, mechanism.leg_count), dtype=float)
    return [Effort(mechanism, load_of(bounds), limits)]


def load_of(effective: Effective | None) -> Load:
    """Return the load of the effort limits and fields."""
    size = effective.load if effective is not None else None
    return Load() if size is None else Load(size.force, size.moment)


def fields_of(request: WorkspaceRequest) -> dict[str, kept.Field]:
    """Return the fields asked for, by name."""
    load = load_of(request.effective)
    known: dict[str, kept.Field] = {
        "effort": kept.effort(load),
        "effort_max": kept.effort_max(load),
        "determinant": kept.determinant,
        "actuators": kept.actuators,
    }
    return {name: known[name] for name in request.fields}


def check_request(request: WorkspaceRequest, node_limit: int) -> None:
    """Raise AnalysisError if the request makes no sense; nothing large is allocated."""
    mechanism = build(request.mechanism, request.working_mode)
    errors = [
        *_coordinate_errors(request, mechanism),
        *_constructive_errors(request, mechanism),
        *_effective_errors(request, mechanism),
        *_size_errors(request, node_limit),
    ]
    if errors:
        raise AnalysisError(*errors)


def _coordinate_errors(request: WorkspaceRequest, mechanism: Mechanism) -> list[tuple[str, str]]:
    motion = mechanism.motion
    allowed = ", ".join(motion.coordinates)
    errors = []
    seen: set[str] = set()
    for k, axis in enumerate(request.grid):
        place = f"/grid/{k}/coordinate"
        if axis.coordinate not in motion.coordinates:
            errors.append((place, f"given {axis.coordinate!r}; allowed: {allowed}"))
        elif axis.coordinate in seen:
            errors.append((place, f"{axis.coordinate!r} has an axis already"))
        elif axis.coordinate in motion.turns:
            errors.append(
                (
                    place,
                    f"{axis.coordinate!r} turns the platform; the type constant_orientation "
                    "needs it in `fixed`",
                )
            )
        seen.add(axis.coordinate)
    for name in request.fixed:
        if name not in motion.coordinates:
            errors.append((pointer("fixed", name), f"given {name!r}; allowed: {allowed}"))
        elif name in seen:
            errors.append((f"/fixed/{name}", f"{name!r} is on the grid already"))
    missing = [c for c in motion.coordinates if c not in seen and c not in request.fixed]
    errors += [
        (f"/fixed/{name}", f"{name!r} is neither on the grid nor fixed; give its value")
        for name in missing
    ]
    return errors


def _constructive_errors(request: WorkspaceRequest, mechanism: Mechanism) -> list[tuple[str, str]]:
    bounds = request.constructive
    missing = []
    if not legs_with_elbows(mechanism):
        missing.append(("crank_rod_angle", "no leg of this mechanism has a crank and a rod"))
    if not rods_at_shared_joints(mechanism):
        missing.append(("rod_rod_angle", "no two rods of this mechanism share a joint"))
    return [
        (f"/constructive/{end}_{angle}", detail)
        for angle, detail in missing
        for end in ("min", "max")
        if bounds is not None and getattr(bounds, f"{end}_{angle}") is not None
    ]


def _effective_errors(request: WorkspaceRequest, mechanism: Mechanism) -> list[tuple[str, str]]:
    errors = []
    bounds = request.effective
    units = effort_units(mechanism)
    if bounds is not None and isinstance(bounds.max_effort, float) and len(set(units)) > 1:
        detail = f"drives bear {shared_unit(units)}; give one number per leg"
        errors.append(("/effective/max_effort", detail))
    if request.class_ == "effective" and (bounds is None or bounds.max_effort is None):
        errors.append(("/effective/max_effort", "the class effective needs a bound; it is missing"))
    if bounds is not None and isinstance(bounds.max_effort, list):
        count = mechanism.leg_count
        if len(bounds.max_effort) != count:
            errors.append(
                (
                    "/effective/max_effort",
                    f"must be one number or {count}, one per leg; given {len(bounds.max_effort)}",
                )
            )
    if (bounds is None or bounds.load is None) and any("effort" in f for f in request.fields):
        errors.append(("/effective/load", "the effort fields need a load; it is missing"))
    return errors


def _size_errors(request: WorkspaceRequest, node_limit: int) -> list[tuple[str, str]]:
    axes = [Axis(a.coordinate, a.min, a.max, a.step) for a in request.grid]
    nodes = math.prod(axis.intervals + 1.0 for axis in axes)
    if nodes <= node_limit:
        return []
    factor = _coarsening(axes, node_limit)
    coarse = [_coarser(axis, factor) for axis in axes]
    steps = ", ".join(f"{axis.coordinate}: {_rounded_up(axis.step)}" for axis in coarse)
    return [
        (
            "/grid",
            f"{nodes:.6g} nodes; at most {node_limit} are allowed. With all steps coarser by the "
            f"same factor it would fit from {steps}",
        )
    ]


def _coarsening(axes: list[Axis], node_limit: int) -> float:
    """Return the least factor, to a millionth, on all steps with which the grid fits."""

    def fits(factor: float) -> bool:
        counts = (_coarser(axis, factor).intervals + 1.0 for axis in axes)
        return math.prod(counts) <= node_limit

    low, high = 1.0, 2.0 * max(axis.intervals + 1.0 for axis in axes)
    while high > low * (1.0 + 1e-6):
        middle = math.sqrt(low * high)
        low, high = (low, middle) if fits(middle) else (middle, high)
    return high


def _coarser(axis: Axis, factor: float) -> Axis:
    # A step a little beyond the axis leaves one node; a longer one says no more.
    longest = max(axis.step, 1.001 * (axis.maximum - axis.minimum))
    return replace(axis, step=min(axis.step * factor, longest))


def _rounded_up(step: float) -> str:
    """Return a step in six digits, not below what it is: the grid must still fit."""
    context = Context(prec=6, rounding=ROUND_CEILING)
    return f"{context.create_decimal_from_float(step):g}"


def field_units(request: WorkspaceRequest, mechanism: Mechanism) -> dict[str, str]:
    """Return the unit of each field asked for."""
    effort = shared_unit(effort_units(mechanism))
    units = {
        "effort": effort,
        "effort_max": effort,
        "determinant": determinant_unit(mechanism),
        "actuators": shared_unit(drive_units(mechanism)),
    }
    return {name: units[name] for name in request.fields}
