"""What worker processes compute. Requests come as JSON, so that nothing else need be pickled."""

from dataclasses import dataclass
from functools import lru_cache, partial

import analyses
import storage
from schemas.analyses import Request


@dataclass(frozen=True)
class Refused:
    """The request does not make sense; `errors` are pairs of a JSON pointer and what is wrong."""

    detail: str
    errors: tuple[tuple[str, str], ...]


def warm() -> None:
    """Load what every tile needs."""
    # The service starts at the other end.
    analyses.warm(backwards=True)


def compute_tile(request_json: str, start: int, stop: int) -> bytes | Refused:
    """Return the arrays of the items from `start` up to `stop`, packed to be stored."""
    try:
        return storage.pack_arrays(analyses.compute(_parsed(request_json), start, stop))
    except analyses.AnalysisError as error:
        return _refused(error)


def assemble_result(request_json: str, database_url: str, job_id: str) -> str | Refused:
    """Return the result of a job whose tiles are all stored, JSON.

    The tiles are read here, one at a time: they pass through no pipe and are never all in memory.
    """
    database = storage.open_database(database_url)
    try:
        tiles = partial(storage.Jobs(database).tiles, job_id)
        return analyses.assemble(_parsed(request_json), tiles).model_dump_json()
    except analyses.AnalysisError as error:
        return _refused(error)
    finally:
        database.close()


# Tiles of a few jobs take turns in one process; 10^5 poses take a third of a second to parse.
@lru_cache(maxsize=8)
def _parsed(request_json: str) -> Request:
    return analyses.parse(request_json)


def _refused(error: analyses.AnalysisError) -> Refused:
    return Refused(error.detail, error.errors)
