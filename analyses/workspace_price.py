"""What a workspace costs: measured on one core of a common machine, condition by condition."""

import numpy as np

from analyses.workspace_orientations import tries
from analyses.workspace_setup import WorkspaceSetup, question_of
from mechanics.inscribed import offers_box
from mechanics.judging import asked_share
from mechanics.legs import CRANK, STRUT
from mechanics.lines import provable
from mechanics.orientations import Question, all_round, foreseen, sampled_work
from mechanics.sweeps import swept
from schemas.workspace import WorkspaceRequest

SECONDS_PER_NODE = 1.5e-7
SECONDS_PER_LEG = {
    "reach": 2e-8,
    "actuator_limits": 6e-8,
    "crank_rod_angle": 4e-8,
    "rod_rod_angle": 8e-8,
    "base_joint_angle": 1.3e-7,
    "platform_joint_angle": 1e-7,
    "rod_distance": 1.6e-7,
    "effort": 1.2e-7,
    "pressure_angle": 2.1e-7,
    "determinant": 8e-8,
    "condition_number": 3e-7,
    "actuator_speed": 8e-8,
}
SECONDS_BY_LINES = 1e-9
"""Of a leg's condition that is decided along whole lines, a node."""
SECONDS_PER_LINE, SECONDS_PER_LINE_OF_CRANKS = 1e-8, 1.5e-7
"""The same, a line: of rails and struts, and of cranks, most of all such with stops."""
SECONDS_BY_BOXES = 3e-8
"""Of a node in boxes that are judged by bounds, before any is asked by itself."""
SECONDS_ALL_ROUND = 8e-8
"""Of a leg's condition that is decided at all angles of a turn at once."""
SECONDS_ASLANT = 6e-7
"""The same, of a leg whose own axis is aslant of the turn, and of stops: by the roots of waves."""
MET_LATER = 0.25
"""The share of nodes asked by themselves that meet the first condition and are held to others."""
SEARCHED = 100
"""How many more angles are looked at to find where arcs end that have no closed forms."""
SECONDS_JUDGED = 1.2e-6
"""Of a box of nodes, of which bounds are to tell the code at all angles of a turn."""
SECONDS_TOLD = 1e-8
"""Of a node whose code may be that of its box: it is written, and read for runs."""
SECONDS_WEIGHED = 2e-9
"""Of a leg's condition at a node and one of many orientations, all angles of a turn included."""
SECONDS_CUT, SECONDS_CUT_ASLANT = 6e-8, 5e-7
"""The same where arcs are cut, and where some are cut by the roots of waves."""
SECONDS_PER_ORIENTATION = 3e-4
"""Of each orientation tried by itself, for every stretch of nodes."""
SECONDS_INSCRIBED = 1.6e-8
"""Of a node of the grid, where the largest ball and box inside the workspace are asked for."""
FIELD_WORK = {
    "effort": "effort",
    "effort_max": "effort",
    "condition_number": "condition_number",
    "pressure_angle": "pressure_angle",
}
"""The condition whose work a field asks for too."""


def seconds_per_node(request: WorkspaceRequest, setup: WorkspaceSetup) -> float:
    """Return the cost of a node that meets every condition, at all its orientations. [s]"""
    question = question_of(request, setup, setup.mechanism)
    if question is not None and all_round(setup.conditions, question.orientations):
        return _seconds_all_round(setup, question)
    decided, told = _told_together(setup, question)
    checked = [condition.reason for condition in setup.conditions[decided:]]
    # What a block keeps for its condition and its field alike is computed once.
    kept = {FIELD_WORK[name] for name in setup.fields if name in FIELD_WORK}
    names = checked + [name for name in kept if name == "effort" or name not in checked]
    asked = sum(SECONDS_PER_LEG[name] for name in names)
    once = SECONDS_PER_NODE if names or setup.fields else 0.0
    share = _asked_share(setup)
    boxes = SECONDS_BY_BOXES if share < 1.0 else 0.0
    many = _looks(setup) * len(setup.mechanisms)
    tried = (boxes + share * (once + setup.mechanism.drive_count * asked)) * many
    grids = 1 if question is None else question.orientations.grid.size
    return tried + told * grids * len(setup.mechanisms)


def _looks(setup: WorkspaceSetup) -> int:
    """Return how often each node is looked at by itself, the ends of arcs sought included."""
    orientations = setup.orientations
    looks = tries(orientations, setup.conditions)
    if orientations is None or orientations.turn is None or _closed(setup):
        return looks
    return looks + SEARCHED * orientations.grid.size


def _closed(setup: WorkspaceSetup) -> bool:
    """Return whether all conditions have closed forms at all angles of a turn."""
    return swept(setup.conditions) == len(setup.conditions)


def _asked_share(setup: WorkspaceSetup) -> float:
    """Return which share of the nodes that lines leave are asked by themselves."""
    orientations = setup.orientations
    if setup.fields or (orientations is not None and orientations.turn is not None):
        return 1.0
    return asked_share(setup.mechanism, setup.conditions, setup.grid)


def seconds_per_tile(setup: WorkspaceSetup) -> float:
    """Return what orientations that are tried one by one cost, however few the nodes. [s]"""
    orientations = setup.orientations
    if orientations is None or all_round(setup.conditions, orientations):
        return 0.0
    return orientations.grid.size * len(setup.mechanisms) * SECONDS_PER_ORIENTATION


def seconds_inscribed(request: WorkspaceRequest, setup: WorkspaceSetup) -> float:
    """Return the cost of the shapes that the result is asked for, 0 if none are. [s]"""
    sought = request.inscribed and offers_box(setup.grid)
    return setup.grid.size * SECONDS_INSCRIBED if sought else 0.0


def _told_together(setup: WorkspaceSetup, question: Question | None) -> tuple[int, float]:
    """Return how many leading conditions are told for many nodes at once, and their cost a node."""
    if question is None or question.orientations.turn is None:
        decided = provable(setup.mechanism, setup.conditions, setup.grid)
        return decided, setup.mechanism.drive_count * decided * _seconds_by_lines(setup)
    decided = swept(setup.conditions)
    parts = [len(condition.legs) for condition in setup.conditions[:decided]]
    tests = sum(parts[:1]) + MET_LATER * sum(parts[1:])
    work = foreseen(question)
    asked = SECONDS_ASLANT if _aslant(setup) else SECONDS_ALL_ROUND
    total = SECONDS_JUDGED * work.judged + asked * tests * work.asked
    return decided, SECONDS_TOLD + total / setup.grid.size


def _seconds_by_lines(setup: WorkspaceSetup) -> float:
    """Return the cost of a leg's condition that is decided along whole lines, a node. [s]"""
    cranks = bool(np.any(setup.mechanism.legs.drive == CRANK))
    line = SECONDS_PER_LINE_OF_CRANKS if cranks else SECONDS_PER_LINE
    return SECONDS_BY_LINES + line / setup.grid.shape[-1]


def _aslant(setup: WorkspaceSetup) -> bool:
    """Return whether some legs' arcs end at roots of waves."""
    driven = bool(np.any(setup.mechanism.legs.drive != STRUT))
    return driven and (setup.mechanism.motion.name != "planar" or swept(setup.conditions) > 1)


def _seconds_all_round(setup: WorkspaceSetup, question: Question) -> float:
    """Return the cost of a node at many orientations that are tried at once. [s]"""
    work = sampled_work(question)
    cut = SECONDS_CUT_ASLANT if _aslant(setup) else SECONDS_CUT
    tests = sum(len(condition.legs) for condition in setup.conditions)
    times = tests * question.orientations.grid.size * len(setup.mechanisms)
    # Of nodes that the first orientations tell little but reading is left.
    return times * (SECONDS_WEIGHED * max(work.weighed, 0.01) + cut * work.cut)
