"""From a workspace request to the grid, the conditions and the fields of `mechanics`."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, Context

import numpy as np

from analyses.errors import AnalysisError, pointer
from analyses.mechanisms import build
from analyses.units import determinant_unit, drive_units, effort_units, power_unit, shared_unit
from analyses.workspace_bounds import bound_errors, conditions_of, load_of
from analyses.workspace_orientations import (
    EVERY,
    MANY,
    free_turns,
    orientation_errors,
    orientations_of,
    tries,
)
from mechanics import fields as kept
from mechanics.conditions.condition import Condition
from mechanics.grid import Axis, Grid
from mechanics.mechanism import Mechanism
from mechanics.motions import Motion
from mechanics.orientations import Orientations, Question
from schemas.workspace import WorkspaceRequest

MOST_ANGLES = 100_000
"""Angles of one turn at which a node may be looked at."""


@dataclass(frozen=True)
class WorkspaceSetup:
    """Everything that a scan needs."""

    mechanisms: tuple[Mechanism, ...]
    """The mechanism in each working mode of which the union is asked."""
    grid: Grid
    conditions: tuple[Condition, ...]
    fields: Mapping[str, kept.Field]
    orientations: Orientations | None
    """Those that each node is tried at; None: the one of its pose."""

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism in the first of its working modes."""
        return self.mechanisms[0]


def set_up(request: WorkspaceRequest) -> WorkspaceSetup:
    """Return what a scan of a checked request needs."""
    mechanisms = in_modes(request)
    mechanism = mechanisms[0]
    coordinates = mechanism.motion.coordinates
    axes = axes_of(request)
    columns = tuple(coordinates.index(axis.coordinate) for axis in axes)
    fixed = np.array([request.fixed.get(c, 0.0) for c in coordinates])
    grid = Grid(axes, columns, fixed)
    conditions = conditions_of(request, mechanism)
    orientations = orientations_of(request, mechanism, grid, conditions)
    return WorkspaceSetup(mechanisms, grid, conditions, fields_of(request), orientations)


def axes_of(request: WorkspaceRequest) -> tuple[Axis, ...]:
    """Return the axes of a request's grid."""
    return tuple(Axis(a.coordinate, a.min, a.max, a.step) for a in request.grid)


def question_of(
    request: WorkspaceRequest, setup: WorkspaceSetup, mechanism: Mechanism
) -> Question | None:
    """Return what is asked at many orientations of a mechanism in one of its working modes."""
    if setup.orientations is None:
        return None
    return Question(
        mechanism,
        setup.conditions,
        setup.grid,
        setup.orientations,
        every=request.type in EVERY,
        measured=bool(request.fields),
    )


def in_modes(request: WorkspaceRequest) -> tuple[Mechanism, ...]:
    """Return the mechanism in each working mode that a request asks for."""
    if request.working_mode != "any":
        return (build(request.mechanism, request.working_mode),)
    own = build(request.mechanism)
    return tuple(own.in_working_mode(mode) for mode in own.working_modes)


def fields_of(request: WorkspaceRequest) -> dict[str, kept.Field]:
    """Return the fields asked for, by name."""
    load = load_of(request.effective)
    known: dict[str, kept.Field] = {
        "effort": kept.effort(load),
        "effort_max": kept.effort_max(load),
        "determinant": kept.determinant,
        "condition_number": kept.condition_number,
        "pressure_angle": kept.pressure_angle,
        "actuators": kept.actuators,
    }
    # Whether neighbours are apart by a singularity shows in the signs.
    hidden = ["determinant"] if request.component == "home" else []
    wanted = dict.fromkeys([*request.fields, *hidden])
    return {name: known[name] for name in wanted if name in known}


def check_request(request: WorkspaceRequest, node_limit: int) -> None:
    """Raise AnalysisError if the request makes no sense; nothing large is allocated."""
    mechanism = in_modes(request)[0]
    errors = [
        *_coordinate_errors(request, mechanism),
        *orientation_errors(request, mechanism),
        *bound_errors(request, mechanism),
    ]
    errors = errors or _size_errors(request, mechanism, node_limit)
    if errors:
        raise AnalysisError(*errors)


def _coordinate_errors(request: WorkspaceRequest, mechanism: Mechanism) -> list[tuple[str, str]]:
    motion = mechanism.motion
    allowed = ", ".join(motion.coordinates)
    errors = []
    seen: set[str] = set()
    misplaced = _misplaced(request, motion)
    for k, axis in enumerate(request.grid):
        place = f"/grid/{k}/coordinate"
        if axis.coordinate not in motion.coordinates:
            errors.append((place, f"given {axis.coordinate!r}; allowed: {allowed}"))
        elif axis.coordinate in seen:
            errors.append((place, f"{axis.coordinate!r} has an axis already"))
        elif axis.coordinate in misplaced:
            does = "turns" if axis.coordinate in motion.turns else "moves"
            detail = f"{axis.coordinate!r} {does} the platform, and the type is {request.type}"
            errors.append((place, detail))
        seen.add(axis.coordinate)
    for name in request.fixed:
        if name not in motion.coordinates:
            errors.append((pointer("fixed", name), f"given {name!r}; allowed: {allowed}"))
        elif name in seen:
            errors.append((f"/fixed/{name}", f"{name!r} is on the grid already"))
    places = motion.translations or motion.coordinates
    needed = places if request.type in MANY else motion.coordinates
    missing = [c for c in needed if c not in seen and c not in request.fixed]
    errors += [
        (f"/fixed/{name}", f"{name!r} is neither on the grid nor fixed; give its value")
        for name in missing
    ]
    return errors


def _misplaced(request: WorkspaceRequest, motion: Motion) -> tuple[str, ...]:
    """Return the coordinates that a request's type cannot have on the grid."""
    if not motion.translations:
        # The place of a platform that only turns is where it points.
        return ()
    if request.type != "orientation":
        return motion.turns
    # With a turn beside them positions make a slice, whose every node is one pose.
    turned = any(axis.coordinate in motion.turns for axis in request.grid)
    return () if turned else motion.translations


def _size_errors(
    request: WorkspaceRequest, mechanism: Mechanism, node_limit: int
) -> list[tuple[str, str]]:
    axes = axes_of(request)
    nodes = math.prod(axis.intervals + 1.0 for axis in axes)
    setup = set_up(request)
    modes = len(setup.mechanisms)
    many = tries(setup.orientations, setup.conditions) * modes
    turn = None if setup.orientations is None else setup.orientations.turn
    if turn is not None and turn.step * MOST_ANGLES < turn.high - turn.low:
        least = (turn.high - turn.low) / MOST_ANGLES
        return [("/orientation_range", f"a step of {turn.step}; at least {least:.3g} is allowed")]
    if nodes * many <= node_limit:
        return []
    if many > 1:
        times = f"{many} times each, orientations and working modes counted"
        detail = f"{nodes:.6g} nodes, {times}; at most {node_limit} are allowed"
        return [("/orientation_range" if many > node_limit else "/grid", detail)]
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


def _coarsening(axes: Sequence[Axis], node_limit: int) -> float:
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
        "condition_number": "-",
        "pressure_angle": "rad",
        "actuators": shared_unit(drive_units(mechanism)),
        "free_orientation": power_unit(["rad"] * free_turns(request, mechanism.motion)),
    }
    return {name: units[name] for name in request.fields}
