"""Which orientations a workspace's type runs over, and whether the type makes sense."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from analyses.errors import pointer
from mechanics.conditions.condition import Condition
from mechanics.conditions.motor_limits import MotorLimits
from mechanics.grid import Axis, Grid
from mechanics.mechanism import Mechanism
from mechanics.motions import Motion
from mechanics.orientations import Orientations
from mechanics.sweeps import swept
from mechanics.turns import Turn
from schemas.workspace import OrientationAxis, WorkspaceRequest
from schemas.workspace_result import OrientationsTried

WHOLE = ("maximal", "full")
EVERY = ("orientation_range", "full")
MANY = (*WHOLE, "inclusive_orientation", "orientation_range")
ONE_TURN_STEP, THREE_TURNS_STEP = math.radians(2.0), math.radians(15.0)
TURN = 2.0 * math.pi
SPIN = "spin"
"""The turn of a platform that only turns, about its own z axis: where that points is its place."""
MIDDLE_TURN = "ry"
"""Of three turns about fixed axes this one needs half a turn only."""
Complaint = tuple[str, str]


def orientations_of(
    request: WorkspaceRequest, mechanism: Mechanism, fixed: Grid, conditions: Sequence[Condition]
) -> Orientations | None:
    """Return the orientations that a request's type runs over; None for one at a time.

    One turn is examined at all of its angles, and so is the last of several if all conditions
    have closed forms there; else several are a grid.
    """
    if request.type not in MANY:
        return None
    motion, idle = mechanism.motion, _idle_turns(mechanism, conditions)
    given = {entry.coordinate: entry for entry in request.orientation_range}
    ranges = [
        _range(name, given.get(name), len(ranged(motion)), idle=name in idle)
        for name in ranged(motion)
        if name not in request.fixed
    ]
    around = len(ranges) == 1 or swept(conditions) == len(conditions)
    tried = ranges[:-1] if around else ranges
    columns = tuple(motion.coordinates.index(r.coordinate) for r in tried)
    grid = Grid(tuple(r.axis for r in tried), columns, fixed.fixed)
    extent = math.prod(r.size for r in ranges)
    return Orientations(grid, ranges[-1].turn(motion) if around else None, extent)


def _idle_turns(mechanism: Mechanism, conditions: Sequence[Condition]) -> tuple[str, ...]:
    """Return the turns that change nothing that is asked: the limits of motors feel every turn."""
    limited = any(isinstance(condition, MotorLimits) for condition in conditions)
    return () if mechanism.wrist is None or limited else mechanism.wrist.idle_turns


def ranged(motion: Motion) -> tuple[str, ...]:
    """Return the turns that the types of many orientations run over."""
    return motion.turns if motion.translations else (SPIN,)


@dataclass(frozen=True)
class _Range:
    """What one turn runs over. [rad]"""

    coordinate: str
    low: float
    high: float
    step: float
    whole: bool

    @property
    def size(self) -> float:
        """The size of the range; of a whole turn about an axis its two ends are one."""
        return self.high - self.low

    @property
    def axis(self) -> Axis:
        """Evenly spaced orientations; of a whole turn the first is the last, and left out."""
        if self.size == 0.0:
            return Axis(self.coordinate, self.low, self.high, self.step)
        step = self.size / max(1, math.ceil(self.size / self.step - 1e-9))
        closed = self.whole and self.coordinate != MIDDLE_TURN
        return Axis(self.coordinate, self.low + step if closed else self.low, self.high, step)

    def turn(self, motion: Motion) -> Turn:
        """Return the turn at all angles of which conditions are asked."""
        own = self.coordinate
        column = None if own == SPIN else motion.coordinates.index(own)
        return Turn(motion, own, column, self.low, self.high, self.step)


def _range(name: str, given: OrientationAxis | None, turns: int, *, idle: bool) -> _Range:
    """Return what a turn runs over, one angle after the other where that changes anything."""
    chosen = _chosen_range(name, given, turns)
    return replace(chosen, step=max(chosen.size, chosen.step)) if idle else chosen


def _chosen_range(name: str, given: OrientationAxis | None, turns: int) -> _Range:
    asked = None if given is None else given.step
    step = asked or (ONE_TURN_STEP if turns == 1 else THREE_TURNS_STEP)
    if given is None or given.min is None or given.max is None:
        return _Range(name, *_whole_turn(name), step, whole=True)
    return _Range(name, given.min, given.max, step, whole=False)


def free_turns(request: WorkspaceRequest, motion: Motion) -> int:
    """Return over how many turns a request's type runs."""
    return sum(name not in request.fixed for name in ranged(motion))


def _whole_turn(name: str) -> tuple[float, float]:
    return (-0.5 * math.pi, 0.5 * math.pi) if name == MIDDLE_TURN else (-math.pi, math.pi)


def tried(orientations: Orientations | None) -> list[OrientationsTried] | None:
    """Return what the result says of the orientations."""
    if orientations is None:
        return None
    told = [_told(axis, all_angles=False) for axis in orientations.grid.axes]
    turn = orientations.turn
    if turn is None:
        return told
    axis = Axis(turn.coordinate, turn.low, turn.high, turn.step)
    return [*told, _told(axis, all_angles=True)]


def _told(axis: Axis, *, all_angles: bool) -> OrientationsTried:
    return OrientationsTried.model_construct(
        coordinate=axis.coordinate,
        min=axis.minimum,
        max=axis.maximum,
        step=axis.step,
        count=None if all_angles else axis.count,
        all_angles=all_angles,
    )


def orientation_errors(request: WorkspaceRequest, mechanism: Mechanism) -> list[Complaint]:
    """Return why the type, its range or its fields make no sense; nothing if they do."""
    motion = mechanism.motion
    if request.type != "constant_orientation" and not motion.turns:
        return [("/type", f"{request.type} needs a platform that turns; this one does not")]
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
    names = [entry.coordinate for entry in request.orientation_range]
    for k, entry in enumerate(request.orientation_range):
        place = ("orientation_range", k)
        if entry.coordinate not in ranged(motion):
            allowed = ", ".join(ranged(motion))
            yield pointer(*place, "coordinate"), f"given {entry.coordinate!r}; allowed: {allowed}"
        if names.index(entry.coordinate) < k:
            yield pointer(*place, "coordinate"), f"{entry.coordinate!r} has a range already"
        yield from _end_errors(request, entry, place)
    yield from _missing_turns(request, motion)


def _end_errors(
    request: WorkspaceRequest, entry: OrientationAxis, place: tuple[str, int]
) -> Iterator[Complaint]:
    if request.type in WHOLE and (entry.min, entry.max) != (None, None):
        yield pointer(*place), f"{request.type} means the whole turn; give its step only"
    if request.type in WHOLE:
        return
    if entry.min is None or entry.max is None:
        yield pointer(*place), "needs min and max"
    elif entry.max < entry.min:
        yield pointer(*place, "max"), f"must not be below min, which is {entry.min}"
    elif entry.max - entry.min > TURN:
        detail = f"must be at most a turn above min, {entry.min + TURN:.6g}; given {entry.max}"
        yield pointer(*place, "max"), detail


def _missing_turns(request: WorkspaceRequest, motion: Motion) -> Iterator[Complaint]:
    if request.type not in MANY:
        return
    names = {entry.coordinate for entry in request.orientation_range}
    for name in ranged(motion):
        if name in request.fixed and request.type in WHOLE:
            yield pointer("fixed", name), f"{request.type} runs over all of {name!r}"
        elif name in request.fixed and name in names:
            yield pointer("fixed", name), f"{name!r} has a range already"
        elif request.type not in WHOLE and name not in request.fixed and name not in names:
            yield "/orientation_range", f"{name!r} has no range and is not fixed"


def _field_errors(request: WorkspaceRequest) -> Iterator[Complaint]:
    for k, name in enumerate(request.fields):
        if (name == "free_orientation") != (request.type in MANY):
            told = "runs over orientations" if request.type in MANY else "has one orientation"
            yield pointer("fields", k), f"the type {request.type} {told}; it has no {name}"


def tries(orientations: Orientations | None, conditions: Sequence[Condition]) -> int:
    """Return at how many orientations each node is tried; all angles in closed form are one."""
    if orientations is None:
        return 1
    turn = orientations.turn
    if turn is None or swept(conditions) == len(conditions):
        return orientations.grid.size
    return orientations.grid.size * (1 + math.ceil((turn.high - turn.low) / turn.step))
