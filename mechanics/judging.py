"""Judging boxes of poses: the code that all of a box's nodes have, where bounds prove it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Bytes, Floats
from mechanics.conditions.condition import Condition
from mechanics.configuration import Configuration
from mechanics.kernels.octree import UNSEEN
from mechanics.mechanism import Mechanism
from mechanics.neighbourhoods import Neighbourhood
from mechanics.octree import Reach

BLOCK = 1024
"""Boxes judged together: enough to hide the cost of a call, few enough to stay in cache."""


@dataclass(frozen=True)
class Judgement:
    """What conditions say of all poses near a centre: a judge of boxes (`octree.Judge`).

    Parameters
    ----------
    first : the code of the first part of the first condition.
    inside : the code where all conditions hold.
    size : the greatest length that the leg equations meet. [m]
    """

    mechanism: Mechanism
    conditions: Sequence[Condition]
    first: int
    inside: int
    size: float

    def __call__(self, poses: Floats, reach: Reach) -> Bytes:
        """Return the code of each centre, shape (boxes,): `UNSEEN` where no bound tells."""
        codes = np.full(poses.shape[1], UNSEEN, np.uint8)
        for at in range(0, codes.size, BLOCK):
            part = slice(at, at + BLOCK)
            block = Configuration(self.mechanism, np.ascontiguousarray(poses[:, part]))
            own = Reach(reach.positions[part], reach.turns[part])
            self._judge(Neighbourhood(block, own, self.size), codes[part])
        return codes

    def _judge(self, near: Neighbourhood, codes: Bytes) -> None:
        """Write the codes of a block's boxes, as `workspace` sifts single nodes."""
        alive, code = np.arange(codes.size), self.first
        for condition in self.conditions:
            margins = condition.margins_near(near)
            holds = margins.least >= 0.0
            every = np.all(holds, axis=0)
            if not every.all():
                doubtful = np.flatnonzero(~every)
                part = np.argmin(holds[:, doubtful], axis=0)
                fails = margins.greatest[part, doubtful] < 0.0
                codes[alive[doubtful[fails]]] = code + part[fails]
                alive, near = alive[every], near.take(every)
            code += len(condition.legs)
        codes[alive] = self.inside
