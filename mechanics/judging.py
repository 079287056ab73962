"""Judging boxes of poses: the code that all of a box's nodes have, where bounds prove it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Bytes, Floats, Integers
from mechanics.conditions.condition import Condition
from mechanics.configuration import Configuration
from mechanics.grid import Grid
from mechanics.kernels.codes import INSIDE, UNSEEN
from mechanics.lines import greatest_length
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Neighbourhood, bounded
from mechanics.octree import Reach, reach_of

BLOCK = 1024
"""Boxes judged together: enough to hide the cost of a call, few enough to stay in cache."""

WORTH_BOXES, SPARSE = 100_000, 64
"""Boxes are judged of so many nodes or more, not in a window of so many times more."""

SAMPLED, TRIED = 512, 4
"""Nodes that are tried to see how many boxes leave, and along each axis those of such a box."""

MOST_ASKED, MOST_ASKED_QUICKLY = 0.75, 0.25
"""If boxes leave a greater share of the nodes, all are asked at once: of any conditions, and where
all are quick."""

FEWEST = 48
"""Boxes of no more nodes cost less asked than judged."""


@dataclass(frozen=True)
class Judgement:
    """What conditions say of all poses near a centre: a judge of boxes (`octree.Judge`).

    Parameters
    ----------
    first : the code of the first part of the first condition.
    grid : that the boxes are of.
    """

    mechanism: Mechanism
    conditions: Sequence[Condition]
    first: int
    grid: Grid

    def __call__(self, poses: Floats, reach: Reach) -> Bytes:
        """Return the code of each centre, shape (boxes,): `UNSEEN` where no bound tells."""
        codes = np.full(poses.shape[1], UNSEEN, np.uint8)
        size = greatest_length(self.mechanism, self.grid)
        for at in range(0, codes.size, BLOCK):
            part = slice(at, at + BLOCK)
            block = Configuration(self.mechanism, np.ascontiguousarray(poses[:, part]))
            own = Reach(reach.positions[part], reach.turns[part])
            self._judge(Neighbourhood(block, own, size), codes[part])
        return codes

    def _judge(self, near: Neighbourhood, codes: Bytes) -> None:
        """Write the codes of a block's boxes, as `workspace` sifts single nodes."""
        alive, code, last = np.arange(codes.size), self.first, self.conditions[-1]
        for condition in self.conditions:
            margins = condition.margins_near(near)
            holds = margins.least >= 0.0
            every = np.all(holds, axis=0)
            if not every.all():
                doubtful = np.flatnonzero(~every)
                part = np.argmin(holds[:, doubtful], axis=0)
                fails = margins.greatest[part, doubtful] < 0.0
                codes[alive[doubtful[fails]]] = code + part[fails]
                alive = alive[every]
                near = near.take(every) if condition is not last else near
            code += len(condition.legs)
        codes[alive] = INSIDE


def worth_judging(
    mechanism: Mechanism, conditions: Sequence[Condition], grid: Grid, left: Integers
) -> bool:
    """Return whether boxes can be told, and tell enough of the flat nodes left."""
    if not bounded(mechanism) or left.size < WORTH_BOXES:
        return False
    nodes = left[np.linspace(0, left.size - 1, SAMPLED).astype(np.int64)]
    share = _untold_share(mechanism, conditions, grid, grid.poses_at(nodes))
    return share <= _most_asked(conditions)


def sparse(size: int, left: int) -> bool:
    """Return whether in a window of so many nodes too few are left for its boxes to be judged."""
    return size > SPARSE * left


def asked_share(
    mechanism: Mechanism, conditions: Sequence[Condition], grid: Grid, left: Floats
) -> float:
    """Return which share of the nodes that lines leave boxes will leave too, from a few of them.

    1 if no boxes will be judged; they are no larger than those tried here for long.

    Parameters
    ----------
    conditions : those that lines do not tell.
    left : array, shape (coordinates, nodes), poses of some of the nodes that lines leave.
    """
    if not conditions or grid.size < WORTH_BOXES or not bounded(mechanism):
        return 1.0
    share = _untold_share(mechanism, conditions, grid, left)
    return share if share <= _most_asked(conditions) else 1.0


def _most_asked(conditions: Sequence[Condition]) -> float:
    return MOST_ASKED_QUICKLY if all(each.quick for each in conditions) else MOST_ASKED


def _untold_share(
    mechanism: Mechanism, conditions: Sequence[Condition], grid: Grid, poses: Floats
) -> float:
    """Return of which share of poses a box about them, as small as boxes get, is not told."""
    if not poses.size:
        return 1.0
    halves = np.array([0.5 * (TRIED - 1) * axis.step for axis in grid.axes])
    near = reach_of(mechanism.motion, grid, np.repeat(halves[:, None], poses.shape[1], axis=1))
    return float(np.mean(Judgement(mechanism, conditions, 1, grid)(poses, near) == UNSEEN))
