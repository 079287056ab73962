"""Which orientations a workspace's type runs over, and whether the type makes sense."""

import math
from collections.abc import Iterator

import numpy as np

from analyses.errors import pointer
from mechanics.grid import Axis, Grid
from mechanics.mechanism import Mechanism
from mechanics.motions import Motion
from schemas.workspace import OrientationAxis, OrientationsTried, WorkspaceRequest

WHOLE = ("maximal", "full")
EVERY = ("orientation_range", "full")
MANY = (*WHOLE, "inclusive_orientation", "orientation_range")
ONE_TURN_STEP, THREE_TURNS_STEP = math.radians(2.0), math.radians(15.0)
MIDDLE_TURN = "ry"
"""Of three turns about fixed axes this one needs half a turn only."""
Complaint = tuple[str, str]


def orientations_of(request: WorkspaceRequest, mechanism: Mechanism, fixed: Grid) -> Grid | None:
    """Return the orientations that a request's type runs over; None for one at a time."""
    if request.type not in MANY:
        return None
    motion = mechanism.motion
    given = {entry.coordinate: entry for entry in request.orientation_range}
    names = [name for name in motion.turns if name not in request.fixed]
    axes = tuple(_axis(name, given.get(name), len(motion.turns)) for name in names)
    columns = tuple(motion.coordinates.index(name) for name in names)
    return Grid(axes, columns, fixed.fixed)


def _axis(name: str, given: OrientationAxis | None, turns: int) -> Axis:
    """Return evenly spaced orientations; of a whole turn the first is the last, and left out."""
    low, high = _whole_turn(name)
    whole = given is None or given.min is None or given.max is None
    if given is not None and given.min is not None and given.max is not None:
        low, high = given.min, given.max
    asked = None if given is None else given.step
    largest = asked or (ONE_TURN_STEP if turns == 1 else THREE_TURNS_STEP)
    count = max(1, math.ceil((high - low) / largest - 1e-9))
    step = (high - low) / count
    if high == low:
        return Axis(name, low, high, largest)
    closed = whole and name != MIDDLE_TURN
    return Axis(name, low + step if closed else low, high, step)


def _whole_turn(name: str) -> tuple[float, float]:
    return (-0.5 * math.pi, 0.5 * math.pi) if name == MIDDLE_TURN else (-math.pi, math.pi)


def tried(orientations: Grid | None) -> list[OrientationsTried] | None:
    """Return what the result says of the orientations."""
    if orientations is None:
        return None
    return [
        OrientationsTried.model_construct(
            coordinate=axis.coordinate,
            min=axis.minimum,
            max=axis.maximum,
            step=axis.step,
            count=axis.count,
        )
        for axis in orientations.axes
    ]


def orientation_errors(request: WorkspaceRequest, mechanism: Mechanism) -> list[Complaint]:
    """Return why the type, its range or its fields make no sense; nothing if they do."""
    motion = mechanism.motion
    if request.type != "constant_orientation" and not motion.turns:
        return [("/type", f"{request.type} needs a platform that turns; this one does not")]
    if request.type in MANY and not motion.translations:
        return [("/type", f"{request.type} needs a platform that moves; this one only turns")]
    return [
        *_range_errors(request, motion),
        *_field_errors(request),
        *([("/component", "home needs one orientation at a time")] if _is_home(request) else []),
    ]


def _is_home(request: WorkspaceRequest) -> bool:
    return request.type in MANY and request.component == "home"


def _range_errors(request: WorkspaceRequest, motion: Motion) -> Iterator[Complaint]:
    if request.orientation_range and request.type not in MANY:
        yield "/orientation_range", f"the type {request.type} has no range of orientations"
        return
    for k, entry in enumerate(request.orientation_range):
        place = ("orientation_range", k)
        if entry.coordinate not in motion.turns:
            allowed = ", ".join(motion.turns)
            yield pointer(*place, "coordinate"), f"given {entry.coordinate!r}; allowed: {allowed}"
        if [e.coordinate for e in request.orientation_range].index(entry.coordinate) < k:
            yield pointer(*place, "coordinate"), f"{entry.coordinate!r} has a range already"
        if request.type in WHOLE and (entry.min, entry.max) != (None, None):
            yield pointer(*place), f"{request.type} means the whole turn; give its step only"
        if request.type not in WHOLE and (entry.min is None or entry.max is None):
            yield pointer(*place), "needs min and max"
        elif entry.min is not None and entry.max is not None and entry.max < entry.min:
            yield pointer(*place, "max"), f"must not be below min, which is {entry.min}"
    yield from _missing_turns(request, motion)


def _missing_turns(request: WorkspaceRequest, motion: Motion) -> Iterator[Complaint]:
    if request.type not in MANY:
        return
    ranged = {entry.coordinate for entry in request.orientation_range}
    for name in motion.turns:
        if name in request.fixed and request.type in WHOLE:
            yield pointer("fixed", name), f"{request.type} runs over all of {name!r}"
        elif name in request.fixed and name in ranged:
            yield pointer("fixed", name), f"{name!r} has a range already"
        elif request.type not in WHOLE and name not in request.fixed and name not in ranged:
            yield "/orientation_range", f"{name!r} has no range and is not fixed"


def _field_errors(request: WorkspaceRequest) -> Iterator[Complaint]:
    for k, name in enumerate(request.fields):
        if (name == "free_orientation") != (request.type in MANY):
            told = "runs over orientations" if request.type in MANY else "has one orientation"
            yield pointer("fields", k), f"the type {request.type} {told}; it has no {name}"


def extent(orientations: Grid) -> float:
    """Return the size of the range that orientations stand for. [rad to the number of turns]"""
    sizes = []
    for axis in orientations.axes:
        turn = _whole_turn(axis.coordinate)
        closed = axis.maximum == turn[1] and abs(axis.minimum - axis.step - turn[0]) < 1e-9
        low = turn[0] if closed and axis.coordinate != MIDDLE_TURN else axis.minimum
        sizes.append(axis.maximum - low)
    return float(np.prod([size for size in sizes if size > 0.0]))


def tries(orientations: Grid | None) -> int:
    """Return at how many orientations each node is tried."""
    return 1 if orientations is None else orientations.size
