from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define

from ..models.job_state import JobState, check_job_state

if TYPE_CHECKING:
    from ..models.job_error import JobError
    from ..models.links import Links
    from ..models.progress import Progress


T = TypeVar("T", bound="Job")


@_attrs_define
class Job:
    """A queued request and what became of it.

    Attributes:
        analysis (str):
        attempt (int): How often an engine has taken it up.
        created (datetime.datetime):
        error (JobError | None):
        finished (datetime.datetime | None):
        id (str):
        links (Links): Where to go on from a job.
        mechanism (None | str): Id of the mechanism's canonical form; null where the request is about none.
        progress (Progress): How far a job has come, in poses, grid nodes or meshes.
        started (datetime.datetime | None):
        state (JobState):
    """

    analysis: str
    attempt: int
    created: datetime.datetime
    error: JobError | None
    finished: datetime.datetime | None
    id: str
    links: Links
    mechanism: None | str
    progress: Progress
    started: datetime.datetime | None
    state: JobState

    def to_dict(self) -> dict[str, Any]:
        from ..models.job_error import JobError  # noqa: PLC0415

        analysis = self.analysis

        attempt = self.attempt

        created = self.created.isoformat()

        error: dict[str, Any] | None
        if isinstance(self.error, JobError):
            error = self.error.to_dict()
        else:
            error = self.error

        finished: None | str
        if isinstance(self.finished, datetime.datetime):
            finished = self.finished.isoformat()
        else:
            finished = self.finished

        id = self.id

        links = self.links.to_dict()

        mechanism: None | str
        mechanism = self.mechanism

        progress = self.progress.to_dict()

        started: None | str
        if isinstance(self.started, datetime.datetime):
            started = self.started.isoformat()
        else:
            started = self.started

        state: str = self.state

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "analysis": analysis,
                "attempt": attempt,
                "created": created,
                "error": error,
                "finished": finished,
                "id": id,
                "links": links,
                "mechanism": mechanism,
                "progress": progress,
                "started": started,
                "state": state,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.job_error import JobError  # noqa: PLC0415
        from ..models.links import Links  # noqa: PLC0415
        from ..models.progress import Progress  # noqa: PLC0415

        d = dict(src_dict)
        analysis = d.pop("analysis")

        attempt = d.pop("attempt")

        created = datetime.datetime.fromisoformat(d.pop("created"))

        def _parse_error(data: object) -> JobError | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                error_type_0 = JobError.from_dict(data)

                return error_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(JobError | None, data)

        error = _parse_error(d.pop("error"))

        def _parse_finished(data: object) -> datetime.datetime | None:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                finished_type_0 = datetime.datetime.fromisoformat(data)

                return finished_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(datetime.datetime | None, data)

        finished = _parse_finished(d.pop("finished"))

        id = d.pop("id")

        links = Links.from_dict(d.pop("links"))

        def _parse_mechanism(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        mechanism = _parse_mechanism(d.pop("mechanism"))

        progress = Progress.from_dict(d.pop("progress"))

        def _parse_started(data: object) -> datetime.datetime | None:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                started_type_0 = datetime.datetime.fromisoformat(data)

                return started_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(datetime.datetime | None, data)

        started = _parse_started(d.pop("started"))

        state = check_job_state(d.pop("state"))

        job = cls(
            analysis=analysis,
            attempt=attempt,
            created=created,
            error=error,
            finished=finished,
            id=id,
            links=links,
            mechanism=mechanism,
            progress=progress,
            started=started,
            state=state,
        )

        return job
