"""What an engine does with jobs; every write first proves that the job is still its own."""

from sqlalchemy import (
    ColumnElement,
    Connection,
    and_,
    func,
    insert,
    or_,
    select,
    update,
)

from storage.clock import now
from storage.database import Database, insert_or_nothing
from storage.errors import LeaseLost
from storage.records import ErrorKind, Job, JobError, JobState
from storage.rows import cancelled, ended, to_job
from storage.tables import jobs, requests, results, tiles


class Queue:
    """The jobs, as one engine sees them.

    A job belongs to an owner and an attempt. Both together are the fencing token: an engine that
    lost its lease while it was silent can no longer write.

    Parameters
    ----------
    database : Database
        Where the jobs are kept.
    owner : str
        Name of the engine, never used by another or by an earlier run.
    lease_seconds : float
        An engine silent for so long loses its jobs, by the database's clock. [s]
    max_attempts : int
        Engines that may lose a job before it fails.
    """

    def __init__(
        self, database: Database, owner: str, *, lease_seconds: float, max_attempts: int = 5
    ) -> None:
        self._database = database
        self._owner = owner
        self._lease_seconds = lease_seconds
        self._max_attempts = max_attempts

    def claim(self) -> Job | None:
        """Take the oldest job that waits or whose engine fell silent; None if there is none.

        A job that lost `max_attempts` engines fails here with the kind "lost"; one that was to
        be cancelled when its engine was lost is cancelled here.
        """
        # Looking is cheap and holds nobody up; only who sees something takes the write lock.
        with self._database.reading() as connection:
            waiting = connection.execute(select(jobs.c.id).where(_claimable()).limit(1)).first()
        if waiting is None:
            return None
        with self._database.writing() as connection:
            self._end_abandoned(connection)
            oldest = (
                select(jobs.c.id)
                .where(_claimable())
                .order_by(jobs.c.created, jobs.c.id)
                .limit(1)
                .with_for_update(skip_locked=True)
                .scalar_subquery()
            )
            taken = (
                update(jobs)
                .where(jobs.c.id == oldest)
                .values(
                    state=JobState.RUNNING,
                    owner=self._owner,
                    attempt=jobs.c.attempt + 1,
                    lease_until=now() + self._lease_seconds,
                    started=func.coalesce(jobs.c.started, now()),
                    revision=jobs.c.revision + 1,
                )
            )
            row = connection.execute(taken.returning(*jobs.c)).one_or_none()
        return None if row is None else to_job(row)

    def renew(self, job: Job) -> bool:
        """Extend the lease of a job, and return whether it is still ours."""
        renewal = (
            update(jobs).where(self._mine(job)).values(lease_until=now() + self._lease_seconds)
        )
        with self._database.writing() as connection:
            return connection.execute(renewal.returning(jobs.c.id)).first() is not None

    def to_cancel(self) -> set[str]:
        """Return the ids of this engine's jobs that are asked to stop."""
        running = and_(jobs.c.state == JobState.RUNNING, jobs.c.owner == self._owner)
        query = select(jobs.c.id).where(running, jobs.c.cancel_requested)
        with self._database.reading() as connection:
            return set(connection.execute(query).scalars())

    def request(self, job: Job) -> str:
        """Return the canonical request of a job, JSON.

        Raises
        ------
        LeaseLost : The job was removed meanwhile.
        """
        query = select(requests.c.request).where(requests.c.job_id == job.id)
        with self._database.reading() as connection:
            request = connection.execute(query).scalar_one_or_none()
        if request is None:
            raise LeaseLost(job.id, self._owner, job.attempt)
        return str(request)

    def finished_tiles(self, job: Job) -> set[int]:
        """Return the tiles that are stored, by whichever attempt."""
        with self._database.reading() as connection:
            stored = select(tiles.c.index).where(tiles.c.job_id == job.id)
            return set(connection.execute(stored).scalars())

    def store_tile(self, job: Job, index: int, packed: bytes) -> bool:
        """Keep a tile and count its items as done, or neither.

        Parameters
        ----------
        job : Job
            The job, as it was claimed.
        index : int
            Number of the tile.
        packed : bytes
            Its arrays, from `pack_arrays`.

        Returns
        -------
        bool
            Whether it was new; a tile that is stored stays as it is.

        Raises
        ------
        LeaseLost : The job is not ours any more.
        """
        start, stop = job.bounds(index)
        values = {
            "job_id": job.id,
            "index": index,
            "attempt": job.attempt,
            "items": stop - start,
            "stored": now(),
            "arrays": packed,
        }
        with self._database.writing() as connection:
            self._require_mine(connection, job)
            if not insert_or_nothing(connection, tiles, values):
                return False
            progress = {"done": jobs.c.done + (stop - start), "revision": jobs.c.revision + 1}
            connection.execute(update(jobs).where(jobs.c.id == job.id).values(progress))
            return True

    def succeed(self, job: Job, result_json: str) -> None:
        """Keep the result and end the job.

        Raises
        ------
        LeaseLost : The job is not ours any more.
        """
        with self._database.writing() as connection:
            self._change(connection, job, **ended(JobState.SUCCESSFUL))
            connection.execute(insert(results).values(job_id=job.id, result=result_json))

    def fail(self, job: Job, error: JobError) -> None:
        """End the job with an error.

        Raises
        ------
        LeaseLost : The job is not ours any more.
        """
        with self._database.writing() as connection:
            self._change(connection, job, **ended(JobState.FAILED, error))

    def cancel(self, job: Job) -> None:
        """End the job because it was asked to stop.

        Raises
        ------
        LeaseLost : The job is not ours any more.
        """
        with self._database.writing() as connection:
            self._change(connection, job, **cancelled())

    def release(self, job: Job) -> None:
        """Give the job back, so that another engine goes on at once; the attempt does not count.

        Raises
        ------
        LeaseLost : The job is not ours any more.
        """
        with self._database.writing() as connection:
            if self._require_mine(connection, job).cancel_requested:
                self._change(connection, job, **cancelled())
                return
            self._change(
                connection,
                job,
                state=JobState.ACCEPTED,
                owner=None,
                lease_until=None,
                attempt=jobs.c.attempt - 1,
                revision=jobs.c.revision + 1,
            )

    def _mine(self, job: Job) -> ColumnElement[bool]:
        return and_(
            jobs.c.id == job.id,
            jobs.c.state == JobState.RUNNING,
            jobs.c.owner == self._owner,
            jobs.c.attempt == job.attempt,
        )

    def _require_mine(self, connection: Connection, job: Job) -> Job:
        query = select(jobs).where(self._mine(job)).with_for_update()
        row = connection.execute(query).one_or_none()
        if row is None:
            raise LeaseLost(job.id, self._owner, job.attempt)
        return to_job(row)

    def _change(self, connection: Connection, job: Job, **values: object) -> None:
        changed = connection.execute(update(jobs).where(self._mine(job)).values(**values))
        if changed.rowcount == 0:
            raise LeaseLost(job.id, self._owner, job.attempt)

    def _end_abandoned(self, connection: Connection) -> None:
        """End the jobs without an engine that no engine shall take again."""
        stopped = update(jobs).where(_abandoned(), jobs.c.cancel_requested).values(cancelled())
        connection.execute(stopped)
        error = JobError(
            ErrorKind.LOST, f"{self._max_attempts} engines in turn were lost while they ran it"
        )
        worn_out = update(jobs).where(_abandoned(), jobs.c.attempt >= self._max_attempts)
        connection.execute(worn_out.values(ended(JobState.FAILED, error)))


def _abandoned() -> ColumnElement[bool]:
    return and_(jobs.c.state == JobState.RUNNING, jobs.c.lease_until < now())


def _claimable() -> ColumnElement[bool]:
    # The first condition follows from the second; it lets the index find the few live rows.
    alive = jobs.c.state.in_([JobState.ACCEPTED, JobState.RUNNING])
    return and_(alive, or_(jobs.c.state == JobState.ACCEPTED, _abandoned()))
