"""Poses of a request: their check, and the obstacles that keep a mechanism from them."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analyses.analysis import Arrays
from analyses.errors import AnalysisError
from mechanics.arrays import Booleans, Floats, Integers
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.condition import NO_LEG, Breach, Condition
from mechanics.conditions.motor_limits import MotorLimits
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.drives import dead_drives
from mechanics.mechanism import Mechanism

ITEM_ARRAYS = ("pose", "leg", "reason", "value", "limit")
_FOREIGN = 1e-12
"""A rate that the motion lacks may be this share of the twist, from rounding."""

REASONS = ("reach", "actuator_limits", "singularity")


def check_poses(
    mechanism: Mechanism,
    poses: Sequence[Sequence[float]],
    coordinates: Sequence[str] | None = None,
) -> None:
    """Raise AnalysisError naming the first pose with another number of coordinates.

    These are all of the motion's, unless others are named.
    """
    names = mechanism.motion.coordinates if coordinates is None else coordinates
    for row, pose in enumerate(poses):
        if len(pose) != len(names):
            raise AnalysisError(
                (
                    f"/poses/{row}",
                    f"must have {len(names)} numbers ({', '.join(names)}); given {len(pose)}",
                )
            )


def check_rows(
    pointer: str, rows: Sequence[Sequence[float]], items: int, width: int, item: str = "pose"
) -> None:
    """Raise AnalysisError unless there is a row of `width` numbers for each item."""
    if len(rows) != items:
        detail = f"must have one row per {item}, that is {items}; given {len(rows)}"
        raise AnalysisError((pointer, detail))
    for number, row in enumerate(rows):
        if len(row) != width:
            detail = f"must have {width} numbers; given {len(row)}"
            raise AnalysisError((f"{pointer}/{number}", detail))


def check_motion(pointer: str, mechanism: Mechanism, rows: Sequence[Sequence[float]]) -> None:
    """Raise AnalysisError if a row [v, w] has a part that the motion lacks."""
    twists = np.array(rows, dtype=float)
    basis = mechanism.motion.twists
    foreign = np.abs(twists - twists @ basis @ basis.T)
    wrong = np.argwhere(foreign > _FOREIGN * np.linalg.norm(twists, axis=1, keepdims=True))
    if wrong.size:
        row, part = (int(index) for index in wrong[0])
        raise AnalysisError(
            (
                f"{pointer}/{row}/{part}",
                f"the motion {mechanism.motion.name} has no such rate and it must be 0; "
                f"given {twists[row, part]}",
            )
        )


def pose_conditions(mechanism: Mechanism) -> tuple[Condition, ...]:
    """Return what a pose must meet for the drives to hold it."""
    return Reach(mechanism), ActuatorLimits(mechanism), MotorLimits(mechanism)


def holds(block: Configuration, conditions: Sequence[Condition]) -> Booleans:
    """Return, shape (poses,), whether every condition holds."""
    verdicts = [np.all(condition.check(block) >= 0.0, axis=0) for condition in conditions]
    every: Booleans = np.logical_and.reduce(verdicts)
    return every


def obstacles(
    block: Configuration,
    conditions: Sequence[Condition],
    start: int,
    *,
    singular: bool = False,
    dead_drives: bool = False,
) -> Arrays:
    """Return one entry per pose and leg at which a condition fails, ordered by pose.

    The arrays are those of `ITEM_ARRAYS`, prefixed `obstacle_`; `start` is added to the poses.
    With `singular` also the poses that all legs reach and where det Jx is 0; with `dead_drives`
    the legs that are stretched or folded, whose drive cannot move the platform.
    """
    found = [_breaches(block, condition) for condition in conditions]
    if singular:
        found.append(_singularities(block))
    if dead_drives:
        found.append(_dead_drives(block))
    return _in_order([np.concatenate(parts) for parts in zip(*found, strict=True)], start)


def drive_obstacles(mechanism: Mechanism, actuators: Floats, start: int) -> Arrays:
    """Return, like `obstacles`, the rows and legs whose given drive is beyond its limits.

    `actuators` has a row a drive; `start` is added to the columns' numbers.
    """
    found = []
    for limits in (ActuatorLimits(mechanism), MotorLimits(mechanism)):
        broken = limits.margins(actuators) < 0.0
        at = np.flatnonzero(np.any(broken, axis=0))
        if at.size:
            nearest = limits.nearest(actuators[:, at])
            found.append(_broken(limits, at, broken[:, at], nearest))
    if not found:
        found.append(_nothing())
    return _in_order([np.concatenate(parts) for parts in zip(*found, strict=True)], start)


def _in_order(columns: Sequence[NDArray[Any]], start: int) -> Arrays:
    """Return the arrays of `ITEM_ARRAYS` ordered by pose, with `start` added to it."""
    order = np.argsort(columns[0], kind="stable")
    found = {
        f"obstacle_{name}": column[order] for name, column in zip(ITEM_ARRAYS, columns, strict=True)
    }
    found["obstacle_pose"] += start
    return found


def _breaches(block: Configuration, condition: Condition) -> tuple[NDArray[Any], ...]:
    # Strictly below zero: a leg that cannot reach has no drive to hold against limits.
    broken = condition.check(block) < 0.0
    at: Booleans = np.any(broken, axis=0)
    if not at.any():
        return _nothing()
    return _broken(condition, np.flatnonzero(at), broken[:, at], condition.explain(block.take(at)))


def _broken(
    condition: Condition, rows: Integers, broken: Booleans, breach: Breach
) -> tuple[NDArray[Any], ...]:
    """Return an entry for each part of a condition that is broken, shape (parts, rows)."""
    part, row = np.nonzero(broken)
    return _entries(
        rows[row],
        np.array(condition.legs, dtype=int)[part],
        np.full(part.size, REASONS.index(condition.reason)),
        breach.value[part, row],
        breach.limit[part, row],
    )


def _singularities(block: Configuration) -> tuple[NDArray[Any], ...]:
    pose = np.flatnonzero(block.determinants == 0.0)
    nothing = np.zeros(pose.size)
    legs = np.full(pose.size, NO_LEG)
    return _entries(pose, legs, np.full(pose.size, REASONS.index("singularity")), nothing, nothing)


def _dead_drives(block: Configuration) -> tuple[NDArray[Any], ...]:
    leg, pose = np.nonzero(dead_drives(block))
    nothing = np.zeros(pose.size)
    reasons = np.full(pose.size, REASONS.index("singularity"))
    return _entries(pose, leg, reasons, nothing, nothing)


def _nothing() -> tuple[NDArray[Any], ...]:
    return _entries(*(np.empty(0),) * 5)


def _entries(*columns: NDArray[Any]) -> tuple[NDArray[Any], ...]:
    types = (np.int64, np.int64, np.uint8, np.float64, np.float64)
    return tuple(c.astype(t) for c, t in zip(columns, types, strict=True))


def obstacle_rows(arrays: Arrays) -> list[dict[str, Any]]:
    """Return the obstacles as rows of an answer."""
    columns = [arrays[f"obstacle_{name}"].tolist() for name in ITEM_ARRAYS]
    return [
        {
            "pose": pose,
            "leg": None if leg == NO_LEG else leg,
            "reason": REASONS[reason],
            "value": value,
            "limit": limit,
        }
        for pose, leg, reason, value, limit in zip(*columns, strict=True)
    ]
