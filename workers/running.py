"""One job while an engine works on it: what to call next, what is still missing."""

from collections import Counter, deque
from dataclasses import dataclass, field

import storage
from workers import tiles
from workers.executors import Call

# Stands for the assembling among the tiles' numbers.
ASSEMBLY = -1


@dataclass(eq=False)
class RunningJob:
    """A claimed job.

    Parameters
    ----------
    job : Job
        As it was claimed: owner and attempt are its fencing token.
    request_json : str
        Its canonical request.
    waiting : deque of int
        Tiles to be computed, then `ASSEMBLY`.
    unstored : int
        Tiles that are not stored yet.
    """

    job: storage.Job
    request_json: str
    waiting: deque[int]
    unstored: int
    deaths: Counter[int] = field(default_factory=Counter)

    def tile_stored(self) -> None:
        """Note that one tile more is stored; the last one makes way for the assembling."""
        self.unstored -= 1
        if self.unstored == 0:
            self.waiting.append(ASSEMBLY)

    def call(self, piece: int, database_url: str, timeout_seconds: float) -> Call:
        """Return what a worker is to do for a tile, or for the assembling.

        Assembling reads every tile, so it may take as long as computing them may.
        """
        if piece == ASSEMBLY:
            arguments = (self.request_json, database_url, self.job.id)
            return Call(tiles.assemble_result, arguments, timeout_seconds * max(1, self.job.tiles))
        bounds = self.job.bounds(piece)
        return Call(tiles.compute_tile, (self.request_json, *bounds), timeout_seconds)


def take_up(queue: storage.Queue, job: storage.Job) -> RunningJob:
    """Return a claimed job with the work that earlier attempts have left.

    Raises
    ------
    LeaseLost : The job was taken away meanwhile.
    """
    finished = queue.finished_tiles(job)
    missing = deque(tile for tile in range(job.tiles) if tile not in finished)
    if not missing:
        return RunningJob(job, queue.request(job), deque([ASSEMBLY]), 0)
    return RunningJob(job, queue.request(job), missing, len(missing))
