"""What HTTP does with jobs."""

from collections.abc import Iterator
from uuid import uuid4

from sqlalchemy import Connection, delete, func, insert, or_, select, tuple_, update

from storage.arrays import Arrays, unpack_arrays
from storage.clock import now
from storage.database import Database, insert_or_nothing
from storage.errors import (
    IdempotencyConflict,
    JobNotFound,
    JobStillRunning,
    QueueFull,
)
from storage.records import Cursor, Job, JobState, NewJob
from storage.rows import cancelled, find_job, to_job
from storage.tables import idempotency_keys, jobs, requests, results, tiles

# How long a key stands for its job. [s]
_KEY_SECONDS = 24 * 3600.0


class Jobs:
    """The jobs, as their clients see them.

    Parameters
    ----------
    database : Database
        Where they are kept.
    queue_limit : int
        Most jobs that may wait to be run.
    """

    def __init__(self, database: Database, *, queue_limit: int = 1000) -> None:
        self._database = database
        self._queue_limit = queue_limit

    def create(self, new: NewJob) -> tuple[Job, bool]:
        """Put a job into the queue.

        Returns
        -------
        tuple of Job, bool
            The job and whether it is new; a repeated idempotency key returns its first job.

        Raises
        ------
        IdempotencyConflict : The key came with another body before.
        QueueFull : As many jobs wait as may.
        """
        job_id = uuid4().hex
        with self._database.writing() as connection:
            earlier = _claim_key(connection, new, job_id)
            if earlier is not None:
                return find_job(connection, earlier), False
            self._require_room(connection)
            _insert(connection, new, job_id)
            return find_job(connection, job_id), True

    def get(self, job_id: str) -> Job:
        """Return one job.

        Raises
        ------
        JobNotFound : There is none of this id.
        """
        with self._database.reading() as connection:
            return find_job(connection, job_id)

    def request(self, job_id: str) -> str:
        """Return the canonical request of a job, JSON.

        Raises
        ------
        JobNotFound : There is none of this id.
        """
        with self._database.reading() as connection:
            request = connection.execute(
                select(requests.c.request).where(requests.c.job_id == job_id)
            ).scalar_one_or_none()
        if request is None:
            raise JobNotFound(job_id)
        return str(request)

    def page(
        self,
        *,
        state: JobState | None = None,
        analysis: str | None = None,
        mechanism_id: str | None = None,
        after: Cursor | None = None,
        size: int,
    ) -> list[Job]:
        """Return up to `size` jobs that match, newest first, those after `after`."""
        query = select(jobs).order_by(jobs.c.created.desc(), jobs.c.id.desc()).limit(size)
        wanted = {"state": state, "analysis": analysis, "mechanism_id": mechanism_id}
        for column, value in wanted.items():
            if value is not None:
                query = query.where(jobs.c[column] == value)
        if after is not None:
            query = query.where(tuple_(jobs.c.created, jobs.c.id) < tuple_(*after))
        with self._database.reading() as connection:
            return [to_job(row) for row in connection.execute(query)]

    def request_cancel(self, job_id: str) -> Job:
        """Stop a job: at once while no engine works on it, else as soon as its engine hears of it.

        Returns
        -------
        Job
            The job after; unchanged if it had ended or was asked to stop before.

        Raises
        ------
        JobNotFound : There is none of this id.
        """
        this = jobs.c.id == job_id
        running = jobs.c.state == JobState.RUNNING
        unattended = or_(jobs.c.state == JobState.ACCEPTED, running & (jobs.c.lease_until < now()))
        flag = {"cancel_requested": True, "revision": jobs.c.revision + 1}
        with self._database.writing() as connection:
            ended = connection.execute(update(jobs).where(this, unattended).values(cancelled()))
            if ended.rowcount == 0:
                unflagged = running & ~jobs.c.cancel_requested
                connection.execute(update(jobs).where(this, unflagged).values(flag))
            return find_job(connection, job_id)

    def delete(self, job_id: str) -> None:
        """Remove an ended job with its result and tiles.

        Raises
        ------
        JobNotFound : There is none of this id.
        JobStillRunning : It has not ended.
        """
        with self._database.writing() as connection:
            job = find_job(connection, job_id)
            if not job.state.ended:
                raise JobStillRunning(job_id, job.state)
            connection.execute(delete(idempotency_keys).where(idempotency_keys.c.job_id == job_id))
            connection.execute(delete(jobs).where(jobs.c.id == job_id))

    def result(self, job_id: str) -> str | None:
        """Return the result of a job, JSON; None until it is successful.

        Raises
        ------
        JobNotFound : There is none of this id.
        """
        with self._database.reading() as connection:
            find_job(connection, job_id)
            query = select(results.c.result).where(results.c.job_id == job_id)
            result: str | None = connection.execute(query).scalar_one_or_none()
            return result

    def tiles(self, job_id: str) -> Iterator[Arrays]:
        """Yield the stored tiles of a job in their order, one by one.

        Raises
        ------
        JobNotFound : There is none of this id, or it was removed meanwhile.
        """
        mine = tiles.c.job_id == job_id
        with self._database.reading() as connection:
            find_job(connection, job_id)
            indices = connection.execute(
                select(tiles.c.index).where(mine).order_by(tiles.c.index)
            ).scalars()
            stored = list(indices)
        # A read each: a slow consumer must not hold a transaction open.
        for index in stored:
            with self._database.reading() as connection:
                packed = connection.execute(
                    select(tiles.c.arrays).where(mine, tiles.c.index == index)
                ).scalar_one_or_none()
            if packed is None:
                raise JobNotFound(job_id)
            yield unpack_arrays(packed)

    def _require_room(self, connection: Connection) -> None:
        query = select(func.count()).where(jobs.c.state == JobState.ACCEPTED)
        waiting = connection.execute(query).scalar_one()
        if waiting >= self._queue_limit:
            raise QueueFull(waiting, self._queue_limit)


def _claim_key(connection: Connection, new: NewJob, job_id: str) -> str | None:
    """Take the idempotency key for a job, or return the job that has it."""
    if new.idempotency_key is None:
        return None
    expired = idempotency_keys.c.created < now() - _KEY_SECONDS
    connection.execute(delete(idempotency_keys).where(expired))
    values = {
        "key": new.idempotency_key,
        "job_id": job_id,
        "body_hash": new.body_hash,
        "created": now(),
    }
    # The insert decides between two requests at once; a look before it could not.
    if insert_or_nothing(connection, idempotency_keys, values):
        return None
    taken = connection.execute(
        select(idempotency_keys).where(idempotency_keys.c.key == new.idempotency_key)
    ).one()
    if taken.body_hash != new.body_hash:
        raise IdempotencyConflict(new.idempotency_key)
    return str(taken.job_id)


def _insert(connection: Connection, new: NewJob, job_id: str) -> None:
    connection.execute(
        insert(jobs).values(
            id=job_id,
            analysis=new.analysis,
            mechanism_id=new.mechanism_id,
            state=JobState.ACCEPTED,
            items=new.items,
            items_per_tile=new.items_per_tile,
            done=0,
            attempt=0,
            revision=1,
            created=now(),
            cancel_requested=False,
        )
    )
    connection.execute(insert(requests).values(job_id=job_id, request=new.request_json))
