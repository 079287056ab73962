"""What a workspace costs: measured on one core of a common machine, condition by condition."""

from collections.abc import Iterable, Sequence

import numpy as np

from analyses.workspace_setup import WorkspaceSetup, question_of
from mechanics import forecasts
from mechanics.arrays import Floats
from mechanics.conditions.condition import Condition
from mechanics.forecasts import Search
from mechanics.inscribed import offers_box
from mechanics.kernels.line_ends import LIMITS, NOTHING
from mechanics.legs import CRANK
from mechanics.lines import provable
from mechanics.orientations import FEW, Question, all_round
from mechanics.sweeps import NODES_SEARCHED, swept
from mechanics.turns import Turn
from schemas.workspace import WorkspaceRequest

SECONDS_PER_NODE = 2e-7
"""Of a pose asked by itself, before any condition is."""
SECONDS_PER_LEG = {
    "reach": 2e-8,
    "actuator_limits": 6e-8,
    "crank_rod_angle": 3e-8,
    "rod_rod_angle": 5e-8,
    "base_joint_angle": 1.4e-7,
    "platform_joint_angle": 1.4e-7,
    "rod_distance": 1.6e-7,
    "effort": 3e-8,
    "pressure_angle": 1.6e-7,
    "determinant": 6e-8,
    "condition_number": 1.5e-7,
    "actuator_speed": 7e-8,
}
"""Of a condition, a leg of each pose that meets it."""
SECONDS_PER_LINE, SECONDS_OF_CRANK, SECONDS_OF_STOPS = 2e-8, 5e-8, 2e-7
"""Of a leg's condition that is decided along whole lines, a line; a crank's, and its stops."""
SECONDS_OF_RUNS = 4e-7
"""Of a line's few runs, until they are put together to a workspace."""
SECONDS_AT_STOPS = 1e-10
"""Of a node and a crank's stops: a few lines in a thousand are left to their nodes."""
SECONDS_UNITED, SECONDS_IN_ORDER = 4e-9, 3e-8
"""Of a node and each of several working modes, and orientations, that are put together."""
SECONDS_BY_BOXES = 3e-8
"""Of a node in boxes that are judged by bounds, before any is asked by itself."""
SECONDS_ALL_ROUND = 8e-8
"""Of a leg's condition that is decided at all angles of a turn at once."""
SECONDS_ASLANT = 1e-6
"""The same, of a leg whose own axis is aslant of the turn, and of stops: by the roots of waves."""
SEARCHED, SEARCHED_OF_ALL = 150, 10
"""How many more angles are looked at to find where arcs end, and whether all of one is left."""
CALLS, CALLS_OF_ALL = 55, 30
"""The same, of nodes searched together: in so many calls."""
SECONDS_PER_CALL = 1.5e-4
SECONDS_JUDGED = 1.2e-6
"""Of a box of nodes, of which bounds are to tell the code at all angles of a turn."""
SECONDS_TOLD = 1e-8
"""Of a node whose code may be that of its box: it is written, and read for runs."""
SECONDS_WEIGHED = 2e-9
"""Of a leg's condition at a node and one of many orientations, all angles of a turn included."""
SECONDS_CUT, SECONDS_CUT_ASLANT = 6e-8, 5e-7
"""The same where arcs are cut, and where they are cut by the roots of waves."""
SECONDS_PER_ORIENTATION = 6e-4
"""Of each orientation tried by itself, for every stretch of nodes."""
SECONDS_INSCRIBED = 1.6e-8
"""Of a node of the grid, where the largest ball and box inside the workspace are asked for."""
FIELD_WORK = {
    "effort": "effort",
    "effort_max": "effort",
    "determinant": "determinant",
    "condition_number": "condition_number",
    "pressure_angle": "pressure_angle",
    "actuators": "actuator_limits",
}
"""The condition whose work a field asks for too."""


def seconds_per_node(request: WorkspaceRequest, setup: WorkspaceSetup) -> float:
    """Return the mean cost of a node, at all its orientations and in all working modes. [s]"""
    modes = len(setup.mechanisms)
    return modes * (_seconds_in_mode(request, setup) + (SECONDS_UNITED if modes > 1 else 0.0))


def _seconds_in_mode(request: WorkspaceRequest, setup: WorkspaceSetup) -> float:
    """Return the mean cost of a node in one working mode, at all its orientations. [s]"""
    question = question_of(request, setup, setup.mechanism)
    if question is None:
        return _seconds_along_lines(setup)
    turn = question.orientations.turn
    if turn is None:
        return _seconds_in_order(setup, question)
    if all_round(setup.conditions, question.orientations):
        return _seconds_all_round(setup, question, turn)
    return _seconds_around(setup, question, turn)


def seconds_per_tile(setup: WorkspaceSetup) -> float:
    """Return what orientations that are tried one by one cost, however few a tile's nodes. [s]"""
    orientations = setup.orientations
    if orientations is None or all_round(setup.conditions, orientations) or _tried_together(setup):
        return 0.0
    return orientations.grid.size * len(setup.mechanisms) * SECONDS_PER_ORIENTATION


def _tried_together(setup: WorkspaceSetup) -> bool:
    """Return whether there are so few nodes that they are tried at several orientations at once."""
    orientations = setup.orientations
    return orientations is not None and orientations.turn is None and setup.grid.size <= FEW


def seconds_inscribed(request: WorkspaceRequest, setup: WorkspaceSetup) -> float:
    """Return the cost of the shapes that the result is asked for, 0 if none are. [s]"""
    sought = request.inscribed and offers_box(setup.grid)
    return setup.grid.size * SECONDS_INSCRIBED if sought else 0.0


def _seconds_along_lines(setup: WorkspaceSetup) -> float:
    """Return the mean cost of a node at its one orientation. [s]"""
    conditions = setup.conditions
    decided = provable(setup.mechanism, conditions, setup.grid)
    met = forecasts.met_along_lines(setup.mechanism, conditions, setup.grid, setup.fields)
    boxes = SECONDS_BY_BOXES * met.shares[decided] if met.asked < 1.0 else 0.0
    checked = [condition.reason for condition in conditions[decided:]]
    # What a block keeps for its condition and its field alike is computed once.
    kept = {FIELD_WORK[name] for name in setup.fields if name in FIELD_WORK}
    again = [name for name in kept if name == "effort" or name not in checked]
    lines = _seconds_by_lines(setup, decided) + SECONDS_OF_RUNS / setup.grid.shape[-1]
    asked = _seconds_asked(setup, decided, met.shares) if checked or setup.fields else 0.0
    legs = setup.mechanism.drive_count * met.shares[-1]
    return float(lines + boxes + met.asked * asked + legs * _seconds_per_leg(again))


def _seconds_in_order(setup: WorkspaceSetup, question: Question) -> float:
    """Return the mean cost of a node at many orientations, one after the other. [s]"""
    by_lines = not _tried_together(setup)
    decided = provable(setup.mechanism, setup.conditions, setup.grid) if by_lines else 0
    shares = forecasts.met_in_order(question)
    asked = _seconds_asked(setup, decided, shares) if decided < len(setup.conditions) else 0.0
    each = _seconds_by_lines(setup, decided) + SECONDS_IN_ORDER + asked
    return float(question.orientations.grid.size * each)


def _seconds_asked(setup: WorkspaceSetup, decided: int, shares: Floats) -> float:
    """Return the cost of a node's conditions, of those that lines do not tell. [s]"""
    each = _seconds_each(setup, setup.conditions[decided:])
    return float(SECONDS_PER_NODE * shares[decided] + shares[decided:-1] @ each)


def _seconds_each(setup: WorkspaceSetup, conditions: Sequence[Condition]) -> Floats:
    """Return what each condition costs a pose that meets it, shape (conditions,). [s]"""
    own = np.array([SECONDS_PER_LEG[condition.reason] for condition in conditions])
    return setup.mechanism.drive_count * own


def _seconds_per_leg(names: Iterable[str]) -> float:
    return sum(SECONDS_PER_LEG[name] for name in names)


def _seconds_by_lines(setup: WorkspaceSetup, decided: int) -> float:
    """Return the cost of the first conditions, decided along whole lines, a node. [s]"""
    line, node = 0.0, 0.0
    for condition in setup.conditions[:decided]:
        for leg, test in zip(condition.legs, condition.line_tests or (), strict=True):
            if test == NOTHING:
                continue
            crank = setup.mechanism.legs.drive[leg] == CRANK
            stops = crank and test == LIMITS
            line += SECONDS_OF_STOPS if stops else SECONDS_OF_CRANK if crank else SECONDS_PER_LINE
            node += SECONDS_AT_STOPS if stops else 0.0
    return line / setup.grid.shape[-1] + node


def _seconds_around(setup: WorkspaceSetup, question: Question, turn: Turn) -> float:
    """Return the mean cost of a node at its one orientation but for all angles of a turn. [s]"""
    work, ways = forecasts.boxes_told(question, turn), forecasts.ways_told(question, turn)
    seen = forecasts.seen_around(question, turn)
    asked = forecasts.met_around(question, seen) @ (
        SECONDS_ALL_ROUND * ways.by_bounds + SECONDS_ASLANT * ways.by_roots
    )
    total = SECONDS_JUDGED * work.judged + asked * work.asked
    told = float(SECONDS_TOLD + total / setup.grid.size)
    if swept(setup.conditions) == len(setup.conditions):
        return told
    search = forecasts.searches(question, turn, seen)
    return told + _seconds_searched(setup, question, search, work.asked / setup.grid.size)


def _seconds_searched(
    setup: WorkspaceSetup, question: Question, search: Search, asked: float
) -> float:
    """Return the mean cost of a node's search, of which this share is asked by itself. [s]"""
    rest = setup.conditions[swept(setup.conditions) :]
    more, calls = (SEARCHED_OF_ALL, CALLS_OF_ALL) if question.every else (SEARCHED, CALLS)
    each = SECONDS_PER_NODE + _seconds_each(setup, rest)
    signs = setup.mechanism.drive_count * SECONDS_PER_LEG["determinant"]
    looks = search.first @ each + (search.sought + more * search.owners) @ (each + signs)
    blocks = asked / NODES_SEARCHED
    # Where no node of a block owns an arc, nothing is searched.
    owning = np.minimum(blocks, search.owners).sum()
    return float(looks + owning * calls * SECONDS_PER_CALL)


def _seconds_all_round(setup: WorkspaceSetup, question: Question, turn: Turn) -> float:
    """Return the mean cost of a node at many orientations that are tried at once. [s]"""
    work, ways = forecasts.pairs_told(question, turn), forecasts.ways_told(question, turn)
    tests = int(np.sum(ways.by_bounds | ways.by_roots))
    cut = SECONDS_CUT * ways.by_bounds.sum() + SECONDS_CUT_ASLANT * ways.by_roots.sum()
    # Of nodes that the first orientations tell little but reading is left.
    each = tests * SECONDS_WEIGHED * max(work.weighed, 0.01) + cut * work.cut
    return float(question.orientations.grid.size * each)
